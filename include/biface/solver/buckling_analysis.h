// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_solver_buckling_analysis_h
#define biface_solver_buckling_analysis_h

#include <deal.II/base/timer.h>

#include <optional>
#include <string>
#include <vector>

#include <biface/base/linear_algebra.h>
#include <biface/model/mesh/wave_numbers.h>
#include <biface/solver/fixed_contact_tangent.h>
#include <biface/solver/linear/eigenpairs.h>
#include <biface/solver/linear/linear_solver.h>

namespace Biface
{
  class ContactInteraction;
  struct LoadRates;
  struct Loads;
  class ShellEquations;
  struct State;


  /** A shape in which the shell buckles. */
  struct BucklingMode
  {
    /** The position s on the line of loads: 0 for the resultants and loads
     * before, 1 for those of the equilibrium. */
    double position = 0;

    /** The displacements @f$\boldsymbol\varphi@f$, with the entries of all
     * nodes of this rank; the largest displacement of a face is 1. */
    LA::Vector shape;

    /** The left eigenvector @f$\mathbf y@f$ with
     * @f$\mathbf y^T(\mathbf K_0-s\,\mathbf G)=\mathbf 0@f$, see
     * left_eigenpairs(), in the owned unknowns. Empty if it was not wanted or
     * does not exist. */
    Eigenpair left;

    /** The work of the change of the loads on the shape, relative to its work
     * on a motion of all nodes by the largest displacement: 0 at a bifurcation,
     * but not at a limit point. */
    double load_work = 0;

    /** The wave numbers of the shape, if the shell is a full turn. */
    std::optional<WaveNumbers> waves;
  };


  /** The result of an analysis of buckling. */
  struct BucklingModes
  {
    bool success = false;
    /** The reason of a failure, as part of a sentence. */
    std::string message;
    /** The rigid motions that nothing holds, which the shapes do not contain:
     * see FixedContactTangent::free_motions(). */
    std::vector<std::string> free_motions;
    /** The modes in ascending order of their positions. */
    std::vector<BucklingMode> modes;
  };


  /**
   * Linearized prediction of buckling from an equilibrium and the change of the
   * resultants and loads on the way to it, see section 9 of doc/theory.md: the
   * lowest @f$s>0@f$ with
   * @f$(\mathbf K_0-s\,\mathbf G)\boldsymbol\varphi=\mathbf 0@f$,
   * @f$\mathbf G=\mathbf K_0-\mathbf K_1@f$, where @f$\mathbf K_1@f$ is the
   * tangent of the equilibrium, see FixedContactTangent, and @f$\mathbf K_0@f$
   * that for the same displacements with the resultants and the loads before.
   * The tangent is linear in these, so that the line through both has no error
   * but that of frozen displacements. In linear strain theory, these are the
   * displacements about which the strains are linearized.
   *
   * Loads that follow from the displacements, such as the pressure of a sealed
   * gas, stiffen both tangents by their value in each, see LowRankStiffness.
   * The shapes are orthogonal to rigid motions that nothing holds, see
   * Deflation: they would meet no resistance but that by which interpolation
   * fails to carry them, and come first.
   *
   * If @f$\mathbf K_0@f$ is symmetric and the linear solver counts no negative
   * pivots, Lanczos' method works in the inner product of @f$\mathbf K_0@f$,
   * and a count of the pivots below the shift proves that no @f$s@f$ is
   * missed. Otherwise it is Arnoldi's method, which finds real @f$s@f$ only.
   */
  class BucklingAnalysis
  {
  public:
    /** The objects are kept by reference.
     * @param timer receives the section "Buckling". */
    BucklingAnalysis(ShellEquations           &equations,
                     const ContactInteraction &contact,
                     LinearSolver             &linear_solver,
                     dealii::TimerOutput      &timer);

    /** A converged state and its loads. */
    struct Equilibrium
    {
      const State &state;
      const Loads &loads;
    };

    /**
     * Compute the lowest shapes. The last assembly of the equations is lost.
     *
     * @param before an earlier equilibrium; its displacements do not matter.
     * @param now the equilibrium from which to predict.
     * @param rates the change of the given loads from one to the other, in any
     * unit.
     * @param n the number of shapes; there may be fewer.
     * @param with_left whether left eigenvectors are wanted, too.
     */
    BucklingModes
    compute(const Equilibrium &before,
            const Equilibrium &now,
            const LoadRates   &rates,
            const unsigned int n,
            const bool         with_left = false);

    /**
     * The positions s of buckling modes up to terms of second order, from the
     * right and left eigenvectors of a slightly different shell, see
     * rayleigh_quotients(); NaN without a left one. The last assembly of the
     * equations is lost.
     *
     * @param before, now see compute().
     * @param modes of the neighbor, whose degrees of freedom are the same.
     */
    std::vector<double>
    quotients(const Equilibrium               &before,
              const Equilibrium               &now,
              const std::vector<BucklingMode> &modes);

    /**
     * The number of negative pivots of the tangent, or of its symmetric part if
     * only loads make it unsymmetric, if the linear solver counts them.
     *
     * While the symmetric part is positive definite, the tangent is regular.
     * Its eigenvalues are those of the symmetric part up to the square of the
     * unsymmetric one, which is an error of the discretization if the loads
     * have a potential; critical_mode() tells whether they do. The last
     * assembly of the equations is lost.
     * @param often see LinearSolver::count_negative_pivots().
     */
    std::optional<unsigned int>
    count_negative_pivots(const Equilibrium &now, const bool often);

    /** The number of eigenvalues closest to zero among which critical_mode()
     * looks. If more change their sign at once, as where cells get too small,
     * their shapes have nothing in common. */
    static constexpr unsigned int n_candidates = 4;

    /** The shape of a critical point. */
    struct CriticalMode
    {
      /** The shape of the critical point; its position is not set. */
      BucklingMode mode;
      /** Whether the tangent is singular at the point as its symmetric part is,
       * up to 1 % of the loads. If not, the loads have no potential. */
      bool is_of_tangent = true;
    };

    /**
     * The shape of the eigenvalue of the tangent closest to zero. The last
     * assembly of the equations is lost.
     *
     * @param unstable whether it is a negative eigenvalue, if there is one.
     * @return none if it was not found.
     */
    std::optional<CriticalMode>
    critical_mode(const Equilibrium &now,
                  const LoadRates   &rates,
                  const bool         unstable);

  private:
    struct Pencil;

    void
    assemble(const Equilibrium &before, const Equilibrium &now, Pencil &pencil);

    /** Compute the tangent of one equilibrium. */
    bool
    assemble(const Equilibrium &now, LA::SparseMatrix &K);

    /** The stiffness in a shape of the shell without stresses and loads, which
     * these have taken away at a critical point, relative to the square of the
     * norm of the shape. */
    double
    softening(const Equilibrium &now, const LA::Vector &shape);

    /** The mode of an eigenvector, with all but its position. */
    BucklingMode
    finish(const LA::Vector &vector, const LA::Vector &loads) const;

    /** Prepare to solve systems with
     * @f$\mathbf K_0-\sigma\mathbf G@f$. */
    LinearSolverResult
    factorize(Pencil &pencil, const double shift);

    /** Solve a system with the shifted matrix, without its part of low rank and
     * without Deflation, on vectors that are orthogonal to the null space. */
    LinearSolverResult
    solve_pinned(const Pencil      &pencil,
                 LA::Vector        &x,
                 const LA::Vector  &b,
                 const LinearSystem system);

    /** Solve a system with @f$\mathbf K_0-\sigma\mathbf G@f$, or with its
     * transpose, on the vectors to which Deflation restricts it. */
    bool
    solve(const Pencil      &pencil,
          LA::Vector        &x,
          const LA::Vector  &b,
          const LinearSystem system = LinearSystem::original);

    /** An estimate of the lowest position s; not set if there is none. */
    std::optional<double>
    estimate_lowest(Pencil &pencil, BucklingModes &result);

    /** The next positions s above the shift, with right or left
     * eigenvectors. */
    Eigenpairs
    find_above_shift(Pencil            &pencil,
                     const unsigned int n,
                     const LinearSystem system = LinearSystem::original);

    /** The left eigenvectors of the pairs @p right, with the factors at hand.
     * @param n the number of eigenvalues among which they are sought. */
    std::vector<Eigenpair>
    find_left(Pencil                       &pencil,
              const std::vector<Eigenpair> &right,
              const unsigned int            n);

    /** Keep the pairs with a real positive eigenvalue, in whose shapes the
     * loads soften the shell. */
    void
    keep_buckling(const Pencil &pencil, std::vector<Eigenpair> &pairs) const;

    /** Whether the loads soften the shell in a shape by more than round-off. */
    bool
    is_softened(const Pencil &pencil, const LA::Vector &shape) const;

    ShellEquations      &equations;
    LinearSolver        &linear_solver;
    dealii::TimerOutput &timer;
    FixedContactTangent  tangent;
    /** Arbitrary displacements, the start of the iterations for eigenvalues. */
    const LA::Vector        start;
    std::vector<LA::Vector> fields;
  };
} // namespace Biface

#endif
