// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_problem_check_excitations_h
#define biface_problem_check_excitations_h

#include <biface/model/mesh/shell_mesh.h>
#include <biface/problem/parameters.h>

namespace Biface
{
  /** Check that the motions that shake the shell are possible for the part of
   * it that is modeled: no sector moves across its axis, no half across its
   * plane of symmetry, and no supports that are not there. Throws InputError on
   * all ranks, on which it must be called. */
  void
  check_excitations(const Parameters &parameters, const ShellMesh &mesh);
} // namespace Biface

#endif
