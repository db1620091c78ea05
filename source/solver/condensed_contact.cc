// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>
#include <deal.II/lac/lapack_full_matrix.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>

#include <biface/base/gather.h>
#include <biface/model/contact/contact_interaction.h>
#include <biface/solver/condensed_contact.h>

namespace Biface
{
  using namespace dealii;

  CondensedContact::CondensedContact(const EquationSystem     &equations,
                                     const ContactInteraction &contact,
                                     LinearSolver             &solver)
    : equations(equations)
    , contact(contact)
    , solver(solver)
    , all_points(contact_points(contact))
  {}


  void
  CondensedContact::restart(const State &state)
  {
    base = contact.active_points(state);
    points.clear();
    positions.clear();
    compliance.clear();
    in_contact.clear();
  }


  std::vector<ContactPoint>
  CondensedContact::differences(const ActiveSet &one,
                                const ActiveSet &other) const
  {
    AssertDimension(one.size(), all_points.size());
    AssertDimension(other.size(), all_points.size());
    std::vector<ContactPoint> mine;
    for (unsigned int i = 0; i < one.size(); ++i)
      if (one[i] != other[i])
        mine.push_back(all_points[i]);
    std::vector<ContactPoint> all;
    for (const auto &part : gather_on_all(equations.mesh.communicator, mine))
      all.insert(all.end(), part.begin(), part.end());
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
  }


  double
  CondensedContact::motion(const Point &point, const LA::Vector &displacement)
  {
    double result = 0;
    for (const auto &[entry, derivative] : point.gradient)
      result += derivative * displacement.begin()[entry];
    return result;
  }


  bool
  CondensedContact::add(const State                     &state,
                        const Loads                     &loads,
                        const std::vector<ContactPoint> &added,
                        LA::Vector                      *system)
  {
    if (!has_room_for(added))
      return false;
    std::vector<ContactConstraint> units =
      contact_constraints(contact, state, loads, added);
    // all right hand sides at once: a direct solver reads its factors once
    std::vector<LA::Vector> answers, forces;
    for (ContactConstraint &unit : units)
      {
        answers.push_back(equations.mesh.owned_vector());
        forces.push_back(std::move(unit.forces));
      }
    if (system)
      {
        answers.push_back(equations.mesh.owned_vector());
        forces.push_back(*system);
      }
    if (!solver.solve_by_factors(answers, forces))
      return false;
    if (system)
      system->swap(answers.back());
    const unsigned int n_old = points.size(), n = n_old + added.size();
    for (unsigned int k = 0; k < added.size(); ++k)
      {
        positions[added[k]] = points.size();
        const auto point    = std::make_shared<Point>();
        point->gradient     = std::move(units[k].gradient);
        point->clearance    = units[k].clearance;
        point->stiffness    = units[k].stiffness;
        point->answer.swap(answers[k]);
        points.push_back(point);
      }

    // only the new rows and columns of C, with one reduction for all
    compliance.resize(n);
    std::vector<double> motions;
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = compliance[i].size(); j < n; ++j)
        motions.push_back(motion(*points[i], points[j]->answer));
    Utilities::MPI::sum(motions, equations.mesh.communicator, motions);
    auto next = motions.begin();
    for (std::vector<double> &row : compliance)
      while (row.size() < n)
        row.push_back(*next++);
    return std::all_of(motions.begin(), motions.end(), [](const double c) {
      return std::isfinite(c);
    });
  }


  FullMatrix<double>
  CondensedContact::compliance_of(
    const std::vector<unsigned int> &selected) const
  {
    FullMatrix<double> matrix(selected.size());
    for (unsigned int i = 0; i < selected.size(); ++i)
      {
        for (unsigned int j = 0; j < selected.size(); ++j)
          matrix(i, j) = compliance[selected[i]][selected[j]];
        matrix(i, i) += 1 / points[selected[i]]->stiffness;
      }
    return matrix;
  }


  std::optional<ActiveSet>
  CondensedContact::choose(const State                     &state,
                           const Loads                     &loads,
                           const std::vector<ContactPoint> &added,
                           const LA::Vector                &residual)
  {
    // beyond it, the shell is not held without the points
    constexpr double maximum_error = 1e-2;

    LA::Vector         x(residual), error(residual);
    const SystemMatrix matrix{equations.tangent(), LinearSystem::original};
    if (!add(state, loads, added, &x) ||
        !(matrix.residual(error, x, residual) <=
          maximum_error * residual.l2_norm()))
      return {};
    std::vector<double> clearances;
    for (const auto &point : points)
      clearances.push_back(-motion(*point, x));
    Utilities::MPI::sum(clearances, equations.mesh.communicator, clearances);
    for (unsigned int i = 0; i < points.size(); ++i)
      {
        clearances[i] += points[i]->clearance;
        // an unstable shell moves against a force
        if (!(compliance[i][i] > 0))
          return {};
      }
    const auto active = touching(clearances);
    if (!active)
      return {};
    ActiveSet result(all_points.size(), 0);
    for (unsigned int i = 0; i < result.size(); ++i)
      if (const auto at = positions.find(all_points[i]); at != positions.end())
        result[i] = (*active)[at->second];
    return result;
  }


  std::optional<std::vector<char>>
  CondensedContact::touching(const std::vector<double> &clearances) const
  {
    // then one point at a time, which may be slow but cannot cycle if the
    // compliance is a P-matrix
    constexpr unsigned int all_at_once = 10;

    const unsigned int n = points.size();
    std::vector<char>  active;
    for (const double clearance : clearances)
      active.push_back(clearance < 0);
    for (unsigned int iteration = 0; iteration < all_at_once + 2 * n;
         ++iteration)
      {
        std::vector<unsigned int> selected;
        for (unsigned int i = 0; i < n; ++i)
          if (active[i])
            selected.push_back(i);
        // a contact problem of few unknowns, to which the active set method of
        // the shell is applied
        FullMatrix<double> inverse = compliance_of(selected);
        if (!invert(inverse))
          return {};
        Vector<double> free(selected.size()), multipliers(selected.size());
        for (unsigned int i = 0; i < selected.size(); ++i)
          free[i] = clearances[selected[i]];
        if (!selected.empty())
          inverse.vmult(multipliers, free);

        std::vector<char> next;
        for (unsigned int i = 0; i < n; ++i)
          {
            double clearance = clearances[i];
            for (unsigned int j = 0; j < selected.size(); ++j)
              clearance -= compliance[i][selected[j]] * multipliers[j];
            next.push_back(clearance < 0);
          }
        for (unsigned int j = 0; j < selected.size(); ++j)
          next[selected[j]] = multipliers[j] < 0;
        if (next == active)
          return active;
        if (iteration < all_at_once)
          active = next;
        else
          {
            const unsigned int first =
              std::mismatch(active.begin(), active.end(), next.begin()).first -
              active.begin();
            active[first] = next[first];
          }
      }
    return {};
  }


  std::optional<LinearSolver::Correction>
  CondensedContact::correction(const State &state, const Loads &loads)
  {
    in_contact.clear();
    if (!base)
      return {};
    // a point that leaves has its spring in the factors, beside which they do
    // not know the shell well enough, section 7 of doc/theory.md
    const ActiveSet active = contact.active_points(state);
    bool            left   = false;
    for (unsigned int i = 0; i < active.size(); ++i)
      left = left || ((*base)[i] && !active[i]);
    if (Utilities::MPI::logical_or(left, equations.mesh.communicator))
      return {};
    const std::vector<ContactPoint> entered = differences(active, *base);
    if (entered.empty())
      return LinearSolver::Correction();

    std::vector<ContactPoint> added;
    for (const ContactPoint &point : entered)
      if (positions.count(point) == 0)
        added.push_back(point);
    if (!added.empty() && !add(state, loads, added))
      return {};
    std::vector<unsigned int> selected;
    for (const ContactPoint &point : entered)
      selected.push_back(positions.at(point));
    const auto inverse =
      std::make_shared<FullMatrix<double>>(compliance_of(selected));
    if (!invert(*inverse))
      return {};
    in_contact = selected;
    std::vector<std::shared_ptr<const Point>> touching;
    for (const unsigned int i : selected)
      touching.push_back(points[i]);
    const MPI_Comm communicator = equations.mesh.communicator;
    // the correction outlives this call and later points: it keeps what it
    // needs
    return [touching, inverse, communicator](LA::Vector &x) {
      std::vector<double> motions;
      for (const auto &point : touching)
        motions.push_back(motion(*point, x));
      Utilities::MPI::sum(motions, communicator, motions);
      Vector<double> of_points(motions.begin(), motions.end()),
        multipliers(motions.size());
      inverse->vmult(multipliers, of_points);
      for (unsigned int i = 0; i < touching.size(); ++i)
        x.add(-multipliers[i], touching[i]->answer);
    };
  }


  unsigned int
  CondensedContact::n_negative(const unsigned int of_factors) const
  {
    // The matrix of displacements and multipliers has the negative eigenvalues
    // of the tangent and of -1/epsilon, and those of the factors and of the
    // compliance with the opposite sign.
    // The eigenvalues are real: the compliance is that of a symmetric tangent
    // times the areas of the points.
    unsigned int n_lost = 0;
    if (!in_contact.empty())
      {
        LAPACKFullMatrix<double> matrix(in_contact.size());
        matrix = compliance_of(in_contact);
        matrix.compute_eigenvalues();
        for (unsigned int i = 0; i < in_contact.size(); ++i)
          if (matrix.eigenvalue(i).real() < 0)
            ++n_lost;
      }
    return of_factors - std::min(n_lost, of_factors);
  }
} // namespace Biface
