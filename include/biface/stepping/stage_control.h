// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_stepping_stage_control_h
#define biface_stepping_stage_control_h

#include <string>
#include <utility>
#include <vector>

#include <biface/contact/body_motion.h>
#include <biface/model/mesh/component.h>

namespace Biface
{
  class EntryDeclarations;


  /** The quantity prescribed in every step of a stage, see Control. */
  enum class ControlKind
  {
    load,
    displacement,
    arc_length,
    ground_force,
    axle_moment,
    ground_force_and_axle_moment
  };

  /** The names of the controls in parameter files, in the order of
   * ControlKind. */
  const std::vector<std::string> &
  control_names();


  /** A motion of a body, or of supports, that is not prescribed but found by a
   * force. */
  struct MotionByForce
  {
    /** The body; empty for supports, whose motion has the name of their factor
     * in 'Load factors'. */
    std::string body;
    BodyMotion  motion;
    /** The prescribed value at the end of the stage: the force along the
     * translation of the motion or, without one, the moment about the axis. */
    double force = 0;

    bool
    moves_supports() const
    {
      return body.empty();
    }

    /** The name in 'Forces on bodies': those of body and motion, or of the
     * factor of supports. */
    std::string
    name() const
    {
      return moves_supports() ? motion.name : body + " " + motion.name;
    }

    /** The name of the factor in 'Load factors'. */
    std::string
    name_of_factor() const
    {
      return moves_supports() ? motion.name : "bodies " + name();
    }

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &body &motion &force;
    }
  };


  /** How the steps of a stage are controlled. */
  struct StageControl
  {
    ControlKind control = ControlKind::load;
    /** The prescribed displacement: a named point, the component, and the value
     * at the end of the stage. */
    std::string control_point;
    Component   control_component = Component::x;
    double      control_value     = 0;
    /** The force on the ground at the end of the stage, if prescribed. */
    double force = 0;
    /** The moment of the axle on the wheel at the end of the stage, if
     * prescribed. */
    double axle_moment = 0;
    /** The forces on bodies as given, by the names of body and motion.
     * Checkpoints have the following ones. */
    std::vector<std::pair<std::string, double>> forces_on_bodies;
    /** The motions found by forces with these forces, set by
     * Parameters::assign_load_factors(). */
    std::vector<MotionByForce> motions_by_force;
    unsigned int               n_steps = 1;
    /** Whether steps of the loads or the force grow after fast convergence. */
    bool adaptive = false;

    /** Whether 'Forces on bodies' has a name. */
    bool
    has_force(const std::string &name) const;

    bool
    prescribes_force() const
    {
      return control == ControlKind::ground_force ||
             control == ControlKind::ground_force_and_axle_moment;
    }

    bool
    prescribes_axle_moment() const
    {
      return control == ControlKind::axle_moment ||
             control == ControlKind::ground_force_and_axle_moment;
    }

    /** Whether the wheel rolls freely at the end of the stage. */
    bool
    ends_free_rolling() const
    {
      return prescribes_axle_moment() && axle_moment == 0;
    }

    /** The value of 'Control' in parameter files, see control_names(). */
    const std::string &
    control_name() const;

    /** Declare the entries of the control. */
    void
    add_parameters(EntryDeclarations &prm);

    /** Throws InputError if a value is invalid. */
    void
    check(const std::string &section) const;

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &control &control_point &control_component     &control_value;
      archive &force &axle_moment &motions_by_force &n_steps &adaptive;
    }
  };
} // namespace Biface

#endif
