// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_stepping_stage_h
#define biface_stepping_stage_h

#include <deal.II/base/parameter_handler.h>

#include <optional>
#include <string>
#include <vector>

#include <biface/model/state.h>

namespace Biface
{
  /** Loads and foundation travel at some point of an analysis. */
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


  /** An instant of an analysis: the position of a stage among the stages, and
   * the part of it that is done. */
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


  /** A stage of loading: from the loads of the stage before to its own, in
   * equal steps. */
  struct Stage
  {
    std::string  name   = "stage";
    StrainTheory theory = StrainTheory::nonlinear;
    /** At the end of the stage; without a value, as at its start. */
    std::optional<double> pressure;
    /** Whether there is a foundation, and how far it has come at the end. */
    bool                  contact = false;
    std::optional<double> travel;
    /** Of the dead loads and prescribed displacements, at the end. */
    std::optional<double> factor;
    unsigned int          n_steps = 1;

    /** What is given in every step: one of control_names(). */
    std::string control = "load";
    /** The displacement that is given: a named point, its component (0 to 2 for
     * x to z), and its value at the end of the stage. */
    std::string  control_point;
    unsigned int control_component = 0;
    double       control_value     = 0;
    /** The force on the foundation at the end of the stage, where it is given.
     */
    double force = 0;
    /** Whether steps of loads and of the force grow after easy ones. */
    bool adaptive = false;

    /** Begin with the stresses reached so far, but undeformed and unloaded. */
    bool from_prestress = false;

    /** The loads at the end of the stage, by those at its start. */
    LoadLevel
    end(const LoadLevel &start) const
    {
      return {pressure.value_or(start.pressure),
              factor.value_or(start.factor),
              travel.value_or(start.travel)};
    }

    /** @param number of the stage, for its default name. */
    void
    add_parameters(dealii::ParameterHandler &prm, const unsigned int number);

    /** Throws InputError where a value is not usable. */
    void
    check(const std::string &section) const;

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      const auto add_optional = [&](std::optional<double> &value) {
        bool            given  = value.has_value();
        double          number = value.value_or(0);
        archive &given &number;
        value = (given ? std::optional<double>(number) : std::nullopt);
      };
      add_optional(pressure);
      add_optional(travel);
      add_optional(factor);
      archive &name &theory &contact                     &n_steps;
      archive &control &control_point &control_component &control_value;
      archive &force &adaptive                           &from_prestress;
    }
  };


  /** Check stages one after the other, and what can be told of each before the
   * run. Throws InputError. */
  void
  check_stages(const std::vector<Stage> &stages);
} // namespace Biface

#endif
