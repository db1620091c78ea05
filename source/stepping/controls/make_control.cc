// SPDX-License-Identifier: LGPL-2.1-or-later

#include <biface/stepping/controls/arc_length_control.h>
#include <biface/stepping/controls/displacement_control.h>
#include <biface/stepping/controls/load_control.h>
#include <biface/stepping/controls/make_control.h>
#include <biface/stepping/controls/resultant_control.h>

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


    /** @param controlled the resultants that are prescribed. */
    template <std::shared_ptr<const ControlledResultant> (*...controlled)()>
    std::unique_ptr<Control>
    prescribe(const Stage &stage, const Control::Parameters &parameters)
    {
      return std::make_unique<ResultantControl>(
        stage, parameters, ResultantControl::Resultants{controlled()...});
    }
  } // namespace


  std::unique_ptr<Control>
  make_control(const Stage &stage, const Control::Parameters &parameters)
  {
    switch (stage.control)
      {
        case ControlKind::load:
          return make<LoadControl>(stage, parameters);
        case ControlKind::displacement:
          return make<DisplacementControl>(stage, parameters);
        case ControlKind::arc_length:
          return make<ArcLengthControl>(stage, parameters);
        case ControlKind::foundation_force:
          return prescribe<controlled_force>(stage, parameters);
        case ControlKind::axle_moment:
          return prescribe<controlled_axle_moment>(stage, parameters);
        case ControlKind::foundation_force_and_axle_moment:
          return prescribe<controlled_force, controlled_axle_moment>(
            stage, parameters);
      }
    Assert(false, ExcInternalError());
    return {};
  }
} // namespace Biface
