// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_forces_gas_h
#define biface_model_forces_gas_h

#include <optional>

#include <biface/model/air/air_column.h>
#include <biface/model/forces/cavity.h>
#include <biface/model/forces/force_term.h>

namespace Biface
{
  class EntryDeclarations;


  /**
   * The gas in the cavity of a shell. A sealed gas cannot leave it: @f$(p+p_a)
   * V^n@f$ is constant, where @f$p@f$ is the gauge pressure, a load of the
   * shell, and @f$p_a@f$ the ambient pressure.
   *
   * The term adds no forces of its own: it sets the pressure, whose forces are
   * those of PressureForces. As @f$p@f$ depends on the displacements of the
   * whole shell, the tangent has the additional part
   * @f$-\mathbf f\otimes\partial p/\partial\mathbf V@f$ of rank one, with the
   * forces @f$\mathbf f@f$ of a unit pressure. The term remembers the content
   * @f$(p+p_a)V^n@f$ while the gas is sealed.
   */
  class Gas : public ForceTerm
  {
  public:
    /** Entries of the section 'Gas'. */
    struct Parameters
    {
      /** The ambient pressure @f$p_a@f$; if not set, there is no gas to be
       * sealed. Unit: force/area. */
      std::optional<double> ambient_pressure;
      /** The exponent @f$n@f$ of the volume: 1 at constant temperature. */
      double             exponent = 1;
      Cavity::Parameters cavity;
      /** The motion of the gas in vibrations. */
      AirColumn::Parameters air;

      void
      add_parameters(EntryDeclarations &prm);

      /** Throws InputError if a value is invalid.
       * @param is_known see Cavity::Parameters::check(). */
      void
      check(const bool is_known) const;
    };

    /** The gas of a cavity.
     * @param parameters with an ambient pressure.
     * @param cavity kept by reference. */
    Gas(const Parameters &parameters, const Cavity &cavity);

    std::string
    name() const override
    {
      return "gas";
    }

    /** Seal the gas in if the loads say so, or let it out. */
    void
    start_stage(const Loads &loads, State &state) const override;

    /** Set the gauge pressure of a sealed gas; not a number if nothing is left
     * of the cavity. */
    void
    set_dependent_loads(const State &state, Loads &loads) const override;

    void
    add_dependent_loads(const State                 &state,
                        const Loads                 &loads,
                        std::vector<DependentLoads> &dependent) const override;

  private:
    /** The gauge pressure of a sealed gas in a volume; not a number if nothing
     * is left of the volume. */
    double
    pressure(const double volume, const double content) const;

    /** The mean pressure over a StepInTime, in which the volume changes evenly,
     * and its derivative by the volume at the end: the work of the gas is the
     * change of its energy. */
    struct MeanPressure
    {
      double value, per_volume;
    };

    /** @param state at the end of the step. */
    MeanPressure
    mean_pressure(const State &state, const double content) const;

    const Cavity &cavity;
    const double  ambient_pressure;
    const double  exponent;
  };
} // namespace Biface

#endif
