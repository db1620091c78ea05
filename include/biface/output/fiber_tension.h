// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_output_fiber_tension_h
#define biface_output_fiber_tension_h

#include <array>
#include <limits>
#include <string>

#include <biface/laminate/laminate.h>
#include <biface/laminate/layup.h>
#include <biface/laminate/resultants.h>

namespace Biface
{
  class ShellEquations;
  struct State;


  /** The force per undeformed area along the fibers divided by the second
   * Piola-Kirchhoff stress, at a strain along them: the stretch; 1 in a linear
   * law, which is one for small strains. */
  double
  force_per_stress(const Ply &ply, const double strain);

  /** The tension along the fibers of a ply, the integral of the stress along
   * them over its thickness. Unit: force/length.
   * @param ply the position of the ply in the laminate.
   * @param E the strains of the faces, see Resultants. */
  double
  fiber_tension(const Laminate       &laminate,
                const unsigned int    ply,
                const StrainsOfPlies &E);


  /** What a layup has to carry tension: the cords of the plies whose cords are
   * described, or the fibers of all plies that have any. */
  class TensionMembers
  {
  public:
    explicit TensionMembers(const Layup &layup)
      : of_cords(layup.has_cords()), any(layup.has_fibers())
    {}

    /** Whether there are any tension members. */
    bool
    exist() const
    {
      return any;
    }

    /** The name of the tension in files. */
    std::string
    name() const
    {
      return of_cords ? "cord_tension" : "fiber_tension";
    }

    /** The tension in a ply: of a cord (force), or of the fibers per width
     * (force/length); NaN for a ply that has none. See fiber_tension(). */
    double
    tension(const Layup          &layup,
            const Laminate       &laminate,
            const unsigned int    ply,
            const StrainsOfPlies &E) const;

  private:
    const bool of_cords, any;
  };


  /** The maximum over all cells and plies of TensionMembers::tension() at the
   * middle of the cell, and its place. */
  struct MaximumTension
  {
    double value = std::numeric_limits<double>::quiet_NaN();
    /** The coordinates @f$\alpha_1,\alpha_2@f$ of the middle of the cell in the
     * user's unit. */
    std::array<double, 2> alpha{};
    /** The number of the ply, from 1 at the inner face. */
    unsigned int ply = 0;
  };

  /** Find the maximum tension. If the tension at several places differs by
   * round-off only, the first of them in the order of the cells is given, on
   * any number of ranks. NaN without tension members. Must be called on all
   * ranks. */
  MaximumTension
  find_maximum_tension(const ShellEquations &equations, const State &state);
} // namespace Biface

#endif
