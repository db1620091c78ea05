// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_solver_harmonic_system_h
#define biface_solver_harmonic_system_h

#include <deal.II/base/timer.h>
#include <deal.II/lac/affine_constraints.h>

#include <array>
#include <complex>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <biface/base/linear_algebra.h>
#include <biface/model/air/air_column.h>
#include <biface/model/state/state.h>

namespace Biface
{
  class ComplexSolver;
  class ContactInteraction;
  struct Loads;
  struct LossOfMaterial;
  class ShellEquations;
  class ShellMesh;
  class VelocityMatrix;


  /** Complex amplitudes of @f$e^{i\omega t}@f$: those of all unknowns of the
   * nodes, owned entries, and of the air in an AirColumn, the pressures of its
   * pieces, then the volumes that have moved through its sections, on all
   * ranks. */
  struct Amplitudes
  {
    using Number = std::complex<double>;

    LA::Vector          real, imaginary;
    std::vector<Number> air;

    void
    add(const Number &factor, const LA::Vector &x);

    void
    add(const Number &factor, const Amplitudes &x);

    /** The product of the amplitudes of the nodes with a vector. */
    Number
    operator*(const LA::Vector &x) const
    {
      return {real * x, imaginary * x};
    }

    /** The norm of the amplitudes of the nodes. */
    double
    norm() const;
  };


  /** Where the energy of harmonic vibrations goes. */
  struct HarmonicLosses
  {
    /** The loss factor @f$\eta@f$ of the whole tangent. */
    double loss_factor = 0;
    /** DampingInTime::of_mass and DampingInTime::of_stiffness. */
    double damping_of_mass = 0, damping_of_stiffness = 0;
    /** The temperature of plies that relax, see TimeStep. */
    double temperature = 0;
  };


  /**
   * The equations of small harmonic vibrations about an equilibrium,
   * @f[
   *   \mathbf A\,\mathbf u=\Bigl[(1+i\eta)\,\mathbf K+\sum_j\bigl(c_j(\omega)-
   *   1\bigr)\mathbf K_j+i\omega\,(\alpha\mathbf M+\beta\mathbf K_0+\mathbf G)
   *   -\omega^2\mathbf M\Bigr]\,\mathbf u=\mathbf f .
   * @f]
   * @f$\mathbf K@f$ is the tangent of the equilibrium with the contact of
   * FixedContactTangent, where stresses relax that of the elastic law;
   * @f$\mathbf K_j@f$ the part of it that the plies of the material j give,
   * with LossOfMaterial::factor() @f$c_j@f$; @f$\mathbf K_0@f$ the law at small
   * strains; @f$\mathbf G@f$ the VelocityMatrix of a wheel that rolls.
   *
   * A sealed gas is a part of low rank, with the Woodbury formula; the air in
   * an AirColumn has unknowns of its own.
   *
   * All functions must be called on all ranks.
   */
  class HarmonicSystem
  {
  public:
    using Number = Amplitudes::Number;

    /** The equations about a converged state. The last assembly of the
     * equations is lost; all objects are kept by reference.
     * @param air null if the air has no inertia. */
    HarmonicSystem(ShellEquations           &equations,
                   const ContactInteraction &contact,
                   const AirColumn          *air,
                   const State              &state,
                   const Loads              &loads,
                   const HarmonicLosses     &losses,
                   dealii::TimerOutput      &timer);

    ~HarmonicSystem();

    HarmonicSystem(const HarmonicSystem &) = delete;

    /** The equations without supports, in linear theory those of the shape
     * about which it linearizes. */
    const State &
    shape() const
    {
      return shape_of_tangent;
    }

    /** Amplitudes of zero. */
    Amplitudes
    zero() const;

    /** Set the frequency and factorize the matrix.
     * @return why this failed, as part of a sentence, or an empty string. */
    std::string
    set_frequency(const double frequency);

    double
    angular_frequency() const
    {
      return omega;
    }

    /** The product of the matrix, regardless of supports: the forces that
     * amplitudes need on the nodes. */
    Amplitudes
    product(const Amplitudes &u) const;

    /** Replace forces, regardless of supports, by the amplitudes that they
     * cause, zero where supports prescribe displacements.
     * @return why this failed, as part of a sentence, or an empty string. */
    std::string
    solve(std::vector<Amplitudes> &x) const;

    /** Add the forces of inertia, and of damping by the mass, of displacements
     * on the whole shell. */
    void
    add_inertia(const LA::Vector &displacement, Amplitudes &forces) const;

    /** Let the air have the inertia of a translation of the wheel along an
     * axis, 0, 1, 2: volumes then count relative to the wheel. */
    void
    add_inertia_of_air(const unsigned int direction, Amplitudes &forces) const;

    /** The number of bodies in contact. */
    unsigned int
    n_bodies() const
    {
      return bodies.size();
    }

    /** The number of the ContactPair of a body, and its name. */
    unsigned int
    number_of_body(const unsigned int body) const
    {
      return bodies[body].number;
    }
    const std::string &
    name_of_body(const unsigned int body) const
    {
      return bodies[body].name;
    }

    /** Add a multiple of the forces of a body on the shell that moves relative
     * to it. */
    void
    add_contact(const unsigned int body,
                const Amplitudes  &relative,
                const double       factor,
                Amplitudes        &forces) const;

    /** Whether there is air with inertia. */
    bool
    has_air() const
    {
      return !air.compliances.empty();
    }

    /** The force on the air of what closes the cavity beside the shell.
     * @param u the amplitudes of the solution.
     * @param wheel the direction of a translation of the wheel by 1; none if it
     * stands. */
    std::array<Number, 3>
    force_of_rim(const Amplitudes                  &u,
                 const std::optional<unsigned int> &wheel) const;

    /** The translations of all nodes along x, y and z. */
    const std::vector<LA::Vector> &
    get_translations() const
    {
      return translations;
    }

  private:
    class Entries;
    struct Part;

    /** The derivative of the forces of a body by displacements of the shell
     * relative to it, and by such velocities: parts with a sign. */
    struct ContactOfBody
    {
      unsigned int                                 number;
      std::string                                  name;
      std::vector<std::pair<double, const Part *>> stiffness, velocity;
    };

    /** A part @f$-\mathbf f\,\mathbf g^T@f$ of the matrix. */
    struct RankOne
    {
      LA::Vector forces, gradient;
    };

    void
    set_contact(const ContactInteraction &contact,
                const State              &state,
                const Loads              &loads);

    /** Call a function with the matrices of the shell and, with a sign, of the
     * bodies, and with their factors at the frequency. */
    template <typename Function>
    void
    for_each_part(const Function &function) const;

    /** Leave what is work-conjugate to the free unknowns. */
    void
    condense(Amplitudes &forces) const;

    /** Solve systems with the matrix of free unknowns once, by its factors and
     * the Woodbury formula. */
    bool
    solve_by_factors(std::vector<Amplitudes> &x) const;

    /** The factor of the inertia of the air: not zero, where air that
     * circulates would be undetermined. */
    double
    factor_of_inertia_of_air() const;

    ShellEquations       &equations;
    const ShellMesh      &mesh;
    const HarmonicLosses &losses;
    State                 shape_of_tangent;
    double                omega = 0;
    /** The first rigid motion that nothing resists, in words; empty for none.
     */
    std::string free_motion;

    /** No constraints, of which the parts are. */
    dealii::AffineConstraints<double> none;
    std::vector<LA::Vector>           translations;
    /** The parts without bodies: stiffness, mass, and if they are there the
     * gyroscopic matrix and the stiffness of damping. */
    std::unique_ptr<const Part> K, M, G, K_0;
    std::vector<std::pair<LossOfMaterial, std::unique_ptr<const Part>>>
                                             materials;
    std::vector<std::unique_ptr<const Part>> parts_of_bodies;
    std::vector<ContactOfBody>               bodies;
    std::vector<RankOne>                     low_rank;
    AirMotion                                air;

    std::unique_ptr<Entries>       entries;
    std::unique_ptr<ComplexSolver> solver;
  };
} // namespace Biface

#endif
