// SPDX-License-Identifier: LGPL-2.1-or-later

// The forces on the bias tire with 8 mm of rubber outside, as a ply of a single
// layer and as a layer of its own, agree with those of the independent program
// of doc/bias_tire.md within the effect of the mesh, 0.25 %, and their ratio
// within 1e-3.

#include "../tests.h"
#include "bias_tire.h"

using namespace Biface;

namespace
{
  /** At 4 and 20 mm. */
  std::array<double, 2>
  forces(const std::string &layers)
  {
    const auto reports =
      run_bias_tire({"Stage 2/Steps=5",
                     "Contact/Multiplier mass=lumped",
                     "Loads/Area of face loads=face",
                     "Mesh/Intervals alpha_1=-120:-60:9, -60:60:24, 60:120:9",
                     "Materials=cord, rubber",
                     "Material rubber/Type=isotropic",
                     "Material rubber/E=1.8",
                     "Material rubber/nu=0.49",
                     "Laminate/Plies=2 x (cord: 1.2 @ +-52), rubber: 8 @ 0",
                     "Element/Thickness strain=mean director",
                     "Laminate/Layers=" + layers});
    std::array<double, 2> result{};
    for (const StepReport &report : reports)
      for (const unsigned int i : {0, 1})
        if (std::abs(report.level.travel - (i == 0 ? 4. : 20.)) < 1e-6)
          result[i] = report.contact.force;
    return result;
  }
} // namespace


int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const auto one = forces("one"), two = forces("4, 1");
  check_small("one layer, 4 mm", one[0] - 288.84, 2.5e-3, 288.84);
  check_small("one layer, 20 mm", one[1] - 2124.79, 2.5e-3, 2124.79);
  check_small("two layers, 4 mm", two[0] - 291.85, 2.5e-3, 291.85);
  check_small("two layers, 20 mm", two[1] - 2168.61, 2.5e-3, 2168.61);
  const double ratio = 2168.61 / 2124.79;
  check_small("ratio at 20 mm", two[1] / one[1] - ratio, 1e-3, ratio);
}
