// SPDX-License-Identifier: LGPL-2.1-or-later

// The steady temperatures of a plane wall and of a cylinder of two materials,
// with sources and films on both faces, are the closed forms, and a film that
// comes and goes counts by its time.

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <cmath>

#include <biface/model/heat/wall_conduction.h>

#include "../tests.h"

using namespace Biface;

namespace
{
  constexpr unsigned int n_strips = 3, n_plies = 8;
  const HeatFilm         inside{2e-5, 20}, outside{5e-5, 35};

  /** A wall between two radii with the same plies everywhere, half of them of
   * each material. */
  WallSection
  wall(const double                 radius,
       const double                 thickness,
       const std::array<double, 2> &conductivity,
       const std::array<double, 2> &source)
  {
    WallSection section;
    section.vertices.reinit(n_strips + 1, n_plies + 1);
    for (unsigned int i = 0; i <= n_strips; ++i)
      for (unsigned int p = 0; p <= n_plies; ++p)
        section.vertices(i, p) = {7. * i * i, radius + thickness * p / n_plies};
    section.conductivity.reinit(n_strips, n_plies);
    section.source.reinit(n_strips, n_plies);
    for (unsigned int i = 0; i < n_strips; ++i)
      for (unsigned int p = 0; p < n_plies; ++p)
        {
          section.conductivity(i, p) = conductivity[p >= n_plies / 2];
          section.source(i, p)       = source[p >= n_plies / 2];
        }
    section.films = {{{n_strips, inside}, {n_strips, outside}}};
    return section;
  }
} // namespace


int
main()
{
  const double h = 8, k = 2.5e-4, q = 4e-6;
  {
    const WallTemperatures T =
      steady_temperatures(wall(1e7, h, {{k, k}}, {{q, q}}));
    // the heat that leaves on both sides, and the gradient in between
    const double H_i = inside.coefficient, H_o = outside.coefficient;
    const double T_i = inside.temperature, T_o = outside.temperature;
    const double t_i =
      (H_o * (q * h * h / (2 * k) + q * h / H_o + T_o - T_i) * 1 + 0) /
        (H_o + H_i + H_o * H_i * h / k) +
      T_i;
    // T = t_i + g z - q z^2/2k with k g = H_i (t_i - T_i)
    const double g   = H_i * (t_i - T_i) / k;
    const double t_o = t_i + g * h - q * h * h / (2 * k);
    check_small("heat through the outer face of a plane wall",
                H_o * (t_o - T_o) - (q * h - H_i * (t_i - T_i)),
                1e-12,
                q * h);
    for (unsigned int i = 0; i < n_strips; ++i)
      {
        check_small("inner face", T.faces[0][i] - t_i, 2e-6, t_i);
        check_small("outer face", T.faces[1][i] - t_o, 2e-6, t_o);
      }
    const double dz = h / n_plies;
    for (const unsigned int p : {0u, n_plies - 1})
      {
        const double z = (p + 0.5) * dz;
        check_small("ply",
                    T.plies(1, p) -
                      (t_i + g * z - q / (2 * k) * (z * z + dz * dz / 12)),
                    2e-6,
                    t_i);
      }
  }

  {
    // T = A_j + B_j ln r - q_j r^2/4k_j in each material
    const double                R = 50, a = R, b = R + h / 2, c = R + h;
    const std::array<double, 2> K{{k, 3 * k}}, Q{{q, 0.2 * q}};
    const auto gradient = [&](const unsigned int j, const double r) {
      return -Q[j] * r / (2 * K[j]);
    };
    const auto value = [&](const unsigned int j, const double r) {
      return -Q[j] * r * r / (4 * K[j]);
    };
    dealii::FullMatrix<double> M(4, 4);
    dealii::Vector<double>     f(4), X(4);
    // K T' = H_i (T - T_i) at a
    M(0, 0) = -inside.coefficient;
    M(0, 1) = K[0] / a - inside.coefficient * std::log(a);
    f(0)    = -inside.coefficient * inside.temperature - K[0] * gradient(0, a) +
           inside.coefficient * value(0, a);
    // the same temperature and flux at b
    M(1, 0) = 1;
    M(1, 1) = std::log(b);
    M(1, 2) = -1;
    M(1, 3) = -std::log(b);
    f(1)    = value(1, b) - value(0, b);
    M(2, 1) = K[0] / b;
    M(2, 3) = -K[1] / b;
    f(2)    = K[1] * gradient(1, b) - K[0] * gradient(0, b);
    // -K T' = H_o (T - T_o) at c
    M(3, 2) = outside.coefficient;
    M(3, 3) = K[1] / c + outside.coefficient * std::log(c);
    f(3) = outside.coefficient * outside.temperature - K[1] * gradient(1, c) -
           outside.coefficient * value(1, c);
    M.gauss_jordan();
    M.vmult(X, f);
    const WallTemperatures T   = steady_temperatures(wall(R, h, K, Q));
    const double           t_i = X(0) + X(1) * std::log(a) + value(0, a),
                 t_o           = X(2) + X(3) * std::log(c) + value(1, c);
    for (unsigned int i = 0; i < n_strips; ++i)
      {
        check_small("inner face of a cylinder", T.faces[0][i] - t_i, 1e-7, t_i);
        check_small("outer face of a cylinder", T.faces[1][i] - t_o, 1e-7, t_o);
      }
  }

  const HeatFilm both = HeatFilm::mean({1, 20}, {4, 50}, 0.2);
  check_small("film in turn", both.coefficient - 1.6, 1e-15);
  check_small("its temperature", both.temperature - 35, 1e-14, 35);
}
