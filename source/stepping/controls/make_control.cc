// SPDX-License-Identifier: LGPL-2.1-or-later

#include <biface/stepping/controls/arc_length_control.h>
#include <biface/stepping/controls/displacement_control.h>
#include <biface/stepping/controls/load_control.h>
#include <biface/stepping/controls/make_control.h>
#include <biface/stepping/controls/resultant_control.h>
#include <biface/stepping/controls/time_control.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    template <class Kind>
    std::unique_ptr<Control>
    make(const Stage &stage, const Control::Parameters &parameters)
    {
      return std::make_unique<Kind>(stage, parameters);
    }


    /** The resultants that a stage prescribes. */
    ControlledResultants
    prescribed_resultants(const Stage &stage)
    {
      ControlledResultants resultants;
      if (stage.prescribes_force())
        resultants.push_back(controlled_force());
      if (stage.prescribes_axle_moment() && !stage.inertia)
        resultants.push_back(controlled_axle_moment());
      // bodies pushed by forces come on top, also of 'Control = load'
      for (const MotionByForce &motion : stage.motions_by_force)
        resultants.push_back(controlled_motion(motion, stage.factors.size()));
      // in time after their masses, which StepInTime has by their positions
      if (stage.prescribes_axle_moment() && stage.inertia)
        resultants.push_back(controlled_axle_moment());
      return resultants;
    }
  } // namespace


  std::unique_ptr<Control>
  make_control(const Stage &stage, const Control::Parameters &parameters)
  {
    switch (stage.control)
      {
        case ControlKind::displacement:
          return make<DisplacementControl>(stage, parameters);
        case ControlKind::arc_length:
          return make<ArcLengthControl>(stage, parameters);
        case ControlKind::load:
        case ControlKind::ground_force:
        case ControlKind::axle_moment:
        case ControlKind::ground_force_and_axle_moment:
          {
            const auto resultants = prescribed_resultants(stage);
            if (stage.inertia)
              return std::make_unique<TimeControl>(
                stage, parameters, resultants);
            if (resultants.empty())
              return make<LoadControl>(stage, parameters);
            return std::make_unique<ResultantControl>(
              stage, parameters, resultants);
          }
      }
    Assert(false, ExcInternalError());
    return {};
  }
} // namespace Biface
