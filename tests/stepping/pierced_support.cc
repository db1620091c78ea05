// SPDX-License-Identifier: LGPL-2.1-or-later

// The travel counts from the first node that can come into contact; held nodes
// that the ground passes through are named once.


#include <biface/stepping/step_report.h>

#include "../run_analysis.h"
#include "../tests.h"

using namespace dealii;
using namespace Biface;

int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  Analysis analysis(DATA_DIR "/sagging_strip.prm");
  analysis.simulation.run([&](const StepReport &report, const State &) {
    if (report.in_contact)
      check_true("a force at the travel " + std::to_string(report.level.travel),
                 report.contact.force > 0);
  });

  const std::string text = analysis.screen.str(), warning = "  Warning: ";
  const auto        found = text.find(warning);
  check_true("a warning", found != std::string::npos);
  check_true("one only", found == text.rfind(warning));
  std::cout << text.substr(found, text.find('\n', found) - found) << std::endl;
}
