// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_problem_proportions_h
#define biface_problem_proportions_h

#include <biface/model/mesh/shell_mesh.h>
#include <biface/problem/parameters.h>

namespace Biface
{
  /**
   * Check the thickness of the shell against its size; and the ground and its
   * motion against the size of the shell, its stiffness, its cells and its
   * velocity: the penalty stiffness, the radius of a drum or sphere, the
   * travel, and the critical velocity of friction.
   *
   * Throws InputError, on all ranks, for a value for which the results would
   * mean nothing.
   */
  void
  check_proportions(const Parameters &parameters, const ShellMesh &mesh);
} // namespace Biface

#endif
