// SPDX-License-Identifier: LGPL-2.1-or-later

#include <biface/model/mesh/shell_mesh.h>
#include <biface/model/state/state.h>

namespace Biface
{
  State::State(const ShellMesh   &mesh,
               const unsigned int n_contacts,
               const unsigned int contacts_per_cell)
    : displacement(mesh.imperfection.size() > 0 ? mesh.imperfection
                                                : mesh.ghosted_vector())
    , resultants(mesh.cells.size())
    , contacts(n_contacts,
               ContactState(contacts_per_cell > 0
                              ? contacts_per_cell * mesh.cells.size()
                              : mesh.nodes.size(),
                            contacts_per_cell))
  {}
} // namespace Biface
