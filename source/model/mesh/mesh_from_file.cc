// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/mpi.h>
#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include <biface/base/errors.h>
#include <biface/element/quadrilateral_geometry.h>
#include <biface/input/parameter_tools.h>
#include <biface/laminate/layup.h>
#include <biface/model/mesh/parallel_triangulation.h>
#include <biface/model/mesh/plies_of_cells.h>
#include <biface/model/mesh/shell_mesh.h>
#include <biface/model/mesh/strip.h>
#include <biface/model/mesh/supports.h>
#include <biface/surface/mesh_file.h>
#include <biface/surface/quadrilateral_mesh.h>
#include <biface/surface/reference_surface.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    void
    create_triangulation(const QuadrilateralMesh &mesh,
                         Triangulation<2, 3>     &triangulation)
    {
      std::vector<CellData<2>> cells(mesh.cells.size());
      for (unsigned int c = 0; c < cells.size(); ++c)
        std::copy(mesh.cells[c].begin(),
                  mesh.cells[c].end(),
                  cells[c].vertices.begin());
      triangulation.create_triangulation(mesh.nodes, cells, SubCellData());
    }


    /** The normals at the nodes, in the planes of symmetry along the edges that
     * lie in them.
     * @param group_of_edge the groups of the mesh by MeshNodes::edges. */
    std::vector<Tensor<1, 3>>
    normals_in_planes(const QuadrilateralMesh         &mesh,
                      const std::vector<EdgeSupport>  &supports,
                      const MeshNodes                 &nodes,
                      const std::vector<unsigned int> &group_of_edge,
                      const double                     fold_angle)
    {
      // the cells on both sides of the plane turn by twice this angle
      const double least =
        std::cos((fold_angle / 2 + 1e-6) * numbers::PI / 180);
      std::vector<Tensor<1, 3>> normals = mesh.normals;
      const std::string         entry   = "Supports/Edge supports";
      for (const EdgeSupport &support : supports)
        if (support.symmetry)
          {
            const unsigned int d = *support.symmetry;
            const unsigned int edge =
              nodes.find_edge(entry, support.text, support.edge);
            for (const unsigned int node :
                 mesh.groups[group_of_edge[edge]].nodes)
              {
                Tensor<1, 3> normal = normals[node];
                normal[d]           = 0;
                if (!(normal.norm() > least))
                  throw InputError(
                    entry,
                    support.text,
                    "the shell must be normal to a plane of symmetry within "
                    "half of 'Surface/Mesh/Fold angle', but its normal at (" +
                      vector_to_string(mesh.nodes[node]) +
                      ") is not in the plane");
                normals[node] = normal / normal.norm();
              }
          }
      return normals;
    }


    /** Whether a direction has a projection into the surface. */
    bool
    has_direction(const Tensor<1, 3> &normal, const Tensor<1, 3> &direction)
    {
      return (direction - (direction * normal) * normal).norm() >
             1e-2 * direction.norm();
    }


    /** The frame at a node: the normal, and the projection of the direction
     * into the surface, or of another one where it has none. */
    std::array<Tensor<1, 3>, 3>
    frame_along(const Tensor<1, 3> &normal, const Tensor<1, 3> &direction)
    {
      Tensor<1, 3> along = direction - (direction * normal) * normal;
      if (!has_direction(normal, direction))
        {
          unsigned int least = 0;
          for (unsigned int d = 1; d < 3; ++d)
            if (std::abs(normal[d]) < std::abs(normal[least]))
              least = d;
          along        = Tensor<1, 3>();
          along[least] = 1;
          along -= normal[least] * normal;
        }
      along /= along.norm();
      return {{along, cross_product_3d(normal, along), normal}};
    }


    /** The mean of the normals at the nodes of a cell, a unit vector. */
    Tensor<1, 3>
    normal_of_cell(const QuadrilateralMesh         &mesh,
                   const std::vector<Tensor<1, 3>> &normals,
                   const unsigned int               cell)
    {
      Tensor<1, 3> normal;
      for (const unsigned int node : mesh.cells[cell])
        normal += normals[node];
      return normal / normal.norm();
    }


    /** The directions of the plies in a cell, with its normal. */
    std::array<Tensor<1, 3>, 3>
    frame_of_cell(const MeshFile                  &file,
                  const std::vector<Tensor<1, 3>> &normals,
                  const unsigned int               cell)
    {
      return frame_along(normal_of_cell(*file.mesh, normals, cell),
                         file.direction_at(file.mesh->center(cell)));
    }


    /** Throw InputError unless plies have a direction in all cells. */
    void
    check_directions(const MeshFile &file, const Layup &layup)
    {
      const QuadrilateralMesh &mesh = *file.mesh;
      for (unsigned int c = 0; c < mesh.cells.size(); ++c)
        {
          const Tensor<1, 3> direction = file.direction_at(mesh.center(c));
          const Tensor<1, 3> normal    = normal_of_cell(mesh, mesh.normals, c);
          if (!(direction.norm() > 0))
            throw InputError("the entry 'Surface/Mesh/Direction' is zero in " +
                             mesh.cell_in_words(c) +
                             ", but it must be a direction.");
          if (layup.has_fibers() && !has_direction(normal, direction))
            throw InputError(
              "the entry 'Surface/Mesh/Direction' is normal to the surface in " +
              mesh.cell_in_words(c) +
              ", but the angles of plies count from its projection into the "
              "surface; choose another vector or formulas, such as '-y; x; 0'.");
        }
    }


    /** Throw InputError if a face is turned inside out in any cell. */
    void
    check_faces(const QuadrilateralMesh         &mesh,
                const std::vector<Tensor<1, 3>> &normals,
                const PliesOfCells              &plies)
    {
      for (unsigned int c = 0; c < mesh.cells.size(); ++c)
        for (const bool outer : {false, true})
          {
            std::array<double, 4>       heights;
            std::array<Tensor<1, 3>, 4> x;
            for (unsigned int v = 0; v < 4; ++v)
              {
                const std::vector<double> &all = plies.heights(c, v);
                heights[v]                     = outer ? all.back() : all[0];
                x[v]                           = mesh.nodes[mesh.cells[c][v]] +
                       heights[v] * normals[mesh.cells[c][v]];
              }
            for (unsigned int v = 0; v < 4; ++v)
              if (!(cross_product_3d(x[v | 1] - x[v & 2], x[v | 2] - x[v & 1]) *
                      normals[mesh.cells[c][v]] >
                    0))
                throw InputError(
                  "the entry 'Laminate/Plies' places a face at " +
                  number_to_string(heights[v]) +
                  " from the reference surface, but there " +
                  mesh.cell_in_words(c) +
                  " is turned inside out: the surface is curved too sharply.");
          }
    }


    /** A side of the mesh on named lines: the cell to which it belongs, the
     * first one of two, and the positions of the lines in MeshNodes::edges. */
    struct NamedSide
    {
      unsigned int              cell = numbers::invalid_unsigned_int;
      std::vector<unsigned int> edges;
    };

    using Side = QuadrilateralMesh::Side;
  } // namespace


  void
  ShellMesh::add_nodes_of_joints(
    const QuadrilateralMesh                       &mesh,
    const std::function<Node(const unsigned int)> &make_node,
    std::map<unsigned int, unsigned int>          &node_of_number)
  {
    // the unknowns of all nodes of joints, from the ranks that own them
    const unsigned int n_dofs = n_dofs_per_node();
    std::size_t        n      = 0;
    for (const std::vector<unsigned int> &joint : mesh.joints)
      n += joint.size() * n_dofs;
    if (n == 0)
      return;
    std::vector<types::global_dof_index> dofs(n);
    const auto                           for_each = [&](const auto &visit) {
      std::size_t begin = 0;
      for (const std::vector<unsigned int> &joint : mesh.joints)
        for (const unsigned int number : joint)
          {
            visit(number, &dofs[begin]);
            begin += n_dofs;
          }
    };
    for_each([&](const unsigned int number, types::global_dof_index *of_node) {
      const auto node = node_of_number.find(number);
      if (node != node_of_number.end() && nodes[node->second].locally_owned)
        std::copy(nodes[node->second].dofs.begin(),
                  nodes[node->second].dofs.end(),
                  of_node);
    });
    // zero on ranks that do not own the node, so that the sum makes all known
    Utilities::MPI::sum(dofs, communicator, dofs);

    std::set<unsigned int> wanted;
    for (const std::vector<unsigned int> &joint : mesh.joints)
      if (std::any_of(
            joint.begin(), joint.end(), [&](const unsigned int number) {
              return node_of_number.count(number) > 0;
            }))
        wanted.insert(joint.begin(), joint.end());
    for_each([&](const unsigned int number, types::global_dof_index *of_node) {
      if (wanted.count(number) == 0 || node_of_number.count(number) > 0)
        return;
      Node node = make_node(number);
      node.dofs.assign(of_node, of_node + n_dofs);
      node_of_number[number] = nodes.size();
      locally_relevant.add_indices(node.dofs.begin(), node.dofs.end());
      neighbors.push_back({static_cast<unsigned int>(nodes.size())});
      nodes.push_back(node);
    });
    for (const std::vector<unsigned int> &joint : mesh.joints)
      if (wanted.count(joint[0]) > 0)
        {
          joints.emplace_back();
          for (const unsigned int number : joint)
            joints.back().push_back(node_of_number.at(number));
        }
  }


  ShellMesh::ShellMesh(const MPI_Comm                          communicator,
                       std::unique_ptr<const ReferenceSurface> surface,
                       const ChartGrid                        &grid,
                       const MeshFile                         &file,
                       const Layup                            &layup,
                       const Supports                         &supports,
                       const std::vector<NamedPoint>          &points)
    : MeshNodes(communicator, std::move(surface), grid, points)
    , formulation(Formulation::standard)
    , normal_thickness(layup.n_layers() > 1)
  {
    set_layup(layup);
    const QuadrilateralMesh &mesh = *file.mesh;
    const PliesOfCells       plies(*this->layup, mesh);
    max_thickness = plies.thickness();

    const unsigned int n_ranks = Utilities::MPI::n_mpi_processes(communicator);
    triangulation              = make_parallel_triangulation(
      communicator,
      grid.distribution,
      [&mesh](Triangulation<2, 3> &whole) {
        create_triangulation(mesh, whole);
      },
      [n_ranks](Triangulation<2, 3> &whole) {
        if (n_ranks > 1)
          GridTools::partition_triangulation(
            n_ranks, whole, SparsityTools::Partitioner::metis);
      },
      nullptr);
    distribute_dofs();

    // the cells of this rank, and those across its folds
    std::set<unsigned int> cells_of_rank;
    for (const auto &cell : dof_handler->active_cell_iterators())
      if (cell->is_locally_owned())
        cells_of_rank.insert(cell->id().get_coarse_cell_id());
    std::set<unsigned int> with_strips = cells_of_rank;
    for (const QuadrilateralMesh::Fold &fold : mesh.folds)
      if (cells_of_rank.count(fold.cells[0].cell) > 0)
        for (const QuadrilateralMesh::CellSide &at : fold.cells)
          with_strips.insert(at.cell);
    // the law of plies is asked for also on a rank without cells
    if (with_strips.empty())
      with_strips.insert(0);
    std::map<unsigned int, unsigned int>   strip_of_cell;
    std::vector<std::vector<unsigned int>> layers_of_strips;
    places_of_strips = std::make_shared<const PlacesOfStrips>(
      plies.places(with_strips, strip_of_cell));
    strips  = places_of_strips->make_strips(*this->layup, layers_of_strips);
    n_walls = places_of_strips->places.size();
    collect_from_file(file, supports, plies, strip_of_cell, layers_of_strips);
    complete(supports, mesh.nodes);
  }


  void
  ShellMesh::check_components(const Supports &supports) const
  {
    const auto check = [this](const std::string                   &entry,
                              const std::string                   &text,
                              const std::vector<SupportCondition> &conditions) {
      // all three together hold whatever the directions are
      std::set<Component> components;
      for (const SupportCondition &condition : conditions)
        components.insert(condition.component);
      const bool has_1 = components.count(Component::v_1) > 0,
                 has_2 = components.count(Component::v_2) > 0;
      if (has_1 != has_2 ||
          (has_1 && std::any_of(conditions.begin(),
                                conditions.end(),
                                [](const SupportCondition &condition) {
                                  return condition.is_prescribed;
                                })))
        require_direction(entry, text);
    };
    for (const EdgeSupport &edge : supports.named_edges)
      check("Supports/Edge supports", edge.text, edge.conditions);
    for (const PointSupport &point : supports.points)
      check("Supports/Point supports", point.point, point.conditions);
  }


  void
  ShellMesh::collect_from_file(
    const MeshFile                               &file,
    const Supports                               &supports,
    const PliesOfCells                           &plies,
    const std::map<unsigned int, unsigned int>   &strip_of_cell,
    const std::vector<std::vector<unsigned int>> &layers_of_strips)
  {
    const QuadrilateralMesh &mesh = *file.mesh;

    // groups of lines or several nodes, and the cells of their sides
    std::map<Side, NamedSide> named_sides;
    std::vector<unsigned int> group_of_edge;
    for (unsigned int g = 0; g < mesh.groups.size(); ++g)
      if (mesh.groups[g].nodes.size() > 1)
        {
          for (const Side &side : mesh.groups[g].sides)
            named_sides[side].edges.push_back(edges.size());
          edges.push_back({mesh.groups[g].name, {}});
          group_of_edge.push_back(g);
        }
    const std::vector<Tensor<1, 3>> normals =
      normals_in_planes(mesh,
                        supports.named_edges,
                        *this,
                        group_of_edge,
                        file.options.fold_angle);
    if (!(thickness() < size()))
      throw InputError(
        "the plies of 'Laminate/Plies' are " + number_to_string(thickness()) +
        " thick, but the whole mesh is only " + number_to_string(size()) +
        " large: it must be in the same unit of length.");
    check_directions(file, *layup);
    check_faces(mesh, normals, plies);
    // elements are numbered without gaps
    std::vector<types::global_cell_index> first_of_cells{0};
    for (unsigned int c = 0; c < mesh.cells.size(); ++c)
      first_of_cells.push_back(first_of_cells.back() + plies.n_elements(c));
    std::vector<unsigned int> stiffest;
    for (unsigned int n = 0; n < mesh.nodes.size(); ++n)
      {
        stiffest.push_back(plies.stiffest(n));
        if (stiffest.back() == numbers::invalid_unsigned_int)
          throw InputError(
            "the entry 'Laminate/Layers' has no layer with plies in all cells "
            "around the node at (" +
            vector_to_string(mesh.nodes[n]) +
            "), where the wall would be a hinge: put plies of all of them into "
            "one layer.");
      }
    // of all nodes on all ranks, which must answer a faulty formula together
    std::vector<Tensor<1, 3>> directions;
    for (unsigned int n = 0; n < mesh.nodes.size(); ++n)
      {
        directions.push_back(file.direction_at(mesh.nodes[n]));
        if (!has_direction(normals[n], directions[n]))
          place_without_direction = mesh.nodes[n];
      }
    check_components(supports);

    for (unsigned int c = 0; c < mesh.cells.size(); ++c)
      for (unsigned int f = 0; f < 4; ++f)
        {
          const auto named = named_sides.find(
            QuadrilateralMesh::without_direction(mesh.side(c, f)));
          if (named == named_sides.end())
            continue;
          if (named->second.cell == numbers::invalid_unsigned_int)
            named->second.cell = c;
          else
            for (const unsigned int edge : named->second.edges)
              edges[edge].is_inside = true;
        }

    const auto make_node = [&](const unsigned int number) {
      constexpr double nan = std::numeric_limits<double>::quiet_NaN();
      Node             node;
      node.grid_index        = {{0, 0}};
      node.number            = number;
      node.alpha             = Point<2>(nan, nan);
      node.surface.position  = mesh.nodes[number];
      node.surface.frame     = frame_along(normals[number], directions[number]);
      node.surface.lame      = {{1, 1}};
      node.surface.curvature = {{0, 0}};
      node.surface.geodesic  = {{0, 0}};
      const std::vector<double> heights = plies.mean_heights(number);
      node.face_heights                 = {{heights.front(), heights.back()}};
      for (unsigned int k = 0; k < n_layers(); ++k)
        node.half_thickness.push_back((heights[k + 1] - heights[k]) / 2);
      node.locally_owned = false;
      node.face_is_free  = {{true, true}};
      return node;
    };

    std::map<unsigned int, unsigned int> node_of_number;
    std::vector<std::set<unsigned int>>  adjacent;
    std::set<unsigned int>               owned_columns;
    for (const auto &cell : dof_handler->active_cell_iterators())
      {
        if (cell->is_artificial())
          continue;
        const unsigned int          number = cell->id().get_coarse_cell_id();
        std::array<unsigned int, 4> cell_nodes;
        for (unsigned int v = 0; v < 4; ++v)
          {
            const unsigned int of_file = mesh.cells[number][v];
            const auto entry = node_of_number.emplace(of_file, nodes.size());
            cell_nodes[v]    = entry.first->second;
            if (!entry.second)
              continue;
            Node node = make_node(of_file);
            Assert(node.surface.position.distance(cell->vertex(v)) <
                     1e-8 * cell->diameter(),
                   ExcMessage("Coarse cells must be numbered as in the file."));
            for (unsigned int i = 0; i < n_dofs_per_node(); ++i)
              node.dofs.push_back(cell->vertex_dof_index(v, i));
            node.locally_owned = locally_owned.is_element(node.dofs[0]);
            nodes.push_back(node);
          }
        adjacent.resize(nodes.size());
        for (const unsigned int i : cell_nodes)
          adjacent[i].insert(cell_nodes.begin(), cell_nodes.end());

        // cells of other ranks give nodes around, no elements
        if (!cell->is_locally_owned())
          continue;
        owned_columns.insert(number);

        for (unsigned int f = 0; f < 4; ++f)
          {
            const auto named = named_sides.find(
              QuadrilateralMesh::without_direction(mesh.side(number, f)));
            if (named == named_sides.end() || named->second.cell != number)
              continue;
            const std::array<unsigned int, 2> ends{
              {GeometryInfo<2>::face_to_cell_vertices(f, 0),
               GeometryInfo<2>::face_to_cell_vertices(f, 1)}};
            BoundarySegment segment{
              0,
              static_cast<unsigned int>(cells.size()),
              ends,
              {{cell_nodes[ends[0]], cell_nodes[ends[1]]}},
              0,
              {},
              {{0, 0}}};
            const Tensor<1, 3> along =
              nodes[segment.nodes[1]].surface.position -
              nodes[segment.nodes[0]].surface.position;
            segment.length = along.norm();
            // sides 1 and 2 run counterclockwise
            for (unsigned int k = 0; k < 2; ++k)
              {
                Tensor<1, 3> axis =
                  nodes[segment.nodes[k]].surface.to_frame(along);
                axis[2] = 0;
                segment.axes[k] =
                  (f == 1 || f == 2 ? 1 : -1) / axis.norm() * axis;
              }
            for (const unsigned int edge : named->second.edges)
              {
                segment.edge = edge;
                boundary.push_back(segment);
              }
          }

        QuadrilateralPoints points;
        for (unsigned int v = 0; v < 4; ++v)
          points.vertices[v] = nodes[cell_nodes[v]].surface;
        points.direction = frame_of_cell(file, normals, number)[0];
        Column column;
        column.wall           = strip_of_cell.at(number);
        column.layers         = layers_of_strips[column.wall];
        points.wall_thickness = strips[column.wall].laminate.thickness();
        for (unsigned int v = 0; v < 4; ++v)
          {
            column.heights[v]  = plies.heights(number, v);
            column.stiffest[v] = stiffest[mesh.cells[number][v]];
          }
        add_elements(cell_nodes,
                     number,
                     first_of_cells[number],
                     column,
                     [&](const std::array<std::array<double, 2>, 4> &heights) {
                       points.heights = heights;
                       return quadrilateral_geometry(points, normal_thickness);
                     });
      }

    for (const auto &set : adjacent)
      neighbors.emplace_back(set.begin(), set.end());
    add_nodes_of_joints(mesh, make_node, node_of_number);
    n_all_folds = mesh.folds.size();

    for (const QuadrilateralMesh::Fold &fold : mesh.folds)
      {
        const Side side = mesh.side(fold.cells[0].cell, fold.cells[0].face);
        const auto named =
          named_sides.find(QuadrilateralMesh::without_direction(side));
        if (named != named_sides.end())
          for (const unsigned int edge : named->second.edges)
            edges[edge].is_inside = true;
        if (owned_columns.count(fold.cells[0].cell) == 0)
          continue;
        FoldSide here;
        here.stiffness           = fold.stiffness;
        here.wedges              = fold.wedges;
        const Tensor<1, 3> along = mesh.nodes[side[1]] - mesh.nodes[side[0]];
        here.length              = along.norm();
        for (const QuadrilateralMesh::CellSide &at : fold.cells)
          {
            const Side     own = mesh.side(at.cell, at.face);
            FoldSide::Part part;
            part.is_reversed = (mesh.nodes[own[0]] != mesh.nodes[side[0]]);
            for (unsigned int end = 0; end < 2; ++end)
              part.nodes[end] =
                node_of_number.at(own[part.is_reversed ? 1 - end : end]);
            part.strip       = strip_of_cell.at(at.cell);
            const auto frame = frame_of_cell(file, normals, at.cell);
            part.across = Tensor<1, 2>({along * frame[1], -(along * frame[0])});
            part.across /= part.across.norm();
            here.parts.push_back(part);
          }
        folds.push_back(here);
      }
    // where faces end
    std::array<std::set<unsigned int>, 3> in_planes;
    for (const EdgeSupport &support : supports.named_edges)
      if (support.symmetry)
        for (const unsigned int number :
             mesh
               .groups[group_of_edge[find_edge(
                 "Supports/Edge supports", support.text, support.edge)]]
               .nodes)
          {
            in_planes[*support.symmetry].insert(number);
            symmetry_planes[*support.symmetry].push_back(
              mesh.nodes[number][*support.symmetry]);
          }
    const auto add_end = [&](const QuadrilateralMesh::CellSide &at,
                             const unsigned int                 face) {
      if (owned_columns.count(at.cell) > 0)
        for (const unsigned int number : mesh.side(at.cell, at.face))
          ends_of_faces[face].push_back(node_of_number.at(number));
    };
    for (const QuadrilateralMesh::CellSide &at : mesh.free_sides)
      {
        const Side side     = mesh.side(at.cell, at.face);
        const bool in_plane = std::any_of(
          in_planes.begin(), in_planes.end(), [&](const auto &numbers) {
            return numbers.count(side[0]) > 0 && numbers.count(side[1]) > 0;
          });
        for (unsigned int face = 0; face < 2 && !in_plane; ++face)
          add_end(at, face);
      }
    for (const QuadrilateralMesh::Fold &fold : mesh.folds)
      for (unsigned int face = 0; face < 2; ++face)
        if (!fold.is_closed[face])
          for (const QuadrilateralMesh::CellSide &at : fold.cells)
            add_end(at, face);
    for (unsigned int face = 0; face < 2; ++face)
      for (const std::vector<unsigned int> &corner : mesh.corners[face])
        {
          const auto first = node_of_number.find(corner[0]);
          if (first == node_of_number.end() ||
              !nodes[first->second].locally_owned)
            continue;
          corners[face].emplace_back();
          for (const unsigned int number : corner)
            corners[face].back().push_back(node_of_number.at(number));
        }
    for (unsigned int i = 0; i < edges.size(); ++i)
      for (const unsigned int number : mesh.groups[group_of_edge[i]].nodes)
        {
          const auto node = node_of_number.find(number);
          if (node != node_of_number.end())
            edges[i].nodes.push_back(node->second);
        }
  }
} // namespace Biface
