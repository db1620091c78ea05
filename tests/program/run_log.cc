// SPDX-License-Identifier: LGPL-2.1-or-later

// A run.log that cannot be opened is answered by one line on the screen, and
// what the run prints is not collected in memory.

#include <deal.II/base/utilities.h>

#include <filesystem>
#include <iostream>
#include <sstream>

#include <biface/analysis/run_log.h>

#include "../tests.h"

using namespace dealii;

namespace
{
  /** Memory of this process, in MB. */
  double
  memory()
  {
    Utilities::System::MemoryStats stats{};
    Utilities::System::get_memory_stats(stats);
    return stats.VmRSS / 1000.;
  }
} // namespace


int
main()
{
  const std::string directory = "directory.log";
  std::filesystem::create_directories(directory);

  std::ostringstream screen;
  Biface::RunLog     log(screen, false, true);
  log.stream() << "before" << std::endl;
  log.open(directory, false);
  std::cout << screen.str();

  // quiet, so that the screen holds nothing either
  Biface::RunLog quiet(screen, true, true);
  quiet.open(directory, false);
  const double      before = memory();
  const std::string line(999, 'x');
  for (unsigned int i = 0; i < 100000; ++i)
    quiet.stream() << line << '\n';
  check_true("100 MB are not kept", memory() - before < 20);
}
