// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <string>

#include <biface/element/mixed_element.h>
#include <biface/element/nonlinear_plies.h>
#include <biface/input/parameter_tools.h>
#include <biface/laminate/layup.h>
#include <biface/laminate/relaxation.h>
#include <biface/model/forces/relaxation_in_transport.h>
#include <biface/model/mesh/strip.h>
#include <biface/model/state/state.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    /** Across a strip there are two rows of Gauss points, and in each row two
     * points in a cell. */
    constexpr unsigned int n_rows = 2;

    /** The Gauss point of a cell in a row, see Modes::n_gauss_points. */
    constexpr unsigned int
    gauss_point(const unsigned int row, const unsigned int second)
    {
      return row + 2 * second;
    }

    /** Particles move against alpha_2 if the wheel rolls forward. */
    bool
    transport_is_against_chart(const double angular_velocity)
    {
      return angular_velocity >= 0;
    }
  } // namespace


  class RelaxationInTransport::Ring
  {
  public:
    Ring(const unsigned int n_cells, const unsigned int n_per_point)
      : values(n_cells * Modes::n_gauss_points * n_per_point)
      , n_per_point(n_per_point)
    {}

    unsigned int
    n_points() const
    {
      return values.size() / (n_per_point * n_rows);
    }

    /** Those of a point of a row. */
    double *
    at(const unsigned int row, const unsigned int point)
    {
      return &values[position(row, point)];
    }
    const double *
    at(const unsigned int row, const unsigned int point) const
    {
      return &values[position(row, point)];
    }

    /** Those of the points next to the points of a cell, Gauss point by Gauss
     * point.
     * @param by -1 or 1, for the points before or after in the row. */
    std::vector<double>
    of_neighbors(const unsigned int around, const int by) const
    {
      std::vector<double> result;
      const unsigned int  n = n_points();
      for (unsigned int second = 0; second < 2; ++second)
        for (unsigned int row = 0; row < n_rows; ++row)
          {
            const double *from = at(row, (2 * around + second + n + by) % n);
            result.insert(result.end(), from, from + n_per_point);
          }
      return result;
    }

    void
    set_cell(const unsigned int around, const std::vector<double> &of_cell)
    {
      for (unsigned int second = 0; second < 2; ++second)
        for (unsigned int row = 0; row < n_rows; ++row)
          std::copy_n(of_cell.begin() + gauss_point(row, second) * n_per_point,
                      n_per_point,
                      at(row, 2 * around + second));
    }

    void
    sum(const MPI_Comm communicator)
    {
      Utilities::MPI::sum(values, communicator, values);
    }

  private:
    unsigned int
    position(const unsigned int row, const unsigned int point) const
    {
      return (row * n_points() + point) * n_per_point;
    }

    std::vector<double> values;
    unsigned int        n_per_point;
  };


  RelaxationInTransport::RelaxationInTransport(
    const ShellMesh &mesh, const std::vector<NonlinearPlies> &plies)
    : mesh(mesh), plies(plies), own_cells(mesh.strips.size())
  {
    for (const unsigned int c : mesh.layers)
      own_cells[mesh.cells[c].strip].push_back(c);
    // without lines there is no transport, and strips may be of one rank
    if (!mesh.grid.has_lines())
      return;
    columns.resize(mesh.strips.size());
    for (const unsigned int c : mesh.layers)
      columns[mesh.cells[c].strip] =
        mesh.grid.cell_index(mesh.cells[c].column)[0];
    Utilities::MPI::max(columns, mesh.communicator, columns);
  }


  const std::vector<RelaxingStress> &
  RelaxationInTransport::relaxing(const unsigned int strip) const
  {
    return plies[strip].relaxing_stresses();
  }


  std::vector<double>
  RelaxationInTransport::temperatures(const State       &state,
                                      const unsigned int strip) const
  {
    const auto found = state.terms.find("heat");
    if (!state.transport_velocity || found == state.terms.end())
      return {};
    const unsigned int  n_plies = mesh.get_layup().get_plies().size();
    std::vector<double> result;
    for (const Ply &ply : mesh.strips[strip].laminate.get_plies())
      result.push_back(
        found->second.numbers[columns[strip] * n_plies + ply.number]);
    return result;
  }


  HistoryOfPlies
  RelaxationInTransport::history(const State            &state,
                                 const Table<2, double> &internal,
                                 const unsigned int      c) const
  {
    return {&internal(c, 0),
            steps(state, mesh.cells[c]),
            temperatures(state, mesh.cells[c].strip)};
  }


  TimeStep
  RelaxationInTransport::step_to(const State       &state,
                                 const unsigned int around,
                                 const unsigned int second) const
  {
    // of a cell, between a Gauss point and the next edge
    static const double part = (1 - 1 / std::sqrt(3.)) / 2;

    const std::vector<double> &lines = mesh.grid.lines[1];
    const unsigned int         n     = mesh.grid.n_cells(1);
    const auto                 size  = [&](const unsigned int j) {
      return lines[j % n + 1] - lines[j % n];
    };
    // a particle comes from the other point of the cell, or across the edge
    // from the nearer one of the cell behind
    const bool descends = transport_is_against_chart(*state.transport_velocity);
    const double angle =
      (second == 1) != descends
        ? (1 - 2 * part) * size(around)
        : part * (size(around) + size(around + (descends ? 1 : n - 1)));
    return {angle / std::abs(*state.transport_velocity),
            state.time_step.temperature};
  }


  std::array<TimeStep, Modes::n_gauss_points>
  RelaxationInTransport::steps(const State &state, const Cell &cell) const
  {
    std::array<TimeStep, Modes::n_gauss_points> result;
    if (!state.transport_velocity)
      {
        result.fill(state.time_step);
        return result;
      }
    for (unsigned int second = 0; second < 2; ++second)
      for (unsigned int row = 0; row < n_rows; ++row)
        result[gauss_point(row, second)] =
          step_to(state, mesh.grid.cell_index(cell.column)[1], second);
    return result;
  }


  RelaxationInTransport::Ring
  RelaxationInTransport::gather(const unsigned int strip,
                                const unsigned int n_per_point,
                                const Fill        &fill) const
  {
    Ring                ring(mesh.grid.n_cells(1), n_per_point);
    std::vector<double> values(n_per_point * Modes::n_gauss_points);
    for (const unsigned int c : own_cells[strip])
      {
        fill(c, values);
        ring.set_cell(around(c), values);
      }
    // the cells of a line may belong to several ranks; values are zero on all
    // but one
    ring.sum(mesh.communicator);
    return ring;
  }


  RelaxationInTransport::Lines
  RelaxationInTransport::lines(const State       &state,
                               const unsigned int strip) const
  {
    const unsigned int n = 2 * mesh.grid.n_cells(1);
    const bool descends = transport_is_against_chart(*state.transport_velocity);
    const std::vector<double> of_plies = temperatures(state, strip);
    Lines                     result{{}, {}};
    // in the order in which the material passes them
    for (unsigned int k = 0; k < n; ++k)
      result.places.push_back(descends ? n - 1 - k : k);
    for (const RelaxingStress &stress : relaxing(strip))
      if (result.of_plies.count(stress.ply) == 0)
        {
          std::vector<TimeStep> steps;
          for (const unsigned int place : result.places)
            {
              steps.push_back(step_to(state, place / 2, place % 2));
              if (!of_plies.empty())
                steps.back().temperature = of_plies[stress.ply];
            }
          result.of_plies.emplace(
            stress.ply, RelaxationAroundLine(*stress.relaxation, steps));
        }
    return result;
  }


  RelaxationInTransport::Ring
  RelaxationInTransport::internal_variables(const Lines       &lines,
                                            const unsigned int strip,
                                            const Ring        &elastic) const
  {
    unsigned int n_per_point = 0;
    for (const RelaxingStress &stress : relaxing(strip))
      n_per_point += stress.n_internal();
    Ring         internal(mesh.grid.n_cells(1), n_per_point);
    unsigned int position = 0, result_position = 0;
    for (const RelaxingStress &stress : relaxing(strip))
      {
        const unsigned int n_numbers = stress.n_internal();
        for (unsigned int row = 0; row < n_rows; ++row)
          {
            // all places at once: each depends on what the material has passed
            // in a whole turn
            std::vector<double> components;
            for (const unsigned int place : lines.places)
              {
                const double *at = elastic.at(row, place) + position;
                components.insert(
                  components.end(), at, at + stress.n_components);
              }
            const std::vector<double> numbers =
              lines.of_plies.at(stress.ply).internal_stresses(components);
            for (unsigned int k = 0; k < lines.places.size(); ++k)
              std::copy_n(numbers.begin() + k * n_numbers,
                          n_numbers,
                          internal.at(row, lines.places[k]) + result_position);
          }
        position += stress.n_components;
        result_position += n_numbers;
      }
    return internal;
  }


  std::string
  RelaxationInTransport::set_internal_variables(
    const Strains    &strains,
    const State      &state,
    Table<2, double> &internal) const
  {
    // change of the stresses in the last round, which shrink by a fraction of
    // what relaxes in each
    constexpr double       small_change = 1e-12;
    constexpr unsigned int max_rounds   = 100;

    const int behind =
      transport_is_against_chart(*state.transport_velocity) ? 1 : -1;
    for (unsigned int strip = 0; strip < mesh.strips.size(); ++strip)
      {
        const std::vector<double> of_plies = temperatures(state, strip);
        for (const RelaxingStress &stress : relaxing(strip))
          if (!of_plies.empty() &&
              !(stress.relaxation->factor_of_times(of_plies[stress.ply]) > 0))
            return "a ply has the temperature " +
                   number_to_string(of_plies[stress.ply]) +
                   ", where its 'Temperature shift' has no value";
      }
    std::vector<std::vector<double>> last(mesh.cells.size());
    std::vector<Lines>               lines_of_strips;
    for (unsigned int strip = 0; strip < mesh.strips.size(); ++strip)
      lines_of_strips.push_back(lines(state, strip));
    for (unsigned int round = 0; round < max_rounds; ++round)
      {
        double change = 0, largest = 0;
        bool   finite = true;
        for (unsigned int strip = 0; strip < mesh.strips.size(); ++strip)
          {
            if (relaxing(strip).empty())
              continue;
            const Ring elastic = gather(
              strip,
              plies[strip].n_relaxing_components(),
              [&](const unsigned int c, std::vector<double> &values) {
                plies[strip].elastic_stresses(
                  strains(c), history(state, internal, c), values);
                for (unsigned int i = 0; i < values.size(); ++i)
                  {
                    const double before = last[c].empty() ? 0. : last[c][i];
                    finite              = finite && std::isfinite(values[i]);
                    largest = std::max(largest, std::abs(values[i]));
                    change  = std::max(change, std::abs(values[i] - before));
                  }
                last[c] = values;
              });
            // a cell starts its step with what the points behind its own have
            // at present
            const Ring variables =
              internal_variables(lines_of_strips[strip], strip, elastic);
            for (const unsigned int c : own_cells[strip])
              {
                const std::vector<double> of_cell =
                  variables.of_neighbors(around(c), behind);
                std::copy(of_cell.begin(), of_cell.end(), &internal(c, 0));
              }
          }
        finite  = Utilities::MPI::min(finite ? 1 : 0, mesh.communicator) == 1;
        change  = Utilities::MPI::max(change, mesh.communicator);
        largest = Utilities::MPI::max(largest, mesh.communicator);
        if (!finite)
          return "a stress around the axle is not a number";
        if (change <= small_change * largest)
          return {};
      }
    return "the stresses that relax around the axle have not settled in " +
           std::to_string(max_rounds) + " rounds";
  }


  std::vector<std::vector<double>>
  RelaxationInTransport::losses(const Strains          &strains,
                                const Table<2, double> &internal,
                                const double            angular_velocity) const
  {
    std::vector<std::vector<double>> result(mesh.cells.size());
    for (unsigned int strip = 0; strip < mesh.strips.size(); ++strip)
      {
        const unsigned int n_plies =
          mesh.strips[strip].laminate.get_plies().size();
        for (const unsigned int c : own_cells[strip])
          result[c].resize(n_plies);
        if (relaxing(strip).empty())
          continue;

        // what is relaxed of the stresses, and the strains, of each point
        const unsigned int n    = plies[strip].n_relaxing_components();
        const Ring         ring = gather(
          strip, 2 * n, [&](const unsigned int c, std::vector<double> &values) {
            const HistoryOfPlies own{&internal(c, 0)};
            std::vector<double>  stresses, of_strains;
            plies[strip].elastic_stresses(
              strains(c), own, stresses, &of_strains);
            // in no time, the internal variables add just this
            const std::vector<double> relaxed =
              plies[strip].added_stresses(own);
            for (unsigned int g = 0; g < Modes::n_gauss_points; ++g)
              {
                std::copy_n(
                  relaxed.begin() + g * n, n, values.begin() + 2 * g * n);
                std::copy_n(of_strains.begin() + g * n,
                            n,
                            values.begin() + (2 * g + 1) * n);
              }
          });

        std::vector<double> of_plies(n_plies);
        unsigned int        position = 0;
        for (const RelaxingStress &stress : relaxing(strip))
          {
            for (unsigned int row = 0; row < n_rows; ++row)
              {
                double energy = 0;
                // the integral of stress by strain around the line, by the
                // trapezoidal rule; elastic stresses would add nothing
                for (unsigned int k = 0; k < ring.n_points(); ++k)
                  {
                    const double *here = ring.at(row, k) + position;
                    const double *next =
                      ring.at(row, (k + 1) % ring.n_points()) + position;
                    for (unsigned int i = 0; i < stress.n_components; ++i)
                      energy +=
                        (here[i] + next[i]) / 2 * (next[n + i] - here[n + i]);
                  }
                // the ring is in the order of the coordinate, particles pass it
                // in that of the transport
                of_plies[stress.ply] +=
                  (transport_is_against_chart(angular_velocity) ? -1 : 1) *
                  stress.thickness * energy / n_rows;
              }
            position += stress.n_components;
          }
        for (const unsigned int c : own_cells[strip])
          result[c] = of_plies;
      }
    return result;
  }


  /** See RelaxationInTransport::stiffness(). */
  class RelaxationInTransport::Stiffness : public NonlocalStiffness
  {
  public:
    Stiffness(const RelaxationInTransport &transport,
              const Strains               &strains,
              const State                 &state,
              const Table<2, double>      &internal)
      : transport(transport), state(state), changes(transport.mesh.cells.size())
    {
      for (unsigned int strip = 0; strip < transport.own_cells.size(); ++strip)
        lines.push_back(transport.lines(state, strip));
      for (unsigned int strip = 0; strip < transport.own_cells.size(); ++strip)
        if (!transport.relaxing(strip).empty())
          for (const unsigned int c : transport.own_cells[strip])
            changes[c] = std::make_unique<NonlinearPlies::Changes>(
              transport.plies[strip],
              strains(c),
              transport.history(state, internal, c));
    }


    void
    vmult(LA::Vector &product, const LA::Vector &x) const override
    {
      const ShellMesh &mesh = transport.mesh;
      LA::Vector       dV   = mesh.ghosted_vector();
      dV                    = x;
      LA::Vector forces     = mesh.owned_vector();
      const int  behind =
        transport_is_against_chart(*state.transport_velocity) ? 1 : -1;
      for (unsigned int strip = 0; strip < transport.own_cells.size(); ++strip)
        {
          if (transport.relaxing(strip).empty())
            continue;
          const auto element = [&](const unsigned int c) {
            return MixedElement(
              mesh.cells[c].geometry,
              mesh.cell_values(state.displacement, mesh.cells[c]));
          };
          const std::vector<unsigned int> &own   = transport.own_cells[strip];
          const NonlinearPlies            &plies = transport.plies[strip];
          std::vector<Modes::Vector>       dE;
          for (const unsigned int c : own)
            dE.push_back(
              element(c).strain_variation(mesh.cell_values(dV, mesh.cells[c])));
          // without and with the changes of the thickness strains
          std::vector<std::vector<double>> added(
            own.size(),
            std::vector<double>(Modes::n_gauss_points *
                                plies.n_relaxing_components()));
          // what relaxes changes the thickness strains, and these the stresses
          // that relax: two more turns, section 10 of doc/theory.md
          const unsigned int n_rounds = plies.is_whole_law() ? 3 : 1;
          for (unsigned int round = 0; round < n_rounds; ++round)
            {
              unsigned int next    = 0;
              const Ring   elastic = transport.gather(
                strip,
                plies.n_relaxing_components(),
                [&](const unsigned int c, std::vector<double> &values) {
                  changes[c]->elastic_stresses(dE[next], added[next], values);
                  ++next;
                });
              const Ring variables =
                transport.internal_variables(lines[strip], strip, elastic);
              for (unsigned int i = 0; i < own.size(); ++i)
                {
                  const std::vector<double> internal =
                    variables.of_neighbors(transport.around(own[i]), behind);
                  added[i] = changes[own[i]]->added_stresses(internal.data());
                }
            }
          for (unsigned int i = 0; i < own.size(); ++i)
            mesh.add_nodal_forces(
              mesh.cells[own[i]],
              element(own[i]).internal_force(
                changes[own[i]]->resultants(added[i]), Modes::Vector()),
              forces);
        }
      forces.compress(VectorOperation::add);
      mesh.condense(forces);
      product = forces;
    }

  private:
    const RelaxationInTransport &transport;
    const State                 &state;
    /** By strip. */
    std::vector<Lines> lines;
    /** By cell; null for those of other ranks and without relaxation. */
    std::vector<std::unique_ptr<const NonlinearPlies::Changes>> changes;
  };


  std::unique_ptr<const NonlocalStiffness>
  RelaxationInTransport::stiffness(const Strains          &strains,
                                   const State            &state,
                                   const Table<2, double> &internal) const
  {
    return std::make_unique<Stiffness>(*this, strains, state, internal);
  }
} // namespace Biface
