// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <biface/contact/rolling.h>
#include <biface/model/forces/inertia_of_wheel.h>
#include <biface/model/mesh/circumferential_slope.h>
#include <biface/model/mesh/strip.h>
#include <biface/model/state/loads.h>
#include <biface/model/state/step_in_time.h>

namespace Biface
{
  using namespace dealii;

  InertiaOfWheel::InertiaOfWheel(const ShellMesh &mesh) : mesh(mesh)
  {
    for (const Strip &strip : mesh.strips)
      mass_moments.push_back(strip.laminate.mass_moments());
  }


  bool
  InertiaOfWheel::acts_on(const unsigned int cell,
                          const State       &state,
                          const Loads       &loads) const
  {
    const MassMoments &m = mass_moments[mesh.cells[cell].strip];
    return mesh.cells[cell].is_layer && loads.rolling &&
           (loads.rolling->angular_velocity != 0 || state.step) &&
           m[0][0] + m[1][1] > 0;
  }


  std::array<Tensor<1, 3>, 2>
  InertiaOfWheel::unit_momentum(const Cell                      &cell,
                                const MixedElement::NodalVector &V,
                                const unsigned int               q) const
  {
    const MassMoments                &m = mass_moments[cell.strip];
    const CircumferentialSlope        slope(mesh, cell, q);
    const std::array<Tensor<1, 3>, 2> x{{slope.of(V, 0), slope.of(V, 1)}};
    std::array<Tensor<1, 3>, 2>       result;
    for (unsigned int face = 0; face < 2; ++face)
      result[face] =
        cell.geometry.weight / 4 * (m[face][0] * x[0] + m[face][1] * x[1]);
    return result;
  }


  MixedElement::NodalVector
  InertiaOfWheel::unit_force(const Cell                      &cell,
                             const MixedElement::NodalVector &V) const
  {
    MixedElement::NodalVector force;
    for (unsigned int q = 0; q < 4; ++q)
      {
        const CircumferentialSlope slope(mesh, cell, q);
        const auto                 momentum = unit_momentum(cell, V, q);
        for (unsigned int face = 0; face < 2; ++face)
          {
            // x' depends on the displacements of both nodes of a segment,
            // section 10 of doc/theory.md
            MixedElement::add_face_force(
              momentum[face] * slope.own, q, face, force);
            MixedElement::add_face_force(
              momentum[face] * slope.neighbor, q ^ 2, face, force);
          }
      }
    return force;
  }


  MixedElement::NodalVector
  InertiaOfWheel::unit_change(const Cell                      &cell,
                              const MixedElement::NodalVector &V) const
  {
    MixedElement::NodalVector force;
    for (unsigned int q = 0; q < 4; ++q)
      {
        const auto momentum = unit_momentum(cell, V, q);
        for (unsigned int face = 0; face < 2; ++face)
          MixedElement::add_face_force(momentum[face], q, face, force);
      }
    return force;
  }


  void
  InertiaOfWheel::add_stiffness(const Cell                &cell,
                                const double               factor,
                                MixedElement::NodalMatrix &K) const
  {
    // the potential is quadratic in the positions, so that the tangent is
    // constant and symmetric
    const MassMoments &m = mass_moments[cell.strip];
    for (unsigned int q = 0; q < 4; ++q)
      {
        const auto parts = CircumferentialSlope(mesh, cell, q).parts();
        for (unsigned int f = 0; f < 2; ++f)
          for (unsigned int g = 0; g < 2; ++g)
            for (const auto &row : parts)
              for (const auto &column : parts)
                MixedElement::add_stiffness(
                  -factor * cell.geometry.weight / 4 * m[f][g] *
                    (transpose(row.second) * column.second),
                  row.first,
                  MixedElement::face_sign[f],
                  column.first,
                  MixedElement::face_sign[g],
                  K);
      }
  }


  void
  InertiaOfWheel::add_transport(const Cell                &cell,
                                const double               factor,
                                MixedElement::NodalMatrix &K) const
  {
    const MassMoments &m = mass_moments[cell.strip];
    for (unsigned int q = 0; q < 4; ++q)
      for (const auto &[vertex, derivative] :
           CircumferentialSlope(mesh, cell, q).parts())
        for (unsigned int f = 0; f < 2; ++f)
          for (unsigned int g = 0; g < 2; ++g)
            MixedElement::add_stiffness(-factor * cell.geometry.weight / 4 *
                                          m[f][g] * derivative,
                                        q,
                                        MixedElement::face_sign[f],
                                        vertex,
                                        MixedElement::face_sign[g],
                                        K);
  }


  void
  InertiaOfWheel::add_gyroscopic(const Cell                &cell,
                                 const double               angular_velocity,
                                 MixedElement::NodalMatrix &G) const
  {
    // two transposed terms of opposite sign make the matrix skew to round-off,
    // section 10 of doc/theory.md
    MixedElement::NodalMatrix N{};
    add_transport(cell, angular_velocity, N);
    for (unsigned int i = 0; i < MixedElement::n_dofs; ++i)
      for (unsigned int j = 0; j < MixedElement::n_dofs; ++j)
        G[i][j] += N[i][j] - N[j][i];
  }


  void
  InertiaOfWheel::add(const CellState &at, CellForces &forces) const
  {
    const double omega  = at.loads.rolling->angular_velocity;
    const double square = omega * omega;
    forces.load += square * unit_force(at.cell, at.V);
    if (forces.with_tangent)
      add_stiffness(at.cell, square, forces.tangent);
  }


  namespace
  {
    /** The product of a matrix with a vector. */
    MixedElement::NodalVector
    product(const MixedElement::NodalMatrix &A,
            const MixedElement::NodalVector &v)
    {
      MixedElement::NodalVector result;
      for (unsigned int i = 0; i < MixedElement::n_dofs; ++i)
        for (unsigned int j = 0; j < MixedElement::n_dofs; ++j)
          result[i] += A[i][j] * v[j];
      return result;
    }
  } // namespace


  void
  InertiaOfWheel::add_over_step(const CellState &start,
                                const CellState &end,
                                CellForces      &forces) const
  {
    const StepInTime      &step   = *end.state.step;
    const StepInTime::Spin spin   = step.spin(end.loads);
    const double           square = spin.mean * spin.mean;
    // the work of all three is that of an energy, or vanishes, section 10 of
    // doc/theory.md
    const auto middle = 0.5 * (start.V + end.V);
    const auto change = end.V - start.V;
    forces.load += square * unit_force(end.cell, middle);
    forces.load += spin.acceleration * unit_change(end.cell, middle);
    MixedElement::NodalMatrix G{};
    add_gyroscopic(end.cell, spin.mean / step.duration, G);
    forces.load -= product(G, change);
    if (!forces.with_tangent)
      return;
    add_stiffness(end.cell, square / 2, forces.tangent);
    add_transport(end.cell, spin.acceleration / 2, forces.tangent);
    for (unsigned int i = 0; i < MixedElement::n_dofs; ++i)
      for (unsigned int j = 0; j < MixedElement::n_dofs; ++j)
        forces.tangent[i][j] += G[i][j];
  }


  void
  InertiaOfWheel::add_load_derivative(const CellState           &at,
                                      const LoadRates           &rates,
                                      MixedElement::NodalVector &force) const
  {
    force += 2 * at.loads.rolling->angular_velocity * rates.angular_velocity *
             unit_force(at.cell, at.V);
  }


  void
  InertiaOfWheel::add_load_derivative_over_step(
    const CellState           &start,
    const CellState           &end,
    const LoadRates           &rates,
    MixedElement::NodalVector &force) const
  {
    if (rates.angular_velocity == 0)
      return;
    const StepInTime &step   = *end.state.step;
    const auto        middle = 0.5 * (start.V + end.V);
    const auto        change = end.V - start.V;
    const double      mean   = rates.angular_velocity / 2;
    force +=
      2 * step.spin(end.loads).mean * mean * unit_force(end.cell, middle);
    force +=
      rates.angular_velocity / step.duration * unit_change(end.cell, middle);
    MixedElement::NodalMatrix G{};
    add_gyroscopic(end.cell, mean / step.duration, G);
    force -= product(G, change);
  }


  double
  InertiaOfWheel::potential(const State &state,
                            const double angular_velocity) const
  {
    double sum = 0;
    if (angular_velocity != 0)
      for (const Cell &cell : mesh.cells)
        if (cell.is_layer)
          {
            const auto V = mesh.cell_values(state.displacement, cell);
            for (unsigned int q = 0; q < 4; ++q)
              {
                const CircumferentialSlope slope(mesh, cell, q);
                const auto                 momentum = unit_momentum(cell, V, q);
                for (unsigned int face = 0; face < 2; ++face)
                  sum += momentum[face] * slope.of(V, face);
              }
          }
    return -angular_velocity * angular_velocity / 2 *
           Utilities::MPI::sum(sum, mesh.communicator);
  }


  void
  InertiaOfWheel::add_momentum(const State &state,
                               const double angular_velocity,
                               LA::Vector  &momentum) const
  {
    for (const Cell &cell : mesh.cells)
      if (cell.is_layer)
        mesh.add_nodal_forces(
          cell,
          -angular_velocity *
            unit_change(cell, mesh.cell_values(state.displacement, cell)),
          momentum);
  }
} // namespace Biface
