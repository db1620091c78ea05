// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_stepping_load_stepping_parameters_h
#define biface_stepping_load_stepping_parameters_h

#include <deal.II/base/numbers.h>

#include <biface/stepping/controls/control_parameters.h>

namespace Biface
{
  class EntryDeclarations;


  /** How LoadStepping goes through the stages. */
  struct LoadSteppingParameters
  {
    ControlParameters control;
    bool              predict = true;
    /** The stage after which the run ends; the last one at the latest. */
    unsigned int last_stage = dealii::numbers::invalid_unsigned_int;

    void
    add_parameters(EntryDeclarations &prm);
  };
} // namespace Biface

#endif
