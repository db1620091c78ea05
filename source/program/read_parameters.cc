// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <initializer_list>
#include <memory>
#include <sstream>

#include <biface/base/errors.h>
#include <biface/input/parameter_text.h>
#include <biface/input/read_file.h>
#include <biface/program/design_variable.h>
#include <biface/program/parameters.h>

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
    };


    /** A setting as the text of a parameter file. */
    std::string
    override_text(const Override &given)
    {
      const std::string &setting = given.setting;
      const std::string option = given.source.substr(0, given.source.find(' '));
      const std::string value =
        given.source.substr(std::min(option.size() + 1, given.source.size()));
      const std::string form   = "it must have the form 'Section/Entry=value'";
      const auto        equals = setting.find('=');
      if (equals == std::string::npos || equals == 0)
        throw InputError(option, value, form);
      const std::vector<std::string> path =
        Utilities::split_string_list(setting.substr(0, equals), '/');
      if (path.empty() || std::find(path.begin(), path.end(), "") != path.end())
        throw InputError(option, value, form);
      // characters that would end the line or continue it in the next one
      if (setting.find_first_of("\n\r#") != std::string::npos ||
          Utilities::trim(setting).back() == '\\')
        throw InputError(option,
                         value,
                         "it must be a single line without '#' and without a "
                         "backslash at the end");

      std::string text;
      for (unsigned int i = 0; i + 1 < path.size(); ++i)
        text += "subsection " + path[i] + "\n";
      text += "set " + path.back() + " = " + setting.substr(equals + 1) + "\n";
      for (unsigned int i = 0; i + 1 < path.size(); ++i)
        text += "end\n";
      return text;
    }


    /** Refuse sections of stages and materials that do not exist. */
    void
    check_sections(const Source                   &source,
                   const std::vector<std::string> &materials,
                   const unsigned int              n_stages)
    {
      const std::vector<ParameterLine> lines = scan_parameter_text(source.text);
      for (unsigned int number = 1; number < lines.size(); ++number)
        {
          const ParameterLine &line = lines[number];
          if (line.keyword != "subsection" || !line.section.empty())
            continue;
          const auto is = [&](const std::string &kind) {
            return line.name.rfind(kind, 0) == 0 &&
                   line.name.size() > kind.size();
          };
          std::string reason;
          if (is("Stage ") &&
              line.name.find_first_not_of("0123456789", 6) == std::string::npos)
            {
              const unsigned long stage =
                std::strtoul(line.name.c_str() + 6, nullptr, 10);
              if (stage > n_stages)
                reason = "raise 'Number of stages', which is " +
                         std::to_string(n_stages);
              else if (line.name != "Stage " + std::to_string(stage) ||
                       stage == 0)
                reason = "stages are numbered from 1";
            }
          else if (is("Material ") &&
                   std::find(materials.begin(),
                             materials.end(),
                             line.name.substr(9)) == materials.end())
            reason = "list " + quoted(line.name.substr(9)) + " in 'Materials'";
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
      std::string points_file = parameters.surface.points_file.name;
      if (!points_file.empty())
        {
          make_absolute(points_file);
          prm.enter_subsection("Surface");
          prm.enter_subsection("Spline");
          prm.set("File", print_file_name(points_file));
          prm.leave_subsection();
          prm.leave_subsection();
        }
      std::vector<TableFile> tables = parameters.laminate.tables;
      if (!tables.empty())
        {
          for (TableFile &table : tables)
            make_absolute(table.file.name);
          prm.enter_subsection("Laminate");
          prm.set("Tables", print_tables(tables));
          prm.leave_subsection();
        }
    }


    /** Old names that still work. */
    std::vector<OldName>
    old_names()
    {
      return {
        {"Points", "Named points"},
        {"Surface/Meridian=points", "Surface/Meridian=spline"},
        {"Surface/Points/", "Surface/Spline/"},
        {"Supports/Points", "Supports/Point supports"},
        {"Supports/*=mean", "Supports/*=middle"},
        {"Loads/Pressure", "Loads/Pressure type"},
        {"Loads/Area of face loads=midway", "Loads/Area of face loads=middle"},
        {"Contact/Plane normal", "Contact/Direction"},
        {"Stage N/Begin from prestress", "Stage N/Start from prestress"},
        {"Step control/Greatest growth", "Step control/Maximum growth"}};
    }


    /** Read settings; later ones replace earlier ones.
     * @param file_name the file to whose folder names of files are relative.
     * @return the old names in the settings. */
    std::vector<OldName>
    parse_sources(std::vector<Source> sources,
                  const std::string  &file_name,
                  Parameters         &parameters,
                  ParameterHandler   &prm)
    {
      std::vector<OldName> used_old_names;
      // these determine which sections exist
      ParameterHandler         names_only;
      unsigned int             n_stages = 1;
      std::vector<std::string> materials{"cord"};
      names_only.add_parameter(
        "Number of stages", n_stages, "", Patterns::Integer(1, 1000));
      names_only.add_parameter(
        "Materials", materials, "", Patterns::List(Patterns::Anything(), 1));
      for (Source &source : sources)
        {
          for (const OldName &old : replace_old_names(source.text, old_names()))
            if (std::none_of(used_old_names.begin(),
                             used_old_names.end(),
                             [&](const OldName &other) {
                               return other.old_name == old.old_name;
                             }))
              used_old_names.push_back(old);
          check_parameter_text(source.name, source.text);
          parse_parameter_text(names_only, source.name, source.text, true);
        }

      if (materials.size() > 1000)
        throw InputError(file_name + ": the entry 'Materials' has " +
                         std::to_string(materials.size()) +
                         " names, but at most 1000 are allowed.");
      for (unsigned int i = 0; i < materials.size(); ++i)
        if (materials[i].empty() ||
            materials[i].find_first_of(":/@") != std::string::npos ||
            std::count(materials.begin(), materials.end(), materials[i]) > 1)
          throw InputError(
            file_name + ": " +
            InputError("Materials",
                       materials[i].empty() ? "," : materials[i],
                       "names must be unique and must not contain ':', '/', "
                       "'@'")
              .what());

      parameters.add_parameters(prm, materials, n_stages);
      for (const Source &source : sources)
        {
          check_sections(source, materials, n_stages);
          parse_parameter_text(prm, source.name, source.text, false);
        }

      make_names_absolute(file_name, parameters, prm);
      return used_old_names;
    }


    /** The texts that set parameters. */
    std::vector<Source>
    collect_sources(const std::string           &file_name,
                    const std::vector<Override> &overrides,
                    const MPI_Comm               communicator)
    {
      std::vector<Source> sources;
      if (!file_name.empty())
        sources.push_back({file_name, read_file(file_name, communicator)});
      for (const Override &setting : overrides)
        sources.push_back({setting.source, override_text(setting)});
      return sources;
    }


    std::vector<std::string>
    parse_collected(const std::vector<Source> &sources,
                    const std::string         &file_name,
                    Parameters                &parameters,
                    ParameterHandler          &prm)
    {
      std::vector<std::string> sentences;
      for (const OldName &old :
           parse_sources(sources, file_name, parameters, prm))
        sentences.push_back("'" + old.old_name + "' is now called '" +
                            old.new_name + "'; the old name still works.");
      return sentences;
    }


    /** Check parameters, and read the files that they name. */
    void
    complete(const MPI_Comm communicator, Parameters &parameters)
    {
      parameters.check();
      if (!parameters.surface.points_file.name.empty())
        parameters.surface.points_file.read("radius, axial coordinate",
                                            communicator);
      for (TableFile &table : parameters.laminate.tables)
        table.file.read("alpha_1, value", communicator);
    }


    /** Whether an entry belongs to one of the sections that begin so. */
    bool
    is_in(const std::string                        &entry,
          const std::initializer_list<const char *> sections)
    {
      return std::any_of(
        sections.begin(), sections.end(), [&](const char *section) {
          return entry.rfind(section, 0) == 0;
        });
    }


    /** What entries change in the mesh. */
    SensitivityParameters::MeshChange
    mesh_change(const std::vector<std::string> &entries)
    {
      using MeshChange  = SensitivityParameters::MeshChange;
      MeshChange change = MeshChange::nothing;
      for (const std::string &entry : entries)
        if (is_in(entry, {"Material ", "Laminate/"}))
          change = std::max(change, MeshChange::plies);
        else if (!is_in(entry, {"Stage ", "Loads/", "Gas/", "Contact/"}))
          change = MeshChange::anything;
      return change;
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
          const std::string &own = stage.friction;
          return stage.contact &&
                 (stage.glued ||
                  (own.empty() ? parameters.contact.friction.coefficient
                               : own) != "0");
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
          const std::vector<std::string> changed_entries =
            variable.get_entries();
          change.mesh_change = mesh_change(changed_entries);
          const bool of_shape =
            std::any_of(changed_entries.begin(),
                        changed_entries.end(),
                        [](const std::string &name) {
                          return is_in(name, {"Surface/", "Mesh/"});
                        });
          const double relative = parameters.sensitivities.step.value_or(
            has_friction || of_shape ? small_step : step);
          const double size =
            relative * (change.value == 0 ? 1 : std::abs(change.value));
          const std::array<double, 2> values{
            {change.value - size, change.value + size}};
          change.step = values[1] - values[0];
          for (unsigned int side = 0; side < 2; ++side)
            {
              std::vector<Source> changed_sources = sources;
              for (const Override &setting :
                   settings({variable}, {values[side]}, declared, entry))
                changed_sources.push_back({entry, override_text(setting)});
              const auto       changed = std::make_shared<Parameters>();
              ParameterHandler changed_prm;
              try
                {
                  parse_collected(
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
                                   "it must be possible to change it a "
                                   "little, and then " +
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
    return parse_collected(collect_sources(file_name, overrides, communicator),
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
      parse_collected(sources, file_name, parameters, prm);
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
