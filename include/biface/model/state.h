// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_state_h
#define biface_model_state_h

#include <optional>
#include <vector>

#include <biface/base/linear_algebra.h>
#include <biface/contact/contact_conditions.h>
#include <biface/contact/moved_foundation.h>
#include <biface/element/modes.h>

namespace Biface
{
  /**
   * Everything that changes while the shell is loaded. A copy is a complete
   * restore point.
   */
  struct State
  {
    /** Nodal displacements, readable at all nodes of this rank. */
    LA::Vector displacement;

    /** The resultants @f$\mathbf H@f$ of each locally owned cell, an unknown
     * of the mixed iteration. Initial resultants are not included. */
    std::vector<Modes::Vector> resultants;

    /** Which nodes of this rank are in contact. */
    ContactConditions::ActiveSet active;
  };


  /** What acts on the shell. */
  struct Loads
  {
    /** See PressureLoad. Unit: force/area. */
    double pressure = 0;

    /** What the dead loads and the prescribed displacements are multiplied by.
     */
    double factor = 0;

    std::optional<MovedFoundation> foundation;
  };


  /** The figures of a contact zone. */
  struct ContactSummary
  {
    /** Compressive force on the foundation, along its direction. */
    double       force   = 0;
    unsigned int n_nodes = 0;
    /** Sum of the areas that belong to the active nodes, on the surface midway
     * between the faces. */
    double area         = 0;
    double max_pressure = 0;
  };


  /** Strain-displacement relations of a stage. */
  enum class StrainTheory
  {
    nonlinear,
    /** Linearized about the state in which the stage begins. */
    linear
  };


  /** What becomes of the resultants after an iteration, see
   * ShellEquations::update(). */
  enum class NewtonIteration
  {
    /** The resultants are unknowns of the Hu-Washizu functional and take their
     * linearized prediction. */
    mixed,
    /** The resultants follow from the displacements. */
    substituted
  };
} // namespace Biface

#endif
