// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_output_failure_maxima_h
#define biface_output_failure_maxima_h

#include <array>
#include <limits>
#include <string>
#include <vector>

namespace Biface
{
  struct FailureCriteria;
  class ShellEquations;
  struct State;


  /** The maximum of a failure index over the shell. */
  struct FailureMaximum
  {
    /** The name of the criterion, see FailureCriterion. */
    std::string name;
    /** The largest failure index; NaN if no ply has strengths. */
    double index = std::numeric_limits<double>::quiet_NaN();
    /** The coordinates @f$\alpha_1,\alpha_2@f$ of the place of the maximum in
     * the user's unit. */
    std::array<double, 2> alpha{};
    /** The number of the ply, from 1 at the inner face. */
    unsigned int ply = 0;

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &name &index &alpha[0] & alpha[1] & ply;
    }
  };


  /**
   * The maxima of the requested failure indices over the corners of all cells
   * and both sides of all plies, as in plies-NNNN.vtu. Within a ply, an index
   * is largest at one of its sides.
   *
   * Of places where the index differs by round-off, such as those of a
   * symmetric shell, the first in the order of the cells is given, on any
   * number of ranks. Must be called on all ranks.
   */
  std::vector<FailureMaximum>
  find_failure_maxima(const ShellEquations  &equations,
                      const State           &state,
                      const FailureCriteria &criteria);
} // namespace Biface

#endif
