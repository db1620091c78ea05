// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include <biface/laminate/material.h>
#include <biface/output/fiber_tension.h>

namespace Biface
{
  using namespace dealii;

  double
  fiber_tension(const Laminate           &laminate,
                const unsigned int        p,
                const Resultants::Vector &E)
  {
    // exact unless a part of the cords in the ply is slack
    static const QGauss<1> gauss(2);

    const Ply &ply   = laminate.get_plies()[p];
    double     below = 0;
    for (unsigned int q = 0; q < p; ++q)
      below += laminate.get_plies()[q].thickness;
    double tension = ply.initial_stress[0][0] * ply.thickness;
    for (unsigned int g = 0; g < gauss.size(); ++g)
      tension +=
        gauss.weight(g) * ply.thickness *
        rotate_about_normal(
          laminate.stress(E, p, below + gauss.point(g)[0] * ply.thickness),
          -ply.angle)[0][0];
    return tension;
  }


  double
  TensionMembers::tension(const Layup              &layup,
                          const Laminate           &laminate,
                          const unsigned int        p,
                          const Resultants::Vector &E) const
  {
    const Ply &ply = laminate.get_plies()[p];
    if (of_cords)
      return ply.cord_pitch > 0 ? fiber_tension(laminate, p, E) * ply.cord_pitch
                                : std::numeric_limits<double>::quiet_NaN();
    return layup.get_plies()[ply.number].has_fibers
             ? fiber_tension(laminate, p, E)
             : std::numeric_limits<double>::quiet_NaN();
  }


  MaximumTension
  find_maximum_tension(const ShellEquations &equations, const State &state)
  {
    // well above the round-off of a solution, below what matters
    constexpr double tolerance = 1e-6;

    const ShellMesh     &mesh = equations.mesh;
    const TensionMembers members(mesh.layup);
    MaximumTension       maximum;
    if (!members.exist())
      return maximum;

    constexpr double          none = -std::numeric_limits<double>::infinity();
    std::vector<double>       of_cells(mesh.cells.size(), none);
    std::vector<unsigned int> plies(mesh.cells.size());
    for (unsigned int c = 0; c < mesh.cells.size(); ++c)
      {
        const Laminate    &laminate = mesh.strips[mesh.cells[c].strip].laminate;
        Resultants::Vector E;
        for (const Resultants::Vector &E_v : Modes::at_vertices(
               equations.internal_forces().total_strains(state, c)))
          E += E_v / 4.;
        for (unsigned int p = 0; p < laminate.get_plies().size(); ++p)
          {
            const double tension = members.tension(mesh.layup, laminate, p, E);
            // the first of plies that differ by round-off
            if (tension > of_cells[c] + tolerance * std::abs(of_cells[c]) ||
                (of_cells[c] == none && !std::isnan(tension)))
              {
                of_cells[c] = tension;
                plies[c]    = laminate.get_plies()[p].number;
              }
          }
      }
    const double largest = Utilities::MPI::max(
      of_cells.empty() ? none
                       : *std::max_element(of_cells.begin(), of_cells.end()),
      mesh.communicator);
    if (largest == none)
      return maximum;
    maximum.value = largest;

    const double             bound = largest - tolerance * std::abs(largest);
    types::global_cell_index first =
      std::numeric_limits<types::global_cell_index>::max();
    unsigned int ply = 0;
    for (unsigned int c = 0; c < mesh.cells.size(); ++c)
      if (of_cells[c] >= bound && mesh.cells[c].number < first)
        {
          first = mesh.cells[c].number;
          ply   = plies[c] + 1;
        }
    const auto first_of_all = Utilities::MPI::min(first, mesh.communicator);
    maximum.ply =
      Utilities::MPI::max(first == first_of_all ? ply : 0, mesh.communicator);
    const GridIndex cell = mesh.grid.cell_index(first_of_all);
    for (unsigned int a = 0; a < 2; ++a)
      maximum.alpha[a] =
        std::round(
          (mesh.grid.lines[a][cell[a]] + mesh.grid.lines[a][cell[a] + 1]) / 2 /
          mesh.get_surface().coordinate_unit(a) * 1e9) /
        1e9;
    return maximum;
  }
} // namespace Biface
