// SPDX-License-Identifier: LGPL-2.1-or-later

// The slip velocity in the VTU files of a wheel that rolls, free and locked,
// lies in the ground and obeys the law of friction, t = -mu p s/sqrt(s^2 +
// s_c^2), at the nodes in contact; elsewhere it is zero. That of the locked
// wheel is the velocity of the wheel.

#include <cmath>
#include <map>
#include <sstream>

#include <biface/model/equations/shell_equations.h>
#include <biface/model/state/loads.h>
#include <biface/output/shell_vtu.h>
#include <biface/stepping/step_report.h>

#include "../model/rolling_wheel.h"

using namespace dealii;
using namespace Biface;

namespace
{
  /** The fields of legacy VTK text, with all their components. */
  std::map<std::string, std::vector<double>>
  fields_of(std::istream &text)
  {
    std::map<std::string, std::vector<double>> fields;
    std::vector<double>                       *field = nullptr;
    std::string                                word;
    while (text >> word)
      if (word == "VECTORS" || word == "SCALARS")
        {
          const bool scalar = (word == "SCALARS");
          text >> word;
          field = &fields[word];
          // the type, and the number of components
          text >> word;
          if (scalar)
            text >> word;
        }
      else if (word == "LOOKUP_TABLE")
        text >> word;
      else if (field && std::isalpha(word[0]) == 0)
        field->push_back(std::stod(word));
    return fields;
  }


  void
  check(const std::string &name, const FacePatches &patches, const bool locked)
  {
    constexpr double mu = 0.5, critical_velocity = 0.02;

    std::stringstream text;
    patches.write_vtk(text);
    auto       fields   = fields_of(text);
    const auto pressure = fields.at("contact_pressure");
    const auto active   = fields.at("active");
    const auto slipping = fields.at("slipping");
    const auto friction = fields.at("friction");
    const auto slip     = fields.at("slip_velocity");
    check_true("fields of the same points",
               !active.empty() && pressure.size() == active.size() &&
                 slipping.size() == active.size() &&
                 friction.size() == 3 * active.size() &&
                 slip.size() == friction.size());

    double off_ground = 0, elsewhere = 0, other_traction = 0, other_speed = 0;
    double max_pressure   = 0;
    unsigned int n_active = 0, n_misjudged = 0;
    for (unsigned int p = 0; p < active.size(); ++p)
      {
        // the plane's normal is the x axis
        const Tensor<1, 3> s({slip[3 * p], slip[3 * p + 1], slip[3 * p + 2]});
        off_ground = std::max(off_ground, std::abs(s[0]));
        if (active[p] == 0)
          {
            elsewhere = std::max(elsewhere, s.norm());
            continue;
          }
        ++n_active;
        max_pressure      = std::max(max_pressure, pressure[p]);
        const double root = std::hypot(s.norm(), critical_velocity);
        for (unsigned int i = 0; i < 3; ++i)
          other_traction = std::max(
            other_traction,
            std::abs(friction[3 * p + i] + mu * pressure[p] * s[i] / root));
        other_speed = std::max(other_speed, std::abs(s.norm() - 1));
        n_misjudged += (slipping[p] != (s.norm() > critical_velocity ? 1 : 0));
      }
    std::cout << name << '\n';
    check_true("  in contact", n_active > 20);
    check_true("  slipping where faster than critical", n_misjudged == 0);
    check_small("  off the ground", off_ground, 1e-12);
    check_small("  elsewhere", elsewhere, 1e-12);
    // six digits in the file
    check_small("  law of friction", other_traction, 1e-5, max_pressure);
    if (locked)
      check_small("  speed of the locked wheel", other_speed, 1e-5);
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  run_analysis(PRM_DIR "/bias_tire.prm",
               rolling_overrides({"Number of stages=4",
                                  "Stage 4/Contact=true",
                                  "Stage 4/Friction=0.5",
                                  "Stage 4/Angular velocity=0",
                                  "Stage 4/Steps=3"}),
               [&](const ShellEquations &equations,
                   const StepReport     &report,
                   const State          &state) {
                 if (!report.rolling)
                   return;
                 const FacePatches patches(
                   equations, state, *report.loads, report.slip_velocities);
                 if (report.step == 4)
                   check("free", patches, false);
                 else if (report.step == 7)
                   check("locked", patches, true);
               });
}
