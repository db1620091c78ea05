// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_solver_condensed_contact_h
#define biface_solver_condensed_contact_h

#include <deal.II/lac/full_matrix.h>

#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <biface/base/linear_algebra.h>
#include <biface/contact/active_set.h>
#include <biface/model/contact/contact_constraints.h>
#include <biface/model/equations/equation_system.h>
#include <biface/solver/linear/linear_solver.h>

namespace Biface
{
  /**
   * The contact without friction at a few points that come and go, condensed
   * out of a system whose matrix @f$\mathbf K@f$ was factorized without them.
   *
   * With the forces @f$\mathbf A@f$ of unit multipliers at the points and the
   * gradients @f$\mathbf G@f$ of their motions into the bodies, see
   * ContactConstraint, the tangent with these points in contact is
   * @f$\mathbf K+\mathbf A\varepsilon\mathbf G^T@f$. The multipliers satisfy
   * @f[
   *   (\mathbf C+\mathbf I/\varepsilon)\,\boldsymbol\lambda =
   *   \mathbf c-\mathbf G^T\mathbf K^{-1}\mathbf r,
   *   \quad\mathbf C=\mathbf G^T\mathbf K^{-1}\mathbf A,
   * @f]
   * with the clearances @f$\mathbf c@f$ and the residual @f$\mathbf r@f$
   * without the points. Points that enter or leave thus need no new factors
   * (the Woodbury formula @cite GolubVanLoan2013), and which of them touch is a
   * problem of few unknowns.
   *
   * A point that leaves must not be in contact in the matrix of the factors:
   * the response to a force at a point on a stiff spring has too few digits of
   * what the shell alone would do.
   */
  class CondensedContact
  {
  public:
    /** Start without factors and points. The objects are kept by reference. */
    CondensedContact(const EquationSystem     &equations,
                     const ContactInteraction &contact,
                     LinearSolver             &solver);

    /** Forget the points: the linear solver has factors of the tangent with the
     * present active set. */
    void
    restart(const State &state);

    /** Whether there is room for more points: for not more than 64 in all. */
    bool
    has_room_for(const std::vector<ContactPoint> &added) const
    {
      return points.size() + added.size() <= max_points;
    }

    /** Add points with their present normals, and return which of all added
     * points touch according to the equations linearized at the state of the
     * factors, by the primal-dual active set method; see
     * ContactInteraction::active_points(). The tangent of the equations is that
     * of the factors. Must be called on all ranks.
     * @param residual that without the points.
     * @return none if there is no answer. */
    std::optional<ActiveSet>
    choose(const State                     &state,
           const Loads                     &loads,
           const std::vector<ContactPoint> &added,
           const LA::Vector                &residual);

    /** Turns solutions with the factors into nearly those with the present
     * active set, to which points that entered are added. Must be called on all
     * ranks.
     * @return none if that is not possible. */
    std::optional<LinearSolver::Correction>
    correction(const State &state, const Loads &loads);

    /** The number of negative eigenvalues of a symmetric tangent with the
     * present active set.
     * @param of_factors that of the matrix of the factors. */
    unsigned int
    n_negative(const unsigned int of_factors) const;

    /** The points in which two active sets differ. Must be called on all
     * ranks. */
    std::vector<ContactPoint>
    differences(const ActiveSet &one, const ActiveSet &other) const;

  private:
    // each takes a vector, and a part of the time of a solution
    static constexpr unsigned int max_points = 64;

    struct Point
    {
      std::vector<std::pair<unsigned int, double>> gradient;
      double                                       clearance = 0;
      double                                       stiffness = 0;
      /** The displacements @f$\mathbf K^{-1}@f$ times the forces of a unit
       * multiplier at the point (locally owned entries). */
      LA::Vector answer;
    };

    /** Add points.
     * @param system its right-hand side is replaced by the solution with the
     * factors; null for none.
     * @return whether this succeeded; not if they are too many. */
    bool
    add(const State                     &state,
        const Loads                     &loads,
        const std::vector<ContactPoint> &added,
        LA::Vector                      *system = nullptr);

    /** The points that touch, as a flag for each point, by the primal-dual
     * active set method; none if it does not converge.
     * @param clearances those that the shell would have without them. */
    std::optional<std::vector<char>>
    touching(const std::vector<double> &clearances) const;

    /** The derivative of the motion of a point into the body, on this rank, in
     * the direction of displacements. */
    static double
    motion(const Point &point, const LA::Vector &displacement);

    /** The matrix @f$\mathbf C+\mathbf I/\varepsilon@f$ of some of the
     * points. */
    dealii::FullMatrix<double>
    compliance_of(const std::vector<unsigned int> &selected) const;

    const EquationSystem           &equations;
    const ContactInteraction       &contact;
    LinearSolver                   &solver;
    const std::vector<ContactPoint> all_points;

    /** The active set in the matrix of the factors, if there are any. */
    std::optional<ActiveSet> base;
    /** The points added since restart(), shared with corrections. */
    std::vector<std::shared_ptr<const Point>> points;
    std::map<ContactPoint, unsigned int>      positions;
    /** The matrix C, row by row, for all points. */
    std::vector<std::vector<double>> compliance;
    /** The positions of the points in contact at present. */
    std::vector<unsigned int> in_contact;
  };
} // namespace Biface

#endif
