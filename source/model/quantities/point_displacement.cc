// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <biface/model/quantities/point_displacement.h>

namespace Biface
{
  using namespace dealii;

  PointDisplacement
  displacement_at(const NamedPoint &point,
                  const LA::Vector &displacement,
                  const ShellMesh  &mesh)
  {
    const unsigned int n_faces = mesh.n_layers() + 1;
    PointDisplacement  u;
    u.global.resize(n_faces);
    u.local.resize(n_faces);
    const unsigned int n = mesh.node_of_point("Named points", point.name);
    // known by the rank that owns the node
    if (n != numbers::invalid_unsigned_int && mesh.nodes[n].locally_owned)
      for (unsigned int i = 0; i < n_faces; ++i)
        {
          // the outermost faces first, then those between layers
          const unsigned int face = (i == 0 ? 0 : i == 1 ? n_faces - 1 : i - 1);
          const Node        &node = mesh.nodes[n];
          u.local[i]  = mesh.displacement_of_any_face(displacement, node, face);
          u.global[i] = node.surface.from_frame(u.local[i]);
        }
    for (const auto faces : {&u.global, &u.local})
      for (Tensor<1, 3> &value : *faces)
        value = Utilities::MPI::sum(value, mesh.communicator);
    return u;
  }
} // namespace Biface
