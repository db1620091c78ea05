// SPDX-License-Identifier: LGPL-2.1-or-later

// Any file is accepted as a meridian, a table for formulas or a list of
// intervals, or is refused with one sentence.

#include <filesystem>
#include <fstream>

#include <biface/input/read_file.h>
#include <biface/laminate/meridional_tables.h>
#include <biface/surface/half_wave_series.h>
#include <biface/surface/intervals.h>
#include <biface/surface/spline_curve.h>

#include "fuzz.h"
#include <unistd.h>

namespace Fuzz::CsvFiles
{
  using namespace Biface;

  namespace
  {
    std::string file_name;
  }


  void
  initialize()
  {
    file_name = (std::filesystem::temp_directory_path() /
                 ("biface_fuzz_" + std::to_string(getpid()) + ".csv"))
                  .string();
    std::atexit([]() { std::remove(file_name.c_str()); });
  }


  void
  try_input(const std::string &input)
  {
    std::ofstream(file_name, std::ios::binary) << input;

    std::string text;
    read(input, [&]() { text = read_file(file_name, MPI_COMM_SELF); });
    read(input, [&]() {
      const SplineCurve curve(parse_pairs(text, "meridian", "radius, axial"),
                              "meridian");
      const double      middle = curve.range().second / 2;
      curve.parameter_of(curve.evaluate(middle).position);
    });
    read(input, [&]() {
      std::vector<TableFile> files =
        parse_tables("entry", "t: " + file_name, "alpha_1");
      for (TableFile &table : files)
        table.file.read("alpha_1, value", MPI_COMM_SELF);
      const MeridionalTables tables(
        files, SurfaceOfPlies(), AngleReference::meridian);
      tables.function(parse_ply_formula("entry", "2*t"))(1.);
    });
    read(input, [&]() { HalfWaveSeries(text, "series").value(0.5, 1); });
    read(input, [&]() { parse_intervals("entry", text).lines(); });
  }
} // namespace Fuzz::CsvFiles
