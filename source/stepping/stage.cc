// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/numbers.h>

#include <cmath>
#include <limits>

#include <biface/base/errors.h>
#include <biface/contact/friction.h>
#include <biface/input/parameter_tools.h>
#include <biface/stepping/controls/control.h>
#include <biface/stepping/stage.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    /** The number of an earlier stage than @p number, or "previous". */
    std::optional<unsigned int>
    parse_start(const std::string &entry,
                const std::string &text,
                const unsigned int number)
    {
      if (text == "previous")
        return {};
      const std::string several =
        (number > 2 ? "the number of an earlier stage, 1 to " : "");
      const std::string allowed =
        (number == 1 ? "it must be 'previous': no stage comes before"
                     : "it must be 'previous' or " + several +
                         std::to_string(number - 1));
      const double earlier = parse_number(entry, text, allowed);
      if (!(earlier >= 1 && earlier < number && earlier == std::floor(earlier)))
        throw InputError(entry, text, allowed);
      return static_cast<unsigned int>(earlier);
    }
  } // namespace


  void
  Stage::add_parameters(ParameterHandler &prm, const unsigned int number)
  {
    name                        = "stage " + std::to_string(number);
    const std::string unchanged = "unchanged";
    std::string       selection;
    for (const std::string &control : control_names())
      selection += (selection.empty() ? "" : "|") + control;

    prm.add_parameter(
      "Name", name, "Name of the stage in the results.", Patterns::Anything());
    add_parsed(
      prm,
      "Stage " + std::to_string(number) + "/",
      "Start from",
      "previous",
      start_from,
      [number](const std::string &entry, const std::string &text) {
        return parse_start(entry, text, number);
      },
      "The stage from whose end this one starts: 'previous', or the number of "
      "an earlier stage, so that several stages can branch from the same "
      "state. Loads that are 'unchanged' are those at the end of that "
      "stage.");
    add_optional_number(
      prm,
      "Pressure",
      pressure,
      unchanged,
      "Pressure at the end of the stage; see the section 'Loads' for its "
      "face and type. 'unchanged': as at the start of the stage. "
      "Unit: force/area.");
    add_choice(prm,
               "Gas",
               sealed,
               {"open", "sealed"},
               "Whether the gas that exerts the pressure can leave the shell. "
               "'open': the pressure is that of the stage. 'sealed': from the "
               "start of the stage the pressure follows from the volume of "
               "the cavity, see the section 'Gas'.");
    prm.add_parameter("Contact",
                      contact,
                      "Whether the stage has contact with the rigid "
                      "foundation of the section 'Contact'. Initially the "
                      "foundation just touches the shell as deformed at the "
                      "start of the first stage with contact (or of the "
                      "first after 'Start from prestress') on the way to the "
                      "stage.",
                      Patterns::Bool());
    add_optional_number(
      prm,
      "Travel",
      travel,
      unchanged,
      "Travel of the foundation against 'Direction' at the end of the stage, "
      "measured from where it first touched the shell. 'unchanged': as at "
      "the start of the stage. Unit: length.");
    add_optional_vector(
      prm,
      "Stage " + std::to_string(number) + "/",
      "Slide",
      slide,
      unchanged,
      "Components x, y, z of the motion of the foundation sideways, orthogonal "
      "to 'Contact/Direction', at the end of the stage. 'unchanged': as at the "
      "start of the stage. Unit: length.");
    add_optional_number(
      prm,
      "Turn",
      turn,
      unchanged,
      "Angle by which the foundation has turned at the end of the stage, "
      "right-handed about 'Contact/Direction' through the point where it first "
      "touched the shell; this axis slides with the foundation. 'unchanged': "
      "as at the start of the stage. Unit: degrees.");
    add_optional_number(
      prm,
      "Wheel turn",
      wheel_turn,
      unchanged,
      "Angle by which the wheel, its supports and loads included, has turned "
      "at the end of the stage, right-handed about the y axis. The results are "
      "in axes that turn with the wheel: the foundation goes around it the "
      "other way, after 'Travel', 'Slide' and 'Turn'. To roll slowly, let the "
      "foundation slide, too. 'unchanged': as at the start of the stage. Unit: "
      "degrees.");
    add_optional_number(
      prm,
      "Angular velocity",
      angular_velocity,
      unchanged,
      "Angular velocity of a steadily rolling or spinning wheel at the end of "
      "the stage, right-handed about the y axis. 'unchanged': as at the start "
      "of the stage. Unit: radians/time.");
    add_optional_number(
      prm,
      "Ground velocity",
      ground_velocity,
      unchanged,
      "Speed of the wheel over the ground, or of the surface of a drum, at the "
      "end of the stage, positive "
      "forward: the direction in which a wheel with positive 'Angular "
      "velocity' rolls. If it or the angular velocity is not 0 at either end "
      "of the stage, friction follows from the slip velocity, see "
      "'Contact/Critical velocity', without history. 'unchanged': as at the "
      "start of the stage. Unit: length/time.");
    add_optional_number(
      prm,
      "Slip angle",
      slip_angle,
      unchanged,
      "Angle between the direction in which the wheel moves over the ground "
      "and its plane at the end of the stage, positive to the left. A drum is "
      "turned by it about 'Direction' through 'Point on path'. "
      "'unchanged': as at the start of the stage. Unit: degrees.");
    add_optional_number(
      prm,
      "Slip ratio",
      slip_ratio,
      "none",
      "Longitudinal slip ratio at the end of the stage, (Omega R - V cos "
      "alpha)/(V cos alpha) with the angular velocity Omega, which it replaces, "
      "the ground velocity V and the slip angle alpha; R is the rolling radius "
      "V cos alpha/Omega at the end of the last stage before that ended in "
      "free rolling, with a prescribed 'Axle moment' of 0. Negative for "
      "braking, -1 for a locked wheel. 'none': see 'Angular velocity'. No "
      "unit.");
    prm.add_parameter("Friction",
                      friction,
                      "Coefficient of friction in the stage, instead of that "
                      "of the section 'Contact'; empty for that one. A number, "
                      "or a formula of the contact pressure p and the slip "
                      "velocity s. No unit.",
                      Patterns::Anything());
    prm.add_parameter("Glued",
                      glued,
                      "Whether the nodes in contact at the start of the stage "
                      "cannot slip, as long as they are in contact. Nodes that "
                      "come into contact later have friction.",
                      Patterns::Bool());
    add_optional_number(
      prm,
      "Load factor",
      factor,
      unchanged,
      "Factor of the loads of the section 'Loads' and of prescribed "
      "displacements of supports at the end of the stage. 'unchanged': as at "
      "the start of the stage. No unit.");
    prm.add_parameter(
      "Control",
      control,
      "The quantity prescribed in every step: 'load' (equal steps of all "
      "loads), 'displacement' (equal steps of one displacement; the fraction "
      "of the loads of the stage is computed and may exceed 1), 'arc length' "
      "(adaptive steps of the norm of all displacements, which pass limit "
      "points, until the loads of the stage are reached; 'Steps' sets the "
      "first step: 1/Steps of the loads), or 'foundation force' (equal steps "
      "of the force on the foundation and of all loads; the travel is "
      "computed), or 'axle moment' (equal steps of the moment of the axle on a "
      "rolling wheel and of all loads; the angular velocity is computed), or "
      "'foundation force and axle moment' (both are prescribed, travel and "
      "angular velocity are computed).",
      Patterns::Selection(selection));
    prm.add_parameter("Control point",
                      control_point,
                      "Name of the point whose displacement (of the middle "
                      "surface) is prescribed.",
                      Patterns::Anything());
    add_choice(prm,
               "Control component",
               control_component,
               component_names(),
               "Component of the prescribed displacement: Cartesian, in the "
               "frame of the coordinate lines, or, for a surface of "
               "revolution, about its axis.");
    prm.add_parameter("Control value",
                      control_value,
                      "Value of the prescribed displacement at the end of "
                      "the stage. Unit: length.",
                      Patterns::Double());
    prm.add_parameter("Force",
                      force,
                      "Compressive force on the foundation at the end of a "
                      "stage whose 'Control' prescribes it. Unit: force.",
                      Patterns::Double());
    prm.add_parameter("Axle moment",
                      axle_moment,
                      "Moment of the axle on the wheel about the y axis at the "
                      "end of a stage whose 'Control' prescribes it: 0 for "
                      "free rolling, negative for braking. Unit: "
                      "force*length.",
                      Patterns::Double());
    prm.add_parameter("Steps",
                      n_steps,
                      "Number of steps; see 'Control'.",
                      Patterns::Integer(1, 1000000));
    prm.add_parameter("Adaptive steps",
                      adaptive,
                      "Whether steps of the loads or the force grow beyond "
                      "1/Steps after fast convergence; see 'Maximum growth'. "
                      "Otherwise all multiples of 1/Steps are reached and "
                      "written.",
                      Patterns::Bool());
    add_choice(prm,
               "Strain theory",
               theory,
               {"nonlinear", "linear"},
               "'nonlinear' (finite displacements) or 'linear' (linearized "
               "about the state at the start of the stage, with its "
               "stresses; contact remains unilateral). Consecutive linear "
               "stages are linearized about different states.");
    prm.add_parameter("Start from prestress",
                      from_prestress,
                      "Whether the stage starts from the undeformed shape "
                      "with the resultants reached so far as initial "
                      "resultants. All loads go on: 'Pressure' and 'Load "
                      "factor' keep their values. Constant forces on the "
                      "nodes take up what is out of balance at the start of "
                      "the stage; its size is printed. Displacements, "
                      "prescribed ones included, and the travel of the "
                      "foundation count anew from 0.",
                      Patterns::Bool());
    prm.add_parameter("Modes",
                      n_modes,
                      "Number of natural frequencies and modes of vibration "
                      "of the loaded shell that are computed at the end of "
                      "the stage, the lowest ones. The foundation holds the "
                      "nodes in contact along its normal and, with friction, "
                      "sideways; on a wheel that rolls, friction follows from "
                      "the slip velocity, and there are gyroscopic terms. All "
                      "plies need a 'Density'.",
                      Patterns::Integer(0, 1000));
    prm.add_parameter("Buckling",
                      n_buckling,
                      "Number of buckling loads that are predicted at the end "
                      "of the stage, the lowest ones: the loads under which "
                      "the tangent is singular if stresses and loads go on "
                      "changing as in the last step of the stage, but the "
                      "shape does not. For the linear buckling load of an "
                      "unloaded shell, a stage of one step with a small part "
                      "of this load, or any load with 'Strain theory = "
                      "linear', where they change as in the whole stage. See "
                      "'Modes' for the nodes in contact.",
                      Patterns::Integer(0, 1000));
    add_choice(prm,
               "Critical points",
               critical_points,
               {"ignore", "report", "locate", "switch branch"},
               "What happens where the number of negative pivots of the "
               "tangent changes along the path. 'report': the program says "
               "after the step whether it is a limit point or a bifurcation. "
               "'locate': the step ends there, by bisection of the step to "
               "0.1 % of the loads. 'switch branch': likewise, and at a "
               "bifurcation the path goes on along the other branch; with "
               "'Control = load' or 'arc length'.");
    prm.add_parameter("Branch amplitude",
                      branch_amplitude,
                      "The largest displacement in the critical shape with "
                      "which the other branch is sought, as a multiple of the "
                      "thickness. The sign chooses the side. With 'Control = "
                      "load', it doubles until the branch has reached the "
                      "loads of the next step. No unit.",
                      Patterns::Double());
  }


  void
  Stage::check(const std::string &section) const
  {
    if (name.empty() || name.find_first_of(",\"\n\r") != std::string::npos)
      throw InputError(section + "/Name",
                       name,
                       "it must not be empty or contain a comma, a quotation "
                       "mark or a line break");
    const auto check_load = [&](const std::string           &entry,
                                const std::optional<double> &load) {
      if (load)
        check_finite(section + "/" + entry, *load);
    };
    check_load("Pressure", pressure);
    check_load("Travel", travel);
    check_load("Load factor", factor);
    check_load("Turn", turn);
    check_load("Wheel turn", wheel_turn);
    check_load("Angular velocity", angular_velocity);
    check_load("Ground velocity", ground_velocity);
    check_load("Slip angle", slip_angle);
    check_load("Slip ratio", slip_ratio);
    if (slip_ratio && !contact)
      throw InputError(section + "/Slip ratio",
                       number_to_string(*slip_ratio),
                       "it needs 'Contact = true'");
    if (slip_ratio && (angular_velocity || prescribes("axle moment")))
      throw InputError(section + "/Slip ratio",
                       number_to_string(*slip_ratio),
                       "it must be 'none' with " +
                         (angular_velocity ? "a given 'Angular velocity'"
                                           : "'Control = " + control + "'"));
    if (slide)
      check_finite(section + "/Slide", *slide);
    if (!friction.empty())
      check_friction(section + "/Friction", friction);
    if (sealed && pressure)
      throw InputError(section + "/Pressure",
                       number_to_string(*pressure),
                       "it must be 'unchanged' in a stage with 'Gas = sealed', "
                       "where the pressure follows from the volume");
    if (sealed && theory == StrainTheory::linear)
      throw InputError(section + "/Strain theory",
                       "linear",
                       "a stage with 'Gas = sealed' must be nonlinear");
    const std::string critical =
      critical_points == CriticalPoints::locate ? "locate" : "switch branch";
    const auto refuse_critical = [&](const bool wrong, const std::string &why) {
      if (wrong)
        throw InputError(section + "/Critical points", critical, why);
    };
    if (locates_critical_points())
      {
        refuse_critical(sealed, "it needs 'Gas = open'");
        refuse_critical(theory == StrainTheory::linear,
                        "it needs 'Strain theory = nonlinear'");
      }
    if (critical_points == CriticalPoints::switch_branch)
      {
        refuse_critical(control != "load" && control != "arc length",
                        "it needs 'Control = load' or 'arc length'");
        refuse_critical(moves_foundation(), "the foundation must not move");
        if (!std::isfinite(branch_amplitude) || branch_amplitude == 0)
          throw InputError(section + "/Branch amplitude",
                           number_to_string(branch_amplitude),
                           "it must be finite and not 0");
      }
    if (control != "load" && theory == StrainTheory::linear)
      throw InputError(section + "/Strain theory",
                       "linear",
                       "a linear stage must have 'Control = load'");
    if (!prescribes("foundation force") && force != 0)
      throw InputError(section + "/Force",
                       number_to_string(force),
                       "it needs 'Control = foundation force' or "
                       "'foundation force and axle moment'");
    if (!prescribes("axle moment") && axle_moment != 0)
      throw InputError(section + "/Axle moment",
                       number_to_string(axle_moment),
                       "it needs 'Control = axle moment' or 'foundation "
                       "force and axle moment'");
    if (contact)
      return;

    const auto refuse_motion = [&](const std::string           &entry,
                                   const std::optional<double> &motion) {
      if (motion.value_or(0) != 0)
        throw InputError(section + "/" + entry,
                         number_to_string(*motion),
                         "it must be 0 unless 'Contact = true'");
    };
    refuse_motion("Travel", travel);
    if (slide && slide->norm() > 0)
      throw InputError(section + "/Slide",
                       vector_to_string(*slide),
                       "it must be 0 unless 'Contact = true'");
    refuse_motion("Turn", turn);
    refuse_motion("Wheel turn", wheel_turn);
    if (!friction.empty())
      throw InputError(
        section + "/Friction", friction, "it needs 'Contact = true'");
    if (glued)
      throw InputError(section + "/Glued", "true", "it needs 'Contact = true'");
  }


  void
  Stage::check_slide(const std::string  &section,
                     const Tensor<1, 3> &direction) const
  {
    if (slide &&
        std::abs(*slide * direction) > 1e-6 * slide->norm() * direction.norm())
      throw InputError(section + "/Slide",
                       vector_to_string(*slide),
                       "it must be orthogonal to 'Contact/Direction', " +
                         vector_to_string(direction) +
                         "; 'Travel' moves the foundation along it");
  }


  namespace
  {
    /** The component of the velocity of a wheel in its plane. */
    double
    forward_velocity(const LoadLevel &level)
    {
      return level.ground_velocity *
             std::cos(level.slip_angle * numbers::PI / 180);
    }
  } // namespace


  Stage
  Stage::with_angular_velocity(const LoadLevel             &start,
                               const std::optional<double> &free_radius) const
  {
    Stage result = *this;
    if (slip_ratio)
      {
        Assert(free_radius, ExcNotInitialized());
        const LoadLevel last = end(start);
        result.angular_velocity =
          (1 + *slip_ratio) * forward_velocity(last) / *free_radius;
      }
    return result;
  }


  double
  free_rolling_radius(const LoadLevel &level)
  {
    return forward_velocity(level) / level.angular_velocity;
  }


  double
  slip_ratio(const LoadLevel &level, const double free_radius)
  {
    const double forward = forward_velocity(level);
    return forward != 0 ? level.angular_velocity * free_radius / forward - 1
                        : std::numeric_limits<double>::quiet_NaN();
  }


  std::optional<unsigned int>
  stage_before(const std::vector<Stage> &stages, const unsigned int position)
  {
    if (position == 0)
      return {};
    return stages[position].start_from.value_or(position) - 1;
  }


  bool
  is_branched_from(const std::vector<Stage> &stages,
                   const unsigned int        position)
  {
    for (unsigned int later = position + 2; later < stages.size(); ++later)
      if (stage_before(stages, later) == position)
        return true;
    return false;
  }


  void
  check_stages(const std::vector<Stage> &stages)
  {
    std::vector<Control::KnownStart> ends;
    for (unsigned int i = 0; i < stages.size(); ++i)
      {
        const Stage      &stage   = stages[i];
        const std::string section = "Stage " + std::to_string(i + 1);
        const auto        before  = stage_before(stages, i);
        stage.check(section);
        if (stage.glued &&
            (!before || !stages[*before].contact || stage.from_prestress))
          throw InputError(section + "/Glued",
                           "true",
                           "the stage from which it starts must have 'Contact "
                           "= true', since the nodes in contact at its end "
                           "are glued");
        if (stage.slip_ratio)
          {
            std::optional<unsigned int> free = before;
            while (free && !stages[*free].ends_rolling_freely())
              free = stage_before(stages, *free);
            if (!free)
              throw InputError(section + "/Slip ratio",
                               number_to_string(*stage.slip_ratio),
                               "a stage before must end in free rolling, with "
                               "'Control = axle moment' and 'Axle moment = "
                               "0': it gives the rolling radius");
          }
        Control::KnownStart start =
          (before ? ends[*before] : Control::KnownStart::undeformed());
        if (stage.from_prestress)
          {
            for_each_motion([](auto &known, const auto &zero) { known = zero; },
                            start,
                            LoadLevel());
            start.is_undeformed = true;
          }
        const auto control = make_control(stage);
        control->check(section, start);
        ends.push_back(control->known_end(start));
      }
  }
} // namespace Biface
