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

  /** Check all stages in order, as far as possible before the run. Throws
   * InputError. */
  void
  check_stages(const std::vector<Stage> &stages);
} // namespace Biface

#endif
