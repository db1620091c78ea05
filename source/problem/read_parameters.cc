// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <set>
#include <sstream>
#include <tuple>

#include <biface/base/errors.h>
#include <biface/input/parameter_text.h>
#include <biface/input/parameter_tools.h>
#include <biface/input/read_file.h>
#include <biface/problem/design_variable.h>
#include <biface/problem/parameters.h>
#include <biface/stepping/buckling.h>
#include <biface/surface/imperfection.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    /** A text of settings. */
    struct Source
    {
      /** Its name in error messages. */
      std::string name;
      std::string text;
      /** The number of the last section of a stage that it may have. */
      unsigned int last_section = 1;
      /** Whether it is a file of plies. */
      bool is_plies_file = false;
    };


    /** The number in the name of a section "Stage N"; none if it is another
     * section. */
    std::optional<unsigned long>
    number_of_stage(const std::string &section)
    {
      const std::string stage = "Stage ";
      if (section.rfind(stage, 0) != 0 || section.size() == stage.size() ||
          section.find_first_not_of("0123456789", stage.size()) !=
            std::string::npos)
        return {};
      return std::strtoul(section.c_str() + stage.size(), nullptr, 10);
    }


    /** Whether a source sets an entry.
     * @param section of the entry, with a slash at its end. */
    bool
    sets(const Source      &source,
         const std::string &entry,
         const std::string &section = "")
    {
      const std::vector<ParameterLine> lines = scan_parameter_text(source.text);
      return std::any_of(
        lines.begin(), lines.end(), [&](const ParameterLine &line) {
          return line.keyword == "set" && line.section == section &&
                 line.name == entry;
        });
    }


    /** Remove the travels of stages whose control by a force is chosen by a
     * later source than the travel, such as an option for a file.
     * @return sentences about them. */
    std::vector<std::string>
    remove_travels(const std::vector<Source> &sources,
                   Parameters                &parameters,
                   ParameterHandler          &prm)
    {
      std::vector<std::string> notes;
      for (unsigned int i = 0; i < parameters.stages.size(); ++i)
        {
          Stage            &stage   = parameters.stages[i];
          const std::string section = "Stage " + std::to_string(i + 1);
          if (!stage.prescribes_force() || stage.travel.value_or(0) == 0)
            continue;
          // a control from a later source, such as '--set', replaces the
          // travel; in one file both are a mistake
          bool control_is_later = false;
          for (const Source &source : sources)
            if (sets(source, "Travel", section + "/"))
              control_is_later = false;
            else if (sets(source, "Control", section + "/"))
              control_is_later = true;
          if (!control_is_later)
            continue;
          notes.push_back("The entry '" + section + "/Travel', " +
                          number_to_string(*stage.travel) +
                          ", is ignored: with 'Control = " +
                          stage.control_name() + "' the travel is computed.");
          stage.travel.reset();
          prm.enter_subsection(section);
          prm.set("Travel", "unchanged");
          prm.leave_subsection();
        }
      return notes;
    }


    /** Remove the sections of stages beyond the last one that is run.
     * @return their names. */
    std::set<std::string>
    remove_surplus_stages(Source &source, const unsigned int n_stages)
    {
      std::set<std::string>            removed;
      const std::vector<ParameterLine> lines = scan_parameter_text(source.text);
      std::istringstream               physical_lines(source.text);
      std::string                      text, physical;
      bool                             in_surplus = false;
      for (unsigned int number = 1; std::getline(physical_lines, physical);
           ++number)
        {
          const ParameterLine &line = lines[number];
          if (line.keyword == "subsection" && line.section.empty())
            if (const auto stage = number_of_stage(line.name))
              if (*stage > n_stages && *stage <= source.last_section)
                {
                  in_surplus = true;
                  removed.insert(line.name);
                }
          // empty lines keep the numbers of the others
          text += (in_surplus ? std::string() : physical) + '\n';
          if (line.keyword == "end" && line.depth == 0)
            in_surplus = false;
        }
      if (!removed.empty())
        source.text = text;
      return removed;
    }


    /** Throw InputError if a name of an entry cannot be that of a section. */
    void
    check_names(const std::string              &file_name,
                const std::string              &entry,
                const std::vector<std::string> &names)
    {
      if (names.size() > 1000)
        throw InputError(file_name + ": the entry '" + entry + "' has " +
                         std::to_string(names.size()) +
                         " names, but at most 1000 are allowed.");
      for (const std::string &name : names)
        if (name.empty() || name.find_first_of(":/@") != std::string::npos ||
            std::count(names.begin(), names.end(), name) > 1)
          throw InputError(
            file_name + ": " +
            InputError(entry,
                       name.empty() ? "," : name,
                       "names must be unique and must not contain ':', '/', "
                       "'@'")
              .what());
    }


    /** Refuse sections of stages, materials and bodies that do not exist, and
     * that of a study. */
    void
    check_sections(const Source                   &source,
                   const std::vector<std::string> &materials,
                   const std::vector<std::string> &bodies,
                   const unsigned int              n_stages)
    {
      const std::vector<ParameterLine> lines = scan_parameter_text(source.text);
      for (unsigned int number = 1; number < lines.size(); ++number)
        {
          // deal.II would only say that there is no such section, not what to
          // change
          const ParameterLine &line = lines[number];
          if (line.keyword != "subsection" || !line.section.empty())
            continue;
          if (line.name == "Study")
            throw InputError(parameter_place(source.name, number) +
                             "the section 'Study' is for runs with "
                             "'--study'.");
          std::string reason;
          if (const auto stage = number_of_stage(line.name))
            {
              if (*stage > n_stages)
                reason = "raise 'Number of stages', which is " +
                         std::to_string(n_stages);
              else if (line.name != "Stage " + std::to_string(*stage) ||
                       *stage == 0)
                reason = "stages are numbered from 1";
            }
          else
            for (const auto &[start, entry, names] :
                 {std::make_tuple("Material ", "Materials", &materials),
                  std::make_tuple("Body ", "Bodies", &bodies)})
              {
                const std::string kind = start;
                if (line.name.rfind(kind, 0) != 0 ||
                    line.name.size() == kind.size())
                  continue;
                const std::string name = line.name.substr(kind.size());
                if (std::find(names->begin(), names->end(), name) ==
                    names->end())
                  reason = "list " + quoted(name) + " in '" + entry + "'";
              }
          if (!reason.empty())
            throw InputError(parameter_place(source.name, number) +
                             "there is no section " + quoted(line.name) + "; " +
                             reason + ".");
        }
    }


    /** Make names of files absolute, so that the written parameters find the
     * files.
     * @param file_name the file to whose folder they are relative. */
    void
    make_names_absolute(const std::string &file_name,
                        Parameters        &parameters,
                        ParameterHandler  &prm)
    {
      const auto make_absolute = [&](std::string &name) {
        std::error_code   error;
        const std::string result =
          std::filesystem::absolute(
            std::filesystem::path(file_name).parent_path() / name, error)
            .string();
        // the reader of the file reports the error
        if (!error)
          name = result;
      };
      for (auto [section, entry, file] :
           {std::make_tuple(
              "Spline", "File", parameters.surface.points_file.name),
            std::make_tuple("Mesh", "File", parameters.surface.mesh.name),
            std::make_tuple(
              "Mesh", "Geometry file", parameters.surface.mesh.geometry_file)})
        if (!file.empty())
          {
            make_absolute(file);
            prm.enter_subsection("Surface");
            prm.enter_subsection(section);
            prm.set(entry, print_file_name(file));
            prm.leave_subsection();
            prm.leave_subsection();
          }
      const auto set_named_files = [&](const std::string &entry,
                                       const auto        &items) {
        std::vector<NamedFile> files;
        for (const auto &item : items)
          {
            files.push_back(item.file);
            make_absolute(files.back().file_name);
          }
        if (files.empty())
          return;
        prm.enter_subsection("Surface");
        prm.enter_subsection("Imperfection");
        prm.set(entry, print_named_files(files));
        prm.leave_subsection();
        prm.leave_subsection();
      };
      set_named_files("Tables", parameters.surface.imperfection.tables);
      set_named_files("Fourier series", parameters.surface.imperfection.series);
      std::vector<TableFile> tables = parameters.laminate.tables;
      if (!tables.empty())
        {
          for (TableFile &table : tables)
            make_absolute(table.file.name);
          prm.enter_subsection("Laminate");
          prm.set("Tables", print_tables(tables));
          prm.leave_subsection();
        }
      for (unsigned int i = 0; i < parameters.stages.size(); ++i)
        if (std::vector<TableFile> of_stage =
              parameters.stages[i].histories.tables;
            !of_stage.empty())
          {
            for (TableFile &table : of_stage)
              make_absolute(table.file.name);
            prm.enter_subsection("Stage " + std::to_string(i + 1));
            prm.set("History tables", print_tables(of_stage));
            prm.leave_subsection();
          }
      for (const MaterialParameters &material : parameters.materials)
        if (std::string file = material.cord_and_rubber.curve.name;
            !file.empty())
          {
            make_absolute(file);
            prm.enter_subsection("Material " + material.name);
            prm.set("Cord curve", print_file_name(file));
            prm.leave_subsection();
          }
      for (const BodyParameters &body : parameters.bodies)
        {
          prm.enter_subsection("Body " + body.name);
          for (auto [entry, file] :
               {std::make_pair("Profile file", body.profile_file),
                std::make_pair("Height file", body.height_file)})
            if (!file.empty())
              {
                make_absolute(file);
                prm.set(entry, print_file_name(file));
              }
          prm.leave_subsection();
        }
    }


    /** Read settings; later ones replace earlier ones.
     * @param file_name the file to whose folder names of files are relative.
     * @return sentences about what is ignored. */
    std::vector<std::string>
    parse_sources(std::vector<Source> sources,
                  const std::string  &file_name,
                  Parameters         &parameters,
                  ParameterHandler   &prm)
    {
      // these determine which sections exist
      ParameterHandler         names_only;
      unsigned int             n_stages = 1;
      std::vector<std::string> materials{"cord"}, bodies;
      const std::string        entry = "Number of stages";
      names_only.add_parameter(entry, n_stages, "", Patterns::Integer(1, 1000));
      names_only.add_parameter(
        "Materials", materials, "", Patterns::List(Patterns::Anything(), 1));
      names_only.add_parameter(
        "Bodies", bodies, "", Patterns::List(Patterns::Anything()));
      for (Source &source : sources)
        {
          check_parameter_text(source.name, source.text);
          parse_parameter_text(names_only, source.name, source.text, true);
          source.last_section = n_stages;
        }
      // who gives the number asks for these stages, also of a file with more;
      // an option for a stage that is not run is a mistake
      if (!file_name.empty() && std::any_of(sources.begin(),
                                            sources.end(),
                                            [&](const Source &source) {
                                              return sets(source, entry);
                                            }))
        sources[0].last_section = std::numeric_limits<unsigned int>::max();

      check_names(file_name, "Materials", materials);
      check_names(file_name, "Bodies", bodies);
      parameters.add_parameters(prm, materials, bodies, n_stages);
      std::set<std::string> surplus;
      for (Source &source : sources)
        {
          surplus.merge(remove_surplus_stages(source, n_stages));
          check_sections(source, materials, bodies, n_stages);
          parse_parameter_text(prm, source.name, source.text, false);
          if (source.is_plies_file)
            parameters.plies_files.push_back(source.name);
        }

      make_names_absolute(file_name, parameters, prm);
      std::vector<std::string> notes = remove_travels(sources, parameters, prm);
      for (const std::string &section : surplus)
        notes.push_back("The section '" + section +
                        "' is ignored: 'Number of stages' is " +
                        std::to_string(n_stages) + ".");
      return notes;
    }


    /** Put the plies of each 'Laminate/Plies file' in 'Laminate/Plies': in a
     * source behind the one that names it.
     * @param file_name the file to whose folder names of files are relative. */
    void
    read_plies_files(const std::string   &file_name,
                     const MPI_Comm       communicator,
                     std::vector<Source> &sources)
    {
      const std::string entry = "Laminate/Plies file";
      for (std::size_t i = 0; i < sources.size(); ++i)
        {
          std::string name;
          bool        has_plies = false;
          for (const ParameterLine &line : scan_parameter_text(sources[i].text))
            if (line.section == "Laminate/" && line.keyword == "set")
              {
                if (line.name == "Plies file")
                  name = line.value;
                has_plies = has_plies || line.name == "Plies";
              }
          if (name.empty())
            continue;
          try
            {
              if (has_plies)
                throw InputError(
                  entry, name, "it must not be given together with 'Plies'");
              const std::string path =
                (std::filesystem::path(file_name).parent_path() /
                 parse_file_name(entry, name))
                  .string();
              const std::string plies =
                plies_of_csv(read_file(path, communicator), path);
              // the name of the file is unset, so that the written parameters
              // have the plies alone
              Source source{path,
                            "subsection Laminate\n  set Plies = " + plies +
                              "\n  set Plies file =\nend\n"};
              source.is_plies_file = true;
              sources.insert(sources.begin() + i + 1, source);
            }
          catch (const InputError &error)
            {
              throw InputError(sources[i].name + ": " + error.what());
            }
          ++i;
        }
    }


    /** The texts that set parameters. */
    std::vector<Source>
    collect_sources(const std::string           &file_name,
                    const std::vector<Override> &overrides,
                    const MPI_Comm               communicator)
    {
      std::vector<Source> sources;
      if (!file_name.empty())
        sources.push_back(
          {file_name,
           join_lines(file_name, read_file(file_name, communicator))});
      for (const Override &setting : overrides)
        sources.push_back({setting.source, override_text(setting)});
      read_plies_files(file_name, communicator, sources);
      return sources;
    }


    /** Check parameters, and read the files that they name. */
    void
    complete(const MPI_Comm communicator, Parameters &parameters)
    {
      // stages of the test are stages like others, with load factors of their
      // own
      parameters.add_tire_test();
      for (unsigned int i = 0; i < parameters.stages.size(); ++i)
        {
          Stage            &stage   = parameters.stages[i];
          const std::string section = "Stage " + std::to_string(i + 1);
          stage.histories.read_tables(section, communicator);
          stage.StageMotion::complete(section, stage, stage);
          stage.StageResponse::complete(stage);
        }
      parameters.assign_load_factors();
      for (BodyParameters &body : parameters.bodies)
        body.read_files(communicator);
      for (MaterialParameters &material : parameters.materials)
        if (!material.cord_and_rubber.curve.name.empty())
          material.cord_and_rubber.curve.read("stretch, force", communicator);
      parameters.read_mesh(communicator);
      parameters.laminate.of_standard_element =
        parameters.formulation == Formulation::standard;
      parameters.check();
      if (!parameters.surface.points_file.name.empty())
        parameters.surface.points_file.read("radius, axial coordinate",
                                            communicator,
                                            parameters.units.of_length());
      parameters.surface.imperfection.read_files(communicator);
      for (TableFile &table : parameters.laminate.tables)
        table.file.read("alpha_1, value", communicator);
    }


    /** What a change of entries changes in the mesh. */
    SensitivityParameters::MeshChange
    mesh_change(const std::vector<EntryAttributes> &entries)
    {
      using MeshChange  = SensitivityParameters::MeshChange;
      MeshChange change = MeshChange::nothing;
      for (const EntryAttributes &entry : entries)
        if (entry.get_kind() == EntryKind::plies)
          change = std::max(change, MeshChange::plies);
        else if (entry.get_kind() != EntryKind::loads)
          change = MeshChange::anything;
      return change;
    }


    /** The change of a design variable in differences.
     * @param entries those whose numbers it changes.
     * @param automatic in parts of its value, if none is given. */
    double
    change_of(const DesignVariable               &variable,
              const std::vector<EntryAttributes> &entries,
              const double                        value,
              const std::optional<double>         given,
              const double                        automatic)
    {
      const std::string entry = "Sensitivities/Relative step";
      if (value != 0)
        {
          if (given && *given > 0.1)
            throw InputError(
              entry, number_to_string(*given), "it must be at most 0.1");
          return given.value_or(automatic) * std::abs(value);
        }
      // without a unit, the size of the change says nothing
      for (const EntryAttributes &changed : entries)
        if (!given && changed.get_unit().is_physical())
          throw InputError(entry,
                           "automatic",
                           "it must be a number, the change of " +
                             quoted(variable.get_name()) +
                             ", which is 0 and has a unit");
      return given.value_or(automatic);
    }


    /** The parameters with each of the entries of the section 'Sensitivities'
     * changed a little. */
    std::vector<SensitivityParameters::Change>
    change_entries(const std::vector<Source> &sources,
                   const std::string         &file_name,
                   const MPI_Comm             communicator,
                   const Parameters          &parameters,
                   const ParameterHandler    &prm)
    {
      // The step balances the round-off of stiff contact and the curvature of
      // the forces, which is large if the shape changes at fixed displacements,
      // or with friction, if a small slip changes its direction.
      constexpr double step = 1e-4, small_step = 2e-5;

      const bool has_friction = std::any_of(
        parameters.stages.begin(),
        parameters.stages.end(),
        [&](const Stage &stage) {
          return stage.contact &&
                 (stage.laws.glued || !parameters.friction_in(stage).is_zero());
        });
      const std::string     entry = "Sensitivities/Entries";
      const DeclaredEntries declared(prm);
      std::vector<SensitivityParameters::Change> changes;
      for (const DesignVariable &variable :
           parse_design_variables(entry, parameters.sensitivities.entries))
        {
          SensitivityParameters::Change change;
          change.name  = variable.get_name();
          change.value = variable.value(declared);
          std::vector<EntryAttributes> changed_entries;
          for (const std::string &name : variable.get_entries())
            changed_entries.push_back(parameters.attributes.at(name));
          for (const EntryAttributes &changed : changed_entries)
            if (!changed.describes_the_problem())
              throw InputError(entry,
                               change.name,
                               "it must be a number that describes the shell, "
                               "its loads or the ground, not the solution "
                               "or the output");
          change.mesh_change = mesh_change(changed_entries);
          const bool of_shape =
            std::any_of(changed_entries.begin(),
                        changed_entries.end(),
                        [](const EntryAttributes &changed) {
                          return changed.get_kind() == EntryKind::shape;
                        });
          const double size =
            change_of(variable,
                      changed_entries,
                      change.value,
                      parameters.sensitivities.step,
                      has_friction || of_shape ? small_step : step);
          const std::array<double, 2> values{
            {change.value - size, change.value + size}};
          // the difference of the numbers as they are rounded
          change.step = values[1] - values[0];
          for (unsigned int side = 0; side < 2; ++side)
            {
              // all of the file is read again, so that whatever depends on the
              // entry follows it, and is checked
              std::vector<Source> changed_sources = sources;
              for (const Override &setting :
                   settings({variable}, {values[side]}, declared, entry))
                changed_sources.push_back({entry, override_text(setting)});
              const auto       changed = std::make_shared<Parameters>();
              ParameterHandler changed_prm;
              try
                {
                  parse_sources(
                    changed_sources, file_name, *changed, changed_prm);
                  complete(communicator, *changed);
                }
              catch (const InputError &error)
                {
                  // without the place in the setting and the period
                  std::string reason = error.what();
                  if (reason.rfind(entry, 0) == 0)
                    reason = reason.substr(reason.find(": ") + 2);
                  if (reason.back() == '.')
                    reason.pop_back();
                  throw InputError(entry,
                                   change.name,
                                   "small changes of it are not allowed: " +
                                     reason);
                }
              change.parameters[side] = changed;
            }
          changes.push_back(change);
        }
      return changes;
    }
  } // namespace


  std::vector<std::string>
  parse_parameters(const std::string           &file_name,
                   const std::vector<Override> &overrides,
                   const MPI_Comm               communicator,
                   Parameters                  &parameters,
                   ParameterHandler            &prm)
  {
    return parse_sources(collect_sources(file_name, overrides, communicator),
                         file_name,
                         parameters,
                         prm);
  }


  std::vector<std::string>
  read_parameters(const std::string           &file_name,
                  const std::vector<Override> &overrides,
                  const MPI_Comm               communicator,
                  Parameters                  &parameters,
                  ParameterHandler            &prm)
  {
    const std::vector<Source> sources =
      collect_sources(file_name, overrides, communicator);
    const std::vector<std::string> sentences =
      parse_sources(sources, file_name, parameters, prm);
    try
      {
        complete(communicator, parameters);
        parameters.sensitivities.changes =
          change_entries(sources, file_name, communicator, parameters, prm);
      }
    catch (const InputError &error)
      {
        throw InputError(file_name + ": " + error.what());
      }
    return sentences;
  }


  std::string
  print_parameters(const ParameterHandler &prm)
  {
    std::ostringstream text;
    prm.print_parameters(
      text, ParameterHandler::PRM | ParameterHandler::KeepDeclarationOrder);
    return text.str();
  }
} // namespace Biface
