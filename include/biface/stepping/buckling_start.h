// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_stepping_buckling_start_h
#define biface_stepping_buckling_start_h

#include <functional>

#include <biface/model/state/loads.h>
#include <biface/stepping/load_level.h>

namespace Biface
{
  struct State;


  /** An equilibrium before the end of a stage, kept by reference. */
  struct EarlierEquilibrium
  {
    const State     &state;
    const LoadLevel &level;
  };


  /** The equilibrium from which the resultants and loads change on the way to
   * the end of a stage, with its loads. */
  struct BucklingStart : public EarlierEquilibrium
  {
    Loads loads;
  };


  /** The equilibrium from which buckling at the end of a stage is predicted:
   * that before the last step or, in linear strain theory, that at the start of
   * the stage, whose tangent is the tangent of the stage.
   * @param now the end of the stage.
   * @param start the loads at the start of the stage.
   * @param before_step the equilibrium before the last step.
   * @param loads_at the loads of a level. */
  BucklingStart
  buckling_start(const State                                   &now,
                 const LoadLevel                               &start,
                 const EarlierEquilibrium                      &before_step,
                 const std::function<Loads(const LoadLevel &)> &loads_at);
} // namespace Biface

#endif
