// SPDX-License-Identifier: LGPL-2.1-or-later

// A restart refuses parameters that change the shell or completed stages, and
// accepts all others.

#include "../restart.h"
#include "../tests.h"

using namespace dealii;

namespace
{
  void
  check(const std::string &setting, const std::string &other = no_vtu)
  {
    std::filesystem::remove_all("changed");
    std::filesystem::copy("cut", "changed");
    const std::string before = text_of("changed/history.csv");
    const Ended       ended =
      restart(with(coarse_tire, {setting, other}), "changed", MPI_COMM_WORLD);
    std::cout << setting << ": " << ended.code << '\n' << said(ended);
    if (ended.code != 0)
      check_true("the history is as it was",
                 text_of("changed/history.csv") == before);
  }


  /** Restart with a table of an imperfection in another place. */
  void
  check_moved_table()
  {
    const auto write_table = [](const std::string &name, const double value) {
      std::ofstream(name) << "alpha_1, alpha_2, value\n"
                          << "0, 0, 0\n0, 90, 0\n90, 0, 0\n90, 90, " << value
                          << '\n';
    };
    const auto with_table = [](const std::string &name) {
      return with(coarse_tire,
                  {"Number of stages=1",
                   "Stage 1/Steps=2",
                   no_vtu,
                   "Surface/Imperfection/Formula=dent",
                   "Surface/Imperfection/Tables=dent: " +
                     std::filesystem::absolute(name).string()});
    };
    write_table("dent.csv", 0.01);
    write_table("moved.csv", 0.01);
    write_table("deeper.csv", 0.02);
    std::filesystem::remove_all("dented");
    run(with_table("dent.csv"), "dented", MPI_COMM_WORLD, "Step 1,");
    for (const char *name : {"deeper.csv", "moved.csv"})
      {
        const Ended ended = restart(with_table(name), "dented", MPI_COMM_WORLD);
        std::cout << name << ": " << ended.code << '\n' << said(ended);
      }
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  std::filesystem::remove_all("cut");
  run(with(coarse_tire, {"Output/Write VTU=false"}),
      "cut",
      MPI_COMM_WORLD,
      "Step 4,");

  check("Surface/Circular arc/Radius=51");
  check("Mesh/Intervals alpha_1=-120:120:16");
  check("Material cord/E_L=500");
  check("Laminate/Plies=cord: 1.2 @ 52");
  check("Supports/alpha_1 min=hinged");
  check("Contact/Regularization=1e5");
  check("Named points=equator: 0 0");
  check("Stage 1/Pressure=0.16");
  check("Stage 2/Strain theory=linear");
  check("Stage 2/Contact=false");
  check("Stage 1/Steps=3");
  check("Mesh/Coarse meshes=1");
  check("Sensitivities/Entries=Stage 1/Pressure");
  check("Stage 2/Regularization=100");
  check("Stage 2/Tangential regularization=1");
  check("Output/Failure criteria=Tsai-Wu");
  check("Number of stages=1");

  // the same, written otherwise
  check("Contact/Regularization=10000.0");
  check("Contact/Direction=1,0,0");
  check("Newton/Residual tolerance=1e-9");
  check("Linear solver/Type=iterative");
  check("Output/Profile alpha_2=90");
  check("Checkpoint/Every steps=2");
  check("Number of stages=3", "Stage 3/Pressure=0");
  check("Stage 2/Travel=21");
  check("Output/Moment center=0, 0, 1");
  check("Units=mm, N, s");
  check("Mesh/Distribution=distributed");
  check("Tire test/Axes=SAE");

  check_moved_table();
}
