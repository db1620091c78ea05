// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <memory>

#include <biface/base/errors.h>
#include <biface/laminate/layup.h>
#include <biface/model/mesh/faces_of_layers.h>
#include <biface/model/mesh/plies_of_cells.h>
#include <biface/model/mesh/strip.h>
#include <biface/surface/quadrilateral_mesh.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    /** The layups of sets of groups. */
    std::vector<Layup>
    layups_of(const std::vector<std::set<std::string>> &sets,
              const Layup                              &layup)
    {
      std::vector<Layup> result;
      for (const std::set<std::string> &set : sets)
        result.push_back(layup.in_groups(set));
      return result;
    }


    WallAtPlace
    wall_at(const Layup &layup, const Point<3> &position)
    {
      // a mesh has no coordinate by which plies end
      return WallAtPlace(layup, PlyPlace(position), 0);
    }
  } // namespace


  std::vector<Strip>
  PlacesOfStrips::make_strips(
    const Layup &layup, std::vector<std::vector<unsigned int>> &layers) const
  {
    const std::vector<Layup> layups = layups_of(sets, layup);
    using Key = std::pair<unsigned int, std::array<double, 3>>;
    std::map<Key, std::shared_ptr<const WallAtPlace>> known;
    const auto at = [&](const unsigned int set, const Point<3> &x) {
      Key key{set, {{0, 0, 0}}};
      if (layup.varies())
        key.second = {{x[0], x[1], x[2]}};
      auto &wall = known[key];
      if (!wall)
        wall = std::make_shared<const WallAtPlace>(wall_at(layups[set], x));
      return wall;
    };

    std::vector<Strip>                              strips;
    std::vector<std::shared_ptr<const WallAtPlace>> inside;
    std::vector<WallsAtVertices>                    at_vertices;
    for (const Place &place : places)
      {
        inside.push_back(at(place.set, place.center));
        at_vertices.emplace_back();
        for (unsigned int v = 0; v < 4; ++v)
          at_vertices.back()[v] = at(place.set, place.vertices[v]);
        strips.push_back(strip_of_wall(*inside.back(), at_vertices.back()));
      }
    layers.clear();
    for (unsigned int i = 0; i < places.size(); ++i)
      layers.push_back(append_layers(i, *inside[i], at_vertices[i], strips));
    return strips;
  }


  PliesOfCells::PliesOfCells(const Layup &layup, const QuadrilateralMesh &mesh)
    : layup(layup), mesh(mesh), sets_around(mesh.nodes.size())
  {
    const std::set<std::string>        names = layup.groups();
    std::vector<std::set<std::string>> of_each(mesh.cells.size());
    for (const QuadrilateralMesh::Group &group : mesh.groups)
      if (names.count(group.name) > 0)
        for (const unsigned int c : group.cells)
          of_each[c].insert(group.name);

    std::map<std::set<std::string>, unsigned int> position;
    for (unsigned int c = 0; c < mesh.cells.size(); ++c)
      {
        const auto found = position.emplace(of_each[c], sets.size());
        set_of_cells.push_back(found.first->second);
        for (const unsigned int n : mesh.cells[c])
          sets_around[n].push_back(set_of_cells[c]);
        if (!found.second)
          continue;
        sets.push_back(of_each[c]);
        if (names.count("") == 0 && of_each[c].empty())
          throw InputError("no ply of the entry 'Laminate/Plies' covers " +
                           mesh.cell_in_words(c) + ".");
      }

    // all walls on all ranks, so that they answer a faulty formula together
    const std::vector<Layup> layups = layups_of(sets, layup);
    const auto               add    = [&](const WallAtPlace &at) {
      max_thickness = std::max(max_thickness, at.wall.thickness());
      Wall result{at.heights, n_elements_of(at.layers), {}};
      for (const std::optional<Laminate> &layer : at.layers)
        result.stiffness.push_back(layer ? layer->membrane_stiffness() : 0.);
      return result;
    };
    for (unsigned int c = 0; c < mesh.cells.size(); ++c)
      {
        const unsigned int set = set_of_cells[c];
        if (layup.varies())
          add(wall_at(layups[set], mesh.center(c)));
        for (const unsigned int n : mesh.cells[c])
          {
            const std::pair<unsigned int, unsigned int> key(
              set, layup.varies() ? n : 0);
            if (walls.count(key) == 0)
              walls[key] = add(wall_at(layups[set], mesh.nodes[n]));
          }
      }
  }


  PlacesOfStrips
  PliesOfCells::places(
    const std::set<unsigned int>         &of_cells,
    std::map<unsigned int, unsigned int> &strip_of_cell) const
  {
    PlacesOfStrips result{sets, {}};
    if (!layup.varies())
      for (unsigned int s = 0; s < sets.size(); ++s)
        result.places.push_back({s, {}, {}});
    for (const unsigned int c : of_cells)
      {
        strip_of_cell[c] = set_of_cells[c];
        if (!layup.varies())
          continue;
        strip_of_cell[c] = result.places.size();
        result.places.push_back({set_of_cells[c], mesh.center(c), {}});
        for (unsigned int v = 0; v < 4; ++v)
          result.places.back().vertices[v] = mesh.nodes[mesh.cells[c][v]];
      }
    return result;
  }


  unsigned int
  PliesOfCells::n_elements(const unsigned int cell) const
  {
    return wall(set_of_cells[cell], mesh.cells[cell][0]).n_elements;
  }


  const PliesOfCells::Wall &
  PliesOfCells::wall(const unsigned int set, const unsigned int node) const
  {
    return walls.at({set, layup.varies() ? node : 0});
  }


  const std::vector<double> &
  PliesOfCells::heights(const unsigned int cell,
                        const unsigned int vertex) const
  {
    return wall(set_of_cells[cell], mesh.cells[cell][vertex]).heights;
  }


  std::vector<double>
  PliesOfCells::mean_heights(const unsigned int node) const
  {
    const std::vector<unsigned int> &around = sets_around[node];
    const std::vector<double>       &first  = wall(around[0], node).heights;
    // without round-off where all cells have the same heights
    if (std::all_of(around.begin(), around.end(), [&](const unsigned int s) {
          return wall(s, node).heights == first;
        }))
      return first;
    std::vector<double> mean(first.size());
    for (const unsigned int s : around)
      for (unsigned int k = 0; k < mean.size(); ++k)
        mean[k] += wall(s, node).heights[k] / around.size();
    return mean;
  }


  unsigned int
  PliesOfCells::stiffest(const unsigned int node) const
  {
    std::vector<double> stiffness(layup.n_layers(), 0.);
    for (unsigned int k = 0; k < stiffness.size(); ++k)
      {
        const std::vector<unsigned int> &around = sets_around[node];
        if (std::all_of(
              around.begin(), around.end(), [&](const unsigned int s) {
                return wall(s, node).stiffness[k] > 0;
              }))
          for (const unsigned int s : around)
            stiffness[k] += wall(s, node).stiffness[k];
      }
    return stiffest_layer(stiffness);
  }
} // namespace Biface
