// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_stepping_controls_control_h
#define biface_stepping_controls_control_h

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <biface/base/linear_algebra.h>
#include <biface/stepping/controls/control_memory.h>
#include <biface/stepping/controls/control_parameters.h>
#include <biface/stepping/controls/control_trial.h>
#include <biface/stepping/stage.h>

namespace Biface
{
  class ContactInteraction;
  class EntryDeclarations;
  struct Loads;
  class ShellEquations;
  class ShellMesh;
  struct State;


  /**
   * The interface and common parts of all controls. A control determines what
   * is prescribed in every step of a stage: it begins the stage, proposes the
   * next step, is informed of the result, and says when the stage is complete;
   * LoadStepping computes the steps. See doc/extending.md for how to add one.
   */
  class Control
  {
  public:
    using Parameters = ControlParameters;
    using Trial      = ControlTrial;
    using Memory     = ControlMemory;

    Control(const Stage &stage, const Parameters &parameters);

    virtual ~Control() = default;

    /** What is known before the run about the start of a stage. */
    struct KnownStart : LoadsOf<std::optional>
    {
      /** Whether all displacements are zero. */
      bool is_undeformed = false;

      static KnownStart
      undeformed()
      {
        KnownStart start    = at(LoadLevel());
        start.is_undeformed = true;
        return start;
      }

      static KnownStart
      at(const LoadLevel &level)
      {
        KnownStart start = with_factors(KnownStart(), level.factors.size());
        for_each_load(
          [](auto &known, const auto &load) { known = load; }, start, level);
        return start;
      }
    };

    /** Check the entries of the stage. Throws InputError that names its section
     * and the entry. */
    virtual void
    check(const std::string & /*section*/, const KnownStart & /*start*/) const
    {}

    /** What is known before the run about the end of the stage. */
    virtual KnownStart
    known_end(const KnownStart &start) const;

    /** Check that the stage fits the mesh. Throws InputError. */
    virtual void
    check(const std::string & /*section*/, const ShellMesh & /*mesh*/) const
    {}

    /** The last converged state, from which a step starts. */
    struct Equilibrium
    {
      const ShellEquations     &equations;
      const ContactInteraction &contact;
      const State              &state;
      const LoadLevel          &level;
      /** The change of the unknowns in the last step (locally owned entries);
       * empty if the shell is at rest. */
      const LA::Vector &last_change;
      /** The loads on the shell at a given level. */
      std::function<Loads(const LoadLevel &)> loads;
    };

    /** Begin the stage. Throws InputError if it cannot make progress. */
    virtual void
    begin(const Equilibrium &start);

    /** Propose the next step. */
    virtual Trial
    propose(const Equilibrium &from) const = 0;

    /** A step to try instead of one that converged at @p mu but went beyond the
     * end of the stage; none if it did not. */
    virtual std::optional<Trial>
    replace(const Trial & /*trial*/, const LoadParameters & /*mu*/) const
    {
      return {};
    }

    /** A converged step. */
    struct Step
    {
      const Trial &trial;
      /** The final load parameters of the step. */
      LoadParameters mu;
      /** Number of iterations in all attempts at the step. */
      unsigned int iterations;
      const State &before, &after;
      /** Whether the step has left the path for another branch. */
      bool to_branch = false;
      /** The error of a step in time, see Attempt. */
      double error_in_time = 0;
    };

    /** Accept a converged step. */
    virtual void
    accept(const Step &step) = 0;

    /** Whether a failed step may be halved. */
    bool
    can_cut() const
    {
      return size.can_fail(parameters.max_cuts);
    }

    /** Halve the failed step.
     * @return whether another attempt is allowed. */
    bool
    cut()
    {
      return size.failed(parameters.max_cuts);
    }

    /** Shorten a step whose error in time was too large.
     * @return whether another attempt is allowed. */
    virtual bool
    shorten(const double /*error_in_time*/)
    {
      return false;
    }

    /** Take the next step as a part of the one that propose() would give, or
     * as a multiple of it. */
    void
    scale_step(const double part)
    {
      size = StepSize(part * step_size());
    }

    /** The change of the loads over the whole stage, without the motions of the
     * ground. */
    LoadRates
    load_rate() const;

    /** The completed fraction of the stage: 1 at its end. */
    virtual double
    done() const = 0;

    /** The controlled quantity, if not a load or the contact force, in words,
     * and its value after the last step. */
    virtual std::optional<std::pair<std::string, double>>
    controlled() const
    {
      return {};
    }

    /** Whether each step is a given fraction of the stage, unless it is
     * halved. */
    virtual bool
    has_equal_steps() const
    {
      return false;
    }

    /** The message if the stage is incomplete but no more steps are allowed;
     * otherwise empty. */
    virtual std::string
    stop_reason() const
    {
      return {};
    }

    virtual Memory
    get_memory() const;

    virtual void
    restore(const Memory &memory);

    /**
     * Change the description of the stage, which may differ in its final loads,
     * the final value of the controlled quantity, and its steps. The loads
     * reached are kept. If they lie on the straight path from the start of the
     * stage to its new end, the stage continues from this fraction of the path;
     * otherwise it starts again from there.
     *
     * @return whether the path has changed.
     */
    bool
    change_stage(const Stage &now, const LoadLevel &reached);

  protected:
    /** The values of a load or of the controlled quantity at the start of the
     * stage, now, and at its end. */
    struct Progression
    {
      double start, now, end;
    };

    /** The completed fraction of all progressions, if it is the same for
     * all. */
    static std::optional<double>
    common_part(const std::vector<Progression> &progressions);

    /** The progressions of all loads and motions. */
    std::vector<Progression>
    progressions_of_loads(const LoadLevel &reached, const LoadLevel &end) const;

    /** The part of change_stage() specific to a control, if the path has
     * changed: continue along the new one, or start again from @p reached. */
    virtual void
    change_path(const Stage &now, const LoadLevel &reached) = 0;

    /** Set the size of steps after a change of their number. */
    virtual void
    change_size()
    {
      size = StepSize(1. / stage.n_steps);
    }

    /** The loads at a fraction of the straight path from the start of the stage
     * to its end. */
    LoadLevel
    level_at(const double fraction) const;

    /** The size of the next step. */
    virtual double
    step_size() const
    {
      return size.get();
    }

    Stage            stage;
    const Parameters parameters;
    /** The loads at the start of the stage. */
    LoadLevel start;
    StepSize  size;
  };


  /** Throw InputError for a stage with unknown loads, none of which changes, or
   * in which the ground or the ground under a wheel moves differently,
   * too. */
  void
  check_loads_follow(const Stage &stage, const Control::KnownStart &start);

  /** Throw InputError for a stage with unknown loads if supports prescribe
   * displacements that may change in it. */
  void
  check_nothing_prescribed(const Stage &stage, const ShellMesh &mesh);
} // namespace Biface

#endif
