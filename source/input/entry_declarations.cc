// SPDX-License-Identifier: LGPL-2.1-or-later

#include <biface/input/entry_declarations.h>

namespace Biface
{
  using namespace dealii;

  Unit::Unit(const std::string &name) : Unit(Kind::common, name)
  {}


  Unit::Unit(const Kind kind, const std::string &name) : kind(kind), name(name)
  {}


  Unit
  Unit::none()
  {
    return {Kind::none, ""};
  }


  Unit
  Unit::degrees()
  {
    return Unit("degrees");
  }


  Unit
  Unit::several(const std::string &names)
  {
    return {Kind::several, names};
  }


  bool
  Unit::is_said() const
  {
    return kind != Kind::not_said;
  }


  bool
  Unit::is_physical() const
  {
    // degrees have a size of their own, whatever units a file has
    return kind == Kind::several || (kind == Kind::common && name != "degrees");
  }


  bool
  Unit::is_common() const
  {
    return kind == Kind::common;
  }


  std::string
  Unit::sentence() const
  {
    switch (kind)
      {
        case Kind::none:
          return "No unit.";
        case Kind::common:
          return "Unit: " + name + ".";
        case Kind::several:
          return "Units: " + name + ".";
        default:
          return "";
      }
  }


  EntryAttributes::EntryAttributes(const Unit &unit) : unit(unit)
  {}


  EntryAttributes::EntryAttributes(const EntryKind kind) : kind(kind)
  {}


  EntryAttributes::EntryAttributes(const RestartChange change)
    : restart_change(change)
  {}


  EntryAttributes::EntryAttributes(const OfStage stage) : stage(stage.number)
  {}


  EntryAttributes
  operator|(const EntryAttributes &a, const EntryAttributes &b)
  {
    // what an entry says counts before what its section says
    EntryAttributes result = a;
    if (!result.unit.is_said())
      result.unit = b.unit;
    if (!result.kind)
      result.kind = b.kind;
    if (!result.restart_change)
      result.restart_change = b.restart_change;
    if (!result.stage)
      result.stage = b.stage;
    return result;
  }


  EntryAttributes
  operator|(const EntryKind kind, const EntryAttributes &others)
  {
    return EntryAttributes(kind) | others;
  }


  EntryKind
  EntryAttributes::get_kind() const
  {
    return kind.value_or(EntryKind::problem);
  }


  bool
  EntryAttributes::describes_the_problem() const
  {
    return get_kind() != EntryKind::solution && get_kind() != EntryKind::output;
  }


  RestartChange
  EntryAttributes::get_restart_change() const
  {
    // earlier steps belong to the problem as it was, but not to the way in
    // which it is solved or written
    return restart_change.value_or(
      describes_the_problem() ? RestartChange::never : RestartChange::always);
  }


  unsigned int
  EntryAttributes::get_stage() const
  {
    return stage.value_or(0);
  }


  EntryDeclarations::EntryDeclarations(ParameterHandler &prm)
    : prm(prm), sections(1)
  {}


  void
  EntryDeclarations::enter_subsection(const std::string     &name,
                                      const EntryAttributes &attributes)
  {
    prm.enter_subsection(name);
    sections.push_back(
      {full_name(name) + "/", attributes | sections.back().attributes});
  }


  void
  EntryDeclarations::leave_subsection()
  {
    prm.leave_subsection();
    sections.pop_back();
  }


  void
  EntryDeclarations::declare_entry(const std::string           &name,
                                   const std::string           &default_value,
                                   const Patterns::PatternBase &pattern,
                                   const std::string           &documentation,
                                   const EntryAttributes       &attributes)
  {
    prm.declare_entry(
      name, default_value, pattern, record(name, documentation, attributes));
  }


  void
  EntryDeclarations::add_action(
    const std::string                              &name,
    const std::function<void(const std::string &)> &action)
  {
    prm.add_action(name, action);
  }


  std::string
  EntryDeclarations::full_name(const std::string &name) const
  {
    return sections.back().path + name;
  }


  std::string
  EntryDeclarations::record(const std::string     &name,
                            const std::string     &documentation,
                            const EntryAttributes &attributes)
  {
    // what neither the entry nor its section says has defaults
    const EntryAttributes all = attributes | sections.back().attributes;
    attributes_by_entry[full_name(name)] = all;
    const std::string sentence           = all.get_unit().sentence();
    return documentation + (sentence.empty() ? "" : " " + sentence);
  }
} // namespace Biface
