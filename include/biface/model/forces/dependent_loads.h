// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_forces_dependent_loads_h
#define biface_model_forces_dependent_loads_h

#include <biface/base/linear_algebra.h>
#include <biface/model/state/load_rates.h>

namespace Biface
{
  /** Loads that change with the displacements of the whole shell, such as the
   * pressure of a sealed gas. */
  struct DependentLoads
  {
    /** The change of the loads per unit of a quantity, and the derivative of
     * this quantity with respect to the nodal unknowns (locally owned
     * entries). */
    LoadRates  rates;
    LA::Vector gradient;
  };
} // namespace Biface

#endif
