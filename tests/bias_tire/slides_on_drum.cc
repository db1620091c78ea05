// SPDX-License-Identifier: LGPL-2.1-or-later

// A coarse bias tire slides on a rough drum, along its axis and around it, in
// large steps of which none is halved, in few iterations. Where all nodes slip
// along the axis, the lateral force is the coefficient of friction times the
// integral of the pressure; where they slip around it, the moment about the
// axis is that times the radius of the drum.

#include <biface/contact/rigid_body.h>
#include <biface/model/quantities/forces_on_shell.h>
#include <biface/model/state/loads.h>
#include <biface/stepping/step_report.h>

#include "../run_analysis.h"
#include "../tests.h"

using namespace dealii;
using namespace Biface;

namespace
{
  constexpr double radius = 300, coefficient = 0.1;


  void
  test(const bool along_axis)
  {
    double       pressure = 0;
    ForceOnShell ground;
    const auto   reports = run_analysis(
      PRM_DIR "/tire_on_drum.prm",
      {"Mesh/Intervals alpha_1=-120:120:14",
         "Mesh/Intervals alpha_2=-180:-20:4:smooth,-20:20:6,20:180:4:smooth",
         "Contact/Drum/Radius=" + std::to_string(radius),
         "Contact/Friction=" + std::to_string(coefficient),
         "Stage 2/Steps=4",
         "Number of stages=3",
         "Stage 3/Contact=true",
         "Stage 3/Travel=20",
         "Stage 3/Pressure=0.15",
         std::string("Stage 3/Slide=") + (along_axis ? "0, 12, 0" : "0, 0, 12"),
         "Stage 3/Steps=2"},
      [&](const ShellEquations &equations,
          const StepReport     &report,
          const State          &state) {
        if (!report.in_contact)
          return;
        pressure = 0;
        for (const Cell &cell : equations.mesh.cells)
          for (const unsigned int n : cell.nodes)
            pressure += cell.geometry.weight / 4 * state.ground().pressure(n);
        const Point<3> on_axis =
          report.loads->ground()->present(Point<3>(radius, 0, 0));
        ground        = force_of_ground(report.forces_of_bodies);
        ground.moment = ground.moment_about(on_axis);
      });
    pressure = Utilities::MPI::sum(pressure, MPI_COMM_WORLD);
    std::cout << (along_axis ? "along the axis" : "around it") << std::endl;
    check_true("  no step halved", reports.size() == 7);
    unsigned int most = 0;
    for (const StepReport &report : reports)
      most = std::max(most, report.iterations);
    check_range("  iterations of a step", most, 1, 15);
    const ContactSummary &last = reports.back().contact;
    check_true("  all slip", last.n_slipping == last.n_nodes);
    const double limit = coefficient * pressure;
    if (along_axis)
      check_small("  lateral force", ground.force[1] - limit, 1e-4, limit);
    else
      check_small("  moment about the axis",
                  std::abs(ground.moment[1]) - radius * limit,
                  1e-4,
                  radius * limit);
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  // one rank speaks for all
  if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
    std::cout.setstate(std::ios::failbit);

  test(true);
  test(false);
}
