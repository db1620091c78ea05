// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>

#include <biface/contact/tangential_law.h>
#include <biface/model/contact/contact_pair.h>
#include <biface/model/contact/contact_summary.h>
#include <biface/model/state/loads.h>
#include <biface/model/state/placed_body.h>

namespace Biface
{
  using namespace dealii;

  unsigned int
  count_active(const ContactPair &pair, const State &state)
  {
    unsigned int n = 0;
    for (unsigned int i = 0; i < pair.points.size(); ++i)
      if (pair.state_of(state).active[i] && pair.points.is_owned(i))
        ++n;
    return Utilities::MPI::sum(n, pair.mesh.communicator);
  }


  unsigned int
  count_slipping(const ContactPair &pair,
                 const State       &state,
                 const Loads       &loads)
  {
    unsigned int n = 0;
    for (unsigned int i = 0; i < pair.points.size(); ++i)
      if (pair.points.is_owned(i) &&
          slips(pair.state_of(state), pair.body(loads), i))
        ++n;
    return Utilities::MPI::sum(n, pair.mesh.communicator);
  }


  namespace
  {
    /** Call a function with the number of each active point of the cells of
     * this rank, and with its area on a cell. */
    template <typename Function>
    void
    for_active_points(const ContactPair  &pair,
                      const ContactState &zone,
                      const Function     &function)
    {
      const ContactPoints &points = pair.points;
      for (const Cell &cell : pair.mesh.wall_elements())
        for (unsigned int i = 0; i < points.on_cell().size(); ++i)
          {
            const unsigned int n = points.number(cell, i);
            if (zone.active[n])
              function(n, points.area(cell, i));
          }
    }
  } // namespace


  double
  friction_work(const ContactPair &pair,
                const State       &before,
                const State       &after,
                const Loads       &loads)
  {
    double work = 0;
    if (pair.has_friction(loads))
      for_active_points(
        pair,
        pair.state_of(after),
        [&](const unsigned int n, const double area) {
          // section 6 of doc/theory.md: the traction at the end of the step on
          // the motion of the stick point
          work -=
            area * (pair.traction_of_multipliers(after, loads, n).friction *
                    pair.body(loads)->laws.tangential().slip_in_step(
                      pair.state_of(before),
                      pair.state_of(after),
                      pair.body(loads)->body,
                      n));
        });
    return Utilities::MPI::sum(work, pair.mesh.communicator);
  }


  namespace
  {
    /** The mean of a function of the pressures at the points, weighted by the
     * forces that they carry; zero if there are none. */
    template <typename Function>
    double
    mean_by_force(const ContactPair  &pair,
                  const ContactState &zone,
                  const Function     &function)
    {
      double force = 0, integral = 0;
      for_active_points(
        pair, zone, [&](const unsigned int n, const double area) {
          const double pressure = zone.pressure(n);
          force += area * pressure;
          integral += area * pressure * function(pressure);
        });
      force    = Utilities::MPI::sum(force, pair.mesh.communicator);
      integral = Utilities::MPI::sum(integral, pair.mesh.communicator);
      return force > 0 ? integral / force : 0.;
    }
  } // namespace


  ContactSummary
  summarize(const ContactPair &pair, const State &state, const Loads &loads)
  {
    const ContactState &zone = pair.state_of(state);
    double force = 0, area = 0, slipping_area = 0, max_pressure = 0;
    if (pair.body(loads))
      {
        const Tensor<1, 3> d = pair.body(loads)->body.direction();
        for_active_points(
          pair, zone, [&](const unsigned int n, const double part) {
            area += part;
            if (slips(zone, pair.body(loads), n))
              slipping_area += part;
            force -=
              part * (pair.traction_of_multipliers(state, loads, n).total * d);
          });
        for (unsigned int n = 0; n < pair.points.size(); ++n)
          if (pair.points.is_owned(n))
            max_pressure = std::max(max_pressure, zone.pressure(n));
      }

    const MPI_Comm communicator = pair.mesh.communicator;
    ContactSummary summary;
    summary.force         = Utilities::MPI::sum(force, communicator);
    summary.area          = Utilities::MPI::sum(area, communicator);
    summary.slipping_area = Utilities::MPI::sum(slipping_area, communicator);
    summary.n_nodes       = count_active(pair, state);
    summary.n_slipping    = count_slipping(pair, state, loads);
    summary.max_pressure  = Utilities::MPI::max(max_pressure, communicator);
    if (summary.n_nodes > 0)
      {
        const double mean =
          mean_by_force(pair, zone, [](const double p) { return p; });
        const double square = mean_by_force(
          pair, zone, [&](const double p) { return (p - mean) * (p - mean); });
        summary.weighted_pressure = mean;
        // what round-off leaves where all pressures are the same
        constexpr double negligible = 1e-12;
        if (square > negligible * negligible * mean * mean)
          summary.pressure_variation = std::sqrt(square) / mean;
      }
    return summary;
  }
} // namespace Biface
