// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_stepping_stage_response_h
#define biface_stepping_stage_response_h

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace Biface
{
  class EntryDeclarations;
  struct StageLoads;


  /** The steady response to harmonic excitations that is computed at the end of
   * a stage, see HarmonicResponse. */
  struct StageResponse
  {
    /** The frequencies; empty for none. Unit: 1/time. */
    std::vector<double> frequencies;

    /** What shakes the shell: the words of 'Excitations'. */
    std::vector<std::string> excitations;

    /** The loss factor @f$\eta@f$ of the whole tangent. */
    double loss_factor = 0;

    /** Whether a response is computed. */
    bool
    vibrates() const
    {
      return !frequencies.empty();
    }

    /** The body and the direction, 0, 1, 2 for x, y, z, of an excitation by a
     * motion, such as "ground z"; nothing for the name of a load. The body is
     * "ground", "supports" or one of those of the stage. */
    static std::optional<std::pair<std::string, unsigned int>>
    motion(const std::string &excitation, const StageLoads &loads);

    /** Whether an excitation has this name. */
    bool
    is_excited_by(const std::string &name) const;

    void
    add_parameters(EntryDeclarations &prm);

    /** Give the loads that excite factors of their own, which change nothing.
     */
    void
    complete(StageLoads &loads) const;

    /** Throws InputError if a value is invalid. */
    void
    check(const std::string &section) const;

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &frequencies &excitations &loss_factor;
    }
  };
} // namespace Biface

#endif
