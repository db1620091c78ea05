// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_stepping_stage_motion_h
#define biface_stepping_stage_motion_h

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <biface/input/formula.h>
#include <biface/input/named_numbers.h>
#include <biface/model/state/damping_in_time.h>
#include <biface/stepping/load_histories.h>

namespace Biface
{
  class EntryDeclarations;
  struct StageControl;
  struct StageLoads;


  /** How the shell moves in a stage with inertia. */
  struct StageMotion
  {
    /** Whether the shell has inertia: the stage goes through time and not
     * through equilibria. */
    bool inertia = false;
    /** Whether the footprint of a wheel that rolls has a past: bristles move on
     * from those of the step before, see RollingStep. */
    bool transient_rolling = false;
    /** The duration of the first step. Unit: time. */
    std::optional<double> time_step;
    /** The error of a step, relative to the largest velocity, above which steps
     * become shorter; 0 for equal steps. */
    double        time_error = 0.01;
    DampingInTime damping_in_time;

    /** About the axle, of what turns with a wheel that rolls beside the shell.
     * Unit: mass*length². */
    double moment_of_inertia = 0;

    /** The formulas of the velocity at the start, by component x, y, z, of the
     * position x, y, z there; empty for that at the end of the stage before.
     * Unit: length/time. */
    std::vector<Formula> initial_velocity;

    /** The velocities at the start of bodies that forces find, by their names
     * in 'Forces on bodies'. Unit: length/time, or 1/time in radians. */
    NamedNumbers velocities_of_bodies;

    /** Loads as functions of the time. */
    LoadHistories histories;

    void
    add_parameters(EntryDeclarations &prm);

    /** Set the steps, and the loads at the end of the stage that histories
     * give. Throws InputError if the stage gives both. */
    void
    complete(const std::string &section,
             StageControl      &control,
             StageLoads        &loads) const;

    /** Throws InputError if a value is invalid.
     * @param vibrates whether there is a response to harmonic excitations, in
     * which the shell is damped, too. */
    void
    check(const std::string &section, const bool vibrates) const;

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &inertia &transient_rolling &time_error &damping_in_time
        &moment_of_inertia;
    }
  };
} // namespace Biface

#endif
