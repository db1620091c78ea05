// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_stepping_controls_controlled_resultant_h
#define biface_stepping_controls_controlled_resultant_h

#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <biface/model/equations/linearized_resultant.h>
#include <biface/stepping/controls/control.h>

namespace Biface
{
  /** A resultant of the forces between shell and ground, another body or
   * supports that is prescribed, and the load that is computed instead. */
  class ControlledResultant
  {
  public:
    virtual ~ControlledResultant() = default;

    /** The name of the resultant in Control::Memory. */
    virtual std::string
    name() const = 0;

    /** Check the entries of a stage, see Control::check(). */
    virtual void
    check(const Stage & /*stage*/,
          const std::string & /*section*/,
          const Control::KnownStart & /*start*/) const
    {}

    /** Check that it fits the mesh. Throws InputError with the section of the
     * stage. */
    virtual void
    check_mesh(const std::string & /*section*/,
               const ShellMesh & /*mesh*/) const
    {}

    /** The prescribed value of the resultant at the end of a stage. */
    virtual double
    end(const Stage &stage) const = 0;

    virtual LinearizedResultant
    evaluate(const LoadedShell            &at,
             const std::vector<LoadRates> &rates) const = 0;

    /** The value to which the violation of a prescribed resultant is relative.
     * @param now the resultant. */
    virtual double
    scale(const double                       prescribed,
          const LinearizedResultant         &now,
          const ControlEquations::Iteration &iteration) const = 0;

    /** The unknown load in a level. */
    virtual double &
    load(LoadLevel &level) const = 0;

    /** The unknown load as far as it is known before the run. */
    virtual std::optional<double> &
    known_load(Control::KnownStart &start) const = 0;

    /** The derivative of the loads by the unknown one. */
    virtual LoadRates
    rate() const = 0;

    /** The initial guess of the unknown load in a step.
     * @param next the other loads at its end. */
    virtual double
    guess(const Control::Equilibrium &from, const LoadLevel &next) const = 0;

    /** The change of the unknown load that brings the shell into contact where
     * the resultant is zero without it, whatever the loads: then no other load
     * changes. None if it is in contact, or needs none. */
    virtual std::optional<double>
    change_into_contact(const double /*prescribed*/,
                        const ControlEquations::Iteration & /*iteration*/) const
    {
      return {};
    }

    /** Whether something else than contact may hold what the load moves, so
     * that change_into_contact() is only for a load on which the resultant does
     * not depend. */
    virtual bool
    is_held_elsewhere() const
    {
      return false;
    }

    /** The largest change of the unknown load in an iteration, beyond which the
     * linearization means nothing. */
    virtual double
    largest_change() const
    {
      return std::numeric_limits<double>::infinity();
    }

    /** The remedies if the resultant does not depend on any load, as part of a
     * sentence that names entries of the parameter file. */
    virtual std::string
    remedies() const = 0;

    /** Whether the resultant depends on its load only in contact with the
     * ground. */
    virtual bool
    needs_contact() const
    {
      return false;
    }
  };


  /** The force on the ground is prescribed, its travel is unknown. */
  std::shared_ptr<const ControlledResultant>
  controlled_force();


  /** The moment of the axle on a rolling wheel is prescribed, zero for free
   * rolling; the angular velocity is unknown. */
  std::shared_ptr<const ControlledResultant>
  controlled_axle_moment();


  /** The force that pushes a body along one of its motions, or supports, is
   * prescribed, its factor is unknown.
   * @param n_factors the number of all factors. */
  std::shared_ptr<const ControlledResultant>
  controlled_motion(const MotionByForce &motion, const unsigned int n_factors);
} // namespace Biface

#endif
