// SPDX-License-Identifier: LGPL-2.1-or-later

// A bar that is pulled at its end, or shaken at the other, moves like
// tan(kL)/(E A k) and 1/cos(kL), with the complex modulus of a loss factor, of
// relaxation, and of damping by mass and stiffness, up to an error of second
// order.

#include <cmath>
#include <complex>

#include <biface/solver/harmonic_response.h>

#include <run_analysis.h>
#include <tests.h>

using namespace dealii;
using namespace Biface;

namespace
{
  using Number = std::complex<double>;

  constexpr double E = 70000, A = 20, L = 1000, rho = 2.7e-9, F = 10;

  /** The modulus and the density at an angular frequency. */
  using Law = std::function<std::pair<Number, Number>(const double)>;

  /** The largest deviation of the end and of the force at the support from the
   * wave, relative to it. */
  double
  deviation(const std::vector<Override> &changes,
            const Law                   &law,
            const unsigned int           n_cells)
  {
    std::vector<Override> overrides{"Mesh/Intervals alpha_1=0:1000:" +
                                    std::to_string(n_cells)};
    overrides.insert(overrides.end(), changes.begin(), changes.end());
    const auto reports = run_analysis(DATA_DIR "/shaken_bar.prm", overrides);
    const FrequencyResponse &response = *reports.back().response;
    double                   largest  = 0;
    for (unsigned int f = 0; f < response.frequencies.size(); ++f)
      {
        const double omega = 2 * numbers::PI * response.frequencies[f];
        const auto [modulus, density] = law(omega);
        const Number k                = omega * std::sqrt(density / modulus);
        const Number pulled =
                       (omega == 0 ? F * L / (modulus * A)
                                   : F * std::tan(k * L) / (modulus * A * k)),
                     shaken = 1. / std::cos(k * L);
        const auto &values  = response.values[f];
        for (const auto &[found, expected] :
             {std::make_pair(values[0][1][0], pulled),
              std::make_pair(values[0][2][0], -F * shaken),
              std::make_pair(values[1][1][0], shaken),
              std::make_pair(values[1][2][0],
                             -modulus * A * k * std::tan(k * L))})
          // at rest there is no force of inertia
          if (std::abs(expected) > 0)
            largest = std::max(largest,
                               std::abs(found - expected) / std::abs(expected));
      }
    return largest;
  }


  void
  check(const std::string           &what,
        const std::vector<Override> &changes,
        const Law                   &law)
  {
    const double coarse = deviation(changes, law, 40),
                 fine   = deviation(changes, law, 80);
    check_small(what, fine, 3e-4);
    check_small(
      what + ": order of convergence", std::log2(coarse / fine) - 2, 0.1);
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  check("loss factor of the material",
        {"Material metal/Loss factor=0.1"},
        [](const double) {
          return std::pair<Number, Number>(E * Number(1, 0.1), rho);
        });
  check(
    "loss factor of the stage", {"Stage 1/Loss factor=0.2"}, [](const double) {
      return std::pair<Number, Number>(E * Number(1, 0.2), rho);
    });
  check("relaxation",
        {"Material metal/Relaxation times=1e-4, 1e-3",
         "Material metal/Relaxation moduli=0.3, 0.2"},
        [](const double omega) {
          return std::pair<Number, Number>(E * (1. -
                                                0.3 / Number(1, omega * 1e-4) -
                                                0.2 / Number(1, omega * 1e-3)),
                                           rho);
        });
  check("damping by mass and stiffness",
        {"Stage 1/Mass damping=500", "Stage 1/Stiffness damping=1e-5"},
        [](const double omega) {
          return std::pair<Number, Number>(
            E * Number(1, 1e-5 * omega),
            rho * (omega > 0 ? Number(1, -500 / omega) : Number(1)));
        });
}
