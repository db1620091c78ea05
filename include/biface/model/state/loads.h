// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_state_loads_h
#define biface_model_state_loads_h

#include <map>
#include <memory>
#include <optional>
#include <vector>

#include <biface/model/state/load_rates.h>

namespace Biface
{
  class RigidBody;
  struct PlacedBody;
  struct Rolling;


  /** The loads on the shell. */
  struct Loads
  {
    /** The pressure, see PressureLoad. Unit: force/area. */
    double pressure = 0;

    /** The factors of the dead loads and prescribed displacements: first the
     * common one, of all those without a factor of their own, see factor_at().
     */
    std::vector<double> factors = {0};

    /** The factors at which prescribed displacements vanish, see
     * Progress::factors_of_shape. */
    std::vector<double> factors_of_shape = {0};

    /** The pressure and the factors at the start of a stage of linear strain
     * theory, with which the loads that follow the shell turn as it deforms,
     * and the others of no meaning; if not set, those above. The forces of
     * their change are those on the shape at the start. */
    std::optional<LoadRates> linearized_at;

    /** Whether the gas that exerts the pressure is sealed in, so that the
     * pressure follows from the state, see Gas. */
    bool sealed_gas = false;

    /** The viscous damping, see ViscousDamping. Unit: force/volume. */
    double damping = 0;

    /** The part of the stage that passes between the last equilibrium and the
     * one that is sought; 0 for the loads in an equilibrium. */
    double part_of_stage = 0;

    /** The bodies that are there, by ContactPair::number; the first is the
     * ground. */
    std::map<unsigned int, std::shared_ptr<const PlacedBody>> bodies;

    /** The motion of wheel and ground; null if the shell does not roll. */
    std::shared_ptr<const Rolling> rolling;

    /** Put the body of a pair in a place. */
    void
    place(const unsigned int number, const PlacedBody &body);

    /** The body of a pair; null if it is not there. */
    const PlacedBody *
    body(const unsigned int number) const;

    /** The ground; null if it is not there. */
    const RigidBody *
    ground() const;
  };
} // namespace Biface

#endif
