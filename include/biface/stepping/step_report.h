// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_stepping_step_report_h
#define biface_stepping_step_report_h

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <biface/model/contact/contact_summary.h>
#include <biface/model/heat/heat_of_plies.h>
#include <biface/model/quantities/footprint.h>
#include <biface/model/quantities/forces_on_shell.h>
#include <biface/model/quantities/rolling_summary.h>
#include <biface/model/quantities/work.h>
#include <biface/model/time/energy_of_motion.h>
#include <biface/stepping/instant.h>
#include <biface/stepping/load_level.h>
#include <biface/stepping/stiffness_of_motions.h>

namespace Biface
{
  struct Buckling;
  struct CriticalPoint;
  struct FrequencyResponse;
  struct Loads;
  class NodalForces;
  struct SensitivityTable;
  struct VibrationModes;


  /** The contact and the motion of a body, other than the ground, after a
   * step. */
  struct BodyReport
  {
    ContactSummary contact;
    /** The displacement of the entry 'Point' of the body, and its rotation as a
     * vector, in radians. */
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
    /** The name of the stage, and whether it has a ground. */
    std::string                  stage;
    bool                         in_contact = false;
    std::shared_ptr<const Loads> loads;
    /** The controlled quantity, if not a load, in words, and its value. */
    std::optional<std::pair<std::string, double>> controlled;
    /** All loads and motions reached; motions of the ground are zero
     * without one. */
    LoadLevel level;
    /** The forces and powers of a wheel that rolls over the ground; not set
     * otherwise. */
    std::optional<RollingSummary> rolling;
    /** The heat of the plies of a rolling wheel, if they lose energy, and how
     * often rolling and conduction were computed in turn. */
    std::optional<HeatOfPlies> heat;
    unsigned int               n_heat_rounds = 0;
    /** The slip velocities of a rolling wheel by node, see
     * Biface::slip_velocities(); otherwise empty. */
    std::vector<dealii::Tensor<1, 3>> slip_velocities;
    /** The slip ratio of a rolling wheel, if free rolling has come before, see
     * Biface::slip_ratio(). */
    std::optional<double> slip_ratio;
    /** The work of the loads and of contact, see Progress. */
    Work work;
    /** The energies and momenta of a shell that moves, in a stage with inertia.
     */
    std::optional<EnergyOfMotion> motion;
    /** The mean moment of the axle in a step of a wheel that rolls in a stage
     * with inertia, see axle_moment_in_time(). Unit: force times length. */
    std::optional<double> axle_moment;
    ContactSummary        contact;
    Footprint             footprint;
    /** The bodies that are there beside the ground, by name. */
    std::map<std::string, BodyReport> bodies;
    /** The forces on the nodes. */
    std::shared_ptr<const NodalForces> forces;
    /** The resultants of the forces on the nodes, see forces_on_shell(). */
    std::vector<ForceOnShell> forces_of_bodies;
    /** The stiffness of the motions of the ground, bodies and supports, by
     * name, see stiffness_of_motions(). */
    std::map<std::string, StepStiffness> stiffness;
    unsigned int                         iterations = 0;
    /** How often the step was halved. */
    unsigned int n_cuts = 0;
    /** The relative residuals before each iteration and after the last. */
    std::vector<double> residuals;
    /** The exact number of negative pivots, see
     * NewtonResult::exact_pivots(). */
    std::optional<unsigned int> n_negative_pivots;
    double                      seconds = 0;
    /** The results at the end of a stage that asks for them; null if there are
     * none. */
    std::shared_ptr<const VibrationModes>    modes;
    std::shared_ptr<const Buckling>          buckling;
    std::shared_ptr<const FrequencyResponse> response;
    std::shared_ptr<const SensitivityTable>  sensitivities;
    /** The critical point that the step has passed; null if there is none. */
    std::shared_ptr<const CriticalPoint> critical_point;
  };
} // namespace Biface

#endif
