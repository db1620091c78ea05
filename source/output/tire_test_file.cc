// SPDX-License-Identifier: LGPL-2.1-or-later

#include <limits>

#include <biface/output/csv.h>
#include <biface/output/tire_test_file.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    const std::string header =
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


  TireTestFile::TireTestFile(const TireTest           &test,
                             const std::vector<Stage> &stages,
                             ResultsDirectory         &directory)
    : test(test), stages(stages), directory(directory)
  {
    directory.remove("tire_test\\.csv");
  }


  void
  TireTestFile::write(const std::map<unsigned int, TireTestResult> &tested)
  {
    if (tested.size() == n_written)
      return;
    n_written        = tested.size();
    std::string text = header;
    for (const auto &[position, result] : tested)
      text += row(position, result);
    write_text(directory.path(file_name), text, false, directory.communicator);
  }


  std::string
  TireTestFile::row(const unsigned int    position,
                    const TireTestResult &result) const
  {
    const Stage &stage   = stages[position];
    const bool   failed  = !result.failure.empty();
    const double nan     = std::numeric_limits<double>::quiet_NaN();
    const double left    = test.axes == TireTest::Axes::SAE ? -1 : 1;
    const double angle   = test.axes == TireTest::Axes::ISO ? 1 : -1;
    const double incline = test.axes == TireTest::Axes::adapted_ISO ? -1 : 1;
    const Tensor<1, 3> signs({1., left, left});
    const char *const  axes[] = {"ISO", "SAE", "adapted ISO"};

    std::vector<double> values{stage.force};
    if (failed)
      {
        values.insert(values.end(),
                      {stage.pressure.value_or(nan),
                       stage.ground_velocity.value_or(nan),
                       incline * stage.inclination_angle.value_or(nan),
                       angle * stage.slip_angle.value_or(nan),
                       stage.slip_ratio.value_or(0)});
        values.resize(values.size() + 14, nan);
        values.push_back(0);
      }
    else
      {
        values.insert(values.end(),
                      {result.pressure,
                       result.velocity,
                       incline * result.inclination_angle,
                       angle * result.slip_angle,
                       result.slip_ratio});
        for (const Tensor<1, 3> &vector : {result.force, result.moment})
          for (unsigned int i = 0; i < 3; ++i)
            values.push_back(signs[i] * vector[i]);
        values.insert(values.end(),
                      {result.angular_velocity,
                       result.rolling_radius,
                       result.loaded_radius,
                       result.axle_moment,
                       result.rolling_resistance,
                       result.footprint_length,
                       result.footprint_width,
                       result.footprint_area,
                       static_cast<double>(result.n_iterations)});
      }
    std::string line = std::to_string(stage.test_point) + ',' +
                       (failed ? cell(result.failure) : "ok") + ',' +
                       axes[static_cast<unsigned int>(test.axes)];
    for (const double value : values)
      // no negative zeros
      line += ',' + csv_number(value == 0 ? 0. : value);
    return line + '\n';
  }


  std::string
  TireTestFile::failures(
    const std::map<unsigned int, TireTestResult> &tested) const
  {
    unsigned int       n     = 0;
    const std::string *first = nullptr;
    for (const auto &[position, result] : tested)
      if (!result.failure.empty() && ++n == 1)
        first = &result.failure;
    if (n == 0)
      return {};
    return std::to_string(n) + " of " +
           std::to_string(TireTest::n_points(stages)) +
           (n == 1 ? " point of the tire test has failed: "
                   : " points of the tire test have failed, the first one: ") +
           *first + ".";
  }


  std::string
  TireTestFile::description() const
  {
    return n_written > 0 ? file_name : "";
  }
} // namespace Biface
