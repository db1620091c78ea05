// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>
#include <deal.II/base/numbers.h>
#include <deal.II/base/quadrature_lib.h>

#include <array>
#include <cmath>

#include <biface/base/errors.h>
#include <biface/element/follower_pressure.h>
#include <biface/input/entry_declarations.h>
#include <biface/input/parameter_tools.h>
#include <biface/model/air/air_column.h>
#include <biface/model/state/state.h>
#include <biface/surface/reference_surface.h>

namespace Biface
{
  using namespace dealii;

  void
  AirColumn::Parameters::add_parameters(EntryDeclarations &prm)
  {
    add_optional_number(
      prm,
      "Sound speed",
      sound_speed,
      "none",
      "Speed of sound in the air of a shell of revolution, whose waves along "
      "the circumference are then part of 'Modes' and 'Frequency response': "
      "343000 mm/s at 20 degrees. It needs the 'Ambient pressure', with which "
      "it gives the density. 'none': the air follows the wall at once.",
      Unit("length/time"));
    prm.add_parameter("Adiabatic exponent",
                      exponent,
                      "Ratio of the specific heats of the air in its waves, "
                      "which exchange no heat; see 'Sound speed'.",
                      Patterns::Double(),
                      Unit::none());
  }


  void
  AirColumn::Parameters::check() const
  {
    if (sound_speed)
      check_positive("Gas/Sound speed", *sound_speed);
    if (!(exponent >= 1 && exponent <= 2))
      throw InputError("Gas/Adiabatic exponent",
                       number_to_string(exponent),
                       "it must be from 1 to 2");
    if (!sound_speed && exponent != Parameters().exponent)
      throw InputError("Gas/Adiabatic exponent",
                       number_to_string(exponent),
                       "it needs a 'Sound speed'");
  }


  double
  AirMotion::first_wave() const
  {
    const double n       = compliances.size();
    double       product = 0;
    for (const Section &section : sections)
      product += section.inertia * compliances[section.to] / n;
    return std::pow(2 * numbers::PI / n, 2) / product;
  }


  bool
  AirMotion::is_on_this_rank(const MPI_Comm communicator)
  {
    return Utilities::MPI::this_mpi_process(communicator) + 1 ==
           Utilities::MPI::n_mpi_processes(communicator);
  }


  namespace
  {
    /** The integrals @f$\int dA/r@f$, @f$\int r\,dA@f$ and @f$\int dA@f$
     * between a segment of the face and the cylinder of the rim. */
    std::array<double, 3>
    section_integrals(const std::array<Point<3>, 2> &ends,
                      const Tensor<1, 3>            &axis,
                      const double                   rim_radius)
    {
      const QGauss<1>       rule(3);
      std::array<double, 2> r, z;
      std::array<double, 3> result{};
      for (unsigned int i = 0; i < 2; ++i)
        {
          z[i] = ends[i] * axis;
          r[i] = (ends[i] - z[i] * axis).norm();
        }
      for (unsigned int q = 0; q < rule.size(); ++q)
        {
          const double at = r[0] + rule.point(q)[0] * (r[1] - r[0]);
          const double dz = rule.weight(q) * (z[1] - z[0]);
          result[0] += std::log(at / rim_radius) * dz;
          result[1] += (at * at - rim_radius * rim_radius) / 2 * dz;
          result[2] += (at - rim_radius) * dz;
        }
      return result;
    }
  } // namespace


  AirMotion
  AirColumn::about(const State &state, const double pressure) const
  {
    const ChartGrid   &grid = mesh.grid;
    const unsigned int n = grid.n_cells(1), n_lines = grid.lines[1].size();
    const Tensor<1, 3> axis = mesh.get_surface().axis();

    // by the line, the integrals over the section, of which the cells on both
    // sides know the same
    constexpr unsigned int n_integrals = 3, n_of_line = n_integrals + 3;
    std::vector<double>    of_lines(n_of_line * n_lines);
    const auto             of_line = [&](const unsigned int line,
                             const unsigned int k) -> double             &{
      return of_lines[n_of_line * line + k];
    };
    LA::Vector gradient = mesh.owned_vector();
    for (const Cell &cell : mesh.wall_elements())
      {
        const unsigned int piece = grid.cell_index(cell.column)[1];
        for (unsigned int side = 0; side < 2; ++side)
          {
            std::array<Point<3>, 2> ends;
            for (unsigned int i = 0; i < 2; ++i)
              ends[i] = mesh.deformed_position(
                state.displacement, mesh.nodes[cell.nodes[2 * side + i]], face);
            const auto integrals    = section_integrals(ends, axis, rim_radius);
            const unsigned int line = piece + side;
            const bool         is_end =
              !grid.closed && (line == 0 || line + 1 == n_lines);
            for (unsigned int k = 0; k < n_integrals; ++k)
              of_line(line, k) += integrals[k] / (is_end ? 1 : 2);
            for (unsigned int d = 0; d < 3; ++d)
              of_line(line, n_integrals + d) +=
                mesh.nodes[cell.nodes[2 * side]].surface.frame[1][d];
          }
      }
    Utilities::MPI::sum(of_lines, mesh.communicator, of_lines);
    // the last line of a closed coordinate is the first one
    if (grid.closed)
      for (unsigned int k = 0; k < n_of_line; ++k)
        of_line(0, k) = of_line(n_lines - 1, k) =
          of_line(0, k) + of_line(n_lines - 1, k);

    const double bulk_modulus =
      parameters.exponent * (pressure + ambient_pressure);
    const double density =
      bulk_modulus / (*parameters.sound_speed * *parameters.sound_speed);
    const auto angle = [&](const unsigned int piece) {
      return grid.lines[1][piece + 1] - grid.lines[1][piece];
    };

    AirMotion result;
    result.is_closed = grid.closed;
    for (unsigned int c = 0; c < n; ++c)
      result.compliances.push_back(angle(c) *
                                   std::abs(of_line(c, 1) + of_line(c + 1, 1)) /
                                   (2 * bulk_modulus));
    for (unsigned int line = (grid.closed ? 0 : 1); line < n; ++line)
      {
        const unsigned int before = (line + n - 1) % n;
        Tensor<1, 3>       direction;
        for (unsigned int d = 0; d < 3; ++d)
          direction[d] = of_line(line, n_integrals + d);
        result.sections.push_back({before,
                                   line,
                                   density * (angle(before) + angle(line)) / 2 /
                                     std::abs(of_line(line, 0)),
                                   std::abs(of_line(line, 2)),
                                   direction / direction.norm()});
      }

    // what a unit pressure does in a piece is the derivative of its volume
    for (unsigned int c = 0; c < n; ++c)
      {
        gradient = 0;
        for (const Cell &cell : mesh.cells)
          if (grid.cell_index(cell.column)[1] == c)
            {
              const MixedElement::NodalVector V =
                mesh.cell_values(state.displacement, cell);
              MixedElement::NodalVector force;
              if (cell.is_wall)
                force = FollowerPressure(cell.geometry, V, face).force();
              if (directors.act_on(cell.position))
                directors.add_force(1, cell, V, force);
              mesh.add_nodal_forces(cell, force, gradient);
            }
        gradient.compress(VectorOperation::add);
        result.gradients.emplace_back();
        for (const auto i : mesh.locally_owned)
          if (gradient(i) != 0)
            result.gradients.back().emplace_back(i, gradient(i));
      }
    return result;
  }
} // namespace Biface
