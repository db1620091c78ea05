// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>
#include <deal.II/distributed/fully_distributed_tria.h>
#include <deal.II/distributed/shared_tria.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/tria_description.h>

#include <algorithm>
#include <cmath>

#include <biface/base/errors.h>
#include <biface/input/parameter_tools.h>
#include <biface/model/shell_mesh.h>

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
      if (grid.distribution == MeshDistribution::shared)
        {
          auto shared = std::make_unique<parallel::shared::Triangulation<2, 3>>(
            communicator,
            Triangulation<2, 3>::none,
            true,
            parallel::shared::Triangulation<2, 3>::partition_metis);
          create_triangulation(surface, grid, *shared);
          return shared;
        }

      const unsigned int n_ranks =
        Utilities::MPI::n_mpi_processes(communicator);
      const auto description = TriangulationDescription::Utilities::
        create_description_from_triangulation_in_groups<2, 3>(
          [&](Triangulation<2, 3> &whole) {
            create_triangulation(surface, grid, whole);
          },
          [&](Triangulation<2, 3> &whole, const MPI_Comm &, unsigned int) {
            GridTools::partition_triangulation(
              n_ranks, whole, SparsityTools::Partitioner::metis);
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
  } // namespace


  ShellMesh::ShellMesh(const MPI_Comm                          communicator,
                       std::unique_ptr<const ReferenceSurface> surface,
                       const ChartGrid                        &grid,
                       const Layup                            &layup,
                       const Supports                         &supports,
                       const std::vector<NamedPoint>          &points)
    : communicator(communicator)
    , grid(grid)
    , layup(layup)
    , points(points)
    , surface(std::move(surface))
    , fe(FE_Q<2, 3>(1), 6)
  {
    make_strips(grid);
    check_geometry(grid);
    if (grid.closed)
      for (const Edge edge : {Edge::alpha_2_min, Edge::alpha_2_max})
        if (!supports.edge_conditions(static_cast<unsigned int>(edge)).empty())
          throw InputError(
            "the section 'Supports' holds an edge of alpha_2, but the "
            "coordinate is closed ('Mesh/Closed in alpha_2') and has no edge.");

    triangulation = make_triangulation(communicator, *this->surface, grid);
    dof_handler.reinit(*triangulation);
    dof_handler.distribute_dofs(fe);
    locally_owned = dof_handler.locally_owned_dofs();
    DoFTools::extract_locally_relevant_dofs(dof_handler, locally_relevant);

    const auto box =
      GridTools::compute_bounding_box(*triangulation).get_boundary_points();
    Tensor<1, 3> diagonal;
    for (unsigned int d = 0; d < 3; ++d)
      diagonal[d] = Utilities::MPI::max(box.second[d], communicator) -
                    Utilities::MPI::min(box.first[d], communicator);
    diameter = diagonal.norm();

    collect_cells_and_nodes(grid);
    find_points();
    make_constraints(supports);
  }


  void
  ShellMesh::make_strips(const ChartGrid &grid)
  {
    std::vector<double> lines = grid.lines[0];
    for (double &alpha_1 : lines)
      alpha_1 /= surface->coordinate_unit(0);

    const double span = lines.back() - lines.front();
    // formulas and sentences see 0, not what is left of it
    for (double &alpha_1 : lines)
      if (std::abs(alpha_1) < 1e-14 * span)
        alpha_1 = 0;
    const double tolerance = 1e-7 * span;
    for (const PlyDescription &ply : layup.get_plies())
      for (const double end : {ply.begin, ply.end})
        if (std::isfinite(end) &&
            std::none_of(lines.begin(), lines.end(), [&](const double line) {
              return std::abs(line - end) <= tolerance;
            }))
          throw InputError("Laminate/Plies",
                           ply.text,
                           "a ply must begin and end at lines of the mesh, and "
                           "there is none at alpha_1 = " +
                             number_to_string(end));

    line_faces.resize(lines.size());
    for (unsigned int i = 0; i + 1 < lines.size(); ++i)
      {
        const double middle = (lines[i] + lines[i + 1]) / 2;
        strips.push_back({layup.laminate(middle),
                          {{layup.laminate(lines[i], middle),
                            layup.laminate(lines[i + 1], middle)}}});
        for (unsigned int side = 0; side < 2; ++side)
          for (unsigned int face = 0; face < 2; ++face)
            line_faces[i + side][face] +=
              strips[i].at_lines[side].face_heights()[face] / 2;
      }
    // lines at the edges have one side only
    for (unsigned int face = 0; face < 2; ++face)
      {
        line_faces.front()[face] *= 2;
        line_faces.back()[face] *= 2;
      }
    for (const auto &faces : line_faces)
      greatest_thickness = std::max(greatest_thickness, faces[1] - faces[0]);
  }


  void
  ShellMesh::check_geometry(const ChartGrid &grid) const
  {
    double size = 0;
    for (const double alpha_1 : grid.lines[0])
      size = std::max(
        size,
        surface->evaluate(Point<2>(alpha_1, grid.lines[1][0])).position.norm());

    for (unsigned int i = 0; i < grid.lines[0].size(); ++i)
      for (const double alpha_2 : grid.lines[1])
        {
          const double                 alpha_1 = grid.lines[0][i];
          const std::array<double, 2> &faces   = line_faces[i];
          const SurfacePoint           point =
            surface->evaluate(Point<2>(alpha_1, alpha_2));
          const std::string where =
            "alpha_1 = " + coordinate_to_string(
                             alpha_1 / surface->coordinate_unit(0),
                             (grid.lines[0].back() - grid.lines[0].front()) /
                               surface->coordinate_unit(0));

          if (!(point.lame[0] > 1e-8 * size && point.lame[1] > 1e-8 * size))
            throw InputError("the entry 'Mesh/Intervals alpha_1' reaches " +
                             where + ", where the radius of the surface is " +
                             number_to_string(point.lame[1]) +
                             ", but the surface must keep clear of its axis "
                             "(A_2 > 0).");

          const ThicknessMetric metric(point.curvature, faces);
          for (unsigned int face = 0; face < 2; ++face)
            for (unsigned int a = 0; a < 2; ++a)
              if (!(metric.zeta[face][a] > 0))
                throw InputError(
                  "the entry 'Laminate/Plies' puts a face at " +
                  number_to_string(faces[face]) +
                  " from the reference surface, but at " + where +
                  " it must stay nearer than the center of curvature, " +
                  number_to_string(1 / std::abs(point.curvature[a])) +
                  " away.");
        }
  }


  LA::Vector
  ShellMesh::ghosted_vector() const
  {
    return LA::Vector(locally_owned, locally_relevant, communicator);
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
      v[i] = V(node.dofs[2 * i + face]);
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
    Vector<double>                       local(MixedElement::n_dofs);
    std::vector<types::global_dof_index> dofs(cell.dofs.begin(),
                                              cell.dofs.end());
    for (unsigned int i = 0; i < MixedElement::n_dofs; ++i)
      local[i] = force[i];
    constraints.distribute_local_to_global(local, dofs, nodal_forces);
  }


  MixedElement::NodalVector
  ShellMesh::cell_values(const LA::Vector &V, const Cell &cell) const
  {
    MixedElement::NodalVector values;
    for (unsigned int i = 0; i < MixedElement::n_dofs; ++i)
      values[i] = V(cell.dofs[i]);
    return values;
  }
} // namespace Biface
