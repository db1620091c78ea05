// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_surface_mesh_text_h
#define biface_surface_mesh_text_h

#include <deal.II/base/point.h>

#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace Biface
{
  /** What the file of a mesh says, before anything is checked that needs more
   * than a line of it; see QuadrilateralMesh. */
  struct MeshText
  {
    /** The positions of the nodes, their numbers in the file, and the positions
     * in @p nodes by these numbers. */
    std::vector<dealii::Point<3>>                 nodes;
    std::vector<std::size_t>                      node_numbers;
    std::unordered_map<std::size_t, unsigned int> node_of_number;

    /** A point, a line or a cell. */
    struct Element
    {
      std::size_t number;
      /** The positions of its corners in @p nodes. */
      std::vector<unsigned int> corners;
      /** The groups to which the element belongs, by their numbers. */
      std::vector<long> groups;
    };
    /** Whether an element occurs once for each of its groups. */
    bool repeats_cells = false;

    /** The points, the lines and the cells. */
    std::array<std::vector<Element>, 3> elements;

    /** The names of groups by dimension and number. */
    std::map<std::pair<unsigned int, long>, std::string> names;

    /** Sets of nodes with names, by their positions in @p nodes. */
    std::map<std::string, std::vector<unsigned int>> node_sets;
  };


  /** Read a file of Gmsh, MSH 2.2 or 4.1 in ASCII. Throws InputError that names
   * the line that contains anything else.
   * @param name that of the file, for messages. */
  MeshText
  read_gmsh(const std::string &text, const std::string &name);

  /** Read an input file of Abaqus or CalculiX: nodes, shells, sets of nodes and
   * elements, and trusses without a section, which are the lines of Gmsh; what
   * has nothing to do with the mesh is passed over. Throws InputError that
   * names the line that contains anything else.
   * @param name that of the file, for messages. */
  MeshText
  read_abaqus(const std::string &text, const std::string &name);
} // namespace Biface

#endif
