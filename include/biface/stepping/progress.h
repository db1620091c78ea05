// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_stepping_progress_h
#define biface_stepping_progress_h

#include <deal.II/base/conditional_ostream.h>

#include <optional>
#include <vector>

#include <biface/base/linear_algebra.h>
#include <biface/stepping/secant_predictor.h>
#include <biface/stepping/stage.h>

namespace Biface
{
  /** Loads and foundation travel at some moment. */
  struct LoadLevel
  {
    double pressure = 0;
    double factor   = 0;
    /** Counted from where the foundation first touched the shell. */
    double travel = 0;

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &pressure &factor &travel;
    }
  };


  /** The size of steps, which is halved by failures. */
  class StepSize
  {
  public:
    explicit StepSize(const double first = 0) : value(first)
    {}

    double
    get() const
    {
      return value;
    }

    /** The next size, by a factor and not beyond a bound. */
    void
    succeeded(const double growth, const double greatest);

    /** @return whether there may be another attempt. */
    bool
    failed(const unsigned int max_cuts, dealii::ConditionalOStream &out);

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &value &n_cuts;
    }

  private:
    double       value;
    unsigned int n_cuts = 0;
  };


  /**
   * Where a run is on its way through the stages: all that LoadStepping knows
   * from one step to the next. With the State and ShellEquations::History, a
   * complete restore point: stepping goes on from a copy as from the original.
   */
  struct Progress
  {
    /** Converged steps through all stages. */
    unsigned int n_steps = 0;
    /** Position of the stage at hand, and whether it was entered. */
    unsigned int stage       = 0;
    bool         stage_begun = false;
    /** The loads of the last converged step. */
    LoadLevel reached;
    /** See ShellEquations::touching_travel(), at the begin of the first stage
     * with contact, or the first one after a prestress. */
    std::optional<double> touching_travel;

    /** Of the stage at hand: its loads at the begin, and there the force or
     * the displacement that is given, if one is. */
    LoadLevel begin;
    double    begin_value = 0;
    /** Which part of the way to the stage's loads they have gone; where a
     * force is given, it goes with them. */
    double fraction = 0;
    /** Which part of its way a displacement that is given has gone. */
    double value_fraction = 0;
    /** Of the next step: a fraction of the stage or, after the first step of
     * given arc length, this length. */
    StepSize size;
    /** Steps of given arc length, the length of the first, and what the last
     * one changed the displacements by (locally owned entries). */
    unsigned int n_arc_steps      = 0;
    double       first_arc_length = 0;
    LA::Vector   last_change;

    SecantPredictor predictor;

    /** Whether the stage at hand, which is @p stage, is at its end. */
    bool
    at_end_of(const Stage &stage) const;

    /** Whether nothing is left to do. */
    bool
    at_end_of(const std::vector<Stage> &stages) const;

    /**
     * Take another description of the stage at hand, which may differ in its
     * loads, in what is given at its end, and in its steps. What was reached is
     * kept. Where it lies on the straight way from the begin of the stage to
     * its new end, it becomes the fraction of that way which it is; otherwise
     * the stage begins anew from there.
     */
    void
    change_stage(const Stage &before, const Stage &now);

    /** The numbers; vectors are distributed, and stored by themselves. */
    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      bool   touched = touching_travel.has_value();
      double travel  = touching_travel.value_or(0);
      archive &n_steps &stage &stage_begun &reached &touched &travel;
      archive &begin &begin_value &fraction &value_fraction  &size;
      archive &n_arc_steps                                   &first_arc_length;
      touching_travel =
        (touched ? std::optional<double>(travel) : std::nullopt);
    }
  };
} // namespace Biface

#endif
