// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>
#include <deal.II/base/numbers.h>

#include <array>
#include <cmath>
#include <complex>
#include <vector>

#include <biface/model/mesh/wave_numbers.h>

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
  wave_numbers(const ShellMesh &mesh, const std::vector<LA::Vector> &parts)
  {
    if (!mesh.grid.closed)
      return {};
    // at most as many waves as half the lines: more of them look like fewer
    const std::vector<double> &lines   = mesh.grid.lines[1];
    const unsigned int         n_lines = mesh.grid.n_nodes(0);
    const unsigned int         n_max   = mesh.grid.n_nodes(1) / 2;
    const double               turn    = lines.back() - lines.front();

    // by part, line, component, wave number: real and imaginary parts
    const auto position = [&](const unsigned int part,
                              const unsigned int line,
                              const unsigned int component,
                              const unsigned int n) {
      return 2 * ((3 * (part * n_lines + line) + component) * (n_max + 1) + n);
    };
    std::vector<double> sums(position(parts.size(), 0, 0, 0));
    // exact integrals of the piecewise linear field: lines need not be
    // equidistant
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
            for (unsigned int p = 0; p < parts.size(); ++p)
              for (unsigned int i = 0; i < 3; ++i)
                {
                  const double  v = parts[p](node.dof(i, MixedElement::mean));
                  const Complex term = v * weight;
                  double *sum = &sums[position(p, node.grid_index[0], i, n)];
                  sum[0] += term.real();
                  sum[1] += term.imag();
                }
          }
      }
    Utilities::MPI::sum(sums, mesh.communicator, sums);
    // the coefficient of e^(+-i n phi)
    const auto coefficient = [&](const unsigned int line,
                                 const unsigned int i,
                                 const unsigned int n,
                                 const int          sign) {
      Complex result = 0, unit = 1;
      for (unsigned int p = 0; p < parts.size(); ++p)
        {
          const double *sum = &sums[position(p, line, i, n)];
          result += unit * Complex(sum[0], sign * sum[1]);
          unit *= Complex(0, 1);
        }
      return result;
    };
    const auto square_of =
      [&](const unsigned int i, const unsigned int n, const int sign) {
        double sum = 0;
        for (unsigned int line = 0; line < n_lines; ++line)
          sum += std::norm(coefficient(line, i, n, sign));
        return sum;
      };
    const auto square = [&](const unsigned int i, const unsigned int n) {
      return square_of(i, n, 1) + (n > 0 ? square_of(i, n, -1) : 0.);
    };

    // if values are equal up to round-off, the first one is taken
    constexpr double larger = 1 + 1e-6;
    WaveNumbers      result{0, 1, 0};
    double           largest = 0;
    for (unsigned int n = 0; n <= n_max; ++n)
      {
        const double sum = square(0, n) + square(1, n) + square(2, n);
        if (sum > larger * largest)
          {
            largest                = sum;
            result.circumferential = n;
          }
      }

    const unsigned int n = result.circumferential;
    // e^(i n phi + i omega t) travels against phi, which is left-handed
    std::array<double, 2> ways{};
    for (unsigned int i = 0; i < 3 && n > 0; ++i)
      {
        ways[0] += square_of(i, n, 1);
        ways[1] += square_of(i, n, -1);
      }
    if (parts.size() > 1 && ways[0] + ways[1] > 0)
      result.travel = (ways[0] - ways[1]) / (ways[0] + ways[1]);
    const int way = (ways[1] > larger * ways[0] ? -1 : 1);

    unsigned int component = 2;
    for (const unsigned int i : {0, 1})
      if (square(i, n) > larger * square(component, n))
        component = i;
    Complex peak = 0;
    for (unsigned int line = 0; line < n_lines; ++line)
      if (std::abs(coefficient(line, component, n, way)) >
          larger * std::abs(peak))
        peak = coefficient(line, component, n, way);
    // smaller values do not make a wave
    constexpr double minimum = 0.05;
    double           sign    = 0;
    for (unsigned int line = 0; line < n_lines && peak != 0.; ++line)
      {
        const double value =
          (coefficient(line, component, n, way) / peak).real();
        if (std::abs(value) < minimum)
          continue;
        if (sign * value < 0)
          ++result.meridional;
        sign = value;
      }
    return result;
  }
} // namespace Biface
