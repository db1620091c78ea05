// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/table_handler.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

#include <biface/model/quantities/point_displacement.h>
#include <biface/model/state/loads.h>
#include <biface/model/state/state.h>
#include <biface/output/reaction_columns.h>
#include <biface/output/summary_table.h>
#include <biface/stepping/critical_point.h>
#include <biface/stepping/step_report.h>

namespace Biface
{
  using namespace dealii;

  void
  SummaryTable::add(const StepReport                  &report,
                    const State                       &state,
                    const ShellMesh                   &mesh,
                    const std::vector<FailureMaximum> &failure_maxima)
  {
    Line line{report.step,
              report.loads->factors[0],
              report.loads->pressure,
              report.level.travel,
              report.in_contact,
              report.contact,
              reaction_values(mesh, *report.loads, report.forces_of_bodies),
              report.critical_point
                ? report.critical_point->kind() +
                    (report.critical_point->located ? "" : " passed")
                : "",
              {},
              failure_maxima};
    for (const NamedPoint &point : mesh.points)
      {
        const PointDisplacement u =
          displacement_at(point, state.displacement, mesh);
        for (unsigned int i = 0; i < 3; ++i)
          line.displacements.push_back((u.global[0][i] + u.global[1][i]) / 2);
      }
    lines.push_back(line);
  }


  void
  SummaryTable::print(const ShellMesh &mesh, std::ostream &out) const
  {
    const std::vector<NamedPoint> &points      = mesh.points;
    constexpr unsigned int         max_columns = 10;

    if (lines.empty())
      return;

    TableHandler table;
    unsigned int n_columns = 0;
    const auto   add = [&](const std::string                              &name,
                         const std::function<std::string(const Line &)> &text) {
      for (const Line &line : lines)
        table.add_value(name, text(line));
      ++n_columns;
    };
    const auto number = [](const double value) {
      char text[32];
      std::snprintf(text, sizeof(text), "%.6g", value == 0 ? 0. : value);
      return std::string(text);
    };
    const auto add_contact =
      [&](const std::string                              &name,
          const std::function<std::string(const Line &)> &text) {
        add(name, [&](const Line &line) {
          return line.in_contact ? text(line) : std::string("-");
        });
      };
    const auto any = [&](const std::function<bool(const Line &)> &is) {
      return std::any_of(lines.begin(), lines.end(), is);
    };

    add("step", [](const Line &line) { return std::to_string(line.step); });
    // columns of zeros would take the place of others
    if (any([](const Line &line) { return line.factor != 0; }))
      add("load factor", [&](const Line &line) { return number(line.factor); });
    if (any([](const Line &line) { return line.pressure != 0; }))
      add("pressure", [&](const Line &line) { return number(line.pressure); });
    // the columns of history.csv in words
    unsigned int reaction = 0;
    for (const SupportMotion &motion : mesh.supported.motions)
      for (const char *what : {motion.displacement_name(), motion.force_name()})
        {
          if (n_columns < max_columns)
            add(motion.name + ' ' + what, [&](const Line &line) {
              return number(line.reactions[reaction]);
            });
          ++reaction;
        }
    if (any([](const Line &line) { return line.in_contact; }))
      {
        add_contact("approach",
                    [&](const Line &line) { return number(line.approach); });
        add_contact("force", [&](const Line &line) {
          return number(line.contact.force);
        });
        add_contact("contact nodes", [&](const Line &line) {
          return std::to_string(line.contact.n_nodes);
        });
        add_contact("contact area", [&](const Line &line) {
          return number(line.contact.area);
        });
        add_contact("max contact pressure", [&](const Line &line) {
          return number(line.contact.max_pressure);
        });
      }
    for (unsigned int i = 0; i < lines.back().failure_maxima.size(); ++i)
      add(lines.back().failure_maxima[i].name + " index",
          [&](const Line &line) {
            const FailureMaximum &maximum = line.failure_maxima[i];
            if (std::isnan(maximum.index))
              return std::string("-");
            return number(maximum.index) + " at (" + number(maximum.alpha[0]) +
                   ", " + number(maximum.alpha[1]) + "), ply " +
                   std::to_string(maximum.ply);
          });
    for (unsigned int p = 0; p < points.size() && n_columns < max_columns; ++p)
      {
        // a line has room for one component of a point: the largest at the end
        const std::vector<double> &last    = lines.back().displacements;
        unsigned int               largest = 3 * p;
        for (unsigned int i = 3 * p; i < 3 * p + 3; ++i)
          if (std::abs(last[i]) > std::abs(last[largest]))
            largest = i;
        add(points[p].name + " u_" + "xyz"[largest % 3], [&](const Line &line) {
          return number(line.displacements[largest]);
        });
      }
    // words, last so that the numbers stay in their columns
    if (any([](const Line &line) { return !line.critical_point.empty(); }))
      add("critical point", [](const Line &line) {
        return line.critical_point.empty() ? "-" : line.critical_point;
      });
    table.write_text(out);
  }
} // namespace Biface
