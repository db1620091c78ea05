// SPDX-License-Identifier: LGPL-2.1-or-later

#include <biface/model/centrifugal_forces.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    /** The derivative by the angle at a vertex as a function of the
     * displacements of a face: of the vertex itself and of its neighbor. */
    struct Slope
    {
      Slope(const Cell &cell, const ShellMesh &mesh, const unsigned int q)
        : lame(mesh.nodes[cell.nodes[q]].surface.lame[1])
      {
        const ElementGeometry::Vertex &vertex = cell.geometry.vertices[q];
        neighbor                              = -lame * vertex.slope[1];
        own                                   = lame * vertex.connection[1];
        for (unsigned int i = 0; i < 3; ++i)
          own[i][i] -= neighbor;
        for (unsigned int face = 0; face < 2; ++face)
          undeformed[face] = lame * vertex.metric.zeta[face][1];
      }

      double                lame;
      Tensor<2, 3>          own;
      double                neighbor;
      std::array<double, 2> undeformed;

      Tensor<1, 3>
      of(const MixedElement::NodalVector &V,
         const unsigned int               q,
         const unsigned int               face) const
      {
        Tensor<1, 3> x =
          own * MixedElement::face_displacement(V, q, face) +
          neighbor * MixedElement::face_displacement(V, q ^ 2, face);
        x[1] += undeformed[face];
        return x;
      }
    };
  } // namespace


  CentrifugalForces::CentrifugalForces(const ShellMesh &mesh) : mesh(mesh)
  {
    for (const Strip &strip : mesh.strips)
      mass_moments.push_back(strip.laminate.mass_moments());
  }


  bool
  CentrifugalForces::acts_on(const unsigned int cell,
                             const State &,
                             const Loads &loads) const
  {
    const MassMoments &m = mass_moments[mesh.cells[cell].strip];
    return loads.rolling && loads.rolling->angular_velocity != 0 &&
           m[0][0] + m[1][1] > 0;
  }


  MixedElement::NodalVector
  CentrifugalForces::unit_force(const CellState &at) const
  {
    const MassMoments        &m = mass_moments[at.cell.strip];
    MixedElement::NodalVector force;
    for (unsigned int q = 0; q < 4; ++q)
      {
        const Slope                       slope(at.cell, mesh, q);
        const std::array<Tensor<1, 3>, 2> x{
          {slope.of(at.V, q, 0), slope.of(at.V, q, 1)}};
        for (unsigned int face = 0; face < 2; ++face)
          {
            const Tensor<1, 3> momentum =
              at.cell.geometry.weight / 4 *
              (m[face][0] * x[0] + m[face][1] * x[1]);
            MixedElement::add_face_force(momentum * slope.own, q, face, force);
            MixedElement::add_face_force(
              slope.neighbor * momentum, q ^ 2, face, force);
          }
      }
    return force;
  }


  void
  CentrifugalForces::add(const CellState &at, CellForces &forces) const
  {
    const double omega  = at.loads.rolling->angular_velocity;
    const double square = omega * omega;
    forces.load += square * unit_force(at);
    if (!forces.with_tangent)
      return;

    const MassMoments &m = mass_moments[at.cell.strip];
    for (unsigned int q = 0; q < 4; ++q)
      {
        const Slope        slope(at.cell, mesh, q);
        const Tensor<2, 3> neighbor =
          slope.neighbor * Tensor<2, 3>(unit_symmetric_tensor<3>());
        const std::array<std::pair<unsigned int, Tensor<2, 3>>, 2> parts{
          {{q, slope.own}, {q ^ 2, neighbor}}};
        for (unsigned int f = 0; f < 2; ++f)
          for (unsigned int g = 0; g < 2; ++g)
            for (const auto &row : parts)
              for (const auto &column : parts)
                MixedElement::add_stiffness(
                  -square * at.cell.geometry.weight / 4 * m[f][g] *
                    (transpose(row.second) * column.second),
                  row.first,
                  MixedElement::face_sign[f],
                  column.first,
                  MixedElement::face_sign[g],
                  forces.tangent);
      }
  }


  void
  CentrifugalForces::add_load_derivative(const CellState           &at,
                                         const LoadRates           &rates,
                                         MixedElement::NodalVector &force) const
  {
    force += 2 * at.loads.rolling->angular_velocity * rates.angular_velocity *
             unit_force(at);
  }
} // namespace Biface
