// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_quantities_hysteresis_h
#define biface_model_quantities_hysteresis_h

#include <deal.II/base/numbers.h>
#include <deal.II/base/table.h>

#include <cmath>
#include <vector>

namespace Biface
{
  class ShellEquations;
  struct State;


  /**
   * The energy that the plies of a rolling wheel dissipate in a turn: by the
   * relaxation of their stresses, see RelaxationInTransport, or by their loss
   * factors, see CyclicLoss. A cell stands for the particles in it: while they
   * flow around the axle, they pass through the strains and stresses of all
   * cells of their line. Nothing of the loss factors acts back on the
   * deformation.
   */
  struct Hysteresis
  {
    /** The number of harmonics whose losses are also given apart, to see
     * whether the mesh resolves the cycles. */
    static constexpr unsigned int n_first_harmonics = 8;

    /** The energies that a ply dissipates in a turn. Unit: force times
     * length. */
    struct OfPly
    {
      double energy = 0;
      /** The part of the energy that belongs to the first harmonics; not a
       * number with relaxation. */
      double of_first_harmonics = 0;
    };

    /** The energy that each ply dissipates in each strip of the wall, by strip
     * and ply. Unit: force times length. */
    dealii::Table<2, double> by_strip;

    /** The part of energy() that stresses lose by relaxation. Unit: force times
     * length. */
    double of_relaxation = 0;

    /** The energies by the plies of the layup. */
    std::vector<OfPly> plies;

    /** The power of an energy that is dissipated per turn. Unit: force times
     * length per time. */
    static double
    power(const double energy, const double angular_velocity)
    {
      return energy * std::abs(angular_velocity) / (2 * dealii::numbers::PI);
    }

    /** The energy that all plies dissipate in a turn. Unit: force times
     * length. */
    double
    energy() const;
  };


  /** The hysteresis of a converged state on a mesh closed around the axle. Must
   * be called on all ranks.
   * @param angular_velocity of which only the sign matters. */
  Hysteresis
  find_hysteresis(const ShellEquations &equations,
                  const State          &state,
                  const double          angular_velocity = 1);
} // namespace Biface

#endif
