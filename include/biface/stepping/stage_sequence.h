// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_stepping_stage_sequence_h
#define biface_stepping_stage_sequence_h

#include <optional>
#include <vector>

namespace Biface
{
  struct Stage;


  /** The position of the stage from whose end the stage at @p position starts:
   * the previous one, or the one that it names. None for the first stage, which
   * starts from the unloaded shell. */
  std::optional<unsigned int>
  stage_before(const std::vector<Stage> &stages, const unsigned int position);

  /** Whether another stage than the next one starts from the end of the stage
   * at @p position. */
  bool
  is_branched_from(const std::vector<Stage> &stages,
                   const unsigned int        position);

  /** The position of the stage whose shape and contact the stage at @p position
   * continues: that of stage_before(), unless it starts from a prestress. None
   * for a stage that starts undeformed. */
  std::optional<unsigned int>
  continued_stage(const std::vector<Stage> &stages,
                  const unsigned int        position);

  /** The continued_stage() of each of the stages. */
  std::vector<std::optional<unsigned int>>
  continued_stages(const std::vector<Stage> &stages);

  /** Whether any stage asks for modes of vibration. */
  bool
  any_modes(const std::vector<Stage> &stages);

  /** Whether any stage asks for buckling loads. */
  bool
  any_buckling(const std::vector<Stage> &stages);

  /** Whether any stage asks for a response to harmonic excitations. */
  bool
  any_response(const std::vector<Stage> &stages);

  /** Whether critical points are located in any stage. */
  bool
  any_located_points(const std::vector<Stage> &stages);

  /** Whether the ground may move in any stage. */
  bool
  any_motion_of_ground(const std::vector<Stage> &stages);

  /** Whether a wheel rolls over the ground in any of the stages. */
  bool
  any_rolling(const std::vector<Stage> &stages);

  /** The number of modes of vibration of the stage that asks for the fewest. */
  unsigned int
  fewest_modes(const std::vector<Stage> &stages);

  /** The number of buckling loads of the stage that asks for the fewest. */
  unsigned int
  fewest_buckling_loads(const std::vector<Stage> &stages);

  /** Check all stages in order, as far as possible before the run. Throws
   * InputError. */
  void
  check_stages(const std::vector<Stage> &stages);
} // namespace Biface

#endif
