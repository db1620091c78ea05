// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>

#include <biface/contact/contact_condition.h>
#include <biface/contact/contact_condition_parameters.h>
#include <biface/model/state/contact_points.h>

namespace Biface
{
  using namespace dealii;

  ContactPoints::ContactPoints(const ShellMesh       &mesh,
                               const Resultants::Face face,
                               const unsigned int     per_side,
                               const MortarMatrix     mass)
    : mesh(mesh), face(face), points_per_side(per_side)
  {
    if (at_nodes())
      {
        // with the consistent mortar matrix, the traction at a node acts on all
        // nodes of the cell
        points_on_cell.resize(4);
        for (unsigned int d = 0; d < 3; ++d)
          {
            std::array<double, 3> density{};
            density[d]   = 1;
            const auto M = mortar_matrix(mass, density);
            for (unsigned int s = 0; s < 4; ++s)
              for (unsigned int r = 0; r < 4; ++r)
                points_on_cell[s].forces[d][r] = M[r][s];
          }
        for (unsigned int s = 0; s < 4; ++s)
          points_on_cell[s].position[s] = 1;
      }
    for (unsigned int i = 0; i < per_cell(); ++i)
      {
        const std::array<double, 2> x{
          {(i % per_side + 0.5) / per_side, (i / per_side + 0.5) / per_side}};
        // M_rs = N_r(s) w/k^2, section 6 of doc/theory.md
        OnCell point{};
        for (unsigned int v = 0; v < 4; ++v)
          {
            point.position[v] =
              (v & 1 ? x[0] : 1 - x[0]) * (v & 2 ? x[1] : 1 - x[1]);
            point.forces[0][v] = point.position[v] / per_cell();
            for (unsigned int a = 0; a < 2; ++a)
              point.forces[1 + a][v] = point.forces[0][v] * (2 * x[a] - 1);
          }
        points_on_cell.push_back(point);
      }
  }


  ContactPoints::ContactPoints(const ShellMesh       &mesh,
                               const Resultants::Face face,
                               const ContactState    &state)
    : ContactPoints(mesh,
                    face,
                    std::lround(std::sqrt(state.per_cell)),
                    MortarMatrix::lumped)
  {}


  bool
  ContactPoints::may_touch(const unsigned int point) const
  {
    if (at_nodes())
      return mesh.nodes[point].face_is_free[face];
    const Cell &cell = cell_of(point);
    return cell.is_wall &&
           std::any_of(
             cell.nodes.begin(), cell.nodes.end(), [&](const unsigned int n) {
               return mesh.nodes[n].face_is_free[face];
             });
  }


  Point<3>
  ContactPoints::position(const LA::Vector  &displacement,
                          const unsigned int point) const
  {
    return Point<3>(interpolate(point, [&](const Node &node) -> Tensor<1, 3> {
      return mesh.deformed_position(displacement, node, face);
    }));
  }


  Tensor<1, 3>
  ContactPoints::motion(const LA::Vector  &increment,
                        const unsigned int point) const
  {
    return interpolate(point, [&](const Node &node) {
      return node.surface.from_frame(mesh.displacement(increment, node, face));
    });
  }


  ActiveSet
  ContactPoints::nodes_around(const ActiveSet &marked) const
  {
    AssertDimension(marked.size(), size());
    if (at_nodes())
      return marked;
    LA::Vector n_marked = mesh.owned_vector();
    for (unsigned int point = 0; point < marked.size(); ++point)
      if (marked[point])
        for (const unsigned int n : cell_of(point).nodes)
          n_marked(mesh.nodes[n].dof(0, MixedElement::mean)) += 1;
    n_marked.compress(VectorOperation::add);
    LA::Vector of_ghosts = mesh.ghosted_vector();
    of_ghosts            = n_marked;
    ActiveSet nodes;
    for (const Node &node : mesh.nodes)
      nodes.push_back(of_ghosts(node.dof(0, MixedElement::mean)) > 0);
    return nodes;
  }
} // namespace Biface
