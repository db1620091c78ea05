// SPDX-License-Identifier: LGPL-2.1-or-later

#include <cmath>
#include <limits>

#include <biface/base/errors.h>
#include <biface/input/parameter_tools.h>
#include <biface/stepping/controls/control.h>
#include <biface/stepping/stage.h>

namespace Biface
{
  using namespace dealii;

  void
  Stage::add_parameters(ParameterHandler &prm, const unsigned int number)
  {
    name = "stage " + std::to_string(number);
    prm.add_parameter("Name",
                      name,
                      "What the stage is called in results.",
                      Patterns::Anything());
    prm.add_parameter(
      "Pressure",
      pressure,
      "Pressure at the end of the stage; on which face, and what it does as the "
      "face moves, is said in the section 'Loads'. Unit: force/area.",
      Patterns::Double());
    prm.add_parameter("Contact",
                      contact,
                      "Whether the rigid foundation of the section 'Contact' "
                      "is there. It first touches the shell as deformed at the "
                      "begin of the first stage with contact (or the first "
                      "after 'Start from prestress').",
                      Patterns::Bool());
    prm.add_parameter("Travel",
                      travel,
                      "How far the foundation has moved against 'Direction' "
                      "at the end of the stage, counted from where it first "
                      "touched. Unit: length.",
                      Patterns::Double());
    prm.add_parameter("Load factor",
                      factor,
                      "What the section 'Loads' and prescribed displacements "
                      "of supports are multiplied by at the end of the stage. "
                      "No unit.",
                      Patterns::Double());
    add_choice(prm,
               "Control",
               control,
               {"load", "displacement", "arc length", "foundation force"},
               "What is given in every step: 'load' (equal steps of all "
               "loads), 'displacement' (equal steps of one displacement; the "
               "loads follow on their way to those given, or beyond), 'arc "
               "length' (steps of the displacements as a whole, which adapt "
               "and pass turning points of the load, until the loads given are "
               "reached; 'Steps' sets the first: 1/Steps of the loads), or "
               "'foundation force' (equal steps of the force on the foundation "
               "and of all loads; its travel follows).");
    prm.add_parameter("Control point",
                      control_point,
                      "Name of the point whose displacement (of the middle "
                      "surface) is given.",
                      Patterns::Anything());
    add_choice(prm,
               "Control component",
               control_component,
               {"x", "y", "z"},
               "Component of the displacement that is given.");
    prm.add_parameter("Control value",
                      control_value,
                      "Its value at the end of the stage. Unit: length.",
                      Patterns::Double());
    prm.add_parameter("Force",
                      force,
                      "Compressive force on the foundation at the end of a "
                      "stage with 'Control = foundation force'. Unit: force.",
                      Patterns::Double());
    prm.add_parameter("Steps",
                      n_steps,
                      "Number of steps; see 'Control'.",
                      Patterns::Integer(1, 1000000));
    prm.add_parameter("Adaptive steps",
                      adaptive,
                      "Whether steps of the loads or of the force grow after "
                      "easy ones, beyond 1/Steps; see 'Maximum growth'. "
                      "Without it, all states at multiples of 1/Steps are "
                      "reached and written.",
                      Patterns::Bool());
    add_choice(prm,
               "Strain theory",
               theory,
               {"nonlinear", "linear"},
               "'nonlinear' (finite displacements) or 'linear' (linearized "
               "about the state in which the stage begins, with its stresses; "
               "contact stays one-sided). Two linear stages in a row are "
               "linearized about different states.");
    prm.add_parameter("Start from prestress",
                      from_prestress,
                      "Whether the stage begins in the undeformed shape with "
                      "the resultants reached so far as initial ones, in "
                      "equilibrium with the loads so far, which are no longer "
                      "listed: 'Pressure' then counts from 0.",
                      Patterns::Bool());
  }


  void
  Stage::check(const std::string &section) const
  {
    if (name.empty() || name.find_first_of(",\"\n\r") != std::string::npos)
      throw InputError(section + "/Name",
                       name,
                       "it must not be empty nor hold a comma or a quotation "
                       "mark");
    if (!std::isfinite(pressure))
      throw InputError(section + "/Pressure",
                       number_to_string(pressure),
                       "it must be a number");
    if (!std::isfinite(travel))
      throw InputError(
        section + "/Travel", number_to_string(travel), "it must be a number");
    if (!std::isfinite(factor))
      throw InputError(section + "/Load factor",
                       number_to_string(factor),
                       "it must be a number");
    if (control != ControlType::load && theory == StrainTheory::linear)
      throw InputError(section + "/Strain theory",
                       "linear",
                       "a linear stage must have 'Control = load'");
    if (control != ControlType::force && force != 0)
      throw InputError(section + "/Force",
                       number_to_string(force),
                       "it needs 'Control = foundation force'");
    make_control(*this)->check(section);
    if (!contact && travel != 0)
      throw InputError(section + "/Travel",
                       number_to_string(travel),
                       "without 'Contact = true' there is nothing to move");
  }


  void
  check_stages(const std::vector<Stage> &stages)
  {
    const double unknown = std::numeric_limits<double>::quiet_NaN();
    LoadLevel    start;
    for (const Stage &stage : stages)
      {
        if (stage.from_prestress)
          start = LoadLevel();
        if (stage.control == Stage::ControlType::displacement ||
            stage.control == Stage::ControlType::arc_length)
          check_loads_follow(stage, start);
        start = stage.end();
        // these follow a displacement and a force
        if (stage.control == Stage::ControlType::displacement)
          start.pressure = start.factor = unknown;
        if (stage.control == Stage::ControlType::force)
          start.travel = unknown;
      }
  }
} // namespace Biface
