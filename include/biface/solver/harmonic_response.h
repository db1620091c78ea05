// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_solver_harmonic_response_h
#define biface_solver_harmonic_response_h

#include <deal.II/base/timer.h>

#include <array>
#include <complex>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <biface/model/state/load_rates.h>
#include <biface/solver/harmonic_system.h>

namespace Biface
{
  /** What shakes the shell, with the amplitude 1: loads, or the motion of a
   * body or of all supports together. */
  struct Excitation
  {
    std::string name;
    /** The loads; none if something moves. */
    std::optional<LoadRates> loads;
    /** The numbers of the ContactPairs of the body that moves, and of those
     * that move with it; none if the supports do. */
    std::set<unsigned int> bodies;
    /** The direction of the motion, 0, 1, 2 for x, y, z. */
    unsigned int direction = 0;

    /** Whether all supports move. */
    bool
    moves_supports() const
    {
      return !loads && bodies.empty();
    }
  };


  /** The steady response to harmonic excitations: complex amplitudes of
   * @f$e^{i\omega t}@f$. */
  struct FrequencyResponse
  {
    /** A displacement of a point, or a force: of a body or a support on the
     * shell, or of the rim on the air. */
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
    /** The amplitudes by the frequency, the excitation and the output; nan
     * where a system was not solved. */
    std::vector<std::vector<std::vector<Value>>> values;
    /** The number of frequencies at which a system was not solved. */
    unsigned int n_failed = 0;
    /** The reason of the last failure, as part of a sentence. */
    std::string message;
  };


  /**
   * The steady response of the loaded shell to harmonic excitations, by the
   * HarmonicSystem at each frequency.
   *
   * A body that moves by @f$\mathbf r@f$ acts on what the shell moves relative
   * to it. If all supports move by @f$\mathbf r@f$, @f$\mathbf u-\mathbf r@f$
   * is sought, and the forces are those of inertia and contact of the motion
   * @f$\mathbf r@f$ of the whole shell. Of what supports prescribe, the load
   * factors give the amplitude.
   */
  class HarmonicResponse
  {
  public:
    /** The objects are kept by reference.
     * @param air the air in the shell; null if it has no inertia.
     * @param timer receives the section "Response". */
    HarmonicResponse(ShellEquations           &equations,
                     const ContactInteraction &contact,
                     const AirColumn          *air,
                     dealii::TimerOutput      &timer)
      : equations(equations), contact(contact), air(air), timer(timer)
    {}

    struct Request
    {
      std::vector<double>     frequencies;
      std::vector<Excitation> excitations;
      HarmonicLosses          losses;
    };

    /** Compute the response about a converged state. Must be called on all
     * ranks. */
    FrequencyResponse
    compute(const State &state, const Loads &loads, const Request &request);

  private:
    ShellEquations           &equations;
    const ContactInteraction &contact;
    const AirColumn *const    air;
    dealii::TimerOutput      &timer;
  };
} // namespace Biface

#endif
