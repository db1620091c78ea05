// SPDX-License-Identifier: LGPL-2.1-or-later

#include <limits>
#include <map>

#include <biface/model/state/loads.h>
#include <biface/output/csv.h>
#include <biface/output/rig_table.h>
#include <biface/stepping/step_report.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    const std::string table_header =
      "point,status,axes,load,pressure,velocity,inclination_angle,slip_angle,"
      "slip_ratio,"
      "F_x,F_y,F_z,M_x,M_y,M_z,angular_velocity,rolling_radius,loaded_radius,"
      "axle_moment,rolling_resistance,footprint_length,footprint_width,"
      "footprint_area,iterations\n";


    /** A sentence as a cell. */
    std::string
    cell(std::string text)
    {
      for (char &c : text)
        if (c == ',' || c == '"' || c == '\n')
          c = ';';
      return text;
    }
  } // namespace


  std::vector<std::string>
  rig_axes_names()
  {
    return {"ISO", "SAE", "adapted ISO"};
  }


  RigPoint
  rig_point(const RigTarget &target, const StepReport &report)
  {
    const RollingSummary &rolling = *report.rolling;
    RigPoint              result;
    result.pressure           = report.loads->pressure;
    result.velocity           = report.level.ground_velocity;
    result.inclination_angle  = report.level.inclination_angle;
    result.slip_angle         = report.level.slip_angle;
    result.slip_ratio         = target.slip_ratio;
    result.angular_velocity   = report.level.angular_velocity;
    result.rolling_radius     = rolling.rolling_radius;
    result.loaded_radius      = rolling.loaded_radius;
    result.force              = rolling.force;
    result.moment             = rolling.moment;
    result.axle_moment        = rolling.axle_moment;
    result.rolling_resistance = rolling.hysteresis
                                  ? rolling.rolling_resistance
                                  : std::numeric_limits<double>::quiet_NaN();
    result.footprint_length   = report.footprint.length;
    result.footprint_width    = report.footprint.width;
    result.footprint_area     = report.footprint.area;
    result.n_iterations       = report.iterations;
    return result;
  }


  RigTable::RigTable(const RigAxes                 axes,
                     const std::vector<RigTarget> &targets,
                     const unsigned int            first_point,
                     ResultsDirectory             &directory)
    : axes(axes)
    , targets(targets)
    , first_point(first_point)
    , directory(directory)
  {
    directory.remove("tire_test\\.csv");
  }


  void
  RigTable::write(const Points &points, const Failures &failures)
  {
    if (points.size() + failures.size() == n_written)
      return;
    n_written = points.size() + failures.size();
    // all of it again: a row, also of a failure, has its place in the test
    std::map<unsigned int, std::string> rows;
    for (const auto &[position, point] : points)
      rows[position] = row(position, &point, "ok");
    for (const auto &[position, failure] : failures)
      rows[position] = row(position, nullptr, cell(failure));
    std::string text = table_header;
    for (const auto &[position, line] : rows)
      text += line;
    write_text(directory.path(file_name), text, false, directory.communicator);
  }


  std::string
  RigTable::row(const unsigned int position,
                const RigPoint    *point,
                const std::string &status) const
  {
    // the y axis points to the right in SAE and to the left otherwise, and z
    // goes with it; x is forward in all
    const RigTarget   &asked   = target(position);
    const double       nan     = std::numeric_limits<double>::quiet_NaN();
    const double       left    = axes == RigAxes::SAE ? -1 : 1;
    const double       angle   = axes == RigAxes::ISO ? 1 : -1;
    const double       incline = axes == RigAxes::adapted_ISO ? -1 : 1;
    const Tensor<1, 3> signs({1., left, left});

    std::vector<double> values{asked.load};
    if (point == nullptr)
      {
        values.insert(values.end(),
                      {asked.pressure,
                       asked.velocity,
                       incline * asked.inclination_angle,
                       angle * asked.slip_angle,
                       asked.slip_ratio});
        // no results, and no iterations
        values.resize(values.size() + 14, nan);
        values.push_back(0);
      }
    else
      {
        values.insert(values.end(),
                      {point->pressure,
                       point->velocity,
                       incline * point->inclination_angle,
                       angle * point->slip_angle,
                       point->slip_ratio});
        for (const Tensor<1, 3> &vector : {point->force, point->moment})
          for (unsigned int i = 0; i < 3; ++i)
            values.push_back(signs[i] * vector[i]);
        values.insert(values.end(),
                      {point->angular_velocity,
                       point->rolling_radius,
                       point->loaded_radius,
                       point->axle_moment,
                       point->rolling_resistance,
                       point->footprint_length,
                       point->footprint_width,
                       point->footprint_area,
                       static_cast<double>(point->n_iterations)});
      }
    std::string line = std::to_string(position - first_point + 1) + ',' +
                       status + ',' +
                       rig_axes_names()[static_cast<unsigned int>(axes)];
    for (const double value : values)
      // no negative zeros
      line += ',' + csv_number(value == 0 ? 0. : value);
    return line + '\n';
  }


  std::string
  RigTable::warning(const Failures &failures) const
  {
    if (failures.empty())
      return {};
    return std::to_string(failures.size()) + " of " +
           std::to_string(targets.size()) +
           (failures.size() == 1
              ? " point of the tire test has failed: "
              : " points of the tire test have failed, the first one: ") +
           failures.begin()->second + ".";
  }


  std::string
  RigTable::description() const
  {
    return n_written > 0 ? file_name : "";
  }
} // namespace Biface
