// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_tests_irregular_mesh_h
#define biface_tests_irregular_mesh_h

#include <deal.II/base/numbers.h>
#include <deal.II/base/point.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <sstream>
#include <string>
#include <vector>

/** A mesh of n x m cells of the unit square on a surface, with the edges
 * 'south', 'east', 'north', 'west', and its corners A to D as points. */
struct IrregularMesh
{
  unsigned int                  n, m;
  std::vector<dealii::Point<3>> nodes;

  unsigned int
  node(const unsigned int i, const unsigned int j) const
  {
    return j * (n + 1) + i;
  }
};


/** @param amount by which nodes are moved at random, as a part of a cell; those
 * of edges along them. */
inline IrregularMesh
irregular_mesh(
  const unsigned int                                                 n,
  const unsigned int                                                 m,
  const double                                                       amount,
  const std::function<dealii::Point<3>(const double, const double)> &surface)
{
  IrregularMesh mesh{n, m, {}};
  // the same numbers on every machine
  std::uint32_t state  = 12345;
  const auto    random = [&state]() {
    state = 1664525u * state + 1013904223u;
    return 2. * (state >> 8) / (1u << 24) - 1;
  };
  for (unsigned int j = 0; j <= m; ++j)
    for (unsigned int i = 0; i <= n; ++i)
      {
        const double du = random() * amount, dv = random() * amount;
        mesh.nodes.push_back(surface((i + (i == 0 || i == n ? 0 : du)) / n,
                                     (j + (j == 0 || j == m ? 0 : dv)) / m));
      }
  return mesh;
}


/** A part of a sphere of radius 10 with a hole of 18 degrees. */
inline dealii::Point<3>
hemisphere(const double u, const double v)
{
  const double longitude = dealii::numbers::PI / 2 * u,
               latitude  = dealii::numbers::PI * 0.4 * v;
  return dealii::Point<3>(10 * std::cos(latitude) * std::cos(longitude),
                          10 * std::cos(latitude) * std::sin(longitude),
                          10 * std::sin(latitude));
}


/** Nodes and elements, each as its kind, tags and nodes, in Gmsh's format. */
inline std::string
gmsh_text(const std::vector<dealii::Point<3>> &nodes,
          const std::vector<std::string>      &elements,
          const unsigned int                   precision = 6)
{
  std::ostringstream text;
  text.precision(precision);
  text << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n"
       << nodes.size() << '\n';
  for (unsigned int i = 0; i < nodes.size(); ++i)
    text << i + 1 << ' ' << nodes[i] << '\n';
  text << "$EndNodes\n$Elements\n" << elements.size() << '\n';
  for (unsigned int i = 0; i < elements.size(); ++i)
    text << i + 1 << ' ' << elements[i] << '\n';
  text << "$EndElements\n";
  return text.str();
}


/** The mesh in Gmsh's format. */
inline std::string
gmsh_text(const IrregularMesh &mesh)
{
  std::ostringstream text;
  text.precision(17);
  text << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n9\n";
  const std::array<std::string, 4> edges{{"south", "east", "north", "west"}};
  for (unsigned int i = 0; i < 4; ++i)
    text << "0 " << 11 + i << " \""
         << "ABCD"[i] << "\"\n1 " << 1 + i << " \"" << edges[i] << "\"\n";
  text << "2 21 \"shell\"\n$EndPhysicalNames\n$Nodes\n"
       << mesh.nodes.size() << '\n';
  for (unsigned int i = 0; i < mesh.nodes.size(); ++i)
    text << i + 1 << ' ' << mesh.nodes[i] << '\n';
  text << "$EndNodes\n$Elements\n";

  std::vector<std::string> elements;
  const auto               add = [&elements](const std::string               &kind,
                               const std::vector<unsigned int> &nodes) {
    std::string element = kind;
    for (const unsigned int node : nodes)
      element += ' ' + std::to_string(node + 1);
    elements.push_back(element);
  };
  const unsigned int n = mesh.n, m = mesh.m;
  add("15 2 11 1", {mesh.node(0, 0)});
  add("15 2 12 1", {mesh.node(n, 0)});
  add("15 2 13 1", {mesh.node(n, m)});
  add("15 2 14 1", {mesh.node(0, m)});
  for (unsigned int i = 0; i < n; ++i)
    {
      add("1 2 1 1", {mesh.node(i, 0), mesh.node(i + 1, 0)});
      add("1 2 3 1", {mesh.node(i, m), mesh.node(i + 1, m)});
    }
  for (unsigned int j = 0; j < m; ++j)
    {
      add("1 2 2 1", {mesh.node(n, j), mesh.node(n, j + 1)});
      add("1 2 4 1", {mesh.node(0, j), mesh.node(0, j + 1)});
      for (unsigned int i = 0; i < n; ++i)
        add("3 2 21 1",
            {mesh.node(i, j),
             mesh.node(i + 1, j),
             mesh.node(i + 1, j + 1),
             mesh.node(i, j + 1)});
    }
  text << elements.size() << '\n';
  for (unsigned int i = 0; i < elements.size(); ++i)
    text << i + 1 << ' ' << elements[i] << '\n';
  text << "$EndElements\n";
  return text.str();
}

#endif
