// SPDX-License-Identifier: LGPL-2.1-or-later

// The imperfection of a Fourier series is, at all nodes, the sum of its terms:
// on a cylinder, on a sector between planes of symmetry, and on a cap.

#include <cmath>

#include <biface/model/equations/shell_equations.h>

#include <run_analysis.h>
#include <tests.h>

using namespace Biface;

namespace
{
  /** The largest deviation from a function of the coordinates, in internal
   * units, at nodes that are not held. */
  template <typename Function>
  void
  compare(const std::string           &what,
          const std::vector<Override> &overrides,
          const Function              &exact)
  {
    double         largest = 0, deviation = 0;
    const Analysis analysis(DATA_DIR "/imperfection_by_series.prm", overrides);
    const ShellMesh &mesh = analysis.simulation.get_equations().mesh;
    for (const Node &node : mesh.nodes)
      for (const unsigned int face : {Resultants::inner, Resultants::outer})
        {
          const double w = mesh.displacement(mesh.imperfection, node, face)[2];
          largest        = std::max(largest, std::abs(w));
          deviation      = std::max(
            deviation, std::abs(w - exact(node.alpha[0], node.alpha[1])));
        }
    deviation = dealii::Utilities::MPI::max(deviation, MPI_COMM_WORLD);
    largest   = dealii::Utilities::MPI::max(largest, MPI_COMM_WORLD);
    if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
      check_small(what, deviation, 1e-12, largest);
  }
} // namespace


int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  // the rows of data/series_measured.csv
  const auto measured = [](const double s, const double phi) {
    return 0.02 - 0.4 * std::cos(2 * phi) + 0.15 * std::sin(2 * phi) +
           std::cos(M_PI * s) *
             (0.1 * std::cos(3 * phi) + 0.2 * std::sin(phi)) -
           0.05 * std::cos(10 * M_PI * s) * std::sin(20 * phi);
  };
  compare("cylinder", {}, [&](const double x, const double phi) {
    return -0.5 * measured(x / 500, phi);
  });
  compare("part of its length",
          {"Mesh/Intervals alpha_1=100:350:10"},
          [&](const double x, const double phi) {
            return -0.5 * measured(x / 500, phi);
          });
  compare("cap",
          {"Surface/Meridian=circular arc", "Mesh/Intervals alpha_1=0:70:10"},
          [&](const double angle, const double phi) {
            return -0.5 * measured(0.5 + angle / (2 * M_PI), phi);
          });
  // data/series_symmetric.csv
  compare("sector",
          {"Mesh/Closed in alpha_2=false",
           "Mesh/Intervals alpha_1=0:250:10",
           "Mesh/Intervals alpha_2=0:90:10",
           "Supports/alpha_1 max=symmetry",
           "Supports/alpha_2 min=symmetry",
           "Supports/alpha_2 max=symmetry",
           "Surface/Imperfection/Fourier series=w: series_symmetric.csv"},
          [](const double x, const double phi) {
            return -0.5 * std::cos(2 * M_PI * x / 500) *
                   (0.3 * std::cos(2 * phi) + 0.1 * std::cos(4 * phi));
          });
}
