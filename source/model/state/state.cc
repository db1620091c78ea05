// SPDX-License-Identifier: LGPL-2.1-or-later

#include <biface/model/state/state.h>

namespace Biface
{
  State::State(const ShellMesh &mesh, const unsigned int n_contacts)
    : displacement(mesh.ghosted_vector())
    , resultants(mesh.cells.size())
    , contacts(n_contacts, ContactState(mesh.nodes.size()))
  {}
} // namespace Biface
