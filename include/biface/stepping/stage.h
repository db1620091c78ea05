// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_stepping_stage_h
#define biface_stepping_stage_h

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/tensor.h>

#include <optional>
#include <string>
#include <vector>

#include <biface/model/state/state.h>
#include <biface/stepping/load_level.h>

namespace Biface
{
  /** Add a value that may not be set to an archive, or read it from one. */
  template <class Archive, class Value>
  void
  serialize_optional(Archive &archive, std::optional<Value> &value)
  {
    bool            given   = value.has_value();
    Value           content = value.value_or(Value());
    archive &given &content;
    value = (given ? std::optional<Value>(content) : std::nullopt);
  }


  /** An instant of an analysis: the position of the stage and the completed
   * fraction of it. */
  struct Instant
  {
    unsigned int stage    = 0;
    double       fraction = 0;

    bool
    operator<(const Instant &other) const
    {
      return stage != other.stage ? stage < other.stage
                                  : fraction < other.fraction;
    }
  };


  /** What is done where the number of negative pivots of the tangent changes
   * along the path of a stage, see CriticalPoint. */
  enum class CriticalPoints
  {
    ignore,
    /** Say so after the step. */
    report,
    /** End the step there, by bisection. */
    locate,
    /** Likewise, and go on along the other branch at a bifurcation. */
    switch_branch
  };


  /** A stage of loading: from the end of the previous stage, or of another one
   * before, to its own loads, in equal steps. Loads that are not set are those
   * at its start. */
  struct Stage : LoadsOf<std::optional>
  {
    std::string  name   = "stage";
    StrainTheory theory = StrainTheory::nonlinear;
    /** The number, from 1, of the stage from whose end this one starts; if not
     * set, that of the previous stage. See stage_before(). */
    std::optional<unsigned int> start_from;
    /** Whether the gas that exerts the pressure is sealed in, see Gas. */
    bool sealed = false;
    /** Whether there is a foundation. */
    bool contact = false;
    /** Instead of the angular velocity, see with_angular_velocity(). */
    std::optional<double> slip_ratio;
    /** The moment of the axle on the wheel at the end of the stage, if
     * prescribed. */
    double axle_moment = 0;
    /** The coefficient of friction, see FrictionLaw; empty for that of the
     * section 'Contact'. */
    std::string friction;
    /** Whether the nodes in contact at the start of the stage cannot slip. */
    bool         glued   = false;
    unsigned int n_steps = 1;

    /** The quantity prescribed in every step: one of control_names(). */
    std::string control = "load";
    /** The prescribed displacement: a named point, the component (0 to 2 for x
     * to z), and the value at the end of the stage. */
    std::string control_point;
    Component   control_component = Component::x;
    double      control_value     = 0;
    /** The force on the foundation at the end of the stage, if prescribed. */
    double force = 0;
    /** Whether steps of the loads or the force grow after fast convergence. */
    bool adaptive = false;

    /** Whether to start with the stresses and loads reached so far, but
     * undeformed. */
    bool from_prestress = false;

    /** The number of natural frequencies computed at the end of the stage, see
     * ModalAnalysis. */
    unsigned int n_modes = 0;

    /** The number of buckling loads predicted at the end of the stage, see
     * BucklingAnalysis. */
    unsigned int n_buckling = 0;

    CriticalPoints critical_points = CriticalPoints::report;
    /** The first amplitude of the critical shape on the other branch, as a
     * multiple of the thickness. */
    double branch_amplitude = 1;

    /** The loads at the end of the stage for given loads at its start. */
    LoadLevel
    end(const LoadLevel &start) const
    {
      LoadLevel result;
      for_each_load(
        [](auto &load, const auto &prescribed, const auto &at_start) {
          load = prescribed.value_or(at_start);
        },
        result,
        *this,
        start);
      return result;
    }

    /** Whether the shell rolls: it does not stand both at the start and at the
     * end of the stage. */
    bool
    rolls(const LoadLevel &start) const
    {
      return start.rolls() || end(start).rolls() || prescribes("axle moment");
    }

    /** Whether the control prescribes a quantity, alone or with another. */
    bool
    prescribes(const std::string &quantity) const
    {
      return control.find(quantity) != std::string::npos;
    }

    /** Whether the wheel rolls freely at the end of the stage. */
    bool
    ends_rolling_freely() const
    {
      return prescribes("axle moment") && axle_moment == 0;
    }

    /** The same stage with the angular velocity at its end that belongs to the
     * slip ratio S, if one is given,
     * @f$\Omega=(1+S)\,V\cos\alpha/R@f$ with the ground velocity V and the slip
     * angle @f$\alpha@f$ at its end.
     * @param start the loads at its start.
     * @param free_radius R, see free_rolling_radius(). */
    Stage
    with_angular_velocity(const LoadLevel             &start,
                          const std::optional<double> &free_radius) const;

    /** Whether steps end at critical points. */
    bool
    locates_critical_points() const
    {
      return critical_points == CriticalPoints::locate ||
             critical_points == CriticalPoints::switch_branch;
    }

    /** Whether the foundation may move while it is there. */
    bool
    moves_foundation() const
    {
      bool moves = prescribes("foundation force");
      for_each_motion([&moves](const auto &motion) { moves = moves || motion; },
                      *this);
      return contact && moves;
    }

    /** @param number the number of the stage, for its default name. */
    void
    add_parameters(dealii::ParameterHandler &prm, const unsigned int number);

    /** Throws InputError if a value is invalid. */
    void
    check(const std::string &section) const;

    /** Check that the foundation slides across its direction of travel. Throws
     * InputError. */
    void
    check_slide(const std::string          &section,
                const dealii::Tensor<1, 3> &direction) const;

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      for_each_load(
        [&archive](auto &load) { serialize_optional(archive, load); }, *this);
      serialize_optional(archive, start_from);
      serialize_optional(archive, slip_ratio);
      archive &friction &glued                           &axle_moment;
      archive &name &theory &contact                     &n_steps;
      archive &control &control_point &control_component &control_value;
      archive &force &adaptive &from_prestress           &sealed;
      archive &n_modes &n_buckling &critical_points      &branch_amplitude;
    }
  };


  /** The rolling radius in free rolling, @f$V\cos\alpha/\Omega@f$. */
  double
  free_rolling_radius(const LoadLevel &level);

  /** The slip ratio of ISO 8855, @f$(\Omega R-V\cos\alpha)/(V\cos\alpha)@f$;
   * not a number if the wheel does not move forward.
   * @param free_radius R, see free_rolling_radius(). */
  double
  slip_ratio(const LoadLevel &level, const double free_radius);

  /** The position of the stage from whose end that at @p position starts: the
   * previous one, or the one that it names. None for the first stage, which
   * starts from the unloaded shell. */
  std::optional<unsigned int>
  stage_before(const std::vector<Stage> &stages, const unsigned int position);

  /** Whether another stage than the next one starts from the end of that at
   * @p position. */
  bool
  is_branched_from(const std::vector<Stage> &stages,
                   const unsigned int        position);

  /** Check all stages in order, as far as possible before the run. Throws
   * InputError. */
  void
  check_stages(const std::vector<Stage> &stages);
} // namespace Biface

#endif
