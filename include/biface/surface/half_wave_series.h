// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_surface_half_wave_series_h
#define biface_surface_half_wave_series_h

#include <array>
#include <string>
#include <vector>

namespace Biface
{
  /**
   * A double Fourier series on a surface of revolution, in the form in which
   * measured shapes of cylinders are published, with half waves of a cosine
   * along the meridian and whole waves around the axis:
   * @f[
   *   w = \sum_{k,l} \cos(k\pi s)\,
   *       (A_{kl}\cos l\varphi + B_{kl}\sin l\varphi),
   * @f]
   * where @f$s@f$ runs from 0 at the start of the meridian to 1 at its end, and
   * @f$\varphi@f$ is @f$\alpha_2@f$. See @cite Arbocz1982.
   */
  class HalfWaveSeries
  {
  public:
    struct Term
    {
      unsigned int k, l;
      double       A, B;
    };

    HalfWaveSeries() = default;

    /** Read the terms from the text of a CSV file with rows 'k, l, A, B'.
     * Throws InputError, naming @p name, if a row is anything else or a term is
     * given twice. */
    HalfWaveSeries(const std::string &text, const std::string &name);

    const std::vector<Term> &
    get_terms() const
    {
      return terms;
    }

    /** The value at @f$s@f$ and @f$\varphi@f$, in radians. The unit is that of
     * the coefficients. */
    double
    value(const double s, const double phi) const;

  private:
    std::vector<Term> terms;
    /** The numbers of different @f$k@f$ and @f$l@f$: the largest ones plus
     * 1. */
    std::array<unsigned int, 2> n_waves{{0, 0}};
  };


  /** How a shell on a surface of revolution goes on beyond its edges. */
  struct SectorOfShell
  {
    /** The values of @f$s@f$, and of @f$\varphi@f$ in radians, at edges that
     * are planes of symmetry, see HalfWaveSeries. */
    std::array<std::vector<double>, 2> planes;
    /** The angle after which the shell repeats; 0 if it is not cyclic. Unit:
     * radians. */
    double period = 0;

    /** Throw InputError if a series does not go on in the same way.
     * @param name that of its file, for messages. */
    void
    check(const HalfWaveSeries &series, const std::string &name) const;
  };
} // namespace Biface

#endif
