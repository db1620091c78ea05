// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>

#include <cmath>
#include <map>
#include <vector>

#include <biface/laminate/material.h>
#include <biface/model/equations/shell_equations.h>
#include <biface/model/mesh/cell_maximum.h>
#include <biface/model/mesh/strip.h>
#include <biface/output/fiber_tension.h>
#include <biface/surface/reference_surface.h>

namespace Biface
{
  using namespace dealii;

  double
  force_per_stress(const Ply &ply, const double strain)
  {
    // the stress is the second Piola-Kirchhoff one: the force per undeformed
    // area is the stretch times it
    return ply.laws.rubber ? std::sqrt(1 + 2 * strain) : 1.;
  }


  double
  fiber_tension(const Laminate       &laminate,
                const unsigned int    p,
                const StrainsOfPlies &E)
  {
    // exact unless a part of the cords in the ply is slack
    static const QGauss<1> gauss(2);

    const Ply &ply   = laminate.get_plies()[p];
    double     below = 0;
    for (unsigned int q = 0; q < p; ++q)
      below += laminate.get_plies()[q].thickness;
    const Tensor<1, 3> along({std::cos(ply.angle), std::sin(ply.angle), 0});
    double             tension = ply.initial_stress[0][0] * ply.thickness;
    for (unsigned int g = 0; g < gauss.size(); ++g)
      {
        const double z      = below + gauss.point(g)[0] * ply.thickness;
        double       stress = along * (laminate.stress(E, p, z) * along);
        if (ply.laws.rubber)
          stress *=
            force_per_stress(ply, along * (laminate.strain(E, p, z) * along));
        tension += gauss.weight(g) * ply.thickness * stress;
      }
    return tension;
  }


  double
  TensionMembers::tension(const Layup          &layup,
                          const Laminate       &laminate,
                          const unsigned int    p,
                          const StrainsOfPlies &E) const
  {
    const Ply &ply = laminate.get_plies()[p];
    if (of_cords)
      return ply.cord_pitch > 0 ? fiber_tension(laminate, p, E) * ply.cord_pitch
                                : std::numeric_limits<double>::quiet_NaN();
    return layup.get_plies()[ply.number].material.has_fibers
             ? fiber_tension(laminate, p, E)
             : std::numeric_limits<double>::quiet_NaN();
  }


  MaximumTension
  find_maximum_tension(const ShellEquations &equations, const State &state)
  {
    constexpr double none = CellMaximum::none;

    const ShellMesh     &mesh = equations.mesh;
    const TensionMembers members(mesh.get_layup());
    MaximumTension       maximum;
    if (!members.exist())
      return maximum;

    std::vector<double>       of_cells(mesh.cells.size(), none);
    std::vector<unsigned int> plies(mesh.cells.size());
    for (const unsigned int wall : mesh.walls)
      {
        // layers may contain parts of a ply
        std::map<unsigned int, double> of_plies;
        const auto [first, end] = mesh.layers_of(wall);
        for (unsigned int c = first; c < end; ++c)
          {
            const Laminate &laminate =
              mesh.strips[mesh.cells[c].strip].laminate;
            const StrainsOfPlies E =
              mean(equations.internal_forces().strains_at_vertices(state, c));
            for (unsigned int p = 0; p < laminate.get_plies().size(); ++p)
              of_plies[laminate.get_plies()[p].number] +=
                members.tension(mesh.get_layup(), laminate, p, E);
          }
        for (const auto &[ply, tension] : of_plies)
          // the first of plies that differ by round-off
          if (tension > of_cells[wall] +
                          CellMaximum::tolerance * std::abs(of_cells[wall]) ||
              (of_cells[wall] == none && !std::isnan(tension)))
            {
              of_cells[wall] = tension;
              plies[wall]    = ply;
            }
      }
    const auto largest = find_cell_maximum(mesh, of_cells);
    if (!largest)
      return maximum;
    maximum.value = largest->value;
    maximum.ply   = Utilities::MPI::max(
      largest->position ? plies[*largest->position] + 1 : 0, mesh.communicator);
    if (!mesh.grid.has_lines())
      {
        maximum.alpha = {{std::numeric_limits<double>::quiet_NaN(),
                          std::numeric_limits<double>::quiet_NaN()}};
        return maximum;
      }
    const GridIndex cell = mesh.grid.cell_index(largest->number);
    for (unsigned int a = 0; a < 2; ++a)
      maximum.alpha[a] =
        std::round(
          (mesh.grid.lines[a][cell[a]] + mesh.grid.lines[a][cell[a] + 1]) / 2 /
          mesh.get_surface().coordinate_unit(a) * 1e9) /
        1e9;
    return maximum;
  }
} // namespace Biface
