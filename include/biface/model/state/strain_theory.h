// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_state_strain_theory_h
#define biface_model_state_strain_theory_h


namespace Biface
{
  /** The strain-displacement relations of a stage. */
  enum class StrainTheory
  {
    nonlinear,
    /** The relations linearized about the state at the start of the stage. */
    linear
  };
} // namespace Biface

#endif
