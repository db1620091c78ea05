// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/patterns.h>

#include <algorithm>

#include <biface/base/errors.h>
#include <biface/input/entry_declarations.h>
#include <biface/input/named_numbers.h>
#include <biface/input/parameter_tools.h>
#include <biface/stepping/stage_control.h>

namespace Biface
{
  using namespace dealii;

  const std::vector<std::string> &
  control_names()
  {
    static const std::vector<std::string> names{
      "load",
      "displacement",
      "arc length",
      "foundation force",
      "axle moment",
      "foundation force and axle moment"};
    return names;
  }


  const std::string &
  StageControl::control_name() const
  {
    return control_names()[static_cast<unsigned int>(control)];
  }


  bool
  StageControl::has_force(const std::string &name) const
  {
    return std::any_of(forces_on_bodies.begin(),
                       forces_on_bodies.end(),
                       [&](const auto &item) { return item.first == name; });
  }


  namespace
  {
    NamedNumbers
    parse_forces(const std::string &entry, const std::string &text)
    {
      return parse_named_numbers(entry,
                                 text,
                                 "each item must have the form 'body motion: "
                                 "force' or 'supports NAME: force'");
    }
  } // namespace


  void
  StageControl::add_parameters(EntryDeclarations &prm)
  {
    // 'Control' decides which of the other entries count; check() refuses those
    // that do not
    add_choice(
      prm,
      "Control",
      control,
      control_names(),
      "The quantity prescribed in every step: 'load' (equal steps of all "
      "loads), 'displacement' (equal steps of one displacement; the fraction "
      "of the loads of the stage is computed and may exceed 1), 'arc length' "
      "(adaptive steps of the norm of all displacements, which pass limit "
      "points, until the loads of the stage are reached; 'Steps' sets the "
      "first step: 1/Steps of the loads), or 'foundation force' (equal steps "
      "of the force on the ground and of all loads; the travel is "
      "computed), or 'axle moment' (equal steps of the moment of the axle on a "
      "rolling wheel and of all loads; the angular velocity is computed), or "
      "'foundation force and axle moment' (both are prescribed, travel and "
      "angular velocity are computed).");
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
                      "the stage.",
                      Patterns::Double(),
                      Unit("length") | RestartChange::within_stage);
    prm.add_parameter("Force",
                      force,
                      "Compressive force on the ground and the 'Bodies' "
                      "that move with it, along 'Contact/Direction', at the "
                      "end of a stage whose 'Control' prescribes it.",
                      Patterns::Double(),
                      Unit("force") | RestartChange::within_stage);
    prm.add_parameter("Axle moment",
                      axle_moment,
                      "Moment of the axle on the wheel about the y axis at the "
                      "end of a stage whose 'Control' prescribes it: 0 for "
                      "free rolling, negative for braking.",
                      Patterns::Double(),
                      Unit("force*length") | RestartChange::within_stage);
    add_parsed(
      prm,
      "Forces on bodies",
      "",
      forces_on_bodies,
      parse_forces,
      "Forces that push bodies along their motions, or supports along "
      "their prescribed displacements, at the end of the stage; the "
      "factors of these motions are found: a comma-separated list of "
      "'body motion: force', or of 'NAME: force' with a name of "
      "supports as in 'Load factors', such as 'supports' or 'supports "
      "alpha_1 min'; 0 for what gives way. A force acts along the "
      "translation; a motion that only turns has a moment about the "
      "axis. All supports of a name move by the same displacement; their "
      "force is the sum of those in history.csv, with images in planes of "
      "symmetry at the ends of an edge, but without another edge beyond a "
      "plane. The body rests on "
      "the shell and on the spring of 'Springs', if it has one. The "
      "force at the start of the stage is what they exert there; it "
      "changes in equal steps. With 'Inertia' it is constant, or "
      "follows 'Load history', and moves the mass of 'Masses'.",
      Unit("force, or force*length"));
    prm.add_parameter("Steps",
                      n_steps,
                      "Number of steps; see 'Control'.",
                      Patterns::Integer(1, 1000000),
                      RestartChange::within_stage);
    prm.add_parameter("Adaptive steps",
                      adaptive,
                      "Whether steps of the loads or the force grow beyond "
                      "1/Steps after fast convergence; see 'Maximum growth'. "
                      "Otherwise all multiples of 1/Steps are reached and "
                      "written.",
                      Patterns::Bool(),
                      RestartChange::within_stage);
  }


  void
  StageControl::check(const std::string &section) const
  {
    // an entry that the control does not read is refused rather than ignored
    if (!prescribes_force() && force != 0)
      throw InputError(section + "/Force",
                       number_to_string(force),
                       "it needs 'Control = foundation force' or "
                       "'foundation force and axle moment'");
    // there the one unknown scales all loads, and the factor of a motion would
    // be another
    if (!forces_on_bodies.empty() && (control == ControlKind::displacement ||
                                      control == ControlKind::arc_length))
      throw InputError(section + "/Forces on bodies",
                       forces_on_bodies.front().first,
                       "it must be empty with 'Control = " + control_name() +
                         "'");
  }
} // namespace Biface
