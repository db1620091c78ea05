// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>

#include <array>
#include <limits>

#include <biface/laminate/layup.h>
#include <biface/model/equations/shell_equations.h>
#include <biface/model/mesh/strip.h>
#include <biface/model/quantities/cyclic_loss.h>
#include <biface/model/quantities/hysteresis.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    /** Across a strip of cells. */
    constexpr unsigned int n_points = 2;

    /** The strains of the faces at points across a cell, in its middle around
     * the axle. */
    using CellStrains = std::array<Resultants::Vector, n_points>;

    CellStrains
    strains_across(const Modes::Vector &modes)
    {
      const auto             at_vertices = Modes::at_vertices(modes);
      static const QGauss<1> quadrature(n_points);
      CellStrains            strains;
      for (unsigned int g = 0; g < n_points; ++g)
        {
          const double s = quadrature.point(g)[0];
          strains[g]     = ((1 - s) * (at_vertices[0] + at_vertices[2]) +
                        s * (at_vertices[1] + at_vertices[3])) /
                       2;
        }
      return strains;
    }


    /** Strains of the cells of a strip, around the axle. */
    using StripStrains = std::vector<CellStrains>;

    /** A row of the product of a matrix and strains around the axle. */
    CellStrains
    product(const FullMatrix<double> &matrix,
            const unsigned int        row,
            const StripStrains       &strains)
    {
      CellStrains result;
      for (unsigned int k = 0; k < strains.size(); ++k)
        for (unsigned int g = 0; g < n_points; ++g)
          result[g] += matrix(row, k) * strains[k][g];
      return result;
    }


    /** The integrals of the stresses of @p E with the strains of @p F over the
     * thickness, times the loss factor: of ply @p p. */
    double
    loss_of_ply(const Laminate           &laminate,
                const unsigned int        p,
                const Resultants::Vector &E,
                const Resultants::Vector &F)
    {
      // in a plate, exact also for the shear stresses of equilibrium
      static const QGauss<1>  quadrature(3);
      const std::vector<Ply> &plies  = laminate.get_plies();
      double                  bottom = 0;
      for (unsigned int below = 0; below < p; ++below)
        bottom += plies[below].thickness;
      double work = 0;
      for (unsigned int q = 0; q < quadrature.size(); ++q)
        {
          const double z = bottom + quadrature.point(q)[0] * plies[p].thickness;
          work += quadrature.weight(q) * plies[p].thickness *
                  laminate.area_ratio(z) *
                  (laminate.stress(E, p, z) * laminate.strain(F, p, z));
        }
      return plies[p].material.loss_factor * work;
    }


    /** Energies by strip of the wall and ply, on this rank; first all of them,
     * then those of the first harmonics. */
    class Energies
    {
    public:
      explicit Energies(const ShellMesh &mesh)
        : mesh(mesh)
        , n_plies(mesh.get_layup().get_plies().size())
        , values(2 * mesh.n_strips() * n_plies)
      {}

      double &
      at(const unsigned int strip,
         const unsigned int ply,
         const bool         first_harmonics = false)
      {
        return values[(first_harmonics * mesh.n_strips() + strip) * n_plies +
                      ply];
      }

      /** Of a cell. */
      double &
      at(const Cell &cell, const Ply &ply, const bool first_harmonics = false)
      {
        return at(
          mesh.grid.cell_index(cell.column)[0], ply.number, first_harmonics);
      }

      void
      sum_over_ranks()
      {
        Utilities::MPI::sum(values, mesh.communicator, values);
      }

    private:
      const ShellMesh    &mesh;
      unsigned int        n_plies;
      std::vector<double> values;
    };


    void
    add_relaxation(const ShellEquations &equations,
                   const State          &state,
                   const double          angular_velocity,
                   Energies             &energies)
    {
      const ShellMesh &mesh = equations.mesh;
      const auto       of_cells =
        equations.internal_forces().losses(state, angular_velocity);
      for (const unsigned int c : mesh.layers)
        {
          const Cell             &cell = mesh.cells[c];
          const std::vector<Ply> &plies =
            mesh.strips[cell.strip].laminate.get_plies();
          for (unsigned int p = 0; p < plies.size(); ++p)
            energies.at(cell, plies[p]) +=
              cell.geometry.weight * of_cells[c][p];
        }
    }
  } // namespace


  double
  Hysteresis::energy() const
  {
    double sum = 0;
    for (const OfPly &ply : plies)
      sum += ply.energy;
    return sum;
  }


  Hysteresis
  find_hysteresis(const ShellEquations &equations,
                  const State          &state,
                  const double          angular_velocity)
  {
    const ShellMesh &mesh = equations.mesh;
    const ChartGrid &grid = mesh.grid;
    Assert(grid.closed, ExcInternalError());

    const unsigned int  n_around = grid.n_cells(1);
    std::vector<double> middles(n_around);
    for (unsigned int j = 0; j < n_around; ++j)
      middles[j] = (grid.lines[1][j] + grid.lines[1][j + 1]) / 2;
    // a particle passes the middles of all cells of its line in a turn
    const CyclicLoss all(middles),
      first(middles, Hysteresis::n_first_harmonics);

    std::vector<std::vector<unsigned int>> own_cells(mesh.strips.size());
    for (const unsigned int c : mesh.layers)
      own_cells[mesh.cells[c].strip].push_back(c);
    const auto around = [&](const unsigned int c) {
      return grid.cell_index(mesh.cells[c].column)[1];
    };

    Energies energies(mesh);
    for (unsigned int strip = 0; strip < mesh.strips.size(); ++strip)
      {
        constexpr unsigned int n_values = n_points * Resultants::n;
        // the strains of all cells, and the area of the strip
        std::vector<double> values(n_around * n_values + 1);
        for (const unsigned int c : own_cells[strip])
          {
            const CellStrains strains = strains_across(
              equations.internal_forces().total_strains(state, c));
            for (unsigned int g = 0; g < n_points; ++g)
              for (unsigned int i = 0; i < Resultants::n; ++i)
                values[around(c) * n_values + g * Resultants::n + i] =
                  strains[g][i];
            values.back() += mesh.cells[c].geometry.weight;
          }
        // the cells of a line may belong to several ranks
        Utilities::MPI::sum(values, mesh.communicator, values);
        StripStrains strains(n_around);
        for (unsigned int j = 0; j < n_around; ++j)
          for (unsigned int g = 0; g < n_points; ++g)
            for (unsigned int i = 0; i < Resultants::n; ++i)
              strains[j][g][i] = values[j * n_values + g * Resultants::n + i];

        const Laminate         &laminate = mesh.strips[strip].laminate;
        const std::vector<Ply> &plies    = laminate.get_plies();
        for (const unsigned int c : own_cells[strip])
          {
            const unsigned int j        = around(c);
            const CellStrains  of_all   = product(all.matrix(), j, strains);
            const CellStrains  of_first = product(first.matrix(), j, strains);
            for (unsigned int p = 0; p < plies.size(); ++p)
              if (plies[p].material.loss_factor > 0)
                for (unsigned int g = 0; g < n_points; ++g)
                  {
                    // all particles of a ring have the same loss: that of one
                    // of them, times the area of the ring
                    const double area = values.back() / n_points;
                    energies.at(mesh.cells[c], plies[p]) +=
                      area * loss_of_ply(laminate, p, strains[j][g], of_all[g]);
                    energies.at(mesh.cells[c], plies[p], true) +=
                      area *
                      loss_of_ply(laminate, p, strains[j][g], of_first[g]);
                  }
          }
      }
    if (mesh.get_layup().relaxes())
      add_relaxation(equations, state, angular_velocity, energies);
    energies.sum_over_ranks();

    const auto &plies = mesh.get_layup().get_plies();
    Hysteresis  result;
    result.by_strip.reinit(mesh.n_strips(), plies.size());
    for (unsigned int p = 0; p < plies.size(); ++p)
      {
        Hysteresis::OfPly ply;
        for (unsigned int i = 0; i < mesh.n_strips(); ++i)
          {
            result.by_strip(i, p) = energies.at(i, p);
            ply.energy += energies.at(i, p);
            ply.of_first_harmonics += energies.at(i, p, true);
          }
        if (plies[p].material.relaxes)
          {
            result.of_relaxation += ply.energy;
            ply.of_first_harmonics = std::numeric_limits<double>::quiet_NaN();
          }
        result.plies.push_back(ply);
      }
    return result;
  }
} // namespace Biface
