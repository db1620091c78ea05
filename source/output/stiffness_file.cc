// SPDX-License-Identifier: LGPL-2.1-or-later

#include <biface/contact/rigid_body.h>
#include <biface/model/state/loads.h>
#include <biface/output/csv.h>
#include <biface/output/stiffness_file.h>
#include <biface/stepping/stage_sequence.h>
#include <biface/stepping/step_report.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    const std::string ground = "foundation";


    std::string
    stiffness_header()
    {
      std::string header = "step,stage,pressure,force,approach,motion,amount,"
                           "direction_x,direction_y,direction_z,secant,tangent";
      for (const std::string kind : {"secant", "tangent"})
        for (const std::string vector : {"F", "M"})
          for (const std::string axis : {"x", "y", "z"})
            header += ',' + kind + '_' + vector + '_' + axis;
      return header;
    }


    std::string
    name_of(const Stiffness::Motion motion)
    {
      switch (motion)
        {
          case Stiffness::Motion::approach:
            return "approach";
          case Stiffness::Motion::slide:
            return "slide";
          case Stiffness::Motion::turn:
            return "turn";
        }
      Assert(false, ExcInternalError());
      return "";
    }


    /** The components of a vector, each after a comma. */
    std::string
    components(const Tensor<1, 3> &vector)
    {
      std::string text;
      for (unsigned int i = 0; i < 3; ++i)
        text += ',' + csv_number(vector[i]);
      return text;
    }
  } // namespace


  StiffnessFile::StiffnessFile(const std::vector<Stage> &stages,
                               ResultsDirectory         &directory,
                               const ShellEquations     &equations)
    : StepTable("stiffness.csv",
                stiffness_header(),
                1,
                directory,
                equations,
                any_motion_of_ground(stages))
  {}


  bool
  StiffnessFile::contains(const StepReport &report) const
  {
    const auto found = report.stiffness.find(ground);
    return found != report.stiffness.end() && found->second.secant.amount != 0;
  }


  void
  StiffnessFile::write(const StepReport &report, const State & /*state*/)
  {
    const StepStiffness &stiffness = report.stiffness.at(ground);
    const Stiffness     &secant    = stiffness.secant;
    const Stiffness     &tangent   = stiffness.tangent;
    const Tensor<1, 3>  &outward   = report.loads->ground()->direction();

    // the ground pushes inward: compressive forces are positive
    append(std::to_string(report.step) + ',' + report.stage + ',' +
           csv_number(stiffness.level.pressure) + ',' +
           csv_number(-(stiffness.loaded.force * outward)) + ',' +
           csv_number(stiffness.level.travel) + ',' + name_of(secant.motion) +
           ',' + csv_number(secant.amount) + components(secant.direction) +
           ',' + csv_number(secant.along()) + ',' +
           csv_number(tangent.along()) + components(secant.force) +
           components(secant.moment) + components(tangent.force) +
           components(tangent.moment) + '\n');
  }
} // namespace Biface
