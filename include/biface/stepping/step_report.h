// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_stepping_step_report_h
#define biface_stepping_step_report_h

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <biface/model/forces/nodal_forces.h>
#include <biface/model/heat/rolling_heat.h>
#include <biface/model/quantities/footprint.h>
#include <biface/model/quantities/forces_on_shell.h>
#include <biface/model/quantities/rolling_summary.h>
#include <biface/model/quantities/work.h>
#include <biface/model/state/state.h>
#include <biface/stepping/foundation_stiffness.h>
#include <biface/stepping/stage.h>

namespace Biface
{
  struct Buckling;
  struct CriticalPoint;
  struct SensitivityTable;
  struct VibrationModes;


  /** A body, other than the foundation, after a step. */
  struct BodyReport
  {
    ContactSummary contact;
    /** The displacement of its 'Point', and its rotation as a vector, in
     * radians. */
    dealii::Tensor<1, 3> displacement, rotation;
  };


  /** The report of a converged step: the data needed by output in addition to
   * the State. */
  struct StepReport
  {
    /** Number of the step, from 1 through all stages. */
    unsigned int step = 0;
    /** The instant at the end of the step. */
    Instant instant;
    /** Name of the stage, and whether it has a foundation. */
    std::string stage;
    bool        in_contact = false;
    Loads       loads;
    /** The controlled quantity, if not a load, in words, and its value. */
    std::optional<std::pair<std::string, double>> controlled;
    /** All loads and motions reached; motions of the foundation are zero
     * without one. */
    LoadLevel level;
    /** If the wheel rolls over the ground. */
    std::optional<RollingSummary> rolling;
    /** Then, if its plies lose energy, their heat; and how often rolling and
     * conduction were computed in turn. */
    std::optional<RollingHeat::Field> heat;
    unsigned int                      n_heat_rounds = 0;
    /** Then, by node, see Biface::slip_velocities(); otherwise empty. */
    std::vector<dealii::Tensor<1, 3>> slip_velocities;
    /** Then, if free rolling has come before, see Biface::slip_ratio(). */
    std::optional<double> slip_ratio;
    /** See Progress. */
    Work           work;
    ContactSummary contact;
    Footprint      footprint;
    /** The bodies that are there beside the foundation, by name. */
    std::map<std::string, BodyReport> bodies;
    /** The forces on the nodes. */
    std::shared_ptr<const NodalForces> forces;
    /** Their resultants, see forces_on_shell(). */
    std::vector<ForceOnShell> forces_of_bodies;
    /** If the foundation alone has moved, in one way, since the start of the
     * stage. */
    std::optional<StepStiffness> stiffness;
    unsigned int                 iterations = 0;
    /** Relative residuals before each iteration and after the last. */
    std::vector<double> residuals;
    /** See NewtonResult; exact. */
    std::optional<unsigned int> n_negative_pivots;
    double                      seconds = 0;
    /** At the end of a stage that asks for them; null if there are none. */
    std::shared_ptr<const VibrationModes>   modes;
    std::shared_ptr<const Buckling>         buckling;
    std::shared_ptr<const SensitivityTable> sensitivities;
    /** If the step passed one; else null. */
    std::shared_ptr<const CriticalPoint> critical_point;
  };
} // namespace Biface

#endif
