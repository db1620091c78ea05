// SPDX-License-Identifier: LGPL-2.1-or-later

// Any parameter file gives an analysis that is ready to run, or is refused with
// one sentence. Only meshes of a few cells are set up; those of the examples
// are replaced by smaller ones.

#include <filesystem>
#include <fstream>
#include <sstream>

#include <biface/analysis/simulation.h>
#include <biface/laminate/layup.h>
#include <biface/problem/parameters.h>
#include <biface/surface/intervals.h>

#include "fuzz.h"
#include <unistd.h>

namespace Fuzz::ParameterFiles
{
  using namespace Biface;

  namespace
  {
    std::filesystem::path folder;
  }


  void
  initialize()
  {
    // the files that the examples name lie beside the input
    folder = std::filesystem::temp_directory_path() /
             ("biface_fuzz_" + std::to_string(getpid()));
    std::filesystem::create_directory(folder);
    for (const auto &file : std::filesystem::directory_iterator(PRM_DIR))
      if (file.path().extension() == ".csv")
        std::filesystem::copy(file.path(), folder);
    std::atexit([]() { std::filesystem::remove_all(folder); });
  }


  namespace
  {
    unsigned int
    n_nodes(const ChartGrid &grid)
    {
      return grid.lines[0].size() * grid.lines[1].size();
    }


    /** The lines of a mesh with few cells between the same ends. */
    std::string
    coarse(const std::vector<double> &lines,
           const double               unit,
           const unsigned int         n)
    {
      std::ostringstream text;
      text.precision(17);
      text << lines.front() / unit << ':' << lines.back() / unit << ':' << n;
      return text.str();
    }


    void
    set_up(Parameters &parameters)
    {
      const auto      surface = make_surface(parameters.surface);
      const ChartGrid grid(parameters.mesh, *surface);
      const Layup     layup(parameters.laminate, parameters.materials);
      parameters.warnings();
      if (n_nodes(grid) > 40)
        for (unsigned int a = 0; a < 2; ++a)
          parameters.mesh.intervals[a] = parse_intervals(
            "entry", coarse(grid.lines[a], surface->coordinate_unit(a), 4));

      std::ostringstream out;
      const Simulation   simulation(parameters, MPI_COMM_SELF, out);
    }
  } // namespace


  void
  try_input(const std::string &input)
  {
    const std::string file_name = (folder / "fuzz.prm").string();
    std::ofstream(file_name, std::ios::binary) << input;

    read(input, [&]() {
      Parameters               parameters;
      dealii::ParameterHandler prm;
      read_parameters(file_name, {}, MPI_COMM_SELF, parameters, prm);
      set_up(parameters);
    });
  }
} // namespace Fuzz::ParameterFiles
