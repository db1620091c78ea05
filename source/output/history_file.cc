// SPDX-License-Identifier: LGPL-2.1-or-later

#include <cmath>
#include <sstream>

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


  std::string
  HistoryFile::header(const FailureCriteria &criteria,
                      const ShellMesh       &mesh,
                      const bool             with_volume)
  {
    const Layup &layup = mesh.layup;
    std::string  header =
      "step,stage,approach,force,contact_nodes,contact_area,"
      "max_pressure,iterations,seconds,pressure,load_factor,"
      "strain_energy,load_work,foundation_work,friction_work,slide_x,"
      "slide_y,slide_z,turn,slipping_nodes";
    if (with_volume)
      header += ",volume";
    for (const FailureCriterion &criterion : criteria.requested())
      for (const std::string what : {"index", "alpha_1", "alpha_2", "ply"})
        header += ',' + criterion.column + '_' + what;
    if (layup.has_slack_cords())
      header += ",slack_cords";
    header += ",footprint_length,footprint_width,footprint_area,"
              "mean_pressure,recovered_max_pressure,load_ratio,"
              "slipping_area";
    if (is_wheel(mesh))
      header += ",loaded_radius";
    const TensionMembers members(layup);
    if (members.exist())
      for (const std::string what : {"", "_alpha_1", "_alpha_2", "_ply"})
        header += ",max_" + members.name() + what;
    return header;
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
    std::ostringstream line;
    line << report.step << ',' << report.stage << ','
         << csv_number(report.approach) << ','
         << csv_number(report.contact.force) << ',' << report.contact.n_nodes
         << ',' << csv_number(report.contact.area) << ','
         << csv_number(report.contact.max_pressure) << ',' << report.iterations
         << ',' << csv_number(report.seconds) << ','
         << csv_number(report.loads.pressure) << ','
         << csv_number(report.loads.factor) << ','
         << csv_number(equations.internal_forces().strain_energy(state)) << ','
         << csv_number(report.work.loads) << ','
         << csv_number(report.work.foundation) << ','
         << csv_number(report.work.friction) << ',';
    for (unsigned int i = 0; i < 3; ++i)
      line << csv_number(report.slide[i]) << ',';
    line << csv_number(report.turn) << ',' << report.contact.n_slipping;
    if (cavity)
      line << ',' << csv_number(cavity->volume(state));
    failure_maxima = find_failure_maxima(equations, state, criteria);
    for (const FailureMaximum &maximum : failure_maxima)
      if (std::isnan(maximum.index))
        line << ",,,,";
      else
        line << ',' << csv_number(maximum.index) << ','
             << csv_number(maximum.alpha[0]) << ','
             << csv_number(maximum.alpha[1]) << ',' << maximum.ply;
    if (equations.mesh.layup.has_slack_cords())
      line << ','
           << csv_number(equations.internal_forces().slack_fraction(state));

    const Footprint &footprint = report.footprint;
    const double     force     = report.contact.force;
    for (const double value :
         {footprint.length,
          footprint.width,
          footprint.area,
          ratio(force, footprint.area),
          footprint.max_pressure,
          ratio(force, report.loads.pressure * footprint.area),
          report.contact.slipping_area})
      line << ',' << csv_number(value);
    if (is_wheel(equations.mesh))
      line << ','
           << csv_number(report.loads.foundation
                           ? report.loads.foundation->clearance(Point<3>())
                           : 0.);
    if (TensionMembers(equations.mesh.layup).exist())
      {
        const MaximumTension maximum = find_maximum_tension(equations, state);
        line << ',' << csv_number(maximum.value) << ','
             << csv_number(maximum.alpha[0]) << ','
             << csv_number(maximum.alpha[1]) << ',' << maximum.ply;
      }
    line << '\n';
    append(line.str());
  }
} // namespace Biface
