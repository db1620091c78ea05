// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_solver_harmonic_response_h
#define biface_solver_harmonic_response_h

#include <deal.II/base/timer.h>

#include <array>
#include <complex>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <biface/model/equations/shell_equations.h>
#include <biface/model/state/loads.h>
#include <biface/model/state/step_in_time.h>

namespace Biface
{
  class ContactInteraction;


  /** What shakes the shell, with the amplitude 1: loads, or the motion of a
   * body or of all supports together. */
  struct Excitation
  {
    std::string name;
    /** The loads; none if something moves. */
    std::optional<LoadRates> loads;
    /** The number of the ContactPair of the body that moves; none if the
     * supports do. */
    std::optional<unsigned int> body;
    /** The direction of the motion, 0, 1, 2 for x, y, z. */
    unsigned int direction = 0;
  };


  /** The steady response to harmonic excitations: complex amplitudes of
   * @f$e^{i\omega t}@f$. */
  struct FrequencyResponse
  {
    /** A displacement of a point, or a force of a body on the shell. */
    struct Output
    {
      std::string name;
      /** "force", "inner" or "outer": the displacement of this face. */
      std::string kind;
    };

    /** Components x, y, z. Unit: length or force, per unit of the
     * excitation. */
    using Value = std::array<std::complex<double>, 3>;

    std::vector<std::string> excitations;
    std::vector<Output>      outputs;
    /** Unit: 1/time. */
    std::vector<double> frequencies;
    /** By the frequency, the excitation and the output; nan where a system was
     * not solved. */
    std::vector<std::vector<std::vector<Value>>> values;
    /** The number of frequencies at which a system was not solved. */
    unsigned int n_failed = 0;
    /** The reason of the last failure, as part of a sentence. */
    std::string message;
  };


  /**
   * The steady response of the loaded shell to harmonic excitations,
   * @f[
   *   \Bigl[(1+i\eta)\,\mathbf K+\sum_j\bigl(c_j(\omega)-1\bigr)\mathbf K_j
   *   +i\omega\,(\alpha\mathbf M+\beta\mathbf K_0+\mathbf G)
   *   -\omega^2\mathbf M\Bigr]\,\mathbf u=\mathbf f .
   * @f]
   * @f$\mathbf K@f$ is the tangent of the equilibrium with the contact of
   * FixedContactTangent, where stresses relax that of the elastic law;
   * @f$\mathbf K_j@f$ the part of it that the plies of the material j give,
   * @f$c_j@f$ LossOfMaterial::factor(); @f$\mathbf K_0@f$ the law at small
   * strains; @f$\mathbf G@f$ the VelocityMatrix of a wheel that rolls.
   *
   * A body that moves by @f$\mathbf r@f$ acts on what the shell moves relative
   * to it. If all supports move by @f$\mathbf r@f$, @f$\mathbf u-\mathbf r@f$
   * is sought, and the forces are those of inertia and contact of the motion
   * @f$\mathbf r@f$ of the whole shell. Of what supports prescribe, the load
   * factors give the amplitude.
   *
   * A system is solved for each frequency by ComplexSolver, the gas sealed in
   * the shell by the Woodbury formula.
   */
  class HarmonicResponse
  {
  public:
    /** The objects are kept by reference.
     * @param timer receives the section "Response". */
    HarmonicResponse(ShellEquations           &equations,
                     const ContactInteraction &contact,
                     dealii::TimerOutput      &timer)
      : equations(equations), contact(contact), timer(timer)
    {}

    struct Request
    {
      std::vector<double>     frequencies;
      std::vector<Excitation> excitations;
      /** The loss factor @f$\eta@f$. */
      double        loss_factor = 0;
      DampingInTime damping;
      /** The temperature of plies that relax, see TimeStep. */
      double temperature = 0;
    };

    /** Compute the response about a converged state. Must be called on all
     * ranks.
     * @param stop asked before each frequency, on all ranks with the same
     * answer; the frequencies left are not computed, and their values nan. */
    FrequencyResponse
    compute(const State                 &state,
            const Loads                 &loads,
            const Request               &request,
            const std::function<bool()> &stop = {});

  private:
    ShellEquations           &equations;
    const ContactInteraction &contact;
    dealii::TimerOutput      &timer;
  };
} // namespace Biface

#endif
