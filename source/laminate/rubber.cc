// SPDX-License-Identifier: LGPL-2.1-or-later

#include <array>
#include <cmath>

#include <biface/laminate/principal_axes.h>
#include <biface/laminate/rubber.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    /** The components of C = 1 + 2E in the order of PointStrains, shear
     * components not doubled. */
    MaterialLaw::Vector
    cauchy_green(const MaterialLaw::Vector &E)
    {
      MaterialLaw::Vector C = E;
      for (const unsigned int i : {0, 1, 5})
        C[i] = 1 + 2 * E[i];
      return C;
    }


    /** The derivatives of C_i by the strain i. */
    constexpr std::array<double, 6> dC{{2, 2, 1, 1, 1, 2}};


    /** @f$\det\mathbf C=dC_{33}-s@f$ */
    struct Determinant
    {
      double d, s;

      explicit Determinant(const MaterialLaw::Vector &C)
        : d(C[0] * C[1] - C[2] * C[2])
        , s(C[1] * C[3] * C[3] + C[0] * C[4] * C[4] - 2 * C[2] * C[3] * C[4])
      {}
    };
  } // namespace


  double
  Rubber::free_thickness_strain(const Vector &strain) const
  {
    const Determinant det(cauchy_green(strain));
    // of det C = 1: rubber hardly changes its volume, so that this is a good
    // start for Newton's method
    return ((1 + det.s) / det.d - 1) / 2;
  }


  double
  Rubber::lowest_thickness_strain(const Vector &strain) const
  {
    const Determinant det(cauchy_green(strain));
    // the strain at which the volume vanishes
    return det.d > 0 ? (det.s / det.d - 1) / 2 : PointStrains::none;
  }


  RubberOfInvariants::Invariants
  RubberOfInvariants::invariants(const Vector &E)
  {
    // without the cancellation of C - 1
    const double x = 2 * E[0], y = 2 * E[1], z = 2 * E[5];
    const double p = E[2] * E[2], q = E[3] * E[3], r = E[4] * E[4];
    const double squares = x * y + y * z + z * x - p - q - r;
    return {x + y + z,
            2 * (x + y + z) + squares,
            x + y + z + squares + x * y * z + 2 * E[2] * E[3] * E[4] - x * r -
              y * q - z * p};
  }


  double
  RubberOfInvariants::energy(const Vector &strain) const
  {
    const Invariants i = invariants(strain);
    return i.i_3 > -1 ? energy_of(i) : PointStrains::none;
  }


  void
  RubberOfInvariants::evaluate(const Vector &strain,
                               Vector       &stress,
                               Matrix       &moduli) const
  {
    const Invariants i = invariants(strain);
    const Vector     C = cauchy_green(strain);
    if (!(i.i_3 > -1))
      {
        for (unsigned int k = 0; k < 6; ++k)
          {
            stress[k] = PointStrains::none;
            for (unsigned int l = 0; l < 6; ++l)
              moduli[k][l] = PointStrains::none;
          }
        return;
      }
    const Derivatives W = derivatives_at(i);

    // the derivatives of the invariants by C
    const std::array<std::array<double, 6>, 3> g{
      {{{1, 1, 0, 0, 0, 1}},
       {{C[1] + C[5],
         C[0] + C[5],
         -2 * C[2],
         -2 * C[3],
         -2 * C[4],
         C[0] + C[1]}},
       {{C[1] * C[5] - C[4] * C[4],
         C[0] * C[5] - C[3] * C[3],
         2 * (C[3] * C[4] - C[5] * C[2]),
         2 * (C[2] * C[4] - C[1] * C[3]),
         2 * (C[2] * C[3] - C[0] * C[4]),
         C[0] * C[1] - C[2] * C[2]}}}};

    for (unsigned int k = 0; k < 6; ++k)
      stress[k] = dC[k] * (W.first[0] * g[0][k] + W.first[1] * g[1][k] +
                           W.first[2] * g[2][k]);

    std::array<std::array<double, 6>, 6> second;
    for (unsigned int k = 0; k < 6; ++k)
      {
        std::array<double, 3> by;
        for (unsigned int m = 0; m < 3; ++m)
          by[m] = W.second[m][0] * g[0][k] + W.second[m][1] * g[1][k] +
                  W.second[m][2] * g[2][k];
        for (unsigned int l = k; l < 6; ++l)
          second[k][l] = by[0] * g[0][l] + by[1] * g[1][l] + by[2] * g[2][l];
      }
    // the second derivatives of the invariants
    const double w_2 = W.first[1], w_3 = W.first[2];
    second[0][1] += w_2 + w_3 * C[5];
    second[0][5] += w_2 + w_3 * C[1];
    second[1][5] += w_2 + w_3 * C[0];
    second[2][2] -= 2 * (w_2 + w_3 * C[5]);
    second[3][3] -= 2 * (w_2 + w_3 * C[1]);
    second[4][4] -= 2 * (w_2 + w_3 * C[0]);
    second[0][4] -= 2 * w_3 * C[4];
    second[1][3] -= 2 * w_3 * C[3];
    second[2][5] -= 2 * w_3 * C[2];
    second[2][3] += 2 * w_3 * C[4];
    second[2][4] += 2 * w_3 * C[3];
    second[3][4] += 2 * w_3 * C[2];
    for (unsigned int k = 0; k < 6; ++k)
      for (unsigned int l = k; l < 6; ++l)
        moduli[k][l] = moduli[l][k] = dC[k] * dC[l] * second[k][l];
  }


  MaterialLaw::ThicknessStress
  RubberOfInvariants::thickness_stress(const Vector &strain) const
  {
    const Invariants i = invariants(strain);
    if (!(i.i_3 > -1))
      return {PointStrains::none, PointStrains::none};
    // all invariants are linear in C_33: their derivatives are constant, and
    // the modulus is that of the energy alone
    const Vector       C = cauchy_green(strain);
    const Derivatives  W = derivatives_at(i);
    const Tensor<1, 3> g({1, C[0] + C[1], Determinant(C).d});
    return {2 * (W.first * g), 4 * (g * (W.second * g))};
  }


  NeoHooke::NeoHooke(const double mu, const double K)
    : mu(mu), lambda(K - 2. / 3 * mu)
  {}


  double
  NeoHooke::energy_of(const Invariants &i) const
  {
    // ln J is half of the logarithm of I_3, and U = (I_3 - 1 - ln I_3)/2
    const double log = std::log1p(i.i_3);
    return mu / 2 * (i.i_1 - log) + lambda / 4 * (i.i_3 - log);
  }


  RubberOfInvariants::Derivatives
  NeoHooke::derivatives_at(const Invariants &i) const
  {
    const double I_3 = 1 + i.i_3;
    Derivatives  W;
    W.first[0]     = mu / 2;
    W.first[2]     = (lambda / 4 * i.i_3 - mu / 2) / I_3;
    W.second[2][2] = (mu / 2 + lambda / 4) / (I_3 * I_3);
    return W;
  }


  PolynomialRubber::PolynomialRubber(const std::array<double, 3> &c,
                                     const double                 c_01,
                                     const double                 K)
    : c(c), c_01(c_01), K(K)
  {}


  namespace
  {
    /** @f$(1+x)^{-p/3}-1@f$ without cancellation. */
    double
    power_less_one(const double x, const double p)
    {
      return std::expm1(-p / 3 * std::log1p(x));
    }
  } // namespace


  double
  PolynomialRubber::energy_of(const Invariants &i) const
  {
    const double a = power_less_one(i.i_3, 1), b = power_less_one(i.i_3, 2);
    // the invariants with bars, less 3
    const double x = i.i_1 + a * (3 + i.i_1), y = i.i_2 + b * (3 + i.i_2);
    return x * (c[0] + x * (c[1] + x * c[2])) + c_01 * y +
           K / 4 * (i.i_3 - std::log1p(i.i_3));
  }


  RubberOfInvariants::Derivatives
  PolynomialRubber::derivatives_at(const Invariants &i) const
  {
    const double I_1 = 3 + i.i_1, I_2 = 3 + i.i_2, I_3 = 1 + i.i_3;
    const double a = 1 + power_less_one(i.i_3, 1), b = a * a;
    // x is the first invariant without the change of volume, less 3; P and P_x
    // are the derivatives of the polynomial
    const double x   = i.i_1 + (a - 1) * I_1;
    const double P   = c[0] + x * (2 * c[1] + 3 * x * c[2]);
    const double P_x = 2 * c[1] + 6 * x * c[2];

    // a_3, b_3, a_33, b_33: the derivatives of the powers by I_3
    const double a_3 = -a / (3 * I_3), b_3 = -2 * b / (3 * I_3);
    const double a_33 = 4 * a / (9 * I_3 * I_3);
    const double b_33 = 10 * b / (9 * I_3 * I_3);

    Derivatives W;
    W.first[0]     = P * a;
    W.first[1]     = c_01 * b;
    W.first[2]     = P * a_3 * I_1 + c_01 * b_3 * I_2 + K / 4 * i.i_3 / I_3;
    W.second[0][0] = P_x * a * a;
    W.second[0][2] = P_x * a * a_3 * I_1 + P * a_3;
    W.second[1][2] = c_01 * b_3;
    W.second[2][2] = P_x * a_3 * a_3 * I_1 * I_1 + P * a_33 * I_1 +
                     c_01 * b_33 * I_2 + K / 4 / (I_3 * I_3);
    return W;
  }


  OgdenRubber::OgdenRubber(const std::vector<Term> &terms, const double K)
    : terms(terms), K(K)
  {}


  namespace
  {
    /** The principal axes of C, and the logarithms of the stretches. */
    struct PrincipalStretches
    {
      std::array<Tensor<1, 3>, 3> axes;
      std::array<double, 3>       log{};
      double                      log_J;
      bool                        valid = true;

      explicit PrincipalStretches(const MaterialLaw::Vector &strain)
      {
        const SymmetricTensor<2, 3> E      = PointStrains::to_strain(strain);
        bool                        finite = true;
        for (unsigned int i = 0; i < 6; ++i)
          finite = finite && std::isfinite(strain[i]);
        if (!finite)
          {
            valid = false;
            return;
          }
        const auto principal = principal_axes(E);
        log_J                = 0;
        for (unsigned int A = 0; A < 3; ++A)
          {
            axes[A] = principal[A].direction;
            valid   = valid && principal[A].value > -0.5;
            log[A]  = valid ? std::log1p(2 * principal[A].value) / 2
                            : PointStrains::none;
            log_J += log[A];
          }
      }
    };
  } // namespace


  double
  OgdenRubber::energy(const Vector &strain) const
  {
    const PrincipalStretches at(strain);
    if (!at.valid)
      return PointStrains::none;
    // expm1 of the logarithms keeps the digits of small strains
    double sum = K / 4 * (std::expm1(2 * at.log_J) - 2 * at.log_J);
    for (const Term &term : terms)
      for (unsigned int A = 0; A < 3; ++A)
        sum += term.mu / term.alpha *
               std::expm1(term.alpha * (at.log[A] - at.log_J / 3));
    return sum;
  }


  void
  OgdenRubber::evaluate(const Vector &strain,
                        Vector       &stress,
                        Matrix       &moduli) const
  {
    const PrincipalStretches at(strain);
    if (!at.valid)
      {
        for (unsigned int k = 0; k < 6; ++k)
          {
            stress[k] = PointStrains::none;
            for (unsigned int l = 0; l < 6; ++l)
              moduli[k][l] = PointStrains::none;
          }
        return;
      }

    // the derivatives of the energy by the logarithms of the stretches
    std::array<double, 3>                first;
    std::array<std::array<double, 3>, 3> second{};
    const double                         J_squared = std::exp(2 * at.log_J);
    first.fill(K / 2 * std::expm1(2 * at.log_J));
    for (auto &row : second)
      row.fill(K * J_squared);
    for (const Term &term : terms)
      {
        // the terms depend on log(lambda_A/J^{1/3}), whose derivatives by
        // log(lambda_B) are 1 and 0, less a third
        std::array<double, 3> x;
        double                sum = 0, excess = 0;
        for (unsigned int A = 0; A < 3; ++A)
          {
            const double y =
              std::expm1(term.alpha * (at.log[A] - at.log_J / 3));
            x[A] = 1 + y;
            sum += x[A];
            excess += y;
          }
        for (unsigned int A = 0; A < 3; ++A)
          {
            first[A] += term.mu * (x[A] - 1 - excess / 3);
            second[A][A] += term.mu * term.alpha * x[A];
            for (unsigned int B = 0; B < 3; ++B)
              second[A][B] +=
                term.mu * term.alpha * (sum / 9 - (x[A] + x[B]) / 3);
          }
      }

    // C_A = exp(2 log_A): S_A = first_A / C_A
    std::array<double, 3> C, S;
    for (unsigned int A = 0; A < 3; ++A)
      {
        C[A] = std::exp(2 * at.log[A]);
        S[A] = first[A] / C[A];
      }
    // dyads of the axes, as stresses and as factors of strains
    const auto dyad = [&](const unsigned int A, const unsigned int B) {
      Vector result;
      for (unsigned int k = 0; k < 6; ++k)
        {
          const unsigned int i = PointStrains::pairs[k][0],
                             j = PointStrains::pairs[k][1];
          result[k] =
            (at.axes[A][i] * at.axes[B][j] + at.axes[A][j] * at.axes[B][i]) / 2;
        }
      return result;
    };
    std::array<std::array<Vector, 3>, 3> N;
    for (unsigned int A = 0; A < 3; ++A)
      for (unsigned int B = 0; B < 3; ++B)
        N[A][B] = dyad(A, B);
    stress = Vector();
    moduli = Matrix();
    for (unsigned int A = 0; A < 3; ++A)
      {
        stress += S[A] * N[A][A];
        for (unsigned int B = 0; B < 3; ++B)
          {
            // dS_A/dE_B with E_B = (C_B - 1)/2
            const double by_stretch =
              (second[A][B] - (A == B ? 2 * first[A] : 0)) / (C[A] * C[B]);
            for (unsigned int k = 0; k < 6; ++k)
              for (unsigned int l = 0; l < 6; ++l)
                moduli[k][l] += by_stretch * N[A][A][k] * N[B][B][l];
            if (A == B)
              continue;
            // (S_A - S_B)/(E_A - E_B), or its limit
            // a shear strain turns the principal axes, and with them the
            // stresses
            const double apart = (C[A] - C[B]) / 2;
            const double by_turn =
              std::abs(apart) > 1e-6 * C[A]
                ? (S[A] - S[B]) / apart
                : (second[A][A] - second[A][B] - 2 * first[A]) / (C[A] * C[A]);
            for (unsigned int k = 0; k < 6; ++k)
              for (unsigned int l = 0; l < 6; ++l)
                moduli[k][l] += by_turn * N[A][B][k] * N[A][B][l];
          }
      }
  }


  MaterialLaw::ThicknessStress
  OgdenRubber::thickness_stress(const Vector &strain) const
  {
    Vector stress;
    Matrix moduli;
    evaluate(strain, stress, moduli);
    return {stress[PointStrains::thickness],
            moduli[PointStrains::thickness][PointStrains::thickness]};
  }
} // namespace Biface
