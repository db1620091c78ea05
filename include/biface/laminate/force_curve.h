// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_laminate_force_curve_h
#define biface_laminate_force_curve_h

#include <memory>
#include <vector>

namespace Biface
{
  struct PairsFile;

  /**
   * The force of a cord by its stretch, as measured: a piecewise cubic that is
   * monotone between the rows of a table @cite FritschCarlson1980, and linear
   * beyond the last one.
   */
  class ForceCurve
  {
  public:
    /** The curve of a table. Throws InputError that names the file unless it
     * has at least four rows of stretch and force, both increasing, from
     * stretch 1 and force 0 on. */
    explicit ForceCurve(const PairsFile &file);

    struct Value
    {
      /** The integral of the force from stretch 1 on. Unit: force. */
      double energy;
      double force;
      /** The derivative of the force by the stretch. Unit: force. */
      double slope;
    };

    /** The force at a stretch.
     * @param stretch at least 1. */
    Value
    at(const double stretch) const;

    double
    initial_slope() const
    {
      return at(1).slope;
    }

    /** The lowest slope at the rows and in the middle between them. */
    double
    lowest_slope() const;

  private:
    class Interpolation;

    std::vector<double> stretches;
    /** The energies at the rows. Unit: force. */
    std::vector<double>                  energies;
    std::shared_ptr<const Interpolation> cubic;
  };
} // namespace Biface

#endif
