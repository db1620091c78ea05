// SPDX-License-Identifier: LGPL-2.1-or-later

#include <cmath>

#include <biface/base/errors.h>
#include <biface/contact/friction_coefficient.h>
#include <biface/input/entry_declarations.h>
#include <biface/input/parameter_tools.h>
#include <biface/stepping/stage_loads.h>

namespace Biface
{
  using namespace dealii;

  NamedFactors
  parse_load_factors(const std::string &entry, const std::string &text)
  {
    const std::string form =
      "each item must have the form 'name: factor' or 'name: unchanged'";
    NamedFactors factors;
    for (const auto &[name, factor] : split_named_list(entry, text, form))
      {
        // without a number, the factor stays as at the start of the stage
        factors.emplace_back(name, std::nullopt);
        if (factor != "unchanged")
          factors.back().second = parse_number(entry, factor, form);
      }
    return factors;
  }


  void
  StageLoads::set_factors(const std::vector<std::vector<std::string>> &names)
  {
    names_of_factors = names;
    factors.assign(names.size(), common_factor);
    for (unsigned int i = 0; i < names.size(); ++i)
      // from the most general to the longest name, of which the last one that
      // is given counts
      for (const std::string &name : names[i])
        for (const auto &[own_name, factor] : own_factors)
          if (own_name == name)
            factors[i] = factor;
  }


  std::vector<unsigned int>
  StageLoads::positions_in(const StageLoads &other) const
  {
    std::vector<unsigned int> positions;
    for (const std::vector<std::string> &names : names_of_factors)
      {
        // what had no factor of its own follows the common one
        unsigned int position = 0;
        for (const std::string &name : names)
          for (unsigned int i = 1; i < other.names_of_factors.size(); ++i)
            if (other.names_of_factors[i].back() == name)
              position = i;
        positions.push_back(position);
      }
    return positions;
  }


  namespace
  {
    std::vector<std::string>
    parse_bodies(const std::string &entry, const std::string &text)
    {
      return split_list(entry, text, ',', 1000);
    }


    std::shared_ptr<const FrictionCoefficient>
    parse_own_friction(const std::string &entry, const std::string &text)
    {
      if (text.empty())
        return nullptr;
      return std::make_shared<const FrictionCoefficient>(entry, text);
    }
  } // namespace


  void
  StageLoads::add_parameters(EntryDeclarations &prm)
  {
    // most entries have no number by default: a stage keeps what it does not
    // set
    const std::string unchanged = "unchanged";
    add_optional_number(
      prm,
      "Pressure",
      pressure,
      unchanged,
      "Pressure at the end of the stage; see the section 'Loads' for its "
      "face and type. 'unchanged': as at the start of the stage.",
      Unit("force/area") | RestartChange::within_stage);
    add_choice(prm,
               "Gas",
               sealed,
               {"open", "sealed"},
               "Whether the gas that exerts the pressure can leave the shell. "
               "'open': the pressure is that of the stage. 'sealed': from the "
               "start of the stage the pressure follows from the volume of "
               "the cavity, see the section 'Gas'.");
    prm.add_parameter(
      "Damping",
      damping,
      "Viscous damping of the motion of the wall, for stages in "
      "which the shell becomes unstable and snaps: the force per "
      "area that opposes a motion of 1 over the whole stage. It "
      "is small enough if 'damping_work' in history.csv is a "
      "small part of the work of the loads but for snaps. The "
      "forces vanish in the first step of the next stage.",
      Patterns::Double(),
      Unit("force/volume"));
    prm.add_parameter("Contact",
                      contact,
                      "Whether the stage has contact with the rigid "
                      "ground of the section 'Contact'. Initially the "
                      "ground just touches the shell as deformed at the "
                      "start of the first stage with contact (or of the "
                      "first after 'Start from prestress') on the way to the "
                      "stage.",
                      Patterns::Bool());
    add_optional_number(
      prm,
      "Travel",
      travel,
      unchanged,
      "Travel of the ground against 'Direction' at the end of the stage, "
      "measured from where it first touched the shell. 'unchanged': as at "
      "the start of the stage.",
      Unit("length") | RestartChange::within_stage);
    add_optional_vector(
      prm,
      "Slide",
      slide,
      unchanged,
      "Components x, y, z of the motion of the ground sideways, orthogonal "
      "to 'Contact/Direction', at the end of the stage. 'unchanged': as at the "
      "start of the stage.",
      Unit("length") | RestartChange::within_stage);
    add_optional_number(
      prm,
      "Turn",
      turn,
      unchanged,
      "Angle by which the ground has turned at the end of the stage, "
      "right-handed about 'Contact/Direction' through the point where it first "
      "touched the shell; this axis slides with the ground. 'unchanged': "
      "as at the start of the stage.",
      Unit::degrees() | RestartChange::within_stage);
    add_optional_number(
      prm,
      "Wheel turn",
      wheel_turn,
      unchanged,
      "Angle by which the wheel, its supports and loads included, has turned "
      "at the end of the stage, right-handed about the y axis. The results are "
      "in axes that turn with the wheel: the ground goes around it the "
      "other way, after 'Travel', 'Slide' and 'Turn'. To roll slowly, let the "
      "ground slide, too. 'unchanged': as at the start of the stage.",
      Unit::degrees() | RestartChange::within_stage);
    add_optional_number(
      prm,
      "Inclination angle",
      inclination_angle,
      unchanged,
      "Angle by which the wheel leans to its right at the end of the stage, "
      "right-handed about its forward direction as in ISO 8855. The results "
      "are in the axes of the wheel: the ground leans the other way about "
      "a line through the origin, after 'Travel', 'Slide' and 'Turn' and "
      "before 'Wheel turn', and 'Force' is normal to it. It is added to the angle of 'Contact/Direction'. "
      "'unchanged': as at the start of the stage.",
      Unit::degrees() | RestartChange::within_stage);
    add_optional_number(
      prm,
      "Angular velocity",
      angular_velocity,
      unchanged,
      "Angular velocity of a steadily rolling or spinning wheel at the end of "
      "the stage, right-handed about the y axis. 'unchanged': as at the start "
      "of the stage.",
      Unit("radians/time") | RestartChange::within_stage);
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
      "start of the stage.",
      Unit("length/time") | RestartChange::within_stage);
    add_optional_number(
      prm,
      "Slip angle",
      slip_angle,
      unchanged,
      "Angle between the direction in which the wheel moves over the ground "
      "and its plane at the end of the stage, positive to the left. A drum is "
      "turned by it about 'Direction' through 'Point on path'. "
      "'unchanged': as at the start of the stage.",
      Unit::degrees() | RestartChange::within_stage);
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
      "braking, -1 for a locked wheel. 'none': see 'Angular velocity'.",
      Unit::none() | RestartChange::within_stage);
    add_parsed(prm,
               "Friction",
               "",
               laws.friction,
               parse_own_friction,
               "Coefficient of friction in the stage, instead of that "
               "of the section 'Contact'; empty for that one. A number, "
               "or a formula of the contact pressure p and the slip "
               "velocity s.",
               Unit::none());
    const std::string of_contact = "as in Contact";
    add_optional_number(
      prm,
      "Regularization",
      laws.penalty_stiffness,
      of_contact,
      "'Contact/Regularization' in the stage, of the ground and of bodies, "
      "to go from soft to rigid contact in several stages: an obstacle with "
      "steep sides lets the way decide where the shell rests on it. From that "
      "of the stage before, the penetration of a pressure changes evenly in "
      "the steps of the stage.",
      Unit("pressure/length"));
    add_optional_number(
      prm,
      "Tangential regularization",
      laws.tangential_stiffness,
      of_contact,
      "'Contact/Tangential regularization' in the stage. It "
      "changes at the start of the stage, where nodes that stick "
      "keep their tractions.",
      Unit("pressure/length"));
    add_parsed(
      prm,
      "Bodies",
      "",
      bodies,
      parse_bodies,
      "Names of the bodies that are there in the stage, separated by "
      "commas; see the entry 'Bodies' outside the stages. Their places "
      "follow from 'Load factors'.",
      RestartChange::within_stage);
    prm.add_parameter(
      "Glued",
      laws.glued,
      "Whether the nodes in contact with the ground at the "
      "start of the stage cannot slip, as long as they are in "
      "contact. Nodes that come into contact later have friction, as "
      "have those in contact with other bodies.",
      Patterns::Bool());
    prm.add_parameter("Duration",
                      duration,
                      "The time that passes in the stage, evenly from step to "
                      "step, in which the stresses of materials with "
                      "'Relaxation times' relax. 0: as fast as they respond at "
                      "once.",
                      Patterns::Double(),
                      Unit("time"));
    add_optional_number(
      prm,
      "Temperature",
      temperature,
      unchanged,
      "Temperature of the shell at the end of the stage, for the 'Temperature "
      "shift' of materials; at the start of the first stage, it is that at its "
      "end. 'unchanged': as at the start of the stage.",
      Unit("temperature") | RestartChange::within_stage);
    add_optional_number(
      prm,
      "Load factor",
      common_factor,
      unchanged,
      "Factor of the loads of the section 'Loads', except the pressure, of "
      "prescribed displacements of supports and of the motions of bodies at the "
      "end of the stage. "
      "'unchanged': as at the start of the stage.",
      Unit::none() | RestartChange::within_stage);
    add_parsed(
      prm,
      "Load factors",
      "",
      own_factors,
      parse_load_factors,
      "Factors at the end of the stage of loads, supports and motions "
      "of bodies that do not follow 'Load factor': a comma-separated list of 'name: "
      "factor' or 'name: unchanged'. A name is 'point forces', 'edge "
      "forces', 'edge moments', 'inner traction', 'outer traction', "
      "'area force', 'supports' or 'bodies', if needed followed by the "
      "point, edge or body, and by the number of the load there, the "
      "component of the support or the motion of the body: 'edge "
      "forces alpha_1 max', 'edge forces alpha_1 max 2', 'supports "
      "alpha_1 max v_3', 'bodies cleat lift'. The longest name of a "
      "load counts. What a stage does not name follows its 'Load factor'.",
      Unit::none() | RestartChange::within_stage);
  }


  LoadLevel
  StageLoads::end(const LoadLevel &start) const
  {
    const LoadLevel from   = with_factors(start, factors.size());
    LoadLevel       result = from;
    for_each_load(
      [](auto &load, const auto &prescribed, const auto &at_start) {
        load = prescribed.value_or(at_start);
      },
      result,
      *this,
      from);
    return result;
  }


  void
  StageLoads::check(const std::string &section) const
  {
    const auto check_load = [&](const std::string           &entry,
                                const std::optional<double> &load) {
      if (load)
        check_finite(section + "/" + entry, *load);
    };
    check_load("Pressure", pressure);
    check_load("Travel", travel);
    check_load("Load factor", common_factor);
    check_load("Turn", turn);
    check_load("Wheel turn", wheel_turn);
    check_load("Inclination angle", inclination_angle);
    check_load("Angular velocity", angular_velocity);
    check_load("Ground velocity", ground_velocity);
    check_load("Slip angle", slip_angle);
    check_load("Slip ratio", slip_ratio);
    check_load("Temperature", temperature);
    check_not_negative(section + "/Duration", duration);
    check_not_negative(section + "/Damping", damping);
    if (slide)
      check_finite(section + "/Slide", *slide);
    if (!contact)
      check_without_contact(section);
  }


  void
  StageLoads::check_without_contact(const std::string &section) const
  {
    // without ground these have no effect, and a file that gives them is in
    // error
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
    refuse_motion("Inclination angle", inclination_angle);
  }


  void
  StageLoads::check_slide(const std::string  &section,
                          const Tensor<1, 3> &direction) const
  {
    // a part along it would add to the travel; components of the file have few
    // digits
    if (slide &&
        std::abs(*slide * direction) > 1e-6 * slide->norm() * direction.norm())
      throw InputError(section + "/Slide",
                       vector_to_string(*slide),
                       "it must be orthogonal to 'Contact/Direction', " +
                         vector_to_string(direction) +
                         "; 'Travel' moves the ground along it");
  }
} // namespace Biface
