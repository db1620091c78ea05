// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_forces_gas_h
#define biface_model_forces_gas_h

#include <deal.II/base/parameter_handler.h>

#include <optional>

#include <biface/model/forces/cavity.h>

namespace Biface
{
  /**
   * The gas in the cavity of a shell. A sealed gas cannot leave it: @f$(p+p_a)
   * V^n@f$ is constant, where @f$p@f$ is the gauge pressure, a load of the
   * shell, and @f$p_a@f$ the ambient pressure.
   *
   * As @f$p@f$ then depends on the displacements of the whole shell, the
   * tangent has the additional term @f$-\mathbf f\otimes\partial
   * p/\partial\mathbf V@f$ of rank one, with the forces @f$\mathbf f@f$ of a
   * unit pressure. Newton adds it to the solutions, without a matrix.
   */
  class Gas
  {
  public:
    /** Entries of the section 'Gas'. */
    struct Parameters
    {
      /** @f$p_a@f$; if not set, there is no gas to be sealed. Unit:
       * force/area. */
      std::optional<double> ambient_pressure;
      /** @f$n@f$: 1 at constant temperature. */
      double             exponent = 1;
      Cavity::Parameters cavity;

      void
      add_parameters(dealii::ParameterHandler &prm);

      /** Throws InputError if a value is invalid.
       * @param has_axis see Cavity::Parameters::check(). */
      void
      check(const bool has_axis) const;
    };

    /** @param parameters with an ambient pressure.
     * @param mesh, face see Cavity. */
    Gas(const ShellMesh       &mesh,
        const Parameters      &parameters,
        const Resultants::Face face);

    const Cavity cavity;

    /** A fixed amount of gas, which defines the pressure of a state. */
    class Sealed
    {
    public:
      /** @param gas kept by reference.
       * @param content @f$(p+p_a)V^n@f$ */
      Sealed(const Gas &gas, const double content) : gas(gas), content(content)
      {}

      /** The gauge pressure @f$p@f$; not a number if nothing is left of the
       * cavity. */
      double
      pressure(const State &state) const;

      /** Its derivative with respect to the nodal unknowns. */
      LA::Vector
      pressure_gradient(const State &state) const;

    private:
      const Gas   &gas;
      const double content;
    };

    /** @f$(p+p_a)V^n@f$ at the gauge pressure @f$p@f$ in a state. */
    double
    content(const double pressure, const State &state) const;

  private:
    const double ambient_pressure;
    const double exponent;
  };
} // namespace Biface

#endif
