// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_mesh_support_motions_h
#define biface_model_mesh_support_motions_h

#include <vector>

#include <biface/model/mesh/support_motion.h>

namespace Biface
{
  class MeshNodes;
  struct SupportedNodes;
  struct Supports;


  /** The motions of all supports, in the order of the supports, then of the
   * factors. Without those that are zero at all nodes. Must be called on all
   * ranks, with the equations of all supported nodes. */
  std::vector<SupportMotion>
  find_support_motions(const Supports       &supports,
                       const MeshNodes      &mesh,
                       const SupportedNodes &supported);
} // namespace Biface

#endif
