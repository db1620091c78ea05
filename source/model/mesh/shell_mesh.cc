// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/mpi.h>
#include <deal.II/distributed/fully_distributed_tria.h>
#include <deal.II/distributed/shared_tria.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/tria_description.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include <biface/base/errors.h>
#include <biface/input/parameter_tools.h>
#include <biface/model/mesh/shell_mesh.h>

#include <boost/signals2/connection.hpp>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    std::unique_ptr<parallel::TriangulationBase<2, 3>>
    make_triangulation(const MPI_Comm          communicator,
                       const ReferenceSurface &surface,
                       const ChartGrid        &grid)
    {
      const unsigned int n_ranks =
        Utilities::MPI::n_mpi_processes(communicator);
      if (grid.distribution == MeshDistribution::shared)
        {
          auto shared = std::make_unique<parallel::shared::Triangulation<2, 3>>(
            communicator,
            Triangulation<2, 3>::none,
            true,
            parallel::shared::Triangulation<2, 3>::partition_custom_signal);
          const boost::signals2::scoped_connection partition =
            shared->signals.create.connect([&, whole = shared.get()] {
              partition_triangulation(surface, grid, n_ranks, *whole);
            });
          create_triangulation(surface, grid, *shared);
          return shared;
        }

      const auto description = TriangulationDescription::Utilities::
        create_description_from_triangulation_in_groups<2, 3>(
          [&](Triangulation<2, 3> &whole) {
            create_triangulation(surface, grid, whole);
          },
          [&](Triangulation<2, 3> &whole, const MPI_Comm &, unsigned int) {
            partition_triangulation(surface, grid, n_ranks, whole);
          },
          communicator,
          n_ranks);
      auto distributed =
        std::make_unique<parallel::fullydistributed::Triangulation<2, 3>>(
          communicator);
      distributed->set_manifold(0, surface);
      distributed->create_triangulation(description);
      return distributed;
    }


    /** The plies between the lines of the first coordinate. Throws InputError
     * if a ply ends between two lines. */
    std::vector<Strip>
    make_strips(const Layup            &layup,
                const ReferenceSurface &surface,
                const ChartGrid        &grid)
    {
      std::vector<double> lines = grid.lines[0];
      for (double &alpha_1 : lines)
        alpha_1 /= surface.coordinate_unit(0);

      const double tolerance = 1e-7 * (lines.back() - lines.front());
      for (const PlyDescription &ply : layup.get_plies())
        for (const double end : {ply.begin, ply.end})
          if (std::isfinite(end) &&
              std::none_of(lines.begin(), lines.end(), [&](const double line) {
                return std::abs(line - end) <= tolerance;
              }))
            throw InputError(
              "Laminate/Plies",
              ply.text,
              "a ply must start and end at mesh lines, and there is none at "
              "alpha_1 = " +
                number_to_string(end));

      std::vector<Strip> strips;
      for (unsigned int i = 0; i + 1 < lines.size(); ++i)
        {
          const double middle = (lines[i] + lines[i + 1]) / 2;
          strips.push_back({layup.laminate(middle),
                            {{layup.laminate(lines[i], middle),
                              layup.laminate(lines[i + 1], middle)}}});
        }
      return strips;
    }


    /** Laminate::face_heights() on each line of the first coordinate: the mean
     * of both sides if a ply ends there. */
    std::vector<std::array<double, 2>>
    face_heights_on_lines(const std::vector<Strip> &strips)
    {
      std::vector<std::array<double, 2>> heights;
      heights.push_back(strips.front().at_lines[0].face_heights());
      for (unsigned int i = 1; i < strips.size(); ++i)
        {
          const auto below = strips[i - 1].at_lines[1].face_heights();
          const auto above = strips[i].at_lines[0].face_heights();
          heights.push_back(
            {{below[0] / 2 + above[0] / 2, below[1] / 2 + above[1] / 2}});
        }
      heights.push_back(strips.back().at_lines[1].face_heights());
      return heights;
    }


    /** On one side of each line: below or above. */
    std::vector<std::array<double, 2>>
    face_heights_on_lines(const std::vector<Strip> &strips,
                          const unsigned int        side)
    {
      std::vector<std::array<double, 2>> heights;
      for (unsigned int i = 0; i <= strips.size(); ++i)
        {
          const bool below = i > 0 && (side == 0 || i == strips.size());
          heights.push_back(below ? strips[i - 1].at_lines[1].face_heights()
                                  : strips[i].at_lines[0].face_heights());
        }
      return heights;
    }


    /** Throw InputError unless the surface and both faces are regular at all
     * nodes. */
    void
    check_geometry(const ReferenceSurface                   &surface,
                   const ChartGrid                          &grid,
                   const std::vector<std::array<double, 2>> &face_heights)
    {
      double size = 0;
      for (const double alpha_1 : grid.lines[0])
        size = std::max(size,
                        surface.evaluate(Point<2>(alpha_1, grid.lines[1][0]))
                          .position.norm());

      for (unsigned int i = 0; i < grid.lines[0].size(); ++i)
        for (const double alpha_2 : grid.lines[1])
          {
            const double                 alpha_1 = grid.lines[0][i];
            const std::array<double, 2> &heights = face_heights[i];
            const SurfacePoint           point =
              surface.evaluate(Point<2>(alpha_1, alpha_2));
            const auto where = [&] {
              return "alpha_1 = " +
                     coordinate_to_string(
                       alpha_1 / surface.coordinate_unit(0),
                       (grid.lines[0].back() - grid.lines[0].front()) /
                         surface.coordinate_unit(0));
            };

            if (!(point.lame[0] > 1e-8 * size && point.lame[1] > 1e-8 * size))
              throw InputError("the entry 'Mesh/Intervals alpha_1' reaches " +
                               where() +
                               ", where the radius of the surface is " +
                               number_to_string(point.lame[1]) +
                               ", but it must be positive everywhere.");

            const ThicknessMetric metric(point.curvature, heights);
            for (unsigned int face = 0; face < 2; ++face)
              for (unsigned int a = 0; a < 2; ++a)
                if (!(metric.zeta[face][a] > 0))
                  throw InputError(
                    "the entry 'Laminate/Plies' places a face at " +
                    number_to_string(heights[face]) +
                    " from the reference surface, but at " + where() +
                    " the center of curvature is only " +
                    number_to_string(1 / std::abs(point.curvature[a])) +
                    " away.");
          }
    }


    /** The diagonal of the box around a triangulation on all ranks. */
    double
    diagonal_of_box(const parallel::TriangulationBase<2, 3> &triangulation)
    {
      const MPI_Comm communicator = triangulation.get_communicator();
      const auto     box =
        GridTools::compute_bounding_box(triangulation).get_boundary_points();
      Tensor<1, 3> diagonal;
      for (unsigned int d = 0; d < 3; ++d)
        diagonal[d] = Utilities::MPI::max(box.second[d], communicator) -
                      Utilities::MPI::min(box.first[d], communicator);
      return diagonal.norm();
    }


    /** Whether any displacement of a face is free: the sum of the two unknowns
     * of a component, with the sign of the face. */
    bool
    face_is_free(const Node                      &node,
                 const unsigned int               face,
                 const AffineConstraints<double> &constraints)
    {
      for (unsigned int i = 0; i < 3; ++i)
        {
          // the derivative of the sum by each unknown
          std::map<types::global_dof_index, double> change;
          for (const auto part :
               {MixedElement::mean, MixedElement::half_difference})
            {
              const auto   dof = node.dof(i, part);
              const double sign =
                (part == MixedElement::mean ? 1.
                                            : MixedElement::face_sign[face]);
              if (!constraints.is_constrained(dof))
                change[dof] += sign;
              else
                for (const auto &entry :
                     *constraints.get_constraint_entries(dof))
                  change[entry.first] += sign * entry.second;
            }
          for (const auto &entry : change)
            if (std::abs(entry.second) > 1e-12)
              return true;
        }
      return false;
    }
  } // namespace


  ShellMesh::ShellMesh(const MPI_Comm                          communicator,
                       std::unique_ptr<const ReferenceSurface> surface,
                       const ChartGrid                        &grid,
                       const Layup                            &layup,
                       const Supports                         &supports,
                       const std::vector<NamedPoint>          &points,
                       const StrainSampling                    sampling,
                       const Interpolation                     interpolation)
    : MeshNodes(communicator, std::move(surface), grid, points)
    , layup(layup)
    , sampling(sampling)
    , interpolation(interpolation)
  {
    strips = make_strips(layup, *this->surface, grid);
    const std::vector<std::array<double, 2>> face_heights =
      face_heights_on_lines(strips);
    for (const auto &heights : face_heights)
      max_thickness = std::max(max_thickness, heights[1] - heights[0]);
    for (const unsigned int side : {0, 1})
      check_geometry(*this->surface, grid, face_heights_on_lines(strips, side));

    triangulation = make_triangulation(communicator, *this->surface, grid);
    const auto new_dof_handler =
      std::make_shared<DoFHandler<2, 3>>(*triangulation);
    new_dof_handler->distribute_dofs(FESystem<2, 3>(FE_Q<2, 3>(1), 6));
    dof_handler   = new_dof_handler;
    locally_owned = dof_handler->locally_owned_dofs();
    DoFTools::extract_locally_relevant_dofs(*dof_handler, locally_relevant);

    diameter = diagonal_of_box(*triangulation);

    collect_cells_and_nodes(face_heights);
    if (supports.is_cyclic())
      add_cyclic_nodes(face_heights);
    locally_relevant.compress();
    for (Cell &cell : cells)
      for (unsigned int i = 0; i < MixedElement::n_dofs; ++i)
        cell.positions[i] = locally_relevant.index_within_set(cell.dofs[i]);
    find_points();
    make_constraints(supports, *this, constraints, prescribed, supported);

    for (Node &node : nodes)
      for (const auto face : {Resultants::inner, Resultants::outer})
        node.face_is_free[face] = face_is_free(node, face, constraints);
    types::global_dof_index n_owned_free = 0;
    for (const auto dof : locally_owned)
      if (!constraints.is_constrained(dof))
        ++n_owned_free;
    n_free = Utilities::MPI::sum(n_owned_free, communicator);
  }


  std::shared_ptr<const ShellMesh>
  ShellMesh::with_layup(const Layup &other) const
  {
    const std::shared_ptr<ShellMesh> result(new ShellMesh(*this));
    result->layup  = other;
    result->strips = make_strips(other, *surface, grid);
    for (unsigned int i = 0; i < strips.size(); ++i)
      for (unsigned int line = 0; line < 2; ++line)
        if (result->strips[i].at_lines[line].face_heights() !=
            strips[i].at_lines[line].face_heights())
          return nullptr;
    return result;
  }


  void
  ShellMesh::collect_cells_and_nodes(
    const std::vector<std::array<double, 2>> &face_heights)
  {
    const auto face_offsets = [&](const Cell                       &cell,
                                  const ShellFEValues::FaceHeights &heights)
      -> decltype(Cell::face_offsets) {
      std::array<Cell::FaceOffset, 4> offsets;
      bool                            any = false;
      for (unsigned int v = 0; v < 4; ++v)
        {
          const std::array<double, 2> &own  = heights[v];
          const std::array<double, 2> &node = nodes[cell.nodes[v]].face_heights;
          if (own == node)
            continue;
          any                    = true;
          const double thickness = node[1] - node[0];
          offsets[v].s = (own[1] + own[0] - node[1] - node[0]) / thickness;
          offsets[v].r = (own[1] - own[0]) / thickness;
        }
      if (any)
        return offsets;
      return {};
    };

    ShellFEValues fe_values(*surface, sampling, interpolation);

    // map from the vertices of the triangulation to the nodes of this rank
    std::vector<unsigned int> node_of_vertex(triangulation->n_vertices(),
                                             numbers::invalid_unsigned_int);

    const auto add_node =
      [&](const DoFHandler<2, 3>::active_cell_iterator &cell,
          const unsigned int                            v,
          const GridIndex                              &grid_index) {
        unsigned int &index = node_of_vertex[cell->vertex_index(v)];
        if (index != numbers::invalid_unsigned_int)
          return index;

        Node node;
        node.grid_index   = grid_index;
        node.alpha        = grid.alpha(grid_index);
        node.face_heights = face_heights[grid_index[0]];
        node.surface      = surface->evaluate(node.alpha);
        node.number       = grid.node_number(grid_index);
        Assert(node.surface.position.distance(cell->vertex(v)) <
                 1e-8 * cell->diameter(),
               ExcMessage("Coarse cells must be numbered as in the grid."));
        for (unsigned int i = 0; i < 6; ++i)
          node.dofs[i] = cell->vertex_dof_index(v, i);
        node.locally_owned = locally_owned.is_element(node.dofs[0]);
        node.face_is_free  = {{true, true}};
        index              = nodes.size();
        nodes.push_back(node);
        return index;
      };

    std::vector<std::set<unsigned int>> adjacent;
    for (const auto &cell : dof_handler->active_cell_iterators())
      {
        if (cell->is_artificial())
          continue;

        const types::global_cell_index number = cell->id().get_coarse_cell_id();
        const GridIndex                cell_index = grid.cell_index(number);
        std::array<unsigned int, 4>    cell_nodes;
        for (unsigned int v = 0; v < 4; ++v)
          cell_nodes[v] = add_node(cell, v, grid.node_of_cell(cell_index, v));
        adjacent.resize(nodes.size());
        for (const unsigned int i : cell_nodes)
          adjacent[i].insert(cell_nodes.begin(), cell_nodes.end());

        if (!cell->is_locally_owned())
          continue;

        for (const unsigned int f : cell->face_indices())
          if (cell->at_boundary(f))
            {
              const std::array<unsigned int, 2> ends{
                {GeometryInfo<2>::face_to_cell_vertices(f, 0),
                 GeometryInfo<2>::face_to_cell_vertices(f, 1)}};
              const std::array<unsigned int, 2> side{
                {cell_nodes[ends[0]], cell_nodes[ends[1]]}};

              // the coordinate that runs along the side
              const unsigned int a      = 1 - f / 2;
              const double       start  = grid.lines[a][cell_index[a]];
              const double       end    = grid.lines[a][cell_index[a] + 1];
              Point<2>           middle = nodes[side[0]].alpha;
              middle[a]                 = (start + end) / 2;
              boundary.push_back(
                {static_cast<Edge>(cell->face(f)->boundary_id()),
                 static_cast<unsigned int>(cells.size()),
                 ends,
                 side,
                 (end - start) * surface->evaluate(middle).lame[a]});
            }

        Cell local;
        local.nodes  = cell_nodes;
        local.strip  = cell_index[0];
        local.number = number;
        ShellFEValues::FaceHeights heights;
        for (unsigned int v = 0; v < 4; ++v)
          {
            // the vertices with the larger alpha_1 are the odd ones
            heights[v] = strips[local.strip].at_lines[v % 2].face_heights();
            for (unsigned int i = 0; i < 6; ++i)
              local.dofs[6 * v + i] = cell->vertex_dof_index(v, i);
          }
        local.face_offsets = face_offsets(local, heights);
        fe_values.reinit(cell, heights);
        local.geometry = fe_values.get_geometry();
        cells.push_back(local);
      }

    for (const auto &set : adjacent)
      neighbors.emplace_back(set.begin(), set.end());
  }


  void
  ShellMesh::add_cyclic_nodes(
    const std::vector<std::array<double, 2>> &face_heights)
  {
    // the two lines next to either edge: those on the other side enter the
    // equations of the nodes on an edge
    const unsigned int                last = grid.n_nodes(1) - 1;
    const std::array<unsigned int, 4> lines{{0, 1, last - 1, last}};

    std::map<types::global_cell_index, unsigned int> known;
    for (unsigned int n = 0; n < nodes.size(); ++n)
      known[nodes[n].number] = n;

    // the unknowns of these nodes, from the ranks that own them
    std::vector<types::global_dof_index> dofs(4 * 6 * grid.n_nodes(0));
    const auto position = [&](const unsigned int line, const unsigned int i) {
      return 6 * (line * grid.n_nodes(0) + i);
    };
    for (unsigned int line = 0; line < 4; ++line)
      for (unsigned int i = 0; i < grid.n_nodes(0); ++i)
        {
          const auto node = known.find(grid.node_number({{i, lines[line]}}));
          if (node != known.end() && nodes[node->second].locally_owned)
            for (unsigned int d = 0; d < 6; ++d)
              dofs[position(line, i) + d] = nodes[node->second].dofs[d];
        }
    Utilities::MPI::sum(dofs, communicator, dofs);

    const unsigned int n_known = nodes.size();
    for (unsigned int n = 0; n < n_known; ++n)
      for (unsigned int line = 0; line < 4; ++line)
        {
          const GridIndex    at   = nodes[n].grid_index;
          const unsigned int from = (line < 2 ? last : 0);
          if (at[1] != from)
            continue;
          const unsigned int begin = (at[0] == 0 ? 0 : at[0] - 1);
          const unsigned int end   = std::min(at[0] + 2, grid.n_nodes(0));
          for (unsigned int i = begin; i < end; ++i)
            {
              const GridIndex other{{i, lines[line]}};
              if (known.count(grid.node_number(other)) > 0)
                continue;
              Node node;
              node.grid_index   = other;
              node.alpha        = grid.alpha(other);
              node.face_heights = face_heights[i];
              node.surface      = surface->evaluate(node.alpha);
              node.number       = grid.node_number(other);
              for (unsigned int d = 0; d < 6; ++d)
                node.dofs[d] = dofs[position(line, i) + d];
              node.locally_owned = false;
              node.face_is_free  = {{true, true}};
              known[node.number] = nodes.size();
              locally_relevant.add_indices(node.dofs.begin(), node.dofs.end());
              neighbors.push_back({static_cast<unsigned int>(nodes.size())});
              nodes.push_back(node);
            }
        }
  }


  void
  Cell::to_own_faces(MixedElement::NodalVector &V) const
  {
    if (!face_offsets)
      return;
    for (unsigned int v = 0; v < 4; ++v)
      for (unsigned int i = 0; i < 3; ++i)
        {
          double &mean = V[MixedElement::dof(v, i, MixedElement::mean)];
          double &difference =
            V[MixedElement::dof(v, i, MixedElement::half_difference)];
          mean += (*face_offsets)[v].s * difference;
          difference *= (*face_offsets)[v].r;
        }
  }


  void
  Cell::to_nodes(MixedElement::NodalVector &forces) const
  {
    if (!face_offsets)
      return;
    for (unsigned int v = 0; v < 4; ++v)
      for (unsigned int i = 0; i < 3; ++i)
        {
          const double mean =
            forces[MixedElement::dof(v, i, MixedElement::mean)];
          double &difference =
            forces[MixedElement::dof(v, i, MixedElement::half_difference)];
          difference =
            (*face_offsets)[v].s * mean + (*face_offsets)[v].r * difference;
        }
  }


  void
  Cell::to_nodes(MixedElement::NodalMatrix &K) const
  {
    if (!face_offsets)
      return;
    // rows, then columns
    for (const bool rows : {true, false})
      for (unsigned int k = 0; k < MixedElement::n_dofs; ++k)
        {
          MixedElement::NodalVector line;
          for (unsigned int l = 0; l < MixedElement::n_dofs; ++l)
            line[l] = (rows ? K[l][k] : K[k][l]);
          to_nodes(line);
          for (unsigned int l = 0; l < MixedElement::n_dofs; ++l)
            (rows ? K[l][k] : K[k][l]) = line[l];
        }
  }


  double
  Cell::sign_of_face(const unsigned int vertex, const unsigned int face) const
  {
    const double sign = MixedElement::face_sign[face];
    if (!face_offsets)
      return sign;
    const FaceOffset &offset = (*face_offsets)[vertex];
    return (sign - offset.s) / offset.r;
  }


  LA::Vector
  ShellMesh::ghosted_vector() const
  {
    return LA::Vector(locally_owned, locally_relevant, communicator);
  }


  double
  ShellMesh::wall_stiffness() const
  {
    double minimum = std::numeric_limits<double>::infinity();
    for (const Strip &strip : strips)
      minimum = std::min(
        {minimum,
         strip.laminate.thickness_stiffness(),
         1000 * strip.laminate.membrane_stiffness() / (size() * size())});
    return minimum;
  }


  bool
  ShellMesh::prescribes_displacements() const
  {
    return Utilities::MPI::logical_or(!prescribed.empty(), communicator);
  }


  bool
  ShellMesh::prescribes_displacements(const unsigned int factor) const
  {
    return Utilities::MPI::logical_or(
      std::any_of(prescribed.begin(),
                  prescribed.end(),
                  [factor](const PrescribedDisplacement &p) {
                    return factor < p.values.size() && p.values[factor] != 0;
                  }),
      communicator);
  }


  LA::Vector
  ShellMesh::owned_vector() const
  {
    return LA::Vector(locally_owned, communicator);
  }


  Tensor<1, 3>
  ShellMesh::displacement(const LA::Vector  &V,
                          const Node        &node,
                          const unsigned int face) const
  {
    Tensor<1, 3> v;
    for (unsigned int i = 0; i < 3; ++i)
      v[i] = V(node.dof(i, MixedElement::mean)) +
             MixedElement::face_sign[face] *
               V(node.dof(i, MixedElement::half_difference));
    return v;
  }


  Point<3>
  ShellMesh::deformed_position(const LA::Vector  &V,
                               const Node        &node,
                               const unsigned int face) const
  {
    return node.surface.position +
           node.face_heights[face] * node.surface.frame[2] +
           node.surface.from_frame(displacement(V, node, face));
  }


  void
  ShellMesh::add_nodal_forces(const Cell                      &cell,
                              const MixedElement::NodalVector &force,
                              LA::Vector &nodal_forces) const
  {
    MixedElement::NodalVector on_nodes = force;
    cell.to_nodes(on_nodes);
    nodal_forces.add(
      MixedElement::n_dofs, cell.dofs.data(), on_nodes.begin_raw());
  }


  void
  ShellMesh::condense(LA::Vector &nodal_forces) const
  {
    for (const auto &line : constraints.get_lines())
      if (locally_owned.is_element(line.index))
        {
          const double force = nodal_forces(line.index);
          for (const auto &entry : line.entries)
            {
              const double part = entry.second * force;
              nodal_forces.add(1, &entry.first, &part);
            }
        }
    nodal_forces.compress(VectorOperation::add);
    for (const auto &line : constraints.get_lines())
      if (locally_owned.is_element(line.index))
        nodal_forces(line.index) = 0;
    nodal_forces.compress(VectorOperation::insert);
  }


  Tensor<1, 3>
  ShellMesh::force_on_face(const LA::Vector  &nodal_forces,
                           const Node        &node,
                           const unsigned int face) const
  {
    Tensor<1, 3> force;
    for (unsigned int i = 0; i < 3; ++i)
      force[i] = (nodal_forces(node.dof(i, MixedElement::mean)) +
                  MixedElement::face_sign[face] *
                    nodal_forces(node.dof(i, MixedElement::half_difference))) /
                 2;
    return force;
  }


  MixedElement::NodalVector
  ShellMesh::cell_values(const LA::Vector &V, const Cell &cell) const
  {
    AssertDimension(V.trilinos_vector().MyLength(),
                    static_cast<int>(locally_relevant.n_elements()));
    // not V(dof), which searches the number of each entry
    const double *const       entries = V.begin();
    MixedElement::NodalVector values;
    for (unsigned int i = 0; i < MixedElement::n_dofs; ++i)
      values[i] = entries[cell.positions[i]];
    cell.to_own_faces(values);
    return values;
  }


  std::vector<std::vector<double>>
  evaluate_at_nodes(const std::vector<Formula> &formulas, const ShellMesh &mesh)
  {
    const ReferenceSurface          &surface = mesh.get_surface();
    std::vector<std::vector<double>> values;
    agree_on_errors(mesh.communicator, [&]() {
      for (const Node &node : mesh.nodes)
        {
          const Point<3> &p = node.surface.position;
          values.emplace_back();
          for (const Formula &formula : formulas)
            values.back().push_back(
              formula({p[0],
                       p[1],
                       p[2],
                       node.alpha[0] / surface.coordinate_unit(0),
                       node.alpha[1] / surface.coordinate_unit(1)}));
        }
    });
    return values;
  }
} // namespace Biface
