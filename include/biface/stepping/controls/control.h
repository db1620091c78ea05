// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_stepping_controls_control_h
#define biface_stepping_controls_control_h

#include <deal.II/base/parameter_handler.h>

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <biface/base/linear_algebra.h>
#include <biface/model/contact_interaction.h>
#include <biface/model/shell_equations.h>
#include <biface/model/shell_mesh.h>
#include <biface/model/state.h>
#include <biface/solver/control_equation.h>
#include <biface/stepping/stage.h>

namespace Biface
{
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
    succeeded(const double growth, const double maximum);

    /** @return whether there may be another attempt. */
    bool
    failed(const unsigned int max_cuts);

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
   * What is given in every step of a stage, and with it how the stage goes on:
   * the interface of all controls, and what they have in common. A control
   * begins a stage, proposes the next step, learns how it went, and says when
   * the stage is done; LoadStepping computes the steps. See doc/extending.md
   * for how to add one.
   */
  class Control
  {
  public:
    struct Parameters
    {
      unsigned int max_cuts       = 6;
      unsigned int max_arc_steps  = 1000;
      double       maximum_growth = 10;

      void
      add_parameters(dealii::ParameterHandler &prm);
    };

    Control(const Stage &stage, const Parameters &parameters);

    virtual ~Control() = default;

    /** What can be told before the run of the start of a stage. */
    struct KnownStart
    {
      std::optional<double> pressure, factor, travel;
      /** Whether there are no displacements. */
      bool is_undeformed = false;

      static KnownStart
      undeformed()
      {
        return {0., 0., 0., true};
      }

      static KnownStart
      at(const LoadLevel &level)
      {
        return {level.pressure, level.factor, level.travel, false};
      }
    };

    /** Check the entries of the stage. Throws InputError.
     * @param section of the stage, to be named. */
    virtual void
    check(const std::string & /*section*/, const KnownStart & /*start*/) const
    {}

    /** What can be told before the run of the end of the stage. */
    virtual KnownStart
    known_end(const KnownStart &start) const;

    /** Check that the stage fits the mesh. Throws InputError. */
    virtual void
    check(const std::string & /*section*/, const ShellMesh & /*mesh*/) const
    {}

    /** The last converged state, where a step starts. */
    struct Equilibrium
    {
      const ShellEquations     &equations;
      const ContactInteraction &contact;
      const State              &state;
      const LoadLevel          &level;
      /** What acts on the shell at a level. */
      std::function<Loads(const LoadLevel &)> loads;
    };

    /** Begin the stage. Throws InputError where it leads nowhere. */
    virtual void
    begin(const Equilibrium &start);

    /** A step to try. */
    struct Trial
    {
      /** The loads, as a function of the load parameter @f$\mu@f$. */
      std::function<LoadLevel(const double)> level;
      /** The value of @f$\mu@f$, or, with an equation, the first guess. */
      double mu = 0;
      /** What determines @f$\mu@f$; null where it is given. */
      std::shared_ptr<const ControlEquation> equation = nullptr;
      /** The part of the stage that the step is, if states change in
       * proportion to it, for predictors; 0 if not. */
      double size = 0;
    };

    /** The next step. */
    virtual Trial
    propose(const Equilibrium &from) const = 0;

    /** Another step to try in place of one that has converged at @p mu, but
     * beyond where the stage is to go; none if all is well. */
    virtual std::optional<Trial>
    replace(const Trial & /*trial*/, const double /*mu*/) const
    {
      return {};
    }

    /** A step that has converged. */
    struct Step
    {
      const Trial &trial;
      /** What the load parameter is in the end. */
      double mu;
      /** Of all attempts at the step. */
      unsigned int iterations;
      const State &before, &after;
    };

    /** Go on from a step. */
    virtual void
    accept(const Step &step) = 0;

    /** Halve the step that has failed.
     * @return whether there may be another attempt. */
    bool
    cut()
    {
      return size.failed(parameters.max_cuts);
    }

    /** The part of the stage that is done: 1 at its end. */
    virtual double
    done() const = 0;

    /** What is controlled beside the loads and contact, in words, and its value
     * after the last step. */
    virtual std::optional<std::pair<std::string, double>>
    controlled() const
    {
      return {};
    }

    /** Whether each step is a given part of the stage, unless it is cut. */
    virtual bool
    has_equal_steps() const
    {
      return false;
    }

    /** Where the stage has not come to its end, but there may be no more steps:
     * what happened; else empty. */
    virtual std::string
    exhausted() const
    {
      return {};
    }

    /** All that a control knows from one step to the next. */
    struct Memory
    {
      /** The loads at the start of the stage. */
      LoadLevel start;
      StepSize  size;
      /** See Control::done(). */
      double done = 0;
      /** What the kind of control adds, by names. */
      std::map<std::string, double> numbers;
      /** Locally owned entries of displacements. */
      std::map<std::string, LA::Vector> vectors;

      /** The numbers, and the names of vectors, which are distributed and
       * stored by themselves. */
      template <class Archive>
      void
      serialize(Archive &archive, const unsigned int)
      {
        std::vector<std::string> names;
        for (const auto &vector : vectors)
          names.push_back(vector.first);
        archive &start &size &done &numbers &names;
        for (const std::string &name : names)
          vectors[name];
      }
    };

    virtual Memory
    get_memory() const;

    virtual void
    restore(const Memory &memory);

    /**
     * Take another description of the stage, which may differ in its loads, in
     * what is given at its end, and in its steps. What was reached is kept.
     * Where it lies on the straight way from the start of the stage to its new
     * end, it becomes the part of that way which it is; otherwise the stage
     * begins anew from there.
     *
     * @return whether the way has changed.
     */
    bool
    change_stage(const Stage &now, const LoadLevel &reached);

  protected:
    /** A number on its way through the stage. */
    struct Way
    {
      double start, now, end;
    };

    /** The part of their ways that all have gone, if it is the same for all. */
    static std::optional<double>
    common_part(const std::vector<Way> &ways);

    /** The ways of the loads. */
    std::vector<Way>
    ways_of_loads(const LoadLevel &reached, const LoadLevel &end) const;

    /** The part of change_stage() of one kind of control, where the way has
     * changed: go on along the new one, or begin anew from @p reached. */
    virtual void
    change_way(const Stage &now, const LoadLevel &reached) = 0;

    /** What the size of steps is after a change of their number. */
    virtual void
    change_size()
    {
      size = StepSize(1. / stage.n_steps);
    }

    /** The loads at a part of the straight way from the start of the stage to
     * its end. */
    LoadLevel
    level_at(const double fraction) const;

    /** How the loads change over the whole stage, without the foundation. */
    LoadRates
    load_rate() const;

    Stage            stage;
    const Parameters parameters;
    /** The loads at the start of the stage. */
    LoadLevel start;
    StepSize  size;
  };


  /** What a stage can ask for. */
  std::vector<std::string>
  control_names();

  /** The control that a stage asks for. */
  std::unique_ptr<Control>
  make_control(const Stage               &stage,
               const Control::Parameters &parameters = Control::Parameters());


  /** A control whose steps are equal parts of the stage, or grow where the
   * stage lets them adapt. Where a step is cut, the end of the equal one is
   * reached nevertheless. */
  class EqualSteps : public Control
  {
  public:
    using Control::Control;

    void
    begin(const Equilibrium &from) override;

    void
    accept(const Step &step) override;

    double
    done() const override
    {
      return fraction;
    }

    bool
    has_equal_steps() const override
    {
      return !stage.adaptive;
    }

    void
    restore(const Memory &memory) override;

  protected:
    /** The part of the stage that is done after the next step. */
    double
    next() const;

    /** Where it is a part, go on from there, or else begin anew.
     * @return whether it is. */
    bool
    go_on_from(const std::optional<double> &part, const LoadLevel &reached);

    double fraction = 0;

  private:
    /** The next end of an equal step, or that of the stage. */
    double
    next_target() const;
  };


  /** The factor for the size of the next step, by the iterations of the last
   * one and those that are wanted. */
  double
  step_growth(const double wanted, const unsigned int iterations);


  /** Refuse to let the loads follow in a stage where none changes, or the
   * foundation moves, too. Throws InputError. */
  void
  check_loads_follow(const Stage &stage, const Control::KnownStart &start);

  /** Refuse to let the loads follow where supports prescribe displacements.
   * Throws InputError. */
  void
  check_nothing_prescribed(const Stage &stage, const ShellMesh &mesh);
} // namespace Biface

#endif
