// SPDX-License-Identifier: LGPL-2.1-or-later


#include <cmath>

#include <biface/base/errors.h>
#include <biface/contact/friction.h>
#include <biface/input/entry_declarations.h>
#include <biface/input/parameter_tools.h>
#include <biface/solver/failure.h>
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
        (number == 1 ? "it must be 'previous' in the first stage"
                     : "it must be 'previous' or " + several +
                         std::to_string(number - 1));
      const double earlier = parse_number(entry, text, allowed);
      if (!(earlier >= 1 && earlier < number && earlier == std::floor(earlier)))
        throw InputError(entry, text, allowed);
      return static_cast<unsigned int>(earlier);
    }
  } // namespace


  InUse
  Stage::in_use(const unsigned int position) const
  {
    const std::string own = "Stage " + std::to_string(position + 1);
    return {contact,
            control == ControlKind::displacement,
            control == ControlKind::arc_length,
            false,
            laws.penalty_stiffness ? own : "Contact",
            laws.tangential_stiffness ? own : "Contact",
            inertia};
  }


  void
  Stage::add_parameters(EntryDeclarations &prm, const unsigned int number)
  {
    name = "stage " + std::to_string(number);

    // the order of the declarations is that of printed files and of the
    // reference of parameters
    prm.add_parameter(
      "Name", name, "Name of the stage in the results.", Patterns::Anything());
    add_parsed(
      prm,
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
    StageLoads::add_parameters(prm);
    StageControl::add_parameters(prm);
    add_choice(prm,
               "Strain theory",
               theory,
               {"nonlinear", "linear"},
               "'nonlinear' (finite displacements) or 'linear' (linearized "
               "about the state at the start of the stage, with its "
               "stresses; contact remains unilateral, and what follows the "
               "shell turns with its size at the start, so that without "
               "contact all displacements are proportional to the change of "
               "the loads). Consecutive linear "
               "stages are linearized about different states.");
    prm.add_parameter("Start from prestress",
                      from_prestress,
                      "Whether the stage starts from the undeformed shape "
                      "with the resultants reached so far as initial "
                      "resultants. The loads are kept: 'Pressure' and 'Load "
                      "factor' have the same values as before. Constant "
                      "nodal forces balance the residual at the start of the "
                      "stage; its norm is printed. Displacements, including "
                      "prescribed ones, and the travel of the ground "
                      "start from 0 again.",
                      Patterns::Bool());
    StageMotion::add_parameters(prm);
    StageResults::add_parameters(prm);
    StageResponse::add_parameters(prm);
  }


  void
  Stage::check(const std::string &section) const
  {
    // a name is a field of tables, which have no quotation
    if (name.empty() || name.find_first_of(",\"\n\r") != std::string::npos)
      throw InputError(section + "/Name",
                       name,
                       "it must not be empty or contain a comma, a quotation "
                       "mark or a line break");
    StageLoads::check(section);
    StageControl::check(section);
    StageMotion::check(section, vibrates());
    StageResults::check(section);
    StageResponse::check(section);
    if (theory == StrainTheory::linear &&
        (control != ControlKind::load || !forces_on_bodies.empty()))
      throw InputError(section + "/Strain theory",
                       "linear",
                       "a linear stage must have 'Control = load' and no "
                       "'Forces on bodies'");
    check_critical_points(section);
  }


  void
  Stage::check_critical_points(const std::string &section) const
  {
    const auto refuse = [&](const bool wrong, const std::string &why) {
      if (wrong)
        throw InputError(
          section + "/Critical points", critical_points_name(), why);
    };
    if (!locates_critical_points())
      return;
    // the pivots are those of a matrix without the term of rank one of the gas,
    // section 5
    refuse(sealed, "it needs 'Gas = open'");
    refuse(theory == StrainTheory::linear,
           "it needs 'Strain theory = nonlinear'");
    refuse(!forces_on_bodies.empty(), "'Forces on bodies' must be empty");
    if (critical_points != CriticalPoints::switch_branch)
      return;
    refuse(control != ControlKind::load && control != ControlKind::arc_length,
           "it needs 'Control = load' or 'arc length'");
    // on the way to the branch the load is unknown, and scales no motion
    refuse(moves_ground(), "the ground must not move");
  }
} // namespace Biface
