// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <filesystem>
#include <set>
#include <sstream>

#include <biface/base/errors.h>
#include <biface/base/version.h>
#include <biface/output/atomic_file.h>
#include <biface/output/csv.h>
#include <biface/output/face_patches.h>
#include <biface/output/results_writer.h>

namespace Biface
{
  using namespace dealii;

  void
  ResultsWriter::Parameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Directory",
                      directory,
                      "Where the results go; made if it does not exist, files "
                      "of an earlier run are replaced.",
                      Patterns::Anything());
    prm.add_parameter("Profile alpha_2",
                      profile,
                      "The coordinate line whose deformed contour is written "
                      "to profile-NNNN.csv; the nearest grid line is taken. "
                      "Unit: degrees for an angle, length otherwise.",
                      Patterns::Double());
    prm.add_parameter("Write VTU",
                      vtu,
                      "Whether to write both faces for ParaView.",
                      Patterns::Bool());
    prm.add_parameter("Write ply VTU",
                      ply_vtu,
                      "Whether to write every ply as a layer of hexahedra for "
                      "ParaView, with its strains and stresses.",
                      Patterns::Bool());
    prm.add_parameter("Points per ply",
                      points_per_ply,
                      "At how many heights within each ply plies-NNNN.csv "
                      "holds the strains and stresses at the named points: 1 "
                      "is the middle, 2 both sides, and so on; 0 writes no "
                      "such file.",
                      Patterns::Integer(0, 101));
    prm.declare_entry("Failure criteria",
                      "",
                      Patterns::MultipleSelection("maximum stress|Tsai-Wu"),
                      "Criteria whose failure indices are written with the "
                      "stresses of plies, a list of 'maximum stress' and "
                      "'Tsai-Wu'; see the strengths of the materials.");
    prm.add_action("Failure criteria", [this](const std::string &text) {
      const auto asked = [&](const std::string &name) {
        return text.find(name) != std::string::npos;
      };
      criteria.maximum_stress = asked("maximum stress");
      criteria.tsai_wu        = asked("Tsai-Wu");
    });
  }


  ResultsWriter::ResultsWriter(const Parameters             &parameters,
                               const ShellEquations         &equations,
                               const std::optional<Written> &continued)
    : parameters(parameters), equations(equations)
  {
    const MPI_Comm communicator = equations.mesh.communicator;

    std::string reason;
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
      {
        std::error_code error;
        std::filesystem::create_directories(parameters.directory, error);
        if (error)
          reason = error.message();
      }
    reason = Utilities::MPI::broadcast(communicator, reason);
    if (!reason.empty())
      throw InputError("Output/Directory",
                       parameters.directory,
                       "that directory cannot be made (" + reason + ")");

    const std::string history_header =
      "step,stage,approach,force,contact_nodes,contact_area,"
      "max_pressure,iterations,seconds,pressure,load_factor\n";
    const std::string probes_header =
      "step,stage,load_factor,name,face,u_x,u_y,u_z,u_1,u_2,u_3\n";
    const unsigned int n_points = equations.mesh.points.size();
    if (continued)
      {
        written = *continued;
        cut_table(path("history.csv"),
                  history_header,
                  written.n_steps,
                  1,
                  communicator);
        if (n_points > 0)
          cut_table(path("probes.csv"),
                    probes_header,
                    written.n_steps,
                    3 * n_points,
                    communicator);
        if (!written.faces.empty())
          write_pvd("shell", written.faces);
        if (!written.plies.empty())
          write_pvd("plies", written.plies);
        return;
      }
    try
      {
        write_text(path("history.csv"), history_header, false, communicator);
        if (n_points > 0)
          write_text(path("probes.csv"), probes_header, false, communicator);
      }
    catch (const OutputError &error)
      {
        throw InputError(error.what());
      }
  }


  void
  ResultsWriter::sync()
  {
    std::string file, reason;
    if (Utilities::MPI::this_mpi_process(equations.mesh.communicator) == 0)
      for (const std::string &name : unsynced)
        if (reason.empty())
          {
            file   = name;
            reason = sync_to_disk(name);
          }
    unsynced.clear();
    const std::pair<std::string, std::string> problem =
      Utilities::MPI::broadcast(equations.mesh.communicator,
                                std::make_pair(file, reason));
    if (!problem.second.empty())
      throw OutputError(problem.first, problem.second);
  }


  std::vector<std::string>
  ResultsWriter::warnings() const
  {
    std::vector<std::string> sentences;
    if (!parameters.criteria.maximum_stress && !parameters.criteria.tsai_wu)
      return sentences;
    std::set<std::string> bare;
    for (const PlyDescription &ply : equations.mesh.layup.get_plies())
      if (!ply.strengths && bare.insert(ply.material).second)
        sentences.push_back("The material '" + ply.material +
                            "' has no strengths (X_t to S), so that its plies "
                            "get no failure index.");
    return sentences;
  }


  void
  ResultsWriter::write_parameters(const std::string &text,
                                  const std::string &file_name) const
  {
    write_text(path("parameters.prm"),
               "# biface " + version() + ", from " + file_name + '\n' + text,
               false,
               equations.mesh.communicator);
  }


  void
  ResultsWriter::write_step(const StepReport &report, const State &state)
  {
    write_contact(report, state);
    write_profile(report, state);
    if (parameters.vtu)
      {
        FacePatches patches(equations, state, report.loads);
        write_vtu(report, patches, "shell", written.faces);
      }
    if (parameters.ply_vtu)
      {
        PlyPatches patches(equations, state, parameters.criteria);
        write_vtu(report, patches, "plies", written.plies);
      }
    if (!equations.mesh.points.empty())
      {
        append_probes(report, state);
        if (parameters.points_per_ply > 0)
          write_plies(report, state);
      }
    append_history(report);
    written.n_steps = report.step;
  }


  void
  ResultsWriter::append_history(const StepReport &report) const
  {
    std::ostringstream line;
    line << report.step << ',' << report.stage << ','
         << csv_number(report.approach) << ','
         << csv_number(report.contact.force) << ',' << report.contact.n_nodes
         << ',' << csv_number(report.contact.area) << ','
         << csv_number(report.contact.max_pressure) << ',' << report.iterations
         << ',' << csv_number(report.seconds) << ','
         << csv_number(report.loads.pressure) << ','
         << csv_number(report.loads.factor) << '\n';
    write_text(
      path("history.csv"), line.str(), true, equations.mesh.communicator);
  }


  template <typename Patches>
  void
  ResultsWriter::write_vtu(const StepReport          &report,
                           Patches                   &patches,
                           const std::string         &series,
                           std::vector<unsigned int> &steps)
  {
    const MPI_Comm communicator = equations.mesh.communicator;

    DataOutBase::VtkFlags flags;
    flags.time              = report.step;
    flags.compression_level = DataOutBase::VtkFlags::best_speed;
    patches.set_flags(flags);

    const std::string name =
      series + "-" + Utilities::int_to_string(report.step, 4) + ".vtu";
    // the pieces of all ranks between the begin of the file, from the first
    // one, and its end, from the last. MPI's parallel files would do it, too,
    // but do not tell of a full disk
    std::ostringstream stream;
    patches.write_vtu(stream);
    std::string       text    = stream.str();
    const std::string closing = "</Piece>\n";
    if (Utilities::MPI::this_mpi_process(communicator) + 1 <
        Utilities::MPI::n_mpi_processes(communicator))
      text.erase(text.rfind(closing) + closing.size());
    if (Utilities::MPI::this_mpi_process(communicator) > 0)
      text.erase(0, text.find("<Piece"));
    write_texts_of_ranks(path(name), text, communicator);

    steps.push_back(report.step);
    write_pvd(series, steps);
  }


  void
  ResultsWriter::write_pvd(const std::string               &series,
                           const std::vector<unsigned int> &steps) const
  {
    std::vector<std::pair<double, std::string>> times_and_names;
    for (const unsigned int step : steps)
      times_and_names.emplace_back(
        step, series + "-" + Utilities::int_to_string(step, 4) + ".vtu");
    std::ostringstream record;
    DataOutBase::write_pvd_record(record, times_and_names);
    write_text(
      path(series + ".pvd"), record.str(), false, equations.mesh.communicator);
  }


  std::string
  ResultsWriter::path(const std::string &name) const
  {
    const std::string path = parameters.directory + "/" + name;
    unsynced.insert(path);
    return path;
  }
} // namespace Biface
