// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <sstream>

#include <biface/base/input_error.h>
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
                      "Whether to write files for ParaView.",
                      Patterns::Bool());
  }


  namespace
  {
    /** A node's coordinate as a person writes it. Free of round-off, so that
     * nodes of one coordinate line agree in it. */
    double
    chart_coordinate(const ReferenceSurface &surface,
                     const Node             &node,
                     const unsigned int      a)
    {
      return std::round(node.alpha[a] / surface.coordinate_unit(a) * 1e9) / 1e9;
    }
  } // namespace


  ResultsWriter::ResultsWriter(const Parameters     &parameters,
                               const ShellEquations &equations)
    : parameters(parameters), equations(equations)
  {
    const MPI_Comm communicator = equations.discretization.communicator;

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

    write_text(path("history.csv"),
               "step,stage,approach,force,contact_nodes,contact_area,"
               "max_pressure,iterations,seconds,pressure,load_factor\n",
               false,
               communicator);
    if (!equations.discretization.points.empty())
      write_text(path("probes.csv"),
                 "step,stage,load_factor,name,face,u_x,u_y,u_z,u_1,u_2,u_3\n",
                 false,
                 communicator);
  }


  void
  ResultsWriter::write_parameters(const ParameterHandler &prm) const
  {
    std::ostringstream text;
    prm.print_parameters(
      text, ParameterHandler::PRM | ParameterHandler::KeepDeclarationOrder);
    write_text(path("parameters.prm"),
               text.str(),
               false,
               equations.discretization.communicator);
  }


  void
  ResultsWriter::write_step(const StepReport &report, const State &state)
  {
    write_contact(report, state);
    write_profile(report, state);
    if (parameters.vtu)
      write_vtu(report, state);
    if (!equations.discretization.points.empty())
      append_probes(report, state);
    append_history(report);
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
    write_text(path("history.csv"),
               line.str(),
               true,
               equations.discretization.communicator);
  }


  void
  ResultsWriter::append_probes(const StepReport &report,
                               const State      &state) const
  {
    const Discretization &discretization = equations.discretization;

    std::string text;
    for (const NamedPoint &point : discretization.points)
      {
        // x, y, z, then 1, 2, 3 of both faces, from the rank that owns the node
        std::array<std::vector<double>, 2> u{
          {std::vector<double>(6), std::vector<double>(6)}};
        const unsigned int n =
          discretization.node_of_point("Points", point.name);
        if (n != numbers::invalid_unsigned_int &&
            discretization.nodes[n].locally_owned)
          for (unsigned int face = 0; face < 2; ++face)
            {
              const Node        &node = discretization.nodes[n];
              const Tensor<1, 3> local =
                discretization.displacement(state.displacement, node, face);
              const Tensor<1, 3> global = node.surface.from_frame(local);
              for (unsigned int i = 0; i < 3; ++i)
                {
                  u[face][i]     = global[i];
                  u[face][3 + i] = local[i];
                }
            }
        for (auto &values : u)
          Utilities::MPI::sum(values, discretization.communicator, values);

        const auto append = [&](const std::string &face,
                                const double       share_of_inner) {
          text += std::to_string(report.step) + ',' + report.stage + ',' +
                  csv_number(report.loads.factor) + ',' + point.name + ',' +
                  face;
          for (unsigned int i = 0; i < 6; ++i)
            text += ',' + csv_number(share_of_inner * u[0][i] +
                                     (1 - share_of_inner) * u[1][i]);
          text += '\n';
        };
        append("inner", 1);
        append("outer", 0);
        append("middle", 0.5);
      }
    write_text(path("probes.csv"), text, true, discretization.communicator);
  }


  void
  ResultsWriter::write_contact(const StepReport &report,
                               const State      &state) const
  {
    const Discretization   &discretization = equations.discretization;
    const ReferenceSurface &surface        = discretization.get_surface();

    Rows rows;
    if (report.loads.foundation)
      for (unsigned int n = 0; n < discretization.nodes.size(); ++n)
        {
          const Node &node = discretization.nodes[n];
          bool        near = false;
          for (const unsigned int neighbor : discretization.neighbors[n])
            near = near || state.active[neighbor];
          if (!node.locally_owned || !near)
            continue;

          const Point<3> x = discretization.deformed_position(
            state.displacement, node, Resultants::outer);
          const double pressure = equations.pressure(state, report.loads, n);
          const ThicknessMetric metric(node.surface.curvature, node.faces);
          rows.push_back({chart_coordinate(surface, node, 0),
                          chart_coordinate(surface, node, 1),
                          x[0],
                          x[1],
                          x[2],
                          equations.clearance(state, report.loads, node),
                          pressure,
                          static_cast<double>(state.active[n]),
                          pressure * metric.area_ratio(Resultants::outer)});
        }
    write_csv(
      path("contact-" + Utilities::int_to_string(report.step, 4) + ".csv"),
      "alpha_1,alpha_2,x,y,z,clearance,pressure,active,face_pressure",
      rows,
      discretization.communicator);
  }


  void
  ResultsWriter::write_profile(const StepReport &report,
                               const State      &state) const
  {
    const Discretization   &discretization = equations.discretization;
    const ReferenceSurface &surface        = discretization.get_surface();

    const double period   = surface.get_periodicity()[1];
    const auto   distance = [&](const Node &node) {
      const double d =
        node.alpha[1] - parameters.profile * surface.coordinate_unit(1);
      return std::abs(period > 0 ? std::remainder(d, period) : d);
    };
    double nearest = std::numeric_limits<double>::max();
    for (const Node &node : discretization.nodes)
      nearest = std::min(nearest, distance(node));
    nearest = Utilities::MPI::min(nearest, discretization.communicator);

    // of two lines equally near, the one with the lesser coordinate
    double line = std::numeric_limits<double>::max();
    for (const Node &node : discretization.nodes)
      if (distance(node) <= nearest + 1e-9)
        line = std::min(line, node.alpha[1]);
    line = Utilities::MPI::min(line, discretization.communicator);

    Rows rows;
    for (unsigned int n = 0; n < discretization.nodes.size(); ++n)
      {
        const Node &node = discretization.nodes[n];
        if (!node.locally_owned || node.alpha[1] != line)
          continue;

        std::vector<double> row{chart_coordinate(surface, node, 0),
                                chart_coordinate(surface, node, 1)};
        for (const unsigned int face : {Resultants::outer, Resultants::inner})
          {
            const Point<3> x =
              discretization.deformed_position(state.displacement, node, face);
            row.insert(row.end(), {x[0], x[1], x[2]});
          }
        row.push_back(report.loads.foundation
                        ? equations.pressure(state, report.loads, n)
                        : 0.);
        rows.push_back(row);
      }
    write_csv(
      path("profile-" + Utilities::int_to_string(report.step, 4) + ".csv"),
      "alpha_1,alpha_2,outer_x,outer_y,outer_z,inner_x,inner_y,"
      "inner_z,pressure",
      rows,
      discretization.communicator);
  }


  void
  ResultsWriter::write_vtu(const StepReport &report, const State &state)
  {
    const MPI_Comm communicator = equations.discretization.communicator;

    FacePatches           patches(equations, state, report.loads);
    DataOutBase::VtkFlags flags;
    flags.time              = report.step;
    flags.compression_level = DataOutBase::VtkFlags::best_speed;
    patches.set_flags(flags);

    const std::string name =
      "shell-" + Utilities::int_to_string(report.step, 4) + ".vtu";
    // every rank writes its part: say what went wrong on any of them
    bool failed = false;
    try
      {
        patches.write_vtu_in_parallel(path(name), communicator);
      }
    catch (const ExceptionBase &)
      {
        failed = true;
      }
    if (Utilities::MPI::max(static_cast<unsigned int>(failed), communicator) >
        0)
      throw InputError("the file '" + path(name) +
                       "' cannot be written, but results must go somewhere.");

    times_and_names.emplace_back(report.step, name);
    std::ostringstream record;
    DataOutBase::write_pvd_record(record, times_and_names);
    write_text(path("shell.pvd"), record.str(), false, communicator);
  }


  std::string
  ResultsWriter::path(const std::string &name) const
  {
    return parameters.directory + "/" + name;
  }
} // namespace Biface
