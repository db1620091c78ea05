// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_surface_mesh_options_h
#define biface_surface_mesh_options_h

#include <memory>
#include <string>
#include <vector>

namespace Biface
{
  class KnownSurface;


  /** How the parts of the surface are joined at the sides of a group. */
  struct JointOfGroup
  {
    /** The text of the user. */
    std::string text;
    std::string group;
    /** The moment per length and angle between the parts; infinite if they are
     * joined rigidly, zero at a hinge. Unit: force. */
    double stiffness;
  };


  /** How a mesh is made from its file. */
  struct MeshOptions
  {
    /** Nodes that are closer to each other become one; 0 for none. Unit:
     * length. */
    double merge_distance = 0;
    /** How often all cells are divided. */
    unsigned int n_refinements = 0;
    /** The surface on which the nodes lie; null if the mesh alone is known. */
    std::shared_ptr<const KnownSurface> surface;
    /** The largest angle at which neighboring cells form a smooth surface.
     * Unit: degrees. */
    double fold_angle = 20;
    /** How parts are joined at the sides of groups; elsewhere rigidly. */
    std::vector<JointOfGroup> joints;
  };
} // namespace Biface

#endif
