// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_solver_modal_analysis_h
#define biface_solver_modal_analysis_h

#include <deal.II/base/tensor.h>
#include <deal.II/base/timer.h>

#include <complex>
#include <optional>
#include <string>
#include <vector>

#include <biface/base/linear_algebra.h>
#include <biface/model/air/air_column.h>
#include <biface/model/equations/mass_matrix.h>
#include <biface/model/mesh/wave_numbers.h>
#include <biface/solver/fixed_contact_tangent.h>
#include <biface/solver/linear/eigenpairs.h>
#include <biface/solver/linear/linear_solver.h>

namespace Biface
{
  struct Loads;
  class ShellEquations;
  struct State;


  /** A mode of free vibration, @f$\mathbf V(t)=\mathbf V_0+
   * \Re(\boldsymbol\varphi\,e^{i\omega t})@f$. */
  struct VibrationMode
  {
    /** The frequency @f$\omega@f$, whose real part is not negative: imaginary
     * for modes in which the shell does not return, complex for those that grow
     * or decay while they oscillate. Unit: 1/time. */
    std::complex<double> omega;

    /** The shape @f$\boldsymbol\varphi@f$, or its real part, with the entries
     * of all nodes of this rank; the largest displacement of a face is 1. */
    LA::Vector shape;

    /** The imaginary part of @f$\boldsymbol\varphi@f$, a quarter of a period
     * earlier, of a shell that rolls or spins, or flutters; else empty. The
     * largest displacement is then that of both parts together, with the sum of
     * their squares. */
    LA::Vector imaginary;

    /** The left eigenvector @f$\mathbf y@f$ with
     * @f$\mathbf y^T(\mathbf K+i\omega\mathbf G-\omega^2\mathbf
     * M)=\mathbf 0@f$, see left_eigenpairs(), in the owned unknowns. Empty if
     * it was not wanted or does not exist. */
    Eigenpair left;

    /** The modal mass @f$\boldsymbol\varphi^H\mathbf M\boldsymbol\varphi@f$,
     * with that of the air. Unit: mass. */
    double mass = 0;

    /** The part of the kinetic energy that is that of the air, see
     * AirColumn. */
    double part_of_air = 0;

    /** The participation factors of the translations along x, y and z,
     * @f$\boldsymbol\varphi^T\mathbf M\mathbf r/
     * \boldsymbol\varphi^H\mathbf M\boldsymbol\varphi@f$, of complex shapes
     * their magnitudes. */
    dealii::Tensor<1, 3> participation;

    /** The wave numbers of the shape, if the shell is a full turn;
     * WaveNumbers::travel is in the direction in which the wheel turns. */
    std::optional<WaveNumbers> waves;

    /** The square @f$\omega^2@f$, an eigenvalue of a standing shell. */
    std::complex<double>
    square() const
    {
      return omega * omega;
    }

    /** The frequency @f$\Re\omega/2\pi@f$. Unit: 1/time. */
    double
    frequency() const;

    /** The rate @f$-\Im\omega@f$ at which the amplitude grows: zero in a stable
     * equilibrium with a symmetric tangent. Of a complex pair, one mode grows
     * and the other decays; of a standing shell with imaginary @f$\omega@f$,
     * the rate of the mode that grows. Unit: 1/time. */
    double
    growth_rate() const;

    /** The effective mass for a translation. Unit: mass. */
    double
    effective_mass(const unsigned int direction) const
    {
      return participation[direction] * participation[direction] * mass;
    }
  };

  /** The frequency @f$\omega@f$ from @f$\omega^2@f$: with a real part that is
   * not negative, or if there is none, that of the mode that grows. */
  std::complex<double>
  omega_of(const std::complex<double> &square);


  /** The result of a modal analysis. */
  struct VibrationModes
  {
    bool success = false;
    /** The reason of a failure, as part of a sentence. */
    std::string message;
    /** The modes in ascending order of @f$\Re\omega^2@f$, or of @f$|\omega|@f$
     * if the shell rolls or spins. */
    std::vector<VibrationMode> modes;
    /** The rigid motions that nothing resists, whose frequency is zero: see
     * FixedContactTangent::neutral_motions(). */
    std::vector<std::string> neutral_motions;
    /** The mass of the whole shell. */
    double total_mass = 0;
    /** Whether the air in the shell has inertia. */
    bool with_air = false;
    /** Whether the shell stands and its tangent is symmetric, so that left
     * eigenvectors are the shapes. */
    bool symmetric = false;
  };


  /**
   * Natural frequencies and shapes of small vibrations about an equilibrium of
   * the loaded shell,
   * @f$\mathbf K\boldsymbol\varphi=\omega^2\mathbf M\boldsymbol\varphi@f$.
   *
   * @f$\mathbf K@f$ is the tangent of the equilibrium: with the prestress, the
   * loads that follow the shell and the gas sealed in it. It is not symmetric
   * if these are not conservative. The nodes in contact are held, see
   * FixedContactTangent.
   *
   * A shell that rolls or spins vibrates in the frame of its axle with
   * @f$(\mathbf K+i\omega\mathbf G-\omega^2\mathbf M)
   * \boldsymbol\varphi=\mathbf 0@f$, where @f$\mathbf G@f$ is the
   * VelocityMatrix. Its nodes in contact are not held sideways: friction
   * follows from the slip velocity.
   *
   * The air in an AirColumn vibrates with the shell, see ShellWithAir; then the
   * shell stands and is held.
   *
   * Rigid motions that nothing resists have the frequency zero, though
   * interpolation in a curved shell gives them a small stiffness; the other
   * modes are orthogonal to them, see Deflation.
   *
   * The eigenvalues closest to zero are computed by nearest_eigenpairs() with
   * the factors of the linear solver, if @f$\mathbf K@f$ is singular, as for a
   * free shell, those of
   * @f$\mathbf K+s\mathbf M@f$ with an @f$s@f$ below the eigenvalues of the
   * elastic modes. Eigenvalues below the
   * round-off of @f$\mathbf K@f$ are set to zero. Modes of the same frequency
   * are chosen such that they do not depend on the number of ranks, and that
   * as few as possible contain a rigid motion.
   */
  class ModalAnalysis
  {
  public:
    /** The objects are kept by reference.
     * @param timer receives the section "Modes".
     * @param air the air in the shell; null if it has no inertia. */
    ModalAnalysis(ShellEquations           &equations,
                  const ContactInteraction &contact,
                  LinearSolver             &linear_solver,
                  dealii::TimerOutput      &timer,
                  const AirColumn          *air = nullptr);

    /**
     * Compute the modes of a converged state. The last assembly of the
     * equations is lost.
     *
     * @param n the number of modes.
     * @param with_left whether left eigenvectors are wanted, too.
     */
    VibrationModes
    compute(const State       &state,
            const Loads       &loads,
            const unsigned int n,
            const bool         with_left = false);

  private:
    struct Problem;

    /** The air in a mode whose vector is that of the shell alone. */
    struct AirInMode
    {
      /** The part of the shell in the kinetic energy. */
      double part_of_shell = 1;
      /** The momentum if the vector with the air is a velocity. Unit: mass. */
      dealii::Tensor<1, 3> momentum = {};
    };

    Problem
    assemble(const State &state, const Loads &loads);

    /** Prepare to solve systems with the matrix at the shift of the problem. */
    LinearSolverResult
    factorize(Problem &problem) const;

    /** The eigenpairs closest to the shift, of the problem or of the transposed
     * one, with the factors at hand.
     * @param linear the last result of the linear solver. */
    Eigenpairs
    nearest(const Problem      &problem,
            const LinearSystem  system,
            const unsigned int  n,
            LinearSolverResult &linear) const;

    /** The eigenpairs closest to zero, for which a shift is chosen. */
    Eigenpairs
    lowest(Problem &problem, const unsigned int n) const;

    /** An estimate of the largest eigenvalue @f$\omega^2@f$ of the modes, from
     * the diagonals of @p K and of the mass matrix. */
    double
    largest_eigenvalue(const LA::SparseMatrix &K) const;

    /** Whether an eigenvalue is smaller than the round-off of @p K in its
     * vector. */
    bool
    is_zero(const LA::SparseMatrix     &K,
            const std::complex<double> &eigenvalue,
            const LA::Vector           &vector) const;

    /** The mode of an eigenpair, in which the value is @f$\omega@f$.
     * @param pair with @f$\omega@f$ for the eigenvalue.
     * @param of_air what the pair lacks. */
    VibrationMode
    finish(const Eigenpair &pair,
           const Loads     &loads,
           const AirInMode &of_air) const;

    /** The left eigenvectors of the pairs @p right, with the factors at
     * hand. */
    std::vector<Eigenpair>
    find_left(const Problem                &problem,
              const std::vector<Eigenpair> &right) const;

    ShellEquations           &equations;
    const ContactInteraction &contact;
    LinearSolver             &linear_solver;
    dealii::TimerOutput      &timer;
    const AirColumn *const    air;
    FixedContactTangent       tangent;
    const MassMatrix          mass;

    /** The fields by which settle() chooses modes: the inertia
     * @f$\mathbf M\mathbf r@f$ of the six rigid motions, then of arbitrary
     * displacements, each for a unit of @f$\mathbf r^T\mathbf M\mathbf r@f$. */
    std::vector<LA::Vector> fields;
    /** The inertia @f$\mathbf M\mathbf r@f$ of the translations along x, y and
     * z. */
    std::vector<LA::Vector> translations;
    /** Arbitrary displacements, the start of the iterations for eigenvalues. */
    LA::Vector start;
  };


  /**
   * The frequencies @f$\omega@f$ of a shell up to terms of second order, from
   * the right and left eigenvectors of a slightly different one, see
   * rayleigh_quotients() and rayleigh_roots(); NaN without a left one. The last
   * assembly of the equations is lost.
   *
   * @param modes of the neighbor, whose degrees of freedom are the same.
   */
  std::vector<std::complex<double>>
  omegas_for_shapes(ShellEquations           &equations,
                    const ContactInteraction &contact,
                    dealii::TimerOutput      &timer,
                    const State              &state,
                    const Loads              &loads,
                    const VibrationModes     &modes);
} // namespace Biface

#endif
