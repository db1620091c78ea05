// SPDX-License-Identifier: LGPL-2.1-or-later

// A wheel with inertia that rolls in time. What rolls steadily goes on so, with
// a given angular velocity or moment of the axle. Without friction and at a
// constant angular velocity the energy in the frame of the axle is constant. On
// the mesh of an independent program the side force after a turn of the wheel
// grows over its relaxation length. A braked wheel comes to the force of steady
// rolling. A cleat that comes slowly exerts the forces that it exerts on a
// wheel without inertia.

#include <algorithm>
#include <cmath>
#include <numeric>

#include <biface/model/quantities/forces_on_shell.h>
#include <biface/model/quantities/rolling_summary.h>
#include <biface/model/time/energy_of_motion.h>

#include "../tests.h"
#include "bias_tire.h"

using namespace Biface;

namespace
{
  const std::vector<Override> coarse{
    "Mesh/Intervals alpha_1=-120:-45:3, -45:45:6, 45:120:3",
    "Mesh/Intervals alpha_2=-180:-30:6, -30:30:12, 30:180:6",
    "Material cord/Density=1.2e-9"};


  std::vector<StepReport>
  roll(const std::string &file, const std::vector<Override> &more)
  {
    std::vector<Override> overrides = coarse;
    overrides.insert(overrides.end(), more.begin(), more.end());
    return run_analysis(PRM_DIR "/" + file, overrides);
  }


  /** The reports of the last stage. */
  std::vector<StepReport>
  last_stage(const std::vector<StepReport> &reports)
  {
    std::vector<StepReport> result;
    for (const StepReport &report : reports)
      if (report.stage == reports.back().stage)
        result.push_back(report);
    return result;
  }


  void
  check_steady()
  {
    const std::vector<Override> in_time{"Number of stages=4",
                                        "Stage 4/Name=stay",
                                        "Stage 4/Slip angle=unchanged",
                                        "Stage 4/Duration=0.01",
                                        "Stage 4/Steps=5",
                                        "Stage 4/Inertia=true",
                                        "Stage 4/Time error=0"};
    for (const bool by_moment : {false, true})
      {
        auto all = in_time;
        if (by_moment)
          all.insert(
            all.end(),
            {"Stage 4/Control=axle moment", "Stage 4/Moment of inertia=100"});
        const auto reports = roll("slip_step.prm", all);
        const auto stay    = last_stage(reports);
        const auto before  = reports[reports.size() - 1 - stay.size()];
        check_small(by_moment ? "steady by the moment"
                              : "steady by the angular velocity",
                    (stay.back().rolling->force - before.rolling->force).norm(),
                    1e-8,
                    before.rolling->force.norm());
        check_small("  angular velocity",
                    stay.back().level.angular_velocity -
                      before.level.angular_velocity,
                    1e-8,
                    before.level.angular_velocity);
        check_small("  moment",
                    stay.back().rolling->axle_moment,
                    1e-8,
                    240 * before.rolling->force.norm());
      }
  }


  void
  check_energy()
  {
    const auto reports =
      last_stage(roll("slip_step.prm",
                      {"Number of stages=4",
                       "Newton/Residual tolerance=1e-11",
                       "Newton/Update tolerance=0",
                       "Stage 3/Control=load",
                       "Stage 3/Friction=0",
                       "Stage 3/Ground velocity=0",
                       "Stage 3/Angular velocity=100",
                       "Stage 4/Name=free vibration",
                       "Stage 4/Slip angle=unchanged",
                       "Stage 4/Friction=0",
                       "Stage 4/Transient rolling=false",
                       "Stage 4/Inertia=true",
                       "Stage 4/Duration=0.01",
                       "Stage 4/Time step=0.0005",
                       "Stage 4/Time error=0",
                       "Stage 4/Initial velocity=1000*x*z/(x^2+z^2); 0; "
                       "1000*x/sqrt(x^2+z^2)"}));
    double lowest = 1e300, highest = -1e300, kinetic = 0, error = 0;
    for (const StepReport &report : reports)
      {
        const double energy = report.motion->sum() - report.work.loads;
        lowest              = std::min(lowest, energy);
        highest             = std::max(highest, energy);
        kinetic             = std::max(kinetic, report.motion->kinetic);
        error               = std::max(error, std::abs(report.work.unbalanced));
      }
    check_small("energy without friction", highest - lowest, 1e-8, kinetic);
    check_small("  balance", error, 1e-8, kinetic);
  }


  void
  check_independent_program()
  {
    const double duration = 58 * 5 * std::acos(-1.) / 180 / 41.8446;
    const std::vector<Override> same{
      "Mesh/Intervals alpha_1=-120:-50:2, -50:50:4, 50:120:2",
      "Contact/Tread/Height=none",
      "Contact/Tread/Modulus=0",
      "Contact/Regularization=0.3",
      "Contact/Tangential regularization=0.075",
      "Loads/Pressure type=dead"};
    auto steady = same, in_time = same;
    steady.insert(steady.end(),
                  {"Number of stages=4", "Stage 4/Transient rolling=false"});
    in_time.insert(in_time.end(),
                   {"Stage 5/Inertia=true",
                    "Stage 5/Time error=0",
                    "Stage 5/Numerical damping=0.222",
                    "Stage 5/Steps=58",
                    "Stage 5/Duration=" + std::to_string(duration)});
    const double end = roll("slip_step.prm", steady).back().rolling->force[1];
    std::vector<double> forces;
    for (const StepReport &report : roll("slip_step.prm", in_time))
      if (report.rolling && report.stage != "free")
        forces.push_back(report.rolling->force[1]);
    check_small("length of an independent program",
                relaxation_length(forces, end, 10000 * duration) - 192.6,
                0.05,
                192.6);
    check_small("  end", forces.back() - end, 3e-3, end);
  }


  void
  check_brake()
  {
    const std::vector<Override> braked{"Stage 4/Slip angle=unchanged",
                                       "Stage 4/Control=axle moment",
                                       "Stage 4/Axle moment=-50000"};
    auto                        steady = braked, in_time = braked;
    steady.insert(steady.end(),
                  {"Number of stages=4", "Stage 4/Transient rolling=false"});
    in_time.insert(in_time.end(),
                   {"Number of stages=4",
                    "Stage 4/Duration=0.15",
                    "Stage 4/Inertia=true",
                    "Stage 4/Stiffness damping=1e-3",
                    "Stage 4/Moment of inertia=50",
                    "Stage 4/Time step=0.002",
                    "Stage 4/Time error=0"});
    const auto end  = roll("slip_step.prm", steady).back();
    const auto last = roll("slip_step.prm", in_time).back();
    check_small("braked wheel",
                last.rolling->force[0] - end.rolling->force[0],
                0.01,
                end.rolling->force[0]);
    check_small("  angular velocity",
                last.level.angular_velocity - end.level.angular_velocity,
                1e-3,
                end.level.angular_velocity);
  }


  void
  check_slow_cleat()
  {
    const std::vector<Override> slow{
      "Mesh/Intervals alpha_2=-180:-27:6:smooth, "
      "-27:27:24, 27:180:6:smooth",
      "Stage 3/Ground velocity=100",
      "Stage 4/Duration=0.9",
      "Stage 4/Numerical damping=1",
      "Stage 4/Steps=30",
      "Stage 4/Time step=Duration/Steps",
      "Stage 4/Time error=0",
      "Body cleat/Motions=pass: 0 0 -90"};
    auto still = slow;
    still.insert(still.end(),
                 {"Stage 4/Inertia=false",
                  "Stage 4/Stiffness damping=0",
                  "Stage 4/Numerical damping=0",
                  "Stage 4/Moment of inertia=0"});
    const auto force = [&](const std::vector<Override> &more) {
      std::vector<dealii::Tensor<1, 3>> result;
      for (const StepReport &report :
           last_stage(roll("cleat_at_speed.prm", more)))
        {
          dealii::Tensor<1, 3> sum;
          for (const auto &item : report.forces_of_bodies)
            if (item.body == "cleat" || item.body == "foundation")
              sum += item.force;
          result.push_back(sum);
        }
      return result;
    };
    const auto with_inertia = force(slow), without = force(still);
    check_true("as many steps", with_inertia.size() == without.size());
    // forces in time are means over the step
    double error = 0, scale = 0;
    for (unsigned int i = 1; i < std::min(with_inertia.size(), without.size());
         ++i)
      {
        const auto mean = (without[i] + without[i - 1]) / 2;
        error           = std::max(error, (with_inertia[i] - mean).norm());
        scale           = std::max(scale, mean.norm());
      }
    check_small("slow cleat", error, 0.02, scale);
  }
} // namespace


int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  check_steady();
  check_energy();
  check_independent_program();
  check_brake();
  check_slow_cleat();
}
