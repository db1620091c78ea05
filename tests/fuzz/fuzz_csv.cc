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

using namespace Biface;

namespace
{
  std::string file_name;
}


extern "C" int
LLVMFuzzerInitialize(int *argc, char ***argv)
{
  Fuzz::initialize_mpi(argc, argv);
  file_name = (std::filesystem::temp_directory_path() /
               ("biface_fuzz_" + std::to_string(getpid()) + ".csv"))
                .string();
  std::atexit([]() { std::remove(file_name.c_str()); });
  return 0;
}


extern "C" int
LLVMFuzzerTestOneInput(const std::uint8_t *data, const std::size_t size)
{
  const std::string input(reinterpret_cast<const char *>(data), size);
  std::ofstream(file_name, std::ios::binary) << input;

  std::string text;
  Fuzz::read(input, [&]() { text = read_file(file_name, MPI_COMM_SELF); });
  Fuzz::read(input, [&]() {
    const SplineCurve curve(parse_pairs(text, "meridian", "radius, axial"),
                            "meridian");
    const double      middle = curve.range().second / 2;
    curve.parameter_of(curve.evaluate(middle).position);
  });
  Fuzz::read(input, [&]() {
    std::vector<TableFile> files = parse_tables("entry", "t: " + file_name);
    for (TableFile &table : files)
      table.file.read("alpha_1, value", MPI_COMM_SELF);
    const MeridionalTables tables(
      files, SurfaceOfPlies(), AngleReference::meridian);
    tables.function(parse_ply_formula("entry", "2*t"))(1.);
  });
  Fuzz::read(input, [&]() { HalfWaveSeries(text, "series").value(0.5, 1); });
  Fuzz::read(input, [&]() { parse_intervals("entry", text).lines(); });
  return 0;
}
