// SPDX-License-Identifier: LGPL-2.1-or-later

// Both versions of Gmsh's format give the same mesh, whatever the order and the
// numbers of nodes; cells of second order are those of their corners; all cells
// take the orientation of the first; normals of a sphere are radial; and each
// fault is answered with its place.

#include <biface/base/errors.h>
#include <biface/surface/mesh_options.h>
#include <biface/surface/quadrilateral_mesh.h>

#include "../irregular_mesh.h"
#include "../tests.h"

using namespace dealii;
using namespace Biface;

namespace
{
  const std::string head = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";

  /** Two cells side by side, the second one of which has nodes in the given
   * order, and a line at the end. */
  std::string
  two_cells(const std::string &second_cell)
  {
    return head +
           "$PhysicalNames\n2\n1 7 \"end\"\n2 1 \"strip\"\n$EndPhysicalNames\n"
           "$Nodes\n6\n10 0 0 0\n20 1 0 0\n30 2 0 0\n40 0 1 0\n50 1 1 0\n"
           "60 2 1 0\n$EndNodes\n$Elements\n3\n1 1 2 7 1 30 60\n"
           "2 3 2 1 1 10 20 50 40\n3 3 2 1 1 " +
           second_cell + "\n$EndElements\n";
  }


  void
  print(const std::string &name, const QuadrilateralMesh &mesh)
  {
    std::cout << name << ": " << mesh.nodes.size() << " nodes, "
              << mesh.cells.size() << " cells, " << mesh.free_sides.size()
              << " free sides, normal " << mesh.normals[0] << ", groups";
    for (const auto &group : mesh.groups)
      std::cout << " '" << group.name << "' " << group.cells.size() << ' '
                << group.sides.size() << ' ' << group.nodes.size();
    std::cout << std::endl;
  }


  void
  refuse(const std::string &text)
  {
    try
      {
        parse_mesh(text, "m.msh", {});
        std::cout << "ACCEPTED" << std::endl;
      }
    catch (const InputError &error)
      {
        std::cout << error.what() << std::endl;
      }
  }
} // namespace


int
main()
{
  print("2.2", parse_mesh(two_cells("20 30 60 50"), "m.msh", {}));
  print("turned", parse_mesh(two_cells("50 60 30 20"), "m.msh", {}));
  print("4.1",
        parse_mesh("$MeshFormat\n4.1 0 8\n$EndMeshFormat\n"
                   "$PhysicalNames\n2\n1 7 \"end\"\n2 1 \"strip\"\n"
                   "$EndPhysicalNames\n"
                   "$Entities\n0 1 1 0\n3 2 0 0 2 1 0 1 7 0\n"
                   "5 0 0 0 2 1 0 1 1 0\n$EndEntities\n"
                   "$Nodes\n2 6 10 60\n1 3 0 2\n30\n60\n2 0 0\n2 1 0\n"
                   "2 5 0 4\n50\n10\n20\n40\n1 1 0\n0 0 0\n1 0 0\n0 1 0\n"
                   "$EndNodes\n"
                   "$Elements\n2 3 1 3\n1 3 1 1\n1 30 60\n"
                   "2 5 3 2\n2 10 20 50 40\n3 20 30 60 50\n$EndElements\n",
                   "m.msh",
                   {}));
  print("second order",
        parse_mesh(gmsh_text({{0, 0, 0},
                              {1, 0, 0},
                              {1, 1, 0},
                              {0, 1, 0},
                              {.5, 0, 0},
                              {1, .5, 0},
                              {.5, 1, 0},
                              {0, .5, 0}},
                             {"16 0 1 2 3 4 5 6 7 8"}),
                   "m.msh",
                   {}));

  // a cell in two groups, and a line twice in one, as Gmsh writes them in 2.2
  print(
    "repeated",
    parse_mesh(
      gmsh_text(
        {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}},
        {"1 2 7 1 1 2", "1 2 7 1 2 1", "3 2 1 1 1 2 3 4", "3 2 2 1 1 2 3 4"}),
      "m.msh",
      {}));

  // the normals of an irregular part of a sphere
  const QuadrilateralMesh sphere = parse_mesh(
    gmsh_text(irregular_mesh(16, 16, 0.25, hemisphere)), "m.msh", {});
  double largest = 0;
  for (unsigned int i = 0; i < sphere.nodes.size(); ++i)
    largest = std::max(
      largest,
      (sphere.normals[i] - sphere.nodes[i] / sphere.nodes[i].norm()).norm());
  std::cout << "sphere: " << sphere.cells.size() << " cells, normals "
            << (largest < 0.1 ? "radial" : "not radial") << std::endl;

  const Point<3> a(0, 0, 0), b(1, 0, 0), c(1, 1, 0), d(0, 1, 0);
  refuse("");
  refuse("<?xml version=\"1.0\"?>\n");
  refuse("$Nodes\n0\n$EndNodes\n");
  refuse("$MeshFormat\n4.0 0 8\n$EndMeshFormat\n");
  refuse("$MeshFormat\n4.1 1 8\n$EndMeshFormat\n");
  refuse(head + "$Nodes\n2\n1 0 0 0\n");
  refuse(head + "$Nodes\n2\n1 0 0 0\n1 0 0 1\n$EndNodes\n");
  refuse(head + "$Nodes\n1\n1 0 nan 0\n$EndNodes\n");
  refuse(head + "$Nodes\n1\n1 0 0\n$EndNodes\n");
  refuse(gmsh_text({a, b, c, d}, {}));
  refuse(gmsh_text({a, b, c, d}, {"3 0 1 2 3 5"}));
  refuse(gmsh_text({a, b, c, d}, {"2 0 1 2 3"}));
  refuse(gmsh_text({a, b, c, d}, {"4 0 1 2 3 4"}));
  refuse(gmsh_text({a, b, c, d}, {"3 0 1 2 2 4"}));
  refuse(gmsh_text({a, b, Point<3>(.2, .2, 0), d}, {"3 0 1 2 3 4"}));
  refuse(gmsh_text({a, b, d, c}, {"3 0 1 2 3 4"}));
  refuse(gmsh_text({a, b, c, d, {2, 0, 0}, {2, 1, 0}},
                   {"3 0 1 2 3 4", "3 0 1 2 3 4"}));
  // an open seam
  refuse(gmsh_text({a, b, c, d, b, {2, 0, 0}, {2, 1, 0}, c},
                   {"3 0 1 2 3 4", "3 0 5 6 7 8"}));
  // a band of Moebius
  {
    const unsigned int       n = 40;
    std::vector<Point<3>>    nodes;
    std::vector<std::string> elements;
    for (unsigned int i = 0; i < n; ++i)
      for (const double w : {-0.3, 0.3})
        {
          const double phi = 2 * numbers::PI * i / n;
          nodes.emplace_back((2 + w * std::cos(phi / 2)) * std::cos(phi),
                             (2 + w * std::cos(phi / 2)) * std::sin(phi),
                             w * std::sin(phi / 2));
        }
    for (unsigned int i = 0; i < n; ++i)
      {
        const bool         last = (i + 1 == n);
        const unsigned int p = 2 * i + 1, q = (last ? 0 : 2 * i + 2) + 1;
        elements.push_back(
          "3 0 " + std::to_string(p) + ' ' + std::to_string(last ? q + 1 : q) +
          ' ' + std::to_string(last ? q : q + 1) + ' ' + std::to_string(p + 1));
      }
    refuse(gmsh_text(nodes, elements));
  }
  // counts that do not fit, and parts that meet in a node
  refuse(head + "$Nodes\n1\n1 0 0 0\n2 1 0 0\n$EndNodes\n");
  refuse(head + "$PartitionedEntities\n$EndPartitionedEntities\n");
  refuse(gmsh_text({a, b, c, d, {2, 1, 0}, {2, 2, 0}, {1, 2, 0}},
                   {"3 0 1 2 3 4", "3 0 3 5 6 7"}));
  // a line that is no side
  refuse(gmsh_text({a, b, c, d}, {"3 0 1 2 3 4", "1 2 3 1 1 3"}));
}
