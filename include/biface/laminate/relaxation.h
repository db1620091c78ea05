// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_laminate_relaxation_h
#define biface_laminate_relaxation_h

#include <vector>

#include <biface/laminate/material_law.h>
#include <biface/laminate/time_step.h>

namespace Biface
{
  /**
   * The relaxation of stresses: a Prony series of the moduli,
   * @f[
   *   E(t) = E_0\Bigl[1-\sum_i g_i\bigl(1-e^{-t/a\tau_i}\bigr)\Bigr],
   * @f]
   * with the same parts @f$g_i@f$ of all instantaneous moduli, and a factor
   * @f$a@f$ of the times that depends on the temperature.
   *
   * Each term has an internal stress, which follows that of the elastic law
   * @f$\mathbf S_0@f$ by @f$\dot{\mathbf q}_i+\mathbf q_i/a\tau_i =
   * g_i\dot{\mathbf S}_0@f$. Over a step in which @f$\mathbf S_0@f$ changes
   * evenly, with @f$x=\Delta t/a\tau_i@f$,
   * @f[
   *   \mathbf q_i \leftarrow e^{-x}\mathbf q_i
   *     + g_i\,\frac{1-e^{-x}}x\,\Delta\mathbf S_0 ,
   *   \qquad
   *   \mathbf S = \Bigl(1-\sum_i g_i\Bigr)\mathbf S_0 + \sum_i\mathbf q_i ,
   * @f]
   * the recursion of Taylor, Pister and Goudreau for linear laws; for others it
   * is that of @cite Simo1987 with all of the stress.
   */
  class Relaxation
  {
  public:
    struct Term
    {
      /** The time @f$\tau_i@f$ at the reference temperature. Unit: time. */
      double time;
      /** The part @f$g_i@f$ of the instantaneous moduli. */
      double part;
    };

    /** The dependence of the times on the temperature, by
     * @f$\log_{10}a=-C_1(T-T_r)/(C_2+T-T_r)@f$ (Williams, Landel, Ferry) or
     * @f$\ln a=C(1/T-1/T_r)@f$ with absolute temperatures (Arrhenius). */
    struct Shift
    {
      enum class Kind
      {
        none,
        WLF,
        Arrhenius
      };
      Kind   kind      = Kind::none;
      double reference = 0;
      double C_1 = 17.44, C_2 = 51.6;
      /** The constant @f$C@f$ of Arrhenius. Unit: temperature. */
      double activation = 0;

      /** The factor @f$a@f$ of the times; nan where a law has none. */
      double
      factor(const double temperature) const;
    };

    Relaxation(const std::vector<Term> &terms, const Shift &shift)
      : terms(terms), shift(shift)
    {}

    unsigned int
    n_terms() const
    {
      return terms.size();
    }

    /** The law of a step: the stress is @p factor times that of the elastic law
     * plus the remaining internal stresses. */
    struct Step
    {
      double factor;
      /** The parts of each internal stress that remain, and the parts of the
       * change of the elastic stress that are added to each. */
      std::vector<double> remains, grows;
    };
    Step
    step(const TimeStep &time) const;

    const std::vector<Term> &
    get_terms() const
    {
      return terms;
    }

    /** The factor @f$a@f$ of the times. */
    double
    factor_of_times(const double temperature) const
    {
      return shift.factor(temperature);
    }

  private:
    std::vector<Term> terms;
    Shift             shift;
  };


  /**
   * The relaxation of a material that flows steadily around a closed line,
   * where the stresses of the elastic law are given at points. With
   * @f$\mathbf v_i=\mathbf S_0-\mathbf q_i/g_i@f$, the recursion of
   * Relaxation is
   * @f[
   *   \mathbf v_i \leftarrow e^{-x}\mathbf v_i
   *     + (1-w)\,\mathbf S_0 + (w-e^{-x})\,\mathbf S_0^-,
   *   \qquad w=\frac{1-e^{-x}}x ,
   * @f]
   * which has no differences of large numbers at any speed. It is closed around
   * the line by dividing what one turn adds to zero by @f$1-e^{-\sum x}@f$.
   */
  class RelaxationAroundLine
  {
  public:
    /** The relaxation along a closed line.
     * @param steps to each point from the one before it, the last one for the
     * first point. */
    RelaxationAroundLine(const Relaxation            &relaxation,
                         const std::vector<TimeStep> &steps);

    /** The internal stresses of all points.
     * @param elastic the components of @f$\mathbf S_0@f$, point by point.
     * @return the numbers of InternalStresses, point by point. */
    std::vector<double>
    internal_stresses(const std::vector<double> &elastic) const;

  private:
    /** The factors of the recursion of a term at each point. */
    struct Factors
    {
      double              part;
      std::vector<double> remains, of_point, of_last;
      /** The divisor of what the first turn adds; 0 if a turn takes so little
       * time that the mean relaxes. */
      double turn;
    };
    std::vector<Factors> terms;
    /** The part of a turn from the point before to each point. */
    std::vector<double> parts;
  };


  /** The stress of a point that relaxes: a factor times the stress of the
   * elastic law, plus a constant. */
  template <typename Stress>
  struct Relaxed
  {
    double factor = 1;
    Stress stress{};
  };


  /** The internal stresses of a point as numbers: those of the terms, and the
   * elastic stress at the last equilibrium. */
  template <typename Stress>
  struct InternalStresses
  {
    static constexpr unsigned int n_components =
      sizeof(Stress) / sizeof(double);

    /** The law of a step that starts with these @p numbers. */
    static Relaxed<Stress>
    relaxed(const Relaxation::Step &step, const double *numbers)
    {
      const unsigned int n = step.grows.size();
      Relaxed<Stress>    result;
      result.factor = step.factor;
      for (unsigned int i = 0; i < n; ++i)
        add(step.remains[i], numbers + i * n_components, result.stress);
      double grows = 0;
      for (unsigned int i = 0; i < n; ++i)
        grows += step.grows[i];
      add(-grows, numbers + n * n_components, result.stress);
      return result;
    }

    /** Set the numbers to those after the step.
     * @param elastic the stress of the elastic law. */
    static void
    commit(const Relaxation::Step &step, const Stress &elastic, double *numbers)
    {
      const unsigned int n    = step.grows.size();
      double            *last = numbers + n * n_components;
      for (unsigned int k = 0; k < n_components; ++k)
        {
          const double now = component(elastic, k);
          for (unsigned int i = 0; i < n; ++i)
            {
              double &q = numbers[i * n_components + k];
              q         = step.remains[i] * q + step.grows[i] * (now - last[k]);
            }
          last[k] = now;
        }
    }

  private:
    static double
    component(const double stress, const unsigned int)
    {
      return stress;
    }
    template <int n>
    static double
    component(const dealii::Tensor<1, n> &stress, const unsigned int k)
    {
      return stress[k];
    }

    static void
    add(const double factor, const double *numbers, double &stress)
    {
      stress += factor * *numbers;
    }
    template <int n>
    static void
    add(const double          factor,
        const double         *numbers,
        dealii::Tensor<1, n> &stress)
    {
      for (unsigned int k = 0; k < n_components; ++k)
        stress[k] += factor * numbers[k];
    }
  };
} // namespace Biface

#endif
