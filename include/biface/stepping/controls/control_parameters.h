// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_stepping_controls_control_parameters_h
#define biface_stepping_controls_control_parameters_h

namespace Biface
{
  class EntryDeclarations;


  /** How far all controls may cut steps and let them grow. */
  struct ControlParameters
  {
    unsigned int max_cuts       = 6;
    unsigned int max_arc_steps  = 1000;
    double       maximum_growth = 10;

    void
    add_parameters(EntryDeclarations &prm);
  };
} // namespace Biface

#endif
