// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_problem_rig_protocol_h
#define biface_problem_rig_protocol_h

#include <vector>

#include <biface/output/rig_table.h>

namespace Biface
{
  class EntryDeclarations;
  struct Stage;


  /**
   * A tire test, as on a test rig: a wheel that rolls at every combination of
   * pressures, inclination angles and loads, and there with slip angles and
   * slip ratios.
   *
   * It is a sequence of stages that follows those of the parameter file. Each
   * point is the end of a stage, which starts from the end of the nearest
   * point before: from zero slip to larger slip on both sides, from load to
   * load, from inclination to inclination. Points at zero slip ratio roll
   * freely, without a moment of the axle.
   */
  struct RigProtocol
  {
    /** How slip angles and slip ratios are combined. */
    enum class Slip
    {
      /** Either the slip angle or the slip ratio is zero. */
      pure,
      /** Every slip angle occurs with every slip ratio. */
      combined
    };

    /** The number of the stage from whose end the test starts; 0 for the last
     * one. There the tire is inflated and does not roll. */
    unsigned int start_from = 0;
    /** The pressures of the test; empty for the pressure at its start. */
    std::vector<double> pressures;
    std::vector<double> loads;
    std::vector<double> inclination_angles{0.};
    std::vector<double> slip_angles;
    std::vector<double> slip_ratios;
    double              ground_velocity = 0;
    Slip                slip            = Slip::pure;
    unsigned int        n_steps         = 1;
    RigAxes             axes            = RigAxes::ISO;

    bool
    is_requested() const
    {
      return !loads.empty();
    }

    /** The number of the stage from whose end the test starts. */
    unsigned int
    number_of_start(const std::vector<Stage> &stages) const;

    void
    add_parameters(EntryDeclarations &prm);

    /** Throws InputError if a value is invalid.
     * @param stages those of the parameter file. */
    void
    check(const std::vector<Stage> &stages) const;

    /** Append the stages of the test: one that presses the standing tire on
     * the ground, then one for each point, see RigTable. All but the first
     * point may fail.
     * @return the position of the stage of the first point, which is the number
     * of all stages if there is no test. */
    unsigned int
    append_to(std::vector<Stage> &stages) const;
  };


  /** What the points of a tire test ask for, one for each of the stages from
   * that of the first point on. */
  std::vector<RigTarget>
  rig_targets(const std::vector<Stage> &stages, const unsigned int first_point);
} // namespace Biface

#endif
