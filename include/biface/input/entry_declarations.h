// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_input_entry_declarations_h
#define biface_input_entry_declarations_h

#include <deal.II/base/parameter_handler.h>

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace Biface
{
  /** The unit of the numbers in the value of an entry. By default nothing is
   * said of it, as for words and counts. */
  class Unit
  {
  public:
    Unit() = default;

    /** A unit, as a product of powers of units of length, force, time and so
     * on: "force/area". Remarks may follow behind a comma. */
    explicit Unit(const std::string &name);

    /** The "unit" of plain numbers. */
    static Unit
    none();

    static Unit
    degrees();

    /** Different units of the numbers in one value.
     * @param names those of all of them, in words. */
    static Unit
    several(const std::string &names);

    /** Whether it is said which unit the numbers have, if any. */
    bool
    is_said() const;

    /** Whether the numbers depend on the units chosen for the file: they are
     * neither plain numbers nor angles in degrees. */
    bool
    is_physical() const;

    /** Whether all numbers of the value have this unit. */
    bool
    is_common() const;

    const std::string &
    get_name() const
    {
      return name;
    }

    /** The sentence for the documentation of the entry: "Unit: force/area.",
     * "No unit." for plain numbers, and nothing if nothing is said. */
    std::string
    sentence() const;

  private:
    enum class Kind
    {
      not_said,
      none,
      common,
      several
    };

    Unit(const Kind kind, const std::string &name);

    Kind        kind = Kind::not_said;
    std::string name;
  };


  /** What an entry describes. */
  enum class EntryKind
  {
    /** the problem, in a way that may change anything of the model */
    problem,
    /** the reference surface and the mesh on it */
    shape,
    /** the plies and their materials: no more of the mesh than its laminates */
    plies,
    /** loads, contact and stages: nothing of the mesh */
    loads,
    /** how the problem is solved */
    solution,
    /** what is written, and in what form */
    output
  };


  /** When an entry may still change as a run is continued, see
   * check_continuation(). */
  enum class RestartChange
  {
    never,
    /** as long as no stage of the tire test has started */
    before_tire_test,
    /** as long as the stage of the entry has not started */
    before_stage,
    /** as long as the stage of the entry is not complete */
    within_stage,
    always
  };


  /** The number of the stage, from 1, to which an entry belongs. */
  struct OfStage
  {
    unsigned int number;
  };


  /**
   * What the program has to know of an entry, whatever its value. Attributes
   * are joined by `|`, as in `Unit("length") | RestartChange::within_stage`;
   * those that are not given are those of the section of the entry.
   */
  class EntryAttributes
  {
  public:
    EntryAttributes() = default;

    // not explicit: each of them is an attribute
    EntryAttributes(const Unit &unit);
    EntryAttributes(const EntryKind kind);
    EntryAttributes(const RestartChange change);
    EntryAttributes(const OfStage stage);

    /** Both attributes; @p a takes precedence. */
    friend EntryAttributes
    operator|(const EntryAttributes &a, const EntryAttributes &b);

    const Unit &
    get_unit() const
    {
      return unit;
    }

    /** EntryKind::problem unless something else is given. */
    EntryKind
    get_kind() const;

    /** Whether the entry describes the problem, and not how it is solved or
     * what is written. */
    bool
    describes_the_problem() const;

    /** RestartChange::never unless something else is given, but
     * RestartChange::always for what does not describe the problem. */
    RestartChange
    get_restart_change() const;

    /** The number of the stage to which the entry belongs; 0 if it belongs to
     * none. */
    unsigned int
    get_stage() const;

  private:
    Unit                         unit;
    std::optional<EntryKind>     kind;
    std::optional<RestartChange> restart_change;
    std::optional<unsigned int>  stage;
  };

  EntryAttributes
  operator|(const EntryAttributes &a, const EntryAttributes &b);

  /** A kind and other attributes. Two enumerators are not converted without
   * this function. */
  EntryAttributes
  operator|(const EntryKind kind, const EntryAttributes &others);

  /** The attributes of entries by their full names, "Section/Entry". */
  using AttributesByEntry = std::map<std::string, EntryAttributes>;


  /**
   * Declares the entries of a ParameterHandler together with their attributes.
   * Its functions are those of dealii::ParameterHandler with the attributes as
   * an additional argument, and with the sentence on the unit added to the
   * documentation.
   */
  class EntryDeclarations
  {
  public:
    /** Declare entries in a handler, which is kept by reference and must not
     * be in a subsection. */
    explicit EntryDeclarations(dealii::ParameterHandler &prm);

    /** @param attributes those of entries and subsections in the section that
     * have no others. */
    void
    enter_subsection(const std::string     &name,
                     const EntryAttributes &attributes = {});

    void
    leave_subsection();

    void
    declare_entry(const std::string                   &name,
                  const std::string                   &default_value,
                  const dealii::Patterns::PatternBase &pattern,
                  const std::string                   &documentation,
                  const EntryAttributes               &attributes = {});

    /** Declare an entry whose value is stored in @p value, its default. */
    template <typename Value>
    void
    add_parameter(const std::string                   &name,
                  Value                               &value,
                  const std::string                   &documentation,
                  const dealii::Patterns::PatternBase &pattern,
                  const EntryAttributes               &attributes = {});

    /** Declare an entry whose value is stored in @p value, its default, with
     * the pattern that belongs to its type. */
    template <typename Value>
    void
    add_parameter(const std::string     &name,
                  Value                 &value,
                  const std::string     &documentation,
                  const EntryAttributes &attributes = {});

    /** Call a function with the default value of a declared entry, and with
     * its value when it is read. */
    void
    add_action(const std::string                              &name,
               const std::function<void(const std::string &)> &action);

    /** The full name of an entry of the current section, "Section/Name". */
    std::string
    full_name(const std::string &name) const;

    /** The attributes of all entries that have been declared. */
    const AttributesByEntry &
    get_attributes() const
    {
      return attributes_by_entry;
    }

  private:
    /** Record the attributes of an entry.
     * @return its documentation with the sentence on its unit. */
    std::string
    record(const std::string     &name,
           const std::string     &documentation,
           const EntryAttributes &attributes);

    /** A section that has been entered. */
    struct Section
    {
      /** The full name of the section, "Section/Subsection/". */
      std::string path;
      /** The attributes of the section and of those around it. */
      EntryAttributes attributes;
    };

    dealii::ParameterHandler &prm;
    /** The current section and those around it, the outermost first. */
    std::vector<Section> sections;
    AttributesByEntry    attributes_by_entry;
  };


  template <typename Value>
  void
  EntryDeclarations::add_parameter(const std::string &name,
                                   Value             &value,
                                   const std::string &documentation,
                                   const dealii::Patterns::PatternBase &pattern,
                                   const EntryAttributes &attributes)
  {
    prm.add_parameter(
      name, value, record(name, documentation, attributes), pattern);
  }


  template <typename Value>
  void
  EntryDeclarations::add_parameter(const std::string     &name,
                                   Value                 &value,
                                   const std::string     &documentation,
                                   const EntryAttributes &attributes)
  {
    prm.add_parameter(name, value, record(name, documentation, attributes));
  }
} // namespace Biface

#endif
