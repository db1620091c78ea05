// SPDX-License-Identifier: LGPL-2.1-or-later

// In the free flight of a curved panel, energy and both momenta are constant
// for every element that rigid motions do not strain, several layers, rubber,
// and cords that go slack; with damping, what it dissipates is what is missing.

#include <deal.II/base/mpi.h>

#include "motion.h"

using namespace dealii;

namespace
{
  void
  check(const std::string              &name,
        const std::string              &file,
        const std::vector<std::string> &settings,
        const bool                      damped = false)
  {
    // the laws hold on any mesh and for any time
    std::vector<std::string> words{std::string(DATA_DIR "/") + file,
                                   "Mesh/Intervals alpha_1=0:120:3",
                                   "Mesh/Intervals alpha_2=-45:45:4",
                                   "Stage 2/Duration=8e-4"};
    words.insert(words.end(), settings.begin(), settings.end());
    std::cout << name << '\n';
    const Motion motion = move(words, "flight", MPI_COMM_SELF);
    check_balance(motion, 1e-11);
    if (damped)
      check_momenta(motion, "free", 1e-11);
    else
      check_constants(motion, "free", 1e-11);
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const std::string              panel  = "flying_panel.prm";
  const std::string              layers = "Laminate/Layers=1, 1";
  const std::vector<std::string> damping{"Stage 1/Mass damping=10",
                                         "Stage 1/Stiffness damping=1e-5",
                                         "Stage 2/Numerical damping=0.2"};
  check("standard", panel, {});
  check("vertices", panel, {"Formulation=vertices"});
  check("layers", panel, {layers});
  check("damping", panel, damping, true);
  check("rubber", "flying_panel_of_rubber.prm", {});
  check("layers of rubber", "flying_panel_of_rubber.prm", {layers});
  check("rubber with damping", "flying_panel_of_rubber.prm", damping, true);
  check("cords", "flying_panel_of_cords.prm", {});
  check("cords with damping", "flying_panel_of_cords.prm", damping, true);
}
