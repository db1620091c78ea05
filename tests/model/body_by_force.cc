// SPDX-License-Identifier: LGPL-2.1-or-later

// A force finds the motion of a body: a cone in a ring, with the force of a
// press fit, goes as far as it expands the ring; a press that may tilt on an
// elastic plate rests on the point where its force is, and a spring takes its
// part. The body may come from afar, and another one may be in contact already.

#include <string>
#include <vector>

#include <biface/stepping/step_report.h>

#include "forces.h"
#include "press_fit.h"

using namespace Biface;

namespace
{
  bool
  is_root()
  {
    return dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
  }


  void
  push_cone(const double friction)
  {
    const double travel = 0.11430052303, force = press_fit_force(friction);
    const Forces forces(DATA_DIR "/press_fit.prm",
                        {"Body cone/Friction=" + std::to_string(friction),
                         "Stage 1/Load factor=unchanged",
                         "Contact/Regularization=1e6",
                         // the first step has no friction yet
                         "Stage 1/Steps=10",
                         "Stage 1/Forces on bodies=cone in: " +
                           dealii::Utilities::to_string(force, 17)});
    if (!is_root())
      return;
    check_small("travel of the cone",
                -forces.report.bodies.at("cone").displacement[1] - travel,
                5e-4,
                travel);
    check_small("its force", -forces.of.at("cone")[1] - force, 1e-6, force);
  }


  /** The press, by the force @p F, with springs. */
  void
  press(const double F, const std::string &springs, const double spring)
  {
    const double E = 10, h = 2, L = 20, width = 10, eccentricity = 1;
    const Forces forces(DATA_DIR "/plate_and_bodies.prm",
                        {"Supports/alpha_1 min=x both",
                         "Supports/alpha_2 min=y both",
                         "Body press/Springs=" + springs,
                         "Number of stages=1",
                         "Stage 1/Bodies=floor, press",
                         "Stage 1/Forces on bodies=press down: " +
                           std::to_string(F) + ", press tilt: 0",
                         "Stage 1/Steps=2"});
    if (!is_root())
      return;
    const BodyReport &body    = forces.report.bodies.at("press");
    const Resultant  &of_body = forces.of.at("press");
    const double      taken   = -spring * body.displacement[2];
    const double      carried = F - taken;
    check_small("force", -of_body[2] - carried, 1e-6, F);
    const double x = 11, z = 0.9999 + body.displacement[2];
    check_small("moment about the axis",
                of_body[4] - (z * of_body[0] - x * of_body[2]),
                1e-6,
                F * L);
    check_small(
      "force of the floor", forces.of.at("floor")[2] - carried, 1e-6, F);
    const double turn =
      carried * eccentricity * h / (E * width * L * L * L / 12);
    check_small("tilt", body.rotation[1] - turn, 0.01, turn);
  }


  /** The press comes from afar onto a plate that is held at one end, and leaves
   * it again. */
  void
  press_from_afar()
  {
    const std::vector<Override> entries{"Supports/alpha_1 min=fixed",
                                        "Body press/Point=18.5, 5, 4",
                                        "Body press/Springs=tilt: 10",
                                        "Number of stages=2",
                                        "Stage 1/Bodies=press",
                                        "Stage 1/Forces on bodies=press down: "
                                        "0.02, press tilt: 0",
                                        "Stage 2/Bodies=press",
                                        "Stage 2/Forces on bodies=press tilt: "
                                        "0, press down: 0"};
    const auto                  reports =
      run_analysis(DATA_DIR "/plate_and_bodies.prm", entries);
    if (!is_root())
      return;
    check_true("it comes to rest",
               reports.size() == 2 &&
                 reports[0].bodies.at("press").displacement[2] < -3 &&
                 reports[0].bodies.at("press").contact.n_nodes > 0);
    check_small("force that is left",
                reports[1].bodies.at("press").contact.max_pressure,
                1e-6);
  }


  void
  press_from_both_sides()
  {
    const Forces forces(DATA_DIR "/plate_and_bodies.prm",
                        {"Supports/alpha_1 min=fixed",
                         "Number of stages=2",
                         "Stage 1/Bodies=floor",
                         "Stage 1/Load factors=bodies floor lift: 0.1",
                         "Stage 2/Bodies=floor",
                         "Stage 2/Contact=true",
                         "Stage 2/Control=foundation force",
                         "Stage 2/Force=0.5"});
    if (is_root())
      check_small(
        "force of the ground", -forces.of.at("foundation")[2] - 0.5, 1e-6, 0.5);
  }


  /** The force on the ground is that on the bodies on it, too. */
  void
  press_with_bump()
  {
    const Forces forces(DATA_DIR "/plate_and_bodies.prm",
                        {"Supports/alpha_1 min=fixed",
                         "Body press/Shape=sphere",
                         "Body press/Radius=30",
                         "Body press/Point=15, 5, 29.9",
                         "Body press/Moves with=foundation",
                         "Number of stages=1",
                         "Stage 1/Bodies=floor, press",
                         "Stage 1/Contact=true",
                         "Stage 1/Control=foundation force",
                         "Stage 1/Force=20"});
    if (!is_root())
      return;
    const double of_plane = -forces.of.at("foundation")[2],
                 of_bump  = -forces.of.at("press")[2];
    check_true("plane and bump press", of_plane > 1 && of_bump > 1);
    check_small("force of both", of_plane + of_bump - 20, 1e-6, 20);
  }


  /** The lever lifts the end by a given displacement: a large turn is
   * unknown. */
  void
  lift()
  {
    const auto run = [&](const std::vector<Override> &entries, double &energy) {
      std::vector<Override> all{"Supports/alpha_1 min=fixed",
                                "Number of stages=1",
                                "Stage 1/Bodies=lever",
                                "Stage 1/Steps=4"};
      all.insert(all.end(), entries.begin(), entries.end());
      return run_analysis(DATA_DIR "/plate_and_bodies.prm",
                          all,
                          [&](const ShellEquations &equations,
                              const StepReport &,
                              const State &state) {
                            energy =
                              equations.internal_forces().strain_energy(state);
                          });
    };
    double       energy = 0, of_given_turn = 0;
    const auto   controlled = run({"Stage 1/Load factor=1",
                                   "Stage 1/Control=displacement",
                                   "Stage 1/Control point=tip",
                                   "Stage 1/Control component=z",
                                   "Stage 1/Control value=6"},
                                energy);
    const double turn = controlled.back().bodies.at("lever").rotation.norm();
    run({"Stage 1/Load factor=" +
         dealii::Utilities::to_string(controlled.back().level.factors[0], 17)},
        of_given_turn);
    if (!is_root())
      return;
    check_true("the lever turns by more than 10 degrees",
               turn > 10 * dealii::numbers::PI / 180);
    check_small("steps", controlled.size() - 4., 0);
    check_small("energy at a given turn", of_given_turn - energy, 1e-6, energy);
  }
} // namespace


int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  push_cone(0);
  push_cone(0.2);
  press(2, "", 0);
  press(2, "down: 0.5", 0.5);
  press_from_afar();
  press_from_both_sides();
  press_with_bump();
  lift();
}
