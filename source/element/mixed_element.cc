// SPDX-License-Identifier: LGPL-2.1-or-later

#include <biface/element/mixed_element.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    Tensor<1, 3>
    nodal_displacement(const MixedElement::NodalVector &V,
                       const unsigned int               vertex,
                       const unsigned int               face)
    {
      Tensor<1, 3> v;
      for (unsigned int i = 0; i < 3; ++i)
        v[i] = V[MixedElement::dof(vertex, i, face)];
      return v;
    }
  } // namespace


  DisplacementGradient
  displacement_gradient(const ElementGeometry           &geometry,
                        const MixedElement::NodalVector &V,
                        const unsigned int               q)
  {
    const ElementGeometry::Vertex &vertex = geometry.vertices[q];

    DisplacementGradient u;
    for (unsigned int face = 0; face < 2; ++face)
      {
        const Tensor<1, 3> v = nodal_displacement(V, q, face);
        for (unsigned int a = 0; a < 2; ++a)
          u.g[face][a] =
            vertex.slope[a] * (v - nodal_displacement(V, q ^ (1 << a), face)) +
            vertex.connection[a] * v;
        u.beta += MixedElement::beta_sign[face] / vertex.thickness * v;
      }
    for (unsigned int face = 0; face < 2; ++face)
      for (unsigned int a = 0; a < 2; ++a)
        u.g[face][a] -= vertex.face_slope[face][a] * u.beta;
    return u;
  }


  namespace
  {
    /** The transpose of displacement_gradient(). */
    void
    add_nodal_force(const ElementGeometry      &geometry,
                    const DisplacementGradient &conjugate,
                    const unsigned int          q,
                    MixedElement::NodalVector  &force)
    {
      const ElementGeometry::Vertex &vertex = geometry.vertices[q];

      Tensor<1, 3> conjugate_beta = conjugate.beta;
      for (unsigned int face = 0; face < 2; ++face)
        for (unsigned int a = 0; a < 2; ++a)
          conjugate_beta -= vertex.face_slope[face][a] * conjugate.g[face][a];

      for (unsigned int face = 0; face < 2; ++face)
        {
          Tensor<1, 3> f =
            MixedElement::beta_sign[face] / vertex.thickness * conjugate_beta;
          for (unsigned int a = 0; a < 2; ++a)
            {
              const Tensor<1, 3> &p = conjugate.g[face][a];
              f += vertex.slope[a] * p + p * vertex.connection[a];
              for (unsigned int i = 0; i < 3; ++i)
                force[MixedElement::dof(q ^ (1 << a), i, face)] -=
                  vertex.slope[a] * p[i];
            }
          for (unsigned int i = 0; i < 3; ++i)
            force[MixedElement::dof(q, i, face)] += f[i];
        }
    }


    /** What does work on the linear part of the strains. */
    DisplacementGradient
    linear_conjugate(const Resultants::Vector &H, const ThicknessMetric &metric)
    {
      using namespace Resultants;
      DisplacementGradient p;
      for (unsigned int face = 0; face < 2; ++face)
        for (unsigned int a = 0; a < 2; ++a)
          {
            const double zeta   = metric.zeta[face][a];
            const double H_a3   = H[transverse(a, face)] / metric.zeta_bar[a];
            p.g[face][a][a]     = H[tangential(a, face)] / zeta;
            p.g[face][a][1 - a] = H[tangential(2, face)] / zeta;
            p.g[face][a][2]     = H_a3;
            p.beta[a] += zeta * H_a3;
          }
      p.beta[2] = H[thickness];
      return p;
    }
  } // namespace


  MixedElement::MixedElement(const ElementGeometry &geometry,
                             const NodalVector     &V)
    : geometry(geometry)
  {
    for (unsigned int q = 0; q < 4; ++q)
      gradients[q] = displacement_gradient(geometry, V, q);
  }


  Modes::Vector
  MixedElement::strain() const
  {
    std::array<Resultants::Vector, 4> at_vertices;
    for (unsigned int q = 0; q < 4; ++q)
      at_vertices[q] =
        green_lagrange_strain(gradients[q], geometry.vertices[q].metric);
    return Modes::from_vertices(at_vertices);
  }


  Modes::Vector
  MixedElement::strain_variation(const NodalVector &dV) const
  {
    std::array<Resultants::Vector, 4> at_vertices;
    for (unsigned int q = 0; q < 4; ++q)
      at_vertices[q] =
        Biface::strain_variation(gradients[q],
                                 displacement_gradient(geometry, dV, q),
                                 geometry.vertices[q].metric);
    return Modes::from_vertices(at_vertices);
  }


  Modes::Vector
  MixedElement::nonlinear_strain() const
  {
    std::array<Resultants::Vector, 4> at_vertices;
    for (unsigned int q = 0; q < 4; ++q)
      {
        const ThicknessMetric &metric = geometry.vertices[q].metric;
        at_vertices[q] = green_lagrange_strain(gradients[q], metric) -
                         Biface::strain_variation(
                           DisplacementGradient(), gradients[q], metric);
      }
    return Modes::from_vertices(at_vertices);
  }


  MixedElement::NodalVector
  MixedElement::internal_force(const Modes::Vector &H,
                               const Modes::Vector &H_0) const
  {
    const auto at_vertices = Modes::to_vertices(geometry.weight * H);
    const auto total_at_vertices =
      Modes::to_vertices(geometry.weight * (H + H_0));
    NodalVector force;
    for (unsigned int q = 0; q < 4; ++q)
      {
        const ThicknessMetric &metric = geometry.vertices[q].metric;
        add_nodal_force(
          geometry, linear_conjugate(at_vertices[q], metric), q, force);
        add_nodal_force(
          geometry,
          GeometricCoupling(total_at_vertices[q], metric).apply(gradients[q]),
          q,
          force);
      }
    return force;
  }
} // namespace Biface
