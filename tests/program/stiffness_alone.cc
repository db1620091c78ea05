// SPDX-License-Identifier: LGPL-2.1-or-later

// A support has a stiffness only while nothing else changes its force: none in
// the stage in which a body leaves or the penalty stiffness changes, and that
// of the motion alone if a stage of its own comes in between.

#include <cmath>

#include "../read_csv.h"
#include "../restart.h"

using namespace dealii;

namespace
{
  const std::string plate =
    "set Units = mm, N, s\n"
    "subsection Surface\nset Type = plane\nend\n"
    "subsection Mesh\nset Intervals alpha_1 = 0:100:8\n"
    "set Intervals alpha_2 = 0:100:8\nset Closed in alpha_2 = false\nend\n"
    "set Materials = wall\n"
    "subsection Material wall\nset Type = isotropic\nset E = 1000\n"
    "set nu = 0.3\nend\n"
    "subsection Laminate\nset Plies = wall: 4 @ 0\n"
    "set Reference surface = middle\nend\n"
    "subsection Supports\nset alpha_1 min = fixed\n"
    "set alpha_1 max = v_1 both; v_2 both; v_3 both = 2\nend\n"
    "set Bodies = ball\n"
    "subsection Body ball\nset Shape = sphere\nset Point = 50, 50, 32\n"
    "set Radius = 30\nset Motions = push: 0 0 -4\nend\n"
    "subsection Contact\nset Regularization = 50\nset Direction = 0, 0, 1\n"
    "end\n"
    "subsection Stage 1\nset Bodies = ball\nset Load factor = 0\n"
    "set Load factors = bodies ball: 1\nset Steps = 4\nend\n"
    "subsection Output\nset Write VTU = false\nend\n"
    "subsection Checkpoint\nset Write = false\nend\n";


  /** The tangent and secant of the support at the end. */
  std::vector<std::string>
  stiffness_of(const std::string &stages)
  {
    std::ofstream("plate.prm") << plate << stages;
    std::ofstream("study.prm")
      << "subsection Study\nset Base file = plate.prm\n"
         "set Variables = E: Material wall/E\nset Values = E: 1000\n"
         "set Outputs = alpha_1 max tangent, alpha_1 max secant\nend\n";
    const Ended ended = run({"--study", "study.prm"}, "study", MPI_COMM_WORLD);
    std::cout << ended.code << ended.err << std::endl;
    const Row row = read_csv("study/study.csv").back();
    return {row.at("alpha_1 max tangent"), row.at("alpha_1 max secant")};
  }


  bool
  is_empty(const std::vector<std::string> &values)
  {
    return values[0].empty() && values[1].empty();
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const std::string moves = "set Load factor = 0.01\n";
  check_true("a body leaves",
             is_empty(stiffness_of("set Number of stages = 2\n"
                                   "subsection Stage 2\n" +
                                   moves + "end\n")));
  check_true("the penalty stiffness changes",
             is_empty(stiffness_of("set Number of stages = 2\n"
                                   "subsection Stage 2\nset Bodies = ball\n"
                                   "set Regularization = 60\n" +
                                   moves + "set Steps = 2\nend\n")));
  const auto alone = stiffness_of("set Number of stages = 3\n"
                                  "subsection Stage 2\nset Load factor = 0\n"
                                  "end\nsubsection Stage 3\n" +
                                  moves + "end\n");
  // E h^3/L^3 of a beam, stiffer by the width that is held
  const double beam = 1000 * 100 * 64 / 1e6;
  check_true("alone",
             std::stod(alone[0]) > beam && std::stod(alone[0]) < 1.2 * beam &&
               alone[0] == alone[1]);
  return 0;
}
