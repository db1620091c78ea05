// SPDX-License-Identifier: LGPL-2.1-or-later

#include <array>

#include <biface/model/quantities/face_stretch.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    double
    area(const std::array<Point<3>, 4> &vertices)
    {
      return cross_product_3d(vertices[3] - vertices[0],
                              vertices[2] - vertices[1])
               .norm() /
             2;
    }
  } // namespace


  LA::Vector
  area_stretch(const ShellMesh       &mesh,
               const LA::Vector      &displacement,
               const Resultants::Face face)
  {
    const LA::Vector rest = mesh.ghosted_vector();
    LA::Vector       now = mesh.owned_vector(), before = mesh.owned_vector();
    // each node counts its cells in full in both areas, whose ratio is meant
    for (const Cell &cell : mesh.wall_elements())
      {
        std::array<Point<3>, 4> deformed, undeformed;
        for (unsigned int v = 0; v < 4; ++v)
          {
            const Node &node = mesh.nodes[cell.nodes[v]];
            deformed[v]      = mesh.deformed_position(displacement, node, face);
            undeformed[v]    = mesh.deformed_position(rest, node, face);
          }
        for (const unsigned int n : cell.nodes)
          {
            const auto dof = mesh.nodes[n].dof(2, MixedElement::mean);
            now(dof) += area(deformed);
            before(dof) += area(undeformed);
          }
      }
    now.compress(VectorOperation::add);
    before.compress(VectorOperation::add);
    for (const Node &node : mesh.nodes)
      if (node.locally_owned)
        {
          const auto dof = node.dof(2, MixedElement::mean);
          now(dof)       = now(dof) / before(dof);
        }
    now.compress(VectorOperation::insert);
    return now;
  }
} // namespace Biface
