// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>

#include <biface/base/errors.h>
#include <biface/input/entry_declarations.h>
#include <biface/input/parameter_tools.h>
#include <biface/stepping/stage_control.h>
#include <biface/stepping/stage_loads.h>
#include <biface/stepping/stage_motion.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    std::vector<Formula>
    parse_velocity(const std::string &entry, const std::string &text)
    {
      std::vector<Formula> components;
      for (const std::string &formula : split_list(entry, text, ';'))
        components.emplace_back(
          entry, formula, std::vector<std::string>{"x", "y", "z"});
      if (!components.empty() && components.size() != 3)
        throw InputError(entry,
                         text,
                         "it must be empty or consist of three formulas of x, "
                         "y, z, separated by semicolons");
      return components;
    }
  } // namespace


  void
  StageMotion::add_parameters(EntryDeclarations &prm)
  {
    prm.add_parameter(
      "Inertia",
      inertia,
      "Whether the shell has inertia: the stage goes through the time "
      "'Duration', from the state and the velocities at the end of the stage "
      "before, and not through equilibria. The shell is at rest at the start if "
      "that stage has no inertia. A wheel that rolls moves in the frame of its "
      "axle; with friction it needs 'Transient rolling', too.",
      Patterns::Bool());
    prm.add_parameter(
      "Transient rolling",
      transient_rolling,
      "Whether a wheel that rolls on bristles goes through the time 'Duration': "
      "the bristles of its footprint move on in each step from those of the "
      "step before, so that forces follow a change of slip over a relaxation "
      "length. The wheel has no inertia unless 'Inertia' is true. 'false': rolling is steady. "
      "For a sudden change of slip, reach it in a stage of a very short 'Duration'; "
      "let a moment of the axle change over a cell at least, since it turns the "
      "wheel.",
      Patterns::Bool());
    add_optional_number(
      prm,
      "Time step",
      time_step,
      "Duration/Steps",
      "Duration of the first step of a stage with inertia, and of all of them "
      "with 'Time error = 0', rounded to an even part of 'Duration'. "
      "'Duration/Steps': by 'Steps'; where steps follow 'Time error' and 'Steps' "
      "is 1, a thousandth of 'Duration'.",
      Unit("time"));
    prm.add_parameter(
      "Time error",
      time_error,
      "Error of the displacements in a step of a stage with inertia, estimated "
      "from the change of the accelerations, relative to the displacement in "
      "the step at the largest velocity so far; steps become shorter above it "
      "and grow below, up to a twentieth of 'Duration', and are shorter where a "
      "'Load history' changes unevenly in them. Without damping, waves in the wall that an impact has "
      "left keep steps short. 0: equal steps.",
      Patterns::Double(),
      Unit::none());
    add_parsed(prm,
               "Initial velocity",
               "",
               initial_velocity,
               parse_velocity,
               "Velocity at the start of a stage with inertia: the components "
               "x, y, z as three formulas of the deformed position x, y, z, "
               "separated by semicolons: '0; 0; -3000' for a fall. Of a wheel "
               "that rolls, that of its shape in the frame of the axle. Empty: "
               "that at the end of the stage before.",
               Unit("length/time"));
    add_parsed(
      prm,
      "Initial velocities of bodies",
      "",
      velocities_of_bodies,
      [](const std::string &entry, const std::string &text) {
        return parse_named_numbers(entry,
                                   text,
                                   "each item must have the form "
                                   "'body motion: velocity'");
      },
      "Velocities at the start of a stage with inertia of bodies that "
      "'Forces on bodies' find, along their motions: a comma-separated "
      "list of 'body motion: velocity'. Otherwise they have that at the "
      "end of the stage before, or none. Supports move as the shell, "
      "see 'Initial velocity'.",
      Unit("length/time, for a motion that only turns 1/time in "
           "radians"));
    prm.add_parameter(
      "Moment of inertia",
      moment_of_inertia,
      "Moment of inertia about the axle of rim, brake and all else that turns "
      "with the shell of a wheel, which 'Control = axle moment' accelerates in a "
      "stage with inertia. That of the shell is not part of it.",
      Patterns::Double(),
      Unit("mass*length^2"));
    histories.add_parameters(prm);
    prm.add_parameter(
      "Mass damping",
      damping_in_time.of_mass,
      "Force per mass and velocity that brakes a shell with "
      "inertia or in a 'Frequency response': alpha of Rayleigh's damping. It also brakes "
      "rigid motions.",
      Patterns::Double(),
      Unit("1/time"));
    prm.add_parameter("Stiffness damping",
                      damping_in_time.of_stiffness,
                      "Stress of a rate of strain, divided by the stress of "
                      "such a strain, in a shell with inertia or in a "
                      "'Frequency response': beta of "
                      "Rayleigh's damping. It leaves rigid motions as they "
                      "are.",
                      Patterns::Double(),
                      Unit("time"));
    prm.add_parameter(
      "Numerical damping",
      damping_in_time.numerical,
      "Damping like 'Stiffness damping' of half the time step times this, "
      "which takes out the vibrations that the steps do not resolve: 0.2 after "
      "an impact. A vibration of the frequency f has the damping ratio "
      "1.6 f dt times it.",
      Patterns::Double(),
      Unit::none());
    prm.add_parameter("Contact damping",
                      damping_in_time.of_contact,
                      "Part of the pressure of contact by which it is larger "
                      "on the way in than on the way out, in a stage with "
                      "inertia: 0 to 1. The springs of 'Contact/"
                      "Regularization' lose energy by it.",
                      Patterns::Double(),
                      Unit::none());
  }


  void
  StageMotion::complete(const std::string &section,
                        StageControl      &control,
                        StageLoads        &loads) const
  {
    if (!inertia)
      return;
    control.adaptive = time_error > 0;
    if (time_step && *time_step > 0 && loads.duration > 0)
      {
        const double n = std::ceil(loads.duration / *time_step * (1 - 1e-9));
        if (!(n <= 1e6))
          throw InputError(section + "/Time step",
                           number_to_string(*time_step),
                           "it must be at least 'Duration'/1000000");
        control.n_steps = std::max(1u, static_cast<unsigned int>(n));
      }
    // whatever the loads do in a stage, a single step would not see it
    constexpr unsigned int n_unknown = 1000;
    if (control.adaptive && !time_step && control.n_steps == 1)
      control.n_steps = n_unknown;
    for (const std::string &name : histories.names())
      {
        const double end = *histories.value(name, loads.duration);
        const auto   set = [&](std::optional<double> &load,
                             const std::string     &entry) {
          if (load)
            throw InputError(
              section + "/" + entry,
              number_to_string(*load),
              "it must not be given, since 'Load history' has '" + name + "'");
          load = end;
        };
        if (name == "pressure" && loads.sealed)
          throw InputError(
            section + "/Load history",
            name,
            "it must not be given with 'Gas = sealed', where the "
            "pressure follows from the volume");
        if (name == "pressure")
          set(loads.pressure, "Pressure");
        else if (name == "travel")
          set(loads.travel, "Travel");
        else if (name == "turn")
          set(loads.turn, "Turn");
        else if (name == "angular velocity")
          set(loads.angular_velocity, "Angular velocity");
        else if (name == "ground velocity")
          set(loads.ground_velocity, "Ground velocity");
        else if (name == "slip angle")
          set(loads.slip_angle, "Slip angle");
        else if (name == "axle moment")
          {
            if (!control.prescribes_axle_moment())
              throw InputError(section + "/Load history",
                               name,
                               "it needs 'Control = axle moment'");
            if (control.axle_moment != 0)
              throw InputError(section + "/Axle moment",
                               number_to_string(control.axle_moment),
                               "it must not be given, since 'Load history' has "
                               "'" +
                                 name + "'");
          }
        else if (name == "load factor")
          set(loads.common_factor, "Load factor");
        else if (control.has_force(name))
          continue;
        else
          {
            std::optional<double> own;
            for (const auto &[other, factor] : loads.own_factors)
              if (other == name)
                own = factor.value_or(0);
            set(own, "Load factors");
            loads.own_factors.emplace_back(name, end);
          }
      }
  }


  void
  StageMotion::check(const std::string &section, const bool vibrates) const
  {
    const auto refuse_without_inertia = [&](const bool         given,
                                            const std::string &entry,
                                            const std::string &value) {
      if (given)
        throw InputError(
          section + "/" + entry, value, "it needs 'Inertia = true'");
    };
    if (!inertia)
      {
        refuse_without_inertia(time_step.has_value(),
                               "Time step",
                               number_to_string(time_step.value_or(0)));
        // a frequency response is damped by the same matrices
        for (const auto &[entry, value] :
             {std::make_pair("Mass damping", damping_in_time.of_mass),
              std::make_pair("Stiffness damping",
                             damping_in_time.of_stiffness)})
          {
            if (value != 0 && !vibrates)
              throw InputError(section + "/" + entry,
                               number_to_string(value),
                               "it needs 'Inertia = true' or a 'Frequency "
                               "response'");
            check_not_negative(section + "/" + entry, value);
          }
        for (const auto &[entry, value] :
             {std::make_pair("Numerical damping", damping_in_time.numerical),
              std::make_pair("Contact damping", damping_in_time.of_contact)})
          refuse_without_inertia(value != 0, entry, number_to_string(value));
        refuse_without_inertia(
          !initial_velocity.empty(),
          "Initial velocity",
          initial_velocity.empty() ? "" : initial_velocity[0].get_text());
        refuse_without_inertia(
          !velocities_of_bodies.empty(),
          "Initial velocities of bodies",
          velocities_of_bodies.empty() ? "" : velocities_of_bodies[0].first);
        refuse_without_inertia(moment_of_inertia != 0,
                               "Moment of inertia",
                               number_to_string(moment_of_inertia));
        const auto names = histories.names();
        refuse_without_inertia(
          !names.empty(), "Load history", names.empty() ? "" : names.front());
        return;
      }
    if (time_step)
      check_positive(section + "/Time step", *time_step);
    check_not_negative(section + "/Time error", time_error);
    check_at_most(section + "/Time error", time_error, 1);
    check_not_negative(section + "/Moment of inertia", moment_of_inertia);
    check_not_negative(section + "/Mass damping", damping_in_time.of_mass);
    check_not_negative(section + "/Stiffness damping",
                       damping_in_time.of_stiffness);
    check_not_negative(section + "/Numerical damping",
                       damping_in_time.numerical);
    check_at_most(section + "/Numerical damping", damping_in_time.numerical, 2);
    check_not_negative(section + "/Contact damping",
                       damping_in_time.of_contact);
    check_at_most(section + "/Contact damping", damping_in_time.of_contact, 1);
  }
} // namespace Biface
