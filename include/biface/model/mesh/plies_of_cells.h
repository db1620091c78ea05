// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_mesh_plies_of_cells_h
#define biface_model_mesh_plies_of_cells_h

#include <deal.II/base/point.h>

#include <array>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace Biface
{
  class Layup;
  struct QuadrilateralMesh;
  struct Strip;

  /** Where the strips of a mesh from a file are: one for each set of groups of
   * cells or, if plies vary from place to place, one for each cell. */
  struct PlacesOfStrips
  {
    struct Place
    {
      /** The position of the set to which the cell belongs. */
      unsigned int set;
      /** The positions of the center and of the vertices of the cell. Unit:
       * length. */
      dealii::Point<3>                center;
      std::array<dealii::Point<3>, 4> vertices;
    };

    /** The sets of those groups of cells that plies name. */
    std::vector<std::set<std::string>> sets;
    std::vector<Place>                 places;

    /** The strips of the whole wall by @p places, followed by those of single
     * layers if there are several. Throws InputError like Layup::laminate().
     * @param [out] layers by @p places, the positions of the layers, see
     * append_layers(). */
    std::vector<Strip>
    make_strips(const Layup                            &layup,
                std::vector<std::vector<unsigned int>> &layers) const;
  };


  /** The plies of all cells of a mesh from a file, the same on all ranks. */
  class PliesOfCells
  {
  public:
    /** Both arguments are kept by reference.
     *
     * Throws InputError on all ranks if no ply covers a cell, or if a thickness
     * is not positive at its center or at a vertex. */
    PliesOfCells(const Layup &layup, const QuadrilateralMesh &mesh);

    /** The places of the strips of some of the cells.
     * @param [out] strip_of_cell the position of the strip of each of them. */
    PlacesOfStrips
    places(const std::set<unsigned int>         &of_cells,
           std::map<unsigned int, unsigned int> &strip_of_cell) const;

    /** The number of elements of a cell, see n_elements_of(). */
    unsigned int
    n_elements(const unsigned int cell) const;

    /** The heights of all faces in a cell at a vertex. Unit: length. */
    const std::vector<double> &
    heights(const unsigned int cell, const unsigned int vertex) const;

    /** The heights of all faces at a node: the means of the cells around it.
     * Unit: length. */
    std::vector<double>
    mean_heights(const unsigned int node) const;

    /** The stiffest_layer() at a node of those that exist in all cells around
     * it; an invalid number if there is none. */
    unsigned int
    stiffest(const unsigned int node) const;

    /** The thickness where it is largest. Unit: length. */
    double
    thickness() const
    {
      return max_thickness;
    }

  private:
    /** What nodes need of the wall of a set of groups. */
    struct Wall
    {
      std::vector<double> heights;
      unsigned int        n_elements;
      /** The membrane stiffness of the layers, 0 of those that do not exist.
       * Unit: force/length. */
      std::vector<double> stiffness;
    };

    /** The wall of a set at a node. */
    const Wall &
    wall(const unsigned int set, const unsigned int node) const;

    const Layup                       &layup;
    const QuadrilateralMesh           &mesh;
    std::vector<std::set<std::string>> sets;
    std::vector<unsigned int>          set_of_cells;
    /** The sets of the cells around each node. */
    std::vector<std::vector<unsigned int>> sets_around;
    /** The walls by set and, if plies vary, by node, 0 otherwise. */
    std::map<std::pair<unsigned int, unsigned int>, Wall> walls;
    double                                                max_thickness = 0;
  };
} // namespace Biface

#endif
