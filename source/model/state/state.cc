// SPDX-License-Identifier: LGPL-2.1-or-later

#include <biface/model/state/state.h>

namespace Biface
{
  State::State(const ShellMesh &mesh)
    : displacement(mesh.ghosted_vector())
    , resultants(mesh.cells.size())
    , active(mesh.nodes.size(), 0)
    , multipliers(mesh.nodes.size())
    , grips(mesh.nodes.size(), Grip::none)
    , stick_points(mesh.nodes.size())
  {}
} // namespace Biface
