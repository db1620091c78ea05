// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>
#include <deal.II/base/numbers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <vector>

#include <biface/model/wave_numbers.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    using Complex = std::complex<double>;

    /** @f$\int_0^h(1-s/h)e^{-ins}\,ds@f$: half of a linear shape function.
     * @param h negative for the other half, with the negative result. */
    Complex
    half_integral(const int n, const double h)
    {
      if (n == 0)
        return h / 2;
      const Complex in(0, n);
      return 1. / in + (1. - std::exp(-in * h)) / (double(n) * n * h);
    }
  } // namespace


  std::optional<WaveNumbers>
  wave_numbers(const ShellMesh &mesh, const LA::Vector &V)
  {
    if (!mesh.grid.closed)
      return {};
    const std::vector<double> &lines   = mesh.grid.lines[1];
    const unsigned int         n_lines = mesh.grid.n_nodes(0);
    const unsigned int         n_max   = mesh.grid.n_nodes(1) / 2;
    const double               turn    = lines.back() - lines.front();

    // by line, component, wave number: real and imaginary parts
    const auto position = [&](const unsigned int line,
                              const unsigned int component,
                              const unsigned int n) {
      return 2 * ((3 * line + component) * (n_max + 1) + n);
    };
    std::vector<double> sums(position(n_lines, 0, 0));
    for (const Node &node : mesh.nodes)
      {
        if (!node.locally_owned)
          continue;
        const unsigned int j = node.grid_index[1];
        const double       before =
          lines[j] - (j > 0 ? lines[j - 1] : lines.end()[-2] - turn);
        const double after = lines[j + 1] - lines[j];
        for (unsigned int n = 0; n <= n_max; ++n)
          {
            const Complex weight =
              std::polar(1., -2 * numbers::PI / turn * n * lines[j]) *
              (half_integral(n, 2 * numbers::PI / turn * after) -
               half_integral(n, -2 * numbers::PI / turn * before));
            for (unsigned int i = 0; i < 3; ++i)
              {
                const double  v    = V(node.dof(i, MixedElement::mean));
                const Complex part = v * weight;
                double       *sum  = &sums[position(node.grid_index[0], i, n)];
                sum[0] += part.real();
                sum[1] += part.imag();
              }
          }
      }
    Utilities::MPI::sum(sums, mesh.communicator, sums);
    const auto coefficient =
      [&](const unsigned int line, const unsigned int i, const unsigned int n) {
        const double *sum = &sums[position(line, i, n)];
        return Complex(sum[0], sum[1]);
      };
    const auto square = [&](const unsigned int i, const unsigned int n) {
      double sum = 0;
      for (unsigned int line = 0; line < n_lines; ++line)
        sum += (n > 0 ? 2 : 1) * std::norm(coefficient(line, i, n));
      return sum;
    };

    WaveNumbers result{0, 1};
    double      largest = 0;
    for (unsigned int n = 0; n <= n_max; ++n)
      {
        const double sum = square(0, n) + square(1, n) + square(2, n);
        if (sum > (1 + 1e-6) * largest)
          {
            largest                = sum;
            result.circumferential = n;
          }
      }

    const unsigned int n         = result.circumferential;
    unsigned int       component = 2;
    for (const unsigned int i : {0, 1})
      if (square(i, n) > (1 + 1e-6) * square(component, n))
        component = i;
    Complex greatest = 0;
    for (unsigned int line = 0; line < n_lines; ++line)
      if (std::abs(coefficient(line, component, n)) >
          (1 + 1e-6) * std::abs(greatest))
        greatest = coefficient(line, component, n);
    // smaller values do not make a wave
    constexpr double minimum = 0.05;
    double           sign    = 0;
    for (unsigned int line = 0; line < n_lines && greatest != 0.; ++line)
      {
        const double value =
          (coefficient(line, component, n) / greatest).real();
        if (std::abs(value) < minimum)
          continue;
        if (sign * value < 0)
          ++result.meridional;
        sign = value;
      }
    return result;
  }
} // namespace Biface
