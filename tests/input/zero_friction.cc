// SPDX-License-Identifier: LGPL-2.1-or-later

// A coefficient of friction of 0 means no friction, however it is written: the
// step of differences is that of frictionless contact.

#include <run_analysis.h>
#include <tests.h>

using namespace Biface;

int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  for (const std::string friction : {"0", "0.0", "0*1", "0.5"})
    {
      const Parameters parameters =
        parameters_of(PRM_DIR "/bias_tire.prm",
                      {"Sensitivities/Entries=Stage 1/Pressure",
                       "Sensitivities/Outputs=force",
                       "Stage 2/Friction=" + friction});
      const auto &change = parameters.sensitivities.changes.at(0);
      std::cout << friction << ": " << 1e5 * change.step / (2 * change.value)
                << std::endl;
    }
}
