// SPDX-License-Identifier: LGPL-2.1-or-later

// The footprint of a tube under pressure on a drum has the length, the area,
// the force and the contact pressure of an inextensible membrane.

#include <biface/stepping/step_report.h>

#include "../run_analysis.h"
#include "../tests.h"

using namespace dealii;
using namespace Biface;


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  // one rank speaks for all
  if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
    std::cout.setstate(std::ios::failbit);

  const double r = 100, R = 150, width = 10, p = 0.1, travel = 20;
  const double cell    = numbers::PI * r / 240;
  const auto   reports = run_analysis(DATA_DIR "/tube_on_plane.prm",
                                    {"Contact/Foundation=drum",
                                       "Contact/Drum/Radius=150",
                                       "Contact/Drum/Axis=0, 1, 0",
                                       "Mesh/Intervals alpha_2=-90:90:240",
                                       "Stage 2/Steps=10"});
  check_true("no step halved", reports.size() == 11);

  // The tube lies on the drum up to the angle t to each side. Its free parts
  // are arcs of the radius rho, from the mirror plane to where they are tangent
  // to the drum, and its length does not change.
  const auto rho = [&](const double t) {
    return (r + R - travel) / std::cos(t) - R;
  };
  double low = 0, high = 1;
  while (high - low > 1e-14)
    {
      const double t = (low + high) / 2;
      (rho(t) * (numbers::PI / 2 + t) + R * t < numbers::PI / 2 * r ? low
                                                                    : high) = t;
    }
  const double t      = low;
  const double length = 2 * R * std::sin(t);
  // inside the pressure, outside the tension p rho of the wall over the radius
  const double pressure = p + p * rho(t) / R;

  const StepReport &last = reports.back();
  // bending lifts the wall off a little before
  check_small("length", last.footprint.length - length, 0.5, cell);
  check_small("width", last.footprint.width - width, 1e-9, width);
  check_small(
    "area", last.footprint.area - 2 * R * t * width, 0.5, cell * width);
  check_small("force",
              last.contact.force - pressure * length * width,
              0.003,
              last.contact.force);
  check_small(
    "maximum pressure", last.contact.max_pressure - pressure, 0.002, pressure);
}
