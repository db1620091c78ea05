// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>

#include <biface/base/errors.h>
#include <biface/base/version.h>
#include <biface/input/entry_declarations.h>
#include <biface/model/equations/shell_equations.h>
#include <biface/output/buckling_file.h>
#include <biface/output/buckling_shapes_file.h>
#include <biface/output/contact_file.h>
#include <biface/output/critical_points_file.h>
#include <biface/output/csv.h>
#include <biface/output/heat_file.h>
#include <biface/output/hysteresis_file.h>
#include <biface/output/mode_vtu.h>
#include <biface/output/modes_file.h>
#include <biface/output/probes_file.h>
#include <biface/output/response_file.h>
#include <biface/output/results_writer.h>
#include <biface/output/rolling_file.h>
#include <biface/output/sensitivities_file.h>
#include <biface/output/stiffness_file.h>
#include <biface/stepping/step_report.h>

namespace Biface
{
  using namespace dealii;

  void
  ResultsWriter::Parameters::add_parameters(EntryDeclarations &prm)
  {
    prm.add_parameter("Directory",
                      directory,
                      "Directory of the results. It is created if it does not "
                      "exist; results of an earlier run in it are removed.",
                      Patterns::Anything());
    prm.add_parameter(
      "Every",
      every,
      "Write the files of single steps (contact-NNNN.csv, profile-NNNN.csv, "
      "plies-NNNN.csv and those for ParaView) in every step whose number is a "
      "multiple of this, and in the last step of each stage. Tables have all "
      "steps.",
      Patterns::Integer(1));
    forces.add_parameters(prm);
    profile.add_parameters(prm);
    shell_vtu.add_parameters(prm);
    plies_vtu.add_parameters(prm);
    plies.add_parameters(prm);
    criteria.add_parameters(prm);
  }


  ResultsWriter::ResultsWriter(const Parameters             &parameters,
                               ResultsDirectory             &directory,
                               const std::vector<Stage>     &stages,
                               const ShellEquations         &equations,
                               const Cavity                 *cavity,
                               const unsigned int            n_sensitivities,
                               const std::optional<Written> &continued)
    : every(parameters.every), directory(directory)
  {
    const auto add = [this](auto file) { files.push_back(std::move(file)); };
    auto       history_file = std::make_unique<HistoryFile>(
      parameters.criteria, cavity, directory, equations);
    history = history_file.get();
    add(std::move(history_file));
    add(std::make_unique<ForcesFile>(parameters.forces, directory, equations));
    add(std::make_unique<StiffnessFile>(stages, directory, equations));
    add(std::make_unique<RollingFile>(stages, directory, equations));
    add(std::make_unique<HysteresisFile>(stages, directory, equations));
    add(std::make_unique<HeatFile>(stages, directory, equations));
    add(std::make_unique<ModesFile>(stages, directory, equations));
    add(std::make_unique<ResponseFile>(stages, directory, equations));
    add(std::make_unique<BucklingFile>(stages, directory, equations));
    if (equations.mesh.grid.has_lines())
      add(std::make_unique<BucklingShapesFile>(stages, directory, equations));
    add(std::make_unique<CriticalPointsFile>(stages, directory, equations));
    add(std::make_unique<SensitivitiesFile>(
      n_sensitivities, directory, equations));
    add(std::make_unique<ContactFile>(directory, equations));
    if (equations.mesh.grid.has_lines())
      add(std::make_unique<ProfileFile>(
        parameters.profile, directory, equations));
    add(std::make_unique<ProbesFile>(directory, equations));
    add(std::make_unique<PliesFile>(
      parameters.plies, parameters.criteria, directory, equations));
    add(std::make_unique<ShellVtu>(parameters.shell_vtu, directory, equations));
    add(std::make_unique<ModeVtu>(
      parameters.shell_vtu, stages, directory, equations));
    add(std::make_unique<BucklingVtu>(
      parameters.shell_vtu, stages, directory, equations));
    add(std::make_unique<PliesVtu>(
      parameters.plies_vtu, parameters.criteria, directory, equations));

    // before anything is removed
    for (const auto &file : files)
      if (file->is_wanted())
        directory.refuse_input(file->names_of_files());
    // what an earlier run has written there is not of this one
    if (!continued)
      for (const auto &file : files)
        directory.remove(file->names_of_files());
    for (const auto &file : files)
      if (continued && continued->count(file->name) > 0)
        file->resume(continued->at(file->name));
      else if (file->is_wanted())
        file->start();
  }


  std::vector<std::string>
  ResultsWriter::warnings() const
  {
    std::vector<std::string> sentences;
    for (const auto &file : files)
      if (file->is_wanted())
        for (const std::string &sentence : file->warnings())
          if (std::find(sentences.begin(), sentences.end(), sentence) ==
              sentences.end())
            sentences.push_back(sentence);
    return sentences;
  }


  std::vector<std::string>
  ResultsWriter::list() const
  {
    std::vector<std::string> descriptions;
    for (const auto &file : files)
      if (file->is_wanted())
        descriptions.push_back(file->description());
    return descriptions;
  }


  void
  ResultsWriter::write_parameters(const std::string &text,
                                  const std::string &file_name)
  {
    write_text(directory.path("parameters.prm"),
               "# biface " + version() + ", from " + file_name + '\n' + text,
               false,
               directory.communicator);
  }


  void
  ResultsWriter::write_step(const StepReport &report, const State &state)
  {
    // Tables after the larger files, which may find the disk full, and the
    // history last: all files of the steps that it lists exist.
    const auto write = [&](const bool tables) {
      for (auto file = files.rbegin(); file != files.rend(); ++file)
        if ((*file)->is_wanted() && (*file)->is_table() == tables)
          (*file)->write_step(report, state);
    };
    if (report.step % every == 0 || report.instant.fraction >= 1)
      write(false);
    for (const auto &file : files)
      file->complete_step();
    write(true);
  }


  ResultsWriter::Written
  ResultsWriter::get_written() const
  {
    Written written;
    for (const auto &file : files)
      if (file->is_wanted() || !file->get_steps().empty())
        written[file->name] = file->get_steps();
    return written;
  }
} // namespace Biface
