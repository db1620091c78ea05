// SPDX-License-Identifier: LGPL-2.1-or-later

#include <biface/model/forces/centrifugal_forces.h>
#include <biface/model/mesh/circumferential_slope.h>
#include <biface/model/mesh/strip.h>
#include <biface/model/state/loads.h>

namespace Biface
{
  using namespace dealii;

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
    return mesh.cells[cell].is_layer && loads.rolling &&
           loads.rolling->angular_velocity != 0 && m[0][0] + m[1][1] > 0;
  }


  MixedElement::NodalVector
  CentrifugalForces::unit_force(const CellState &at) const
  {
    const MassMoments        &m = mass_moments[at.cell.strip];
    MixedElement::NodalVector force;
    for (unsigned int q = 0; q < 4; ++q)
      {
        const CircumferentialSlope        slope(mesh, at.cell, q);
        const std::array<Tensor<1, 3>, 2> x{
          {slope.of(at.V, 0), slope.of(at.V, 1)}};
        for (unsigned int face = 0; face < 2; ++face)
          {
            // x' depends on the displacements of both nodes of a segment,
            // section 10 of doc/theory.md
            const Tensor<1, 3> momentum =
              at.cell.geometry.weight / 4 *
              (m[face][0] * x[0] + m[face][1] * x[1]);
            MixedElement::add_face_force(momentum * slope.own, q, face, force);
            MixedElement::add_face_force(
              momentum * slope.neighbor, q ^ 2, face, force);
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

    // the potential is quadratic in the positions, so that the tangent is
    // constant and symmetric
    const MassMoments &m = mass_moments[at.cell.strip];
    for (unsigned int q = 0; q < 4; ++q)
      {
        const auto parts = CircumferentialSlope(mesh, at.cell, q).parts();
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
