// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_stepping_step_messages_h
#define biface_stepping_step_messages_h

#include <deal.II/base/conditional_ostream.h>

#include <biface/stepping/stage_run.h>

namespace Biface
{
  struct ControlTrial;


  /** Print what is out of balance in a start from a prestress. */
  void
  print(const StageRun                  &run,
        const ShellEquations::Unbalance &unbalance,
        dealii::ConditionalOStream      &out);

  /** Print the number and the loads of a step. */
  void
  announce(const StageRun             &run,
           const ControlTrial         &trial,
           dealii::ConditionalOStream &out);
} // namespace Biface

#endif
