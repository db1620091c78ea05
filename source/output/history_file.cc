// SPDX-License-Identifier: LGPL-2.1-or-later

#include <cmath>

#include <biface/output/csv.h>
#include <biface/output/fiber_tension.h>
#include <biface/output/history_file.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    /** Whether the shell is a surface of revolution about the axle. */
    bool
    is_wheel(const ShellMesh &mesh)
    {
      return mesh.get_surface().get_periodicity()[1] > 0;
    }


    /** A ratio, zero where it means nothing. */
    double
    ratio(const double numerator, const double denominator)
    {
      return denominator > 0 ? numerator / denominator : 0.;
    }
  } // namespace


  std::vector<std::string>
  history_columns(const FailureCriteria &criteria,
                  const ShellMesh       &mesh,
                  const bool             with_volume)
  {
    std::vector<std::string> columns{
      "step",          "stage",           "approach",      "force",
      "contact_nodes", "contact_area",    "max_pressure",  "iterations",
      "seconds",       "pressure",        "load_factor",   "strain_energy",
      "load_work",     "foundation_work", "friction_work", "slide_x",
      "slide_y",       "slide_z",         "turn",          "slipping_nodes"};
    if (with_volume)
      columns.emplace_back("volume");
    for (const FailureCriterion &criterion : criteria.requested())
      for (const std::string what : {"index", "alpha_1", "alpha_2", "ply"})
        columns.push_back(criterion.column + '_' + what);
    if (mesh.layup.has_slack_cords())
      columns.emplace_back("slack_cords");
    for (const std::string column : {"footprint_length",
                                     "footprint_width",
                                     "footprint_area",
                                     "mean_pressure",
                                     "recovered_max_pressure",
                                     "load_ratio",
                                     "slipping_area"})
      columns.push_back(column);
    if (is_wheel(mesh))
      columns.emplace_back("loaded_radius");
    const TensionMembers members(mesh.layup);
    if (members.exist())
      for (const std::string what : {"", "_alpha_1", "_alpha_2", "_ply"})
        columns.push_back("max_" + members.name() + what);
    return columns;
  }


  std::vector<std::optional<double>>
  history_values(const StepReport                  &report,
                 const State                       &state,
                 const ShellEquations              &equations,
                 const Cavity                      *cavity,
                 const std::vector<FailureMaximum> &failure_maxima)
  {
    const ShellMesh                   &mesh    = equations.mesh;
    const ContactSummary              &contact = report.contact;
    std::vector<std::optional<double>> values{
      report.approach,
      contact.force,
      contact.n_nodes,
      contact.area,
      contact.max_pressure,
      report.iterations,
      report.seconds,
      report.loads.pressure,
      report.loads.factor,
      equations.internal_forces().strain_energy(state),
      report.work.loads,
      report.work.foundation,
      report.work.friction,
      report.slide[0],
      report.slide[1],
      report.slide[2],
      report.turn,
      contact.n_slipping};
    const auto add = [&](const double value) { values.emplace_back(value); };
    if (cavity)
      add(cavity->volume(state));
    for (const FailureMaximum &maximum : failure_maxima)
      if (std::isnan(maximum.index))
        values.resize(values.size() + 4);
      else
        for (const double value : {maximum.index,
                                   maximum.alpha[0],
                                   maximum.alpha[1],
                                   static_cast<double>(maximum.ply)})
          add(value);
    if (mesh.layup.has_slack_cords())
      add(equations.internal_forces().slack_fraction(state));

    const Footprint &footprint = report.footprint;
    for (const double value :
         {footprint.length,
          footprint.width,
          footprint.area,
          ratio(contact.force, footprint.area),
          footprint.max_pressure,
          ratio(contact.force, report.loads.pressure * footprint.area),
          contact.slipping_area})
      add(value);
    if (is_wheel(mesh))
      add(report.loads.foundation
            ? report.loads.foundation->clearance(Point<3>())
            : 0.);
    if (TensionMembers(mesh.layup).exist())
      {
        const MaximumTension maximum = find_maximum_tension(equations, state);
        for (const double value : {maximum.value,
                                   maximum.alpha[0],
                                   maximum.alpha[1],
                                   static_cast<double>(maximum.ply)})
          add(value);
      }
    return values;
  }


  std::string
  HistoryFile::header(const FailureCriteria &criteria,
                      const ShellMesh       &mesh,
                      const bool             with_volume)
  {
    std::string text;
    for (const std::string &column :
         history_columns(criteria, mesh, with_volume))
      text += (text.empty() ? "" : ",") + column;
    return text;
  }


  HistoryFile::HistoryFile(const FailureCriteria &criteria,
                           const Cavity          *cavity,
                           ResultsDirectory      &directory,
                           const ShellEquations  &equations)
    : StepTable("history.csv",
                header(criteria, equations.mesh, cavity != nullptr),
                1,
                directory,
                equations)
    , criteria(criteria)
    , cavity(cavity)
  {}


  std::vector<std::string>
  HistoryFile::warnings() const
  {
    return criteria.warnings(equations.mesh.layup);
  }


  void
  HistoryFile::write(const StepReport &report, const State &state)
  {
    failure_maxima   = find_failure_maxima(equations, state, criteria);
    std::string line = std::to_string(report.step) + ',' + report.stage;
    for (const std::optional<double> &value :
         history_values(report, state, equations, cavity, failure_maxima))
      line += ',' + (value ? csv_number(*value) : std::string());
    append(line + '\n');
  }
} // namespace Biface
