// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>
#include <deal.II/lac/exceptions.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/lapack_full_matrix.h>
#include <deal.II/lac/vector.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <biface/stepping/controls/resultant_equations.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    std::vector<LoadRates>
    rates_of(const ControlledResultants &resultants)
    {
      std::vector<LoadRates> rates;
      for (const auto &resultant : resultants)
        rates.push_back(resultant->rate());
      return rates;
    }


    /** Solve a small linear system; the solution is not finite if there is
     * none. */
    std::vector<double>
    solve(LAPACKFullMatrix<double> &matrix, Vector<double> &rhs)
    {
      try
        {
          matrix.compute_lu_factorization();
        }
      catch (const LACExceptions::ExcSingular &)
        {
          return std::vector<double>(rhs.size(),
                                     std::numeric_limits<double>::quiet_NaN());
        }
      matrix.solve(rhs);
      return std::vector<double>(rhs.begin(), rhs.end());
    }


    /** The part of the sum of absolute values that round-off may leave of
     * forces that cancel, where the shell follows its supports as a rigid body.
     */
    constexpr double roundoff = 1e-11;


    /** The round-off in the derivative of a resultant by a load. Must be called
     * on all ranks.
     * @param dV_q the displacements per unit of the load.
     * @param per_load the derivative at fixed displacements. */
    double
    noise(const LinearizedResultant &resultant,
          const LA::Vector          &dV_q,
          const double               per_load)
    {
      double absolute = 0;
      for (const auto i : dV_q.locally_owned_elements())
        absolute += std::abs(resultant.gradient(i) * dV_q(i));
      absolute = Utilities::MPI::sum(absolute, dV_q.get_mpi_communicator());
      return roundoff * (absolute + std::abs(per_load));
    }


    /** Whether a resultant depends on its load by more than round-off. */
    bool
    depends_on(const ControlledResultant         &resultant,
               const ControlEquations::Iteration &iteration,
               const LA::Vector                  &dV_q)
    {
      const LinearizedResultant now =
        resultant.evaluate(iteration, {resultant.rate()});
      const double per_load = now.per_load[0];
      return std::abs(now.gradient * dV_q + per_load) >
             noise(now, dV_q, per_load);
    }


    /** Whether a matrix is singular if its entries have errors up to those
     * given. */
    bool
    is_singular(const FullMatrix<double> &matrix,
                const FullMatrix<double> &errors)
    {
      // rows and columns have units of their own
      const unsigned int  n = matrix.m();
      std::vector<double> rows(n), columns(n);
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j < n; ++j)
          rows[i] = std::max(rows[i], std::abs(matrix(i, j)));
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j < n; ++j)
          if (rows[i] > 0)
            columns[j] = std::max(columns[j], std::abs(matrix(i, j)) / rows[i]);
      LAPACKFullMatrix<double> scaled(n);
      double                   error = 0;
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j < n; ++j)
          {
            const double scale = rows[i] * columns[j];
            if (scale == 0)
              return true;
            scaled(i, j) = matrix(i, j) / scale;
            error        = std::max(error, errors(i, j) / scale);
          }
      scaled.compute_svd();
      return scaled.singular_value(n - 1) <= n * error;
    }
  } // namespace


  void
  check(const ControlledResultants &resultants,
        const std::string          &section,
        const ShellMesh            &mesh)
  {
    for (const auto &resultant : resultants)
      resultant->check_mesh(section, mesh);
  }


  LoadParameters
  found_loads(const ControlledResultants &resultants, const LoadLevel &level)
  {
    LoadLevel      from = level;
    LoadParameters values;
    for (const auto &resultant : resultants)
      values.push_back(resultant->load(from));
    return values;
  }


  LoadLevel
  with_found_loads(const ControlledResultants &resultants,
                   const LoadLevel            &level,
                   const LoadParameters       &values)
  {
    LoadLevel result = level;
    for (unsigned int i = 0; i < resultants.size(); ++i)
      resultants[i]->load(result) = values[i];
    return result;
  }


  Control::KnownStart
  without_found_loads(const ControlledResultants &resultants,
                      const Control::KnownStart  &end)
  {
    Control::KnownStart result = end;
    for (const auto &resultant : resultants)
      resultant->known_load(result).reset();
    return result;
  }


  ResultantEquations::ResultantEquations(const ControlledResultants &resultants,
                                         const std::vector<double>  &values,
                                         const ContactInteraction   *contact)
    : ControlEquations(rates_of(resultants))
    , resultants(resultants)
    , values(values)
    , contact(contact)
  {}


  LoadedShell
  ResultantEquations::with_contact(const LoadedShell &shell) const
  {
    return {shell.equations,
            contact ? *contact : shell.contact,
            shell.state,
            shell.loads};
  }


  LoadParameters
  ResultantEquations::parameter_changes(
    const Iteration               &iteration,
    const LA::Vector              &dV_R,
    const std::vector<LA::Vector> &dV_q) const
  {
    // out of contact a resultant and its derivatives vanish, and the system
    // is singular: first this load alone moves
    const unsigned int n = resultants.size();
    for (unsigned int i = 0; i < n; ++i)
      if (const auto change =
            resultants[i]->change_into_contact(values[i], iteration);
          change && !(resultants[i]->is_held_elsewhere() &&
                      depends_on(*resultants[i], iteration, dV_q[i])))
        {
          LoadParameters changes(n);
          changes[i] = *change;
          return changes;
        }

    LoadParameters changes =
      parameter_changes_about(iteration, iteration, dV_R, dV_q);
    // all changes are shortened alike, to keep the direction of the linear
    // solution
    double part = 1;
    for (unsigned int i = 0; i < n; ++i)
      if (std::isfinite(changes[i]))
        part = std::min(part,
                        resultants[i]->largest_change() / std::abs(changes[i]));
    for (double &change : changes)
      change *= part;
    return changes;
  }


  LoadParameters
  ResultantEquations::parameter_changes_about(
    const Iteration               &about,
    const Iteration               &iteration,
    const LA::Vector              &dV_R,
    const std::vector<LA::Vector> &dV_q) const
  {
    // the system of section 7, with a row for each resultant and a column
    // for each unknown load
    // of the forces that cancel in a resultant
    constexpr double   negligible = 1e-9;
    const unsigned int n          = resultants.size();
    FullMatrix<double> matrix(n, n), errors(n, n);
    Vector<double>     missing(n);
    // supports that move together, without contact, leave nothing but round-off
    const bool may_be_singular =
      n > 1 &&
      std::any_of(resultants.begin(), resultants.end(), [](const auto &item) {
        return item->is_held_elsewhere();
      });
    for (unsigned int i = 0; i < n; ++i)
      {
        const LinearizedResultant linear =
          resultants[i]->evaluate(with_contact(about), rates);
        // derivatives are those of 'about', what is missing that of the
        // iterate
        const double now =
          (&about == &iteration
             ? linear.value
             : resultants[i]->evaluate(with_contact(iteration), {}).value);
        missing[i] = values[i] - now - linear.gradient * dV_R;
        for (unsigned int j = 0; j < n; ++j)
          {
            matrix(i, j) = linear.gradient * dV_q[j] + linear.per_load[j];
            if (may_be_singular)
              errors(i, j) = noise(linear, dV_q[j], linear.per_load[j]);
          }
        // a body without force that touches nothing stays where it is
        if (values[i] == 0 && linear.magnitude == 0 && matrix(i, i) == 0)
          matrix(i, i) = 1;
        // and so do supports that nothing holds
        if (values[i] == 0 && resultants[i]->is_held_elsewhere() &&
            std::abs(missing[i]) <= negligible * linear.magnitude &&
            std::abs(matrix(i, i)) <=
              noise(linear, dV_q[i], linear.per_load[i]))
          {
            for (unsigned int j = 0; j < n; ++j)
              matrix(i, j) = errors(i, j) = (i == j ? 1. : 0.);
            errors(i, i) = missing[i] = 0;
          }
      }
    if (may_be_singular && is_singular(matrix, errors))
      return LoadParameters(n, std::numeric_limits<double>::quiet_NaN());
    LAPACKFullMatrix<double> factors(n);
    factors = matrix;
    return solve(factors, missing);
  }


  std::string
  ResultantEquations::remedies() const
  {
    std::string text;
    for (const auto &resultant : resultants)
      text += (text.empty() ? "" : "; ") + resultant->remedies();
    return text;
  }


  double
  ResultantEquations::violation(const Iteration &iteration) const
  {
    double largest = 0;
    for (unsigned int i = 0; i < resultants.size(); ++i)
      {
        const LinearizedResultant now =
          resultants[i]->evaluate(with_contact(iteration), {});
        // also where the scale is 0, as of nothing that touches
        if (now.value == values[i])
          continue;
        const double relative = std::abs(now.value - values[i]) /
                                resultants[i]->scale(values[i], now, iteration);
        // not a number is none
        largest = (relative <= largest ? largest : relative);
      }
    return largest;
  }
} // namespace Biface
