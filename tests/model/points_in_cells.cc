// SPDX-License-Identifier: LGPL-2.1-or-later

// Points in cells feel a bar that is between the lines of nodes: the force is
// that of an elastic layer on a stiff plate, and nodes feel nothing. A plane
// presses all points alike. Nothing depends on the units.

#include <cmath>
#include <string>

#include <biface/stepping/step_report.h>

#include "forces.h"

using namespace Biface;

namespace
{
  /** The force of a bar that is pushed into the layer on the plate. The
   * compression @p k of the layer is per length, all lengths in the unit
   * @p length. */
  double
  force_of_bar(const std::string &points,
               const double       length = 1,
               const double       force  = 1)
  {
    const auto text = [&](const double lengths) {
      return dealii::Utilities::to_string(lengths * length, 17);
    };
    const auto stress = [&](const double value) {
      return dealii::Utilities::to_string(value * force / (length * length),
                                          17);
    };
    const Forces forces(
      DATA_DIR "/plate_and_bodies.prm",
      {"Mesh/Intervals alpha_1=0:" + text(20) + ":8",
       "Mesh/Intervals alpha_2=0:" + text(10) + ":3",
       "Named points=tip: " + text(20) + " 0",
       "Material rubber/E=" + stress(1e6),
       "Laminate/Plies=rubber: " + text(2) + " @ 0",
       "Supports/alpha_1 min=fixed",
       "Supports/alpha_1 max=fixed",
       "Contact/Regularization=" +
         dealii::Utilities::to_string(force / std::pow(length, 3), 17),
       "Contact/Points in cells=" + points,
       "Bodies=floor, press, lever, bar",
       "Body bar/Shape=cylinder",
       "Body bar/Axis=0, 1, 0",
       "Body bar/Radius=" + text(8),
       // over the middle of the fourth of eight cells
       "Body bar/Point=" + text(8.75) + ", " + text(5) + ", " + text(9),
       "Body bar/Motions=down: 0 0 " + text(-0.05),
       "Number of stages=1",
       "Stage 1/Bodies=bar",
       "Stage 1/Load factors=bodies bar: 1"});
    return forces.report.bodies.at("bar").contact.n_nodes > 0
             ? -forces.of.at("bar")[2] / force
             : 0.;
  }


  /** The floor is pushed against the press: the range of the pressure, and the
   * deviation of the force. */
  void
  squeeze()
  {
    const Forces          forces(DATA_DIR "/plate_and_bodies.prm",
                        {"Supports/alpha_1 min=x both",
                                  "Supports/alpha_2 min=y both",
                                  "Contact/Points in cells=3",
                                  "Number of stages=1",
                                  "Stage 1/Bodies=floor, press",
                                  "Stage 1/Forces on bodies=press down: 40"});
    const ContactSummary &press = forces.report.bodies.at("press").contact;
    if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
      return;
    check_small("force of the floor", forces.of.at("floor")[2] - 40, 1e-6, 40);
    check_small("maximum pressure", press.max_pressure - 0.2, 1e-6, 0.2);
    check_small("its variation", press.pressure_variation, 1e-6);
    check_true("all points of 24 cells touch", press.n_nodes == 24 * 9);
  }
} // namespace


int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  squeeze();

  // the integral of the compression over the width in contact, times the length
  // of the bar
  const double R = 8, depth = 0.05,
               half  = std::sqrt(R * R - (R - depth) * (R - depth)),
               exact = 10 * (R * R * std::asin(half / R) - half * (R - depth));
  const double at_nodes = force_of_bar("0"), coarse = force_of_bar("5"),
               fine = force_of_bar("10"), in_m_N = force_of_bar("10", 1e-3, 1),
               in_mm_kN = force_of_bar("10", 1, 1e-3);
  if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
    return 0;
  check_small("force at nodes", at_nodes, 1e-15);
  check_small("at 5 x 5 points", coarse - exact, 0.04, exact);
  check_small("at 10 x 10 points", fine - exact, 0.02, exact);
  check_small("in m", in_m_N - fine, 1e-8, fine);
  check_small("in kN", in_mm_kN - fine, 1e-8, fine);
}
