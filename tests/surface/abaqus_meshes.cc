// SPDX-License-Identifier: LGPL-2.1-or-later

// An input file of Abaqus or CalculiX gives nodes, shells and sets, as ranges,
// as lists and by names, in any case of letters; a set of nodes is an edge
// along the free sides between them, and so is one of the lines of Gmsh, if
// they have no section as trusses; elements may go on in the next line; what
// has nothing to do with the mesh is passed over; and each fault is answered
// with its place.

#include <biface/base/errors.h>
#include <biface/surface/mesh_options.h>
#include <biface/surface/quadrilateral_mesh.h>

#include "../tests.h"

using namespace dealii;
using namespace Biface;

namespace
{
  /** A strip of three cells, whose last line are the given ones. */
  std::string
  strip(const std::string &element, const std::string &more)
  {
    return "*HEADING\n three cells\n** a comment\n*Node, nset=all\n"
           "1, 0, 0, 0\n2, 1., 0., 0.\n3, 2, 0\n4, 3.0E0, 0,\n"
           "11, 0, 1, 0\n12, 1, 1, 0\n13, 2, 1, 0\n14, 3, 1, 0\n" +
           element + more;
  }

  const std::string s4 = "*ELEMENT, TYPE=S4R, ELSET=Eall\n1, 1,2,12,11\n"
                         "2, 2,3,\n13,12\n3, 3,4,14,13\n";


  void
  print(const std::string &text)
  {
    try
      {
        const QuadrilateralMesh mesh = parse_mesh(text, "m.inp", {});
        std::cout << mesh.nodes.size() << " nodes, " << mesh.cells.size()
                  << " cells, groups";
        for (const auto &group : mesh.groups)
          std::cout << " '" << group.name << "' " << group.cells.size() << ' '
                    << group.sides.size() << ' ' << group.nodes.size();
        std::cout << std::endl;
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
  print(
    strip(s4,
          "*NSET, NSET=left\n1, 11\n*nset, nset=Bottom, generate\n1, 4\n"
          "*Nset,nset=tip\n 14,\n*NSET, NSET=both\nLEFT, bottom\n"
          "*ELSET, ELSET=ends\n1, 3\n*MATERIAL, NAME=STEEL\n*ELASTIC\n"
          "210000, .3\n*STEP\n*STATIC\n*BOUNDARY\nleft, 1, 6\n*END STEP\n"));
  print(strip("*ELEMENT, TYPE=S8R\n1, 1,3,13,11,2,13,12,\n11\n", ""));
  const std::string line = "*ELEMENT, type=T3D2, ELSET=Line3\n7, 1, 11\n";
  print(strip(line + s4, "*ELSET, ELSET=west\n7,\n"));
  print(strip(line + s4, "*SOLID SECTION, ELSET=Line3, MATERIAL=STEEL\n0.1\n"));
  print(strip("*ELEMENT, TYPE=S3\n1, 1,2,12\n", ""));
  print(strip("*ELEMENT, TYPE=B31\n1, 1,2\n", ""));
  print(strip("*ELEMENT, TYPE=SC8R\n1, 1,2,12,11,1,2,12,11\n", ""));
  print(strip("*ELEMENT, TYPE=S4\n1, 1,2,12\n", ""));
  print(strip("*ELEMENT, TYPE=S4\n1, 1,2,12,99\n", ""));
  print(strip("*ELEMENT, TYPE=S4\n1, 1,2,12,11\n1, 2,3,13,12\n", ""));
  print(strip(s4, "*NSET, NSET=left\n1, 99\n"));
  print(strip(s4, "*NSET, NSET=left\n1, unknown\n"));
  print(strip(s4, "*NSET\n1, 2\n"));
  print(strip(s4, "*NSET, NSET=left, GENERATE\n4, 1\n"));
  print(strip(s4, "*INCLUDE, INPUT=more.inp\n"));
  print(strip("", ""));
  print("*NODE\n1, 0, zero, 0\n");
}
