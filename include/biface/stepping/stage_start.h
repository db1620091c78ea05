// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_stepping_stage_start_h
#define biface_stepping_stage_start_h

#include <memory>
#include <optional>

#include <biface/contact/friction.h>
#include <biface/model/contact/contact_interaction.h>
#include <biface/model/equations/shell_equations.h>
#include <biface/model/forces/gas.h>
#include <biface/model/state/state.h>
#include <biface/stepping/progress.h>
#include <biface/stepping/stage.h>

namespace Biface
{
  /** The loads at a level in the current stage.
   * @param rolls see Stage::rolls().
   * @param friction null without friction. */
  Loads
  loads_at(const LoadLevel                          &level,
           const Stage                              &stage,
           const bool                                rolls,
           const std::shared_ptr<const FrictionLaw> &friction,
           const ContactInteraction                 &contact,
           const Progress                           &progress);

  /**
   * Start a stage, but for its control: return to the undeformed shape if it
   * starts from a prestress, find where the foundation touches, glue the nodes
   * in contact, set the strain theory, and seal the gas in.
   *
   * @param rolls see Stage::rolls().
   * @param gas null if no stage has a sealed gas.
   * @param progress, state those of the end of the stage before; they become
   * those of the start of this one.
   * @return what is out of balance in a start from a prestress.
   */
  std::optional<ShellEquations::Unbalance>
  start_stage(const Stage              &stage,
              const bool                rolls,
              ShellEquations           &equations,
              const ContactInteraction &contact,
              const Gas                *gas,
              Progress                 &progress,
              State                    &state);
} // namespace Biface

#endif
