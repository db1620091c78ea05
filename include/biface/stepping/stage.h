// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_stepping_stage_h
#define biface_stepping_stage_h

#include <optional>
#include <string>

#include <biface/base/serialize_optional.h>
#include <biface/model/state/strain_theory.h>
#include <biface/stepping/load_level.h>
#include <biface/stepping/stage_control.h>
#include <biface/stepping/stage_loads.h>
#include <biface/stepping/stage_motion.h>
#include <biface/stepping/stage_response.h>
#include <biface/stepping/stage_results.h>

namespace Biface
{
  class EntryDeclarations;
  struct InUse;


  /** A stage of loading: from the end of the previous stage, or of another one
   * before, to its own loads, in steps that its control chooses, with the
   * results asked for. */
  struct Stage : StageLoads,
                 StageControl,
                 StageMotion,
                 StageResults,
                 StageResponse
  {
    std::string  name   = "stage";
    StrainTheory theory = StrainTheory::nonlinear;
    /** The number, from 1, of the stage from whose end this one starts; not set
     * for the previous stage. See stage_before(). */
    std::optional<unsigned int> start_from;
    /** Whether to start with the stresses and loads reached so far, but
     * undeformed. */
    bool from_prestress = false;
    /** Whether the run goes on with other stages if this one fails, but not
     * with those that start from it. */
    bool may_fail = false;

    /** Whether the shell rolls: it does not stand both at the start and at the
     * end of the stage, and between them. */
    bool
    rolls(const LoadLevel &start) const
    {
      return start.rolls() || end(start).rolls() || prescribes_axle_moment() ||
             histories.has("angular velocity") ||
             histories.has("ground velocity");
    }

    /** Whether the wheel rolls freely and steadily at the end of the stage. */
    bool
    ends_free_rolling() const
    {
      return StageControl::ends_free_rolling() && !transient_rolling &&
             !inertia;
    }

    /** The settings that matter for remedies if a step of the stage fails.
     * @param position that of the stage. */
    InUse
    in_use(const unsigned int position) const;

    /** Whether the stage has a ground that may move. */
    bool
    moves_ground() const
    {
      bool moves = prescribes_force();
      for_each_motion([&moves](const auto &motion) { moves = moves || motion; },
                      *this);
      return contact && moves;
    }

    /** Declare the entries of the stage.
     * @param number the number of the stage, for its default name. */
    void
    add_parameters(EntryDeclarations &prm, const unsigned int number);

    /** Throws InputError if a value is invalid. */
    void
    check(const std::string &section) const;

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int version)
    {
      StageLoads::serialize(archive, version);
      StageControl::serialize(archive, version);
      StageMotion::serialize(archive, version);
      StageResults::serialize(archive, version);
      StageResponse::serialize(archive, version);
      serialize_optional(archive, start_from);
      archive &name &theory &from_prestress &may_fail;
    }

  private:
    /** Check that critical points can be located. */
    void
    check_critical_points(const std::string &section) const;
  };
} // namespace Biface

#endif
