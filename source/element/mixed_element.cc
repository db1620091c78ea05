// SPDX-License-Identifier: LGPL-2.1-or-later

#include <biface/element/mixed_element.h>

// The tangent is compiled twice, once for processors that work on four numbers
// at a time; the loader chooses. Not with fused multiply-add: it rounds
// differently what cancels between the faces of a thin shell.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && \
  !defined(__SANITIZE_ADDRESS__) && !defined(DEBUG)
#  define BIFACE_VECTORIZED \
    __attribute__((flatten, target_clones("avx2", "default")))
#else
#  define BIFACE_VECTORIZED
#endif

namespace Biface
{
  using namespace dealii;

  namespace
  {
    /** One of the two vectors of unknowns at a vertex. */
    Tensor<1, 3>
    nodal_value(const MixedElement::NodalVector &V,
                const unsigned int               vertex,
                const MixedElement::Part         part)
    {
      Tensor<1, 3> v;
      for (unsigned int i = 0; i < 3; ++i)
        v[i] = V[MixedElement::dof(vertex, i, part)];
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
    const Tensor<1, 3> half = nodal_value(V, q, MixedElement::half_difference);
    u.beta                  = 2 / vertex.thickness * half;
    const Tensor<1, 3> v    = nodal_value(V, q, MixedElement::mean);
    for (unsigned int a = 0; a < 2; ++a)
      {
        const unsigned int neighbor = q ^ (1 << a);
        const Tensor<1, 3> of_mean  = geometry.derivative(
          q, a, v, nodal_value(V, neighbor, MixedElement::mean));
        const Tensor<1, 3> of_half = geometry.derivative(
          q, a, half, nodal_value(V, neighbor, MixedElement::half_difference));
        for (unsigned int face = 0; face < 2; ++face)
          for (unsigned int i = 0; i < 3; ++i)
            u.g[face][a][i] = of_mean[i] +
                              MixedElement::face_sign[face] * of_half[i] -
                              vertex.face_slope[face][a] * u.beta[i];
      }
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

      // where the thickness varies, the derivative at constant height enters
      // the strains, see DisplacementGradient::g
      Tensor<1, 3> conjugate_beta = conjugate.beta;
      for (unsigned int face = 0; face < 2; ++face)
        for (unsigned int a = 0; a < 2; ++a)
          conjugate_beta -= vertex.face_slope[face][a] * conjugate.g[face][a];

      for (const auto part :
           {MixedElement::mean, MixedElement::half_difference})
        {
          Tensor<1, 3> f;
          if (part == MixedElement::half_difference)
            f = 2 / vertex.thickness * conjugate_beta;
          for (unsigned int a = 0; a < 2; ++a)
            {
              const auto [own, other] = geometry.conjugate_of_derivative(
                q,
                a,
                part == MixedElement::mean
                  ? conjugate.g[1][a] + conjugate.g[0][a]
                  : conjugate.g[1][a] - conjugate.g[0][a]);
              f += own;
              for (unsigned int i = 0; i < 3; ++i)
                force[MixedElement::dof(q ^ (1 << a), i, part)] += other[i];
            }
          for (unsigned int i = 0; i < 3; ++i)
            force[MixedElement::dof(q, i, part)] += f[i];
        }
    }


    /** The work-conjugate vectors of the linear part of the strains. */
    DisplacementGradient
    linear_conjugate(const Resultants::Vector &H, const ThicknessMetric &metric)
    {
      using namespace Resultants;
      DisplacementGradient p;
      for (unsigned int face = 0; face < 2; ++face)
        for (unsigned int a = 0; a < 2; ++a)
          {
            const double zeta = metric.zeta[face][a];
            const double H_a3 = H[transverse(a, face)] / metric.zeta_bar[a];
            const auto  &t    = metric.tangents[face];
            p.g[face][a]      = H[tangential(a, face)] / zeta * t[a] +
                           H[tangential(2, face)] / zeta * t[1 - a];
            p.g[face][a][2] += H_a3;
            p.beta += zeta * H_a3 * t[a];
          }
      p.beta[2] += H[thickness];
      return p;
    }
  } // namespace


  MixedElement::MixedElement(const ElementGeometry &geometry,
                             const NodalVector     &V)
    : geometry(geometry)
  {
    if (of_vectors())
      {
        cell_change = vectors_of(V);
        cell        = geometry.quadrilateral->undeformed();
        for (unsigned int k = 0; k < Quadrilateral::n_vectors; ++k)
          cell[k] += cell_change[k];
        if (with_normal_thickness())
          shear = NormalThickness::shear(strain_of_directors(), tangents());
        return;
      }
    for (unsigned int q = 0; q < 4; ++q)
      gradients[q] = displacement_gradient(geometry, V, q);
  }


  MixedElement::MixedElement(const ElementGeometry &geometry,
                             const NodalVector     &start,
                             const NodalVector     &end)
    : MixedElement(geometry, (start + end) / 2)
  {
    // x_1 y_1 - x_0 y_0 = the mean of x times the change of y, and conversely
    if (with_normal_thickness())
      {
        const MixedElement at_start(geometry, start), at_end(geometry, end);
        for (unsigned int g = 0; g < shear.size(); ++g)
          for (unsigned int a = 0; a < 2; ++a)
            shear[g][a] = (at_start.shear[g][a] + at_end.shear[g][a]) / 2;
      }
  }


  Modes::Vector
  MixedElement::strain() const
  {
    Modes::Vector E = strain_of_directors();
    if (with_normal_thickness())
      NormalThickness::subtract_products(shear, shear, 0.5, E);
    return E;
  }


  Quadrilateral::Vectors
  MixedElement::vectors_of(const NodalVector &V) const
  {
    Quadrilateral::NodalVectors nodal;
    for (unsigned int q = 0; q < 4; ++q)
      for (const auto part : {mean, half_difference})
        nodal[4 * part + q] =
          geometry.vertices[q].axes * nodal_value(V, q, part);
    return geometry.quadrilateral->vectors(nodal);
  }


  MixedElement::NodalVector
  MixedElement::forces_of(const Quadrilateral::Vectors &conjugate) const
  {
    const auto  nodal = geometry.quadrilateral->conjugate_at_nodes(conjugate);
    NodalVector force;
    for (unsigned int q = 0; q < 4; ++q)
      for (const auto part : {mean, half_difference})
        {
          const Tensor<1, 3> f =
            nodal[4 * part + q] * geometry.vertices[q].axes;
          for (unsigned int i = 0; i < 3; ++i)
            force[dof(q, i, part)] = f[i];
        }
    return force;
  }


  Quadrilateral::Form
  MixedElement::second_variation(const Modes::Vector &H) const
  {
    Modes::Vector weighted = H;
    for (const Modes::Group &group : Modes::groups)
      for (unsigned int i = 0; i < group.size; ++i)
        weighted[group.first_mode + i] *= group.weight(i);
    const Quadrilateral &quadrilateral = *geometry.quadrilateral;
    return quadrilateral.form(quadrilateral.covariant_resultants(weighted));
  }


  Modes::Vector
  MixedElement::strain_of_directors() const
  {
    if (of_vectors())
      {
        // |x|^2 - |X|^2 = (x - X) . (x + X)
        const Quadrilateral   &quadrilateral = *geometry.quadrilateral;
        Quadrilateral::Vectors mean          = cell_change;
        for (unsigned int k = 0; k < mean.size(); ++k)
          mean[k] = quadrilateral.undeformed()[k] + cell_change[k] / 2;
        return quadrilateral.physical(
          quadrilateral.products(cell_change, mean));
      }

    std::array<Resultants::Vector, 4> at_vertices;
    for (unsigned int q = 0; q < 4; ++q)
      at_vertices[q] =
        green_lagrange_strain(gradients[q], geometry.vertices[q].metric);
    return Modes::from_vertices(at_vertices);
  }


  Modes::Vector
  MixedElement::strain_variation(const NodalVector &dV) const
  {
    if (of_vectors())
      {
        const Quadrilateral &quadrilateral = *geometry.quadrilateral;
        Modes::Vector        E =
          quadrilateral.physical(quadrilateral.products(cell, vectors_of(dV)));
        if (with_normal_thickness())
          NormalThickness::subtract_products(
            shear, NormalThickness::shear(E, tangents()), 1, E);
        return E;
      }

    std::array<DisplacementGradient, 4> variation;
    std::array<Resultants::Vector, 4>   at_vertices;
    for (unsigned int q = 0; q < 4; ++q)
      {
        variation[q]   = displacement_gradient(geometry, dV, q);
        at_vertices[q] = Biface::strain_variation(
          gradients[q], variation[q], geometry.vertices[q].metric);
      }
    return Modes::from_vertices(at_vertices);
  }


  Modes::Vector
  MixedElement::nonlinear_strain() const
  {
    if (of_vectors())
      {
        const Quadrilateral &quadrilateral = *geometry.quadrilateral;
        Modes::Vector        eta           = quadrilateral.physical(
          quadrilateral.products(cell_change, cell_change) / 2);
        if (with_normal_thickness())
          NormalThickness::subtract_products(shear, shear, 0.5, eta);
        return eta;
      }

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


  Modes::Vector
  MixedElement::hourglass_strain(const NodalVector &dV) const
  {
    if (of_vectors())
      return geometry.quadrilateral->hourglass_strain(vectors_of(dV));

    std::array<DisplacementGradient, 4> variation;
    for (unsigned int q = 0; q < 4; ++q)
      variation[q] = displacement_gradient(geometry, dV, q);

    Modes::Vector eta;
    for (unsigned int face = 0; face < 2; ++face)
      for (unsigned int a = 0; a < 2; ++a)
        {
          Tensor<1, 3> slope;
          double       mean_square = 0;
          for (unsigned int q = 0; q < 4; ++q)
            {
              const double zeta = geometry.vertices[q].metric.zeta[face][a];
              // the coordinate other than a is -1 or 1 at the vertex
              const double sign = ((q & (2 >> a)) == 0 ? -1. : 1.);
              slope += sign / 4 * variation[q].g[face][a];
              mean_square += 1 / (4 * zeta * zeta);
            }
          eta[Resultants::tangential(a, face)] =
            slope.norm_square() / 2 * mean_square;
        }
    return eta;
  }


  MixedElement::NodalVector
  MixedElement::internal_force(const Modes::Vector &resultants,
                               const Modes::Vector &H_0) const
  {
    Modes::Vector H = resultants;
    if (with_normal_thickness())
      H += NormalThickness::resultants(shear, resultants + H_0, tangents());

    // initial resultants do work on the nonlinear part of the strains only: in
    // the undeformed shape, constant forces balance them
    if (of_vectors())
      {
        Quadrilateral::Vectors conjugate =
          Quadrilateral::apply(second_variation(geometry.weight * H),
                               geometry.quadrilateral->undeformed());
        const Quadrilateral::Vectors of_change = Quadrilateral::apply(
          second_variation(geometry.weight * (H + H_0)), cell_change);
        for (unsigned int k = 0; k < conjugate.size(); ++k)
          conjugate[k] += of_change[k];
        return forces_of(conjugate);
      }
    const auto at_vertices = Modes::to_vertices(geometry.weight * H);
    const auto total_at_vertices =
      Modes::to_vertices(geometry.weight * (H + H_0));

    NodalVector force;
    for (unsigned int q = 0; q < 4; ++q)
      {
        const ThicknessMetric &metric = geometry.vertices[q].metric;
        DisplacementGradient   conjugate =
          linear_conjugate(at_vertices[q], metric);
        conjugate +=
          GeometricCoupling(total_at_vertices[q], metric).apply(gradients[q]);
        add_nodal_force(geometry, conjugate, q, force);
      }
    return force;
  }


  MixedElement::NodalVector
  MixedElement::tangent_product(const ModeStiffness &stiffness,
                                const Modes::Vector &resultants,
                                const NodalVector   &dV) const
  {
    // B^T D B dV and G[H] dV without the matrices, whose large entries would
    // cancel only up to round-off
    const Modes::Vector dE    = strain_variation(dV);
    const Modes::Vector dH    = stiffness.resultants(dE);
    NodalVector         force = internal_force(dH, Modes::Vector());
    Modes::Vector       H     = resultants;
    if (with_normal_thickness())
      {
        H += NormalThickness::resultants(shear, resultants, tangents());
        // only modes of shear
        force += internal_force(
          NormalThickness::resultants(
            NormalThickness::shear(dE, tangents()), resultants, tangents()),
          Modes::Vector());
      }

    if (of_vectors())
      {
        force += forces_of(Quadrilateral::apply(
          second_variation(geometry.weight * H), vectors_of(dV)));
        return force;
      }

    std::array<DisplacementGradient, 4> variation;
    for (unsigned int q = 0; q < 4; ++q)
      variation[q] = displacement_gradient(geometry, dV, q);

    const auto at_vertices = Modes::to_vertices(geometry.weight * H);
    for (unsigned int q = 0; q < 4; ++q)
      {
        DisplacementGradient conjugate =
          GeometricCoupling(at_vertices[q], geometry.vertices[q].metric)
            .apply(variation[q]);
        add_nodal_force(geometry, conjugate, q, force);
      }
    return force;
  }


  namespace
  {
    // Within a tangent, unknowns are sorted part by part, the twelve of a part
    // vertex by vertex: loops over them are long and contiguous.
    constexpr unsigned int n_of_part = MixedElement::n_dofs / 2;
    using PartVector                 = std::array<double, n_of_part>;
    using PartMatrix                 = std::array<PartVector, n_of_part>;


    /**
     * The variation of each strain at the four vertices, the column of an
     * unknown holding the derivative that belongs to it: of the strain at the
     * vertex of this unknown, or at the neighbor of that vertex.
     */
    struct VariationAtVertices
    {
      using Rows = std::array<PartVector, Resultants::n>;

      /** By the displacement of the strain's face at the same vertex. */
      alignas(64) Rows own{};
      /** By the displacement of that face at the neighbor along
       * @f$\alpha_a@f$. */
      alignas(64) std::array<Rows, 2> neighbor{};
      /** By the half difference at the same vertex. */
      alignas(64) Rows director{};

      VariationAtVertices(const ElementGeometry                     &geometry,
                          const std::array<DisplacementGradient, 4> &gradients)
      {
        using namespace Resultants;

        for (unsigned int q = 0; q < 4; ++q)
          {
            const ElementGeometry::Vertex &vertex = geometry.vertices[q];
            const DisplacementGradient    &u      = gradients[q];

            // d(strain) = p . d(beta)
            const auto add_beta = [&](const unsigned int  strain,
                                      const Tensor<1, 3> &p) {
              for (unsigned int i = 0; i < 3; ++i)
                director[strain][3 * q + i] += 2 / vertex.thickness * p[i];
            };

            // d(strain) = p . d(g_a)
            const auto add_g = [&](const unsigned int  strain,
                                   const unsigned int  face,
                                   const unsigned int  a,
                                   const Tensor<1, 3> &p) {
              const auto [at_q, at_neighbor] =
                geometry.conjugate_of_derivative(q, a, p);
              for (unsigned int i = 0; i < 3; ++i)
                {
                  own[strain][3 * q + i] += at_q[i];
                  neighbor[a][strain][3 * (q ^ (1 << a)) + i] += at_neighbor[i];
                }
              if (vertex.face_slope[face][a] != 0)
                add_beta(strain, -vertex.face_slope[face][a] * p);
            };

            // the derivatives of green_lagrange_strain() by its five vectors
            for (unsigned int face = 0; face < 2; ++face)
              {
                const auto &zeta = vertex.metric.zeta[face];
                const auto &g    = u.g[face];
                const auto &t    = vertex.metric.tangents[face];
                for (unsigned int a = 0; a < 2; ++a)
                  {
                    const unsigned int c = 1 - a;

                    Tensor<1, 3> p = g[a] / (zeta[a] * zeta[a]);
                    p += 1 / zeta[a] * t[a];
                    add_g(tangential(a, face), face, a, p);

                    p = g[c] / (zeta[0] * zeta[1]);
                    p += 1 / zeta[a] * t[c];
                    add_g(tangential(2, face), face, a, p);

                    const double zeta_bar = vertex.metric.zeta_bar[a];
                    p                     = u.beta / zeta_bar;
                    p[2] += 1 / zeta_bar;
                    add_g(transverse(a, face), face, a, p);

                    p = g[a] / zeta_bar;
                    p += zeta[a] / zeta_bar * t[a];
                    add_beta(transverse(a, face), p);
                  }
              }
            Tensor<1, 3> p = u.beta;
            p[2] += 1;
            add_beta(thickness, p);
          }
      }
    };


    /** The sign of the face to which a strain belongs; that of the thickness
     * depends on the director alone. */
    double
    sign_of_face(const unsigned int strain)
    {
      using namespace Resultants;
      for (unsigned int face = 0; face < 2; ++face)
        for (unsigned int i = 0; i < 3; ++i)
          if (strain == tangential(i, face) ||
              (i < 2 && strain == transverse(i, face)))
            return MixedElement::face_sign[face];
      return 0;
    }
  } // namespace


  void
  MixedElement::strain_matrix_of_vectors(StrainMatrix &B) const
  {
    alignas(64) Quadrilateral::Rows rows;
    geometry.quadrilateral->variation(cell, rows);
    for (unsigned int m = 0; m < Modes::n; ++m)
      for (unsigned int part = 0; part < 2; ++part)
        for (unsigned int q = 0; q < 4; ++q)
          {
            const Tensor<2, 3> &axes = geometry.vertices[q].axes;
            const unsigned int  r    = 4 * part + q;
            for (unsigned int i = 0; i < 3; ++i)
              B[m][n_of_part * part + 3 * q + i] = rows[m][r] * axes[0][i] +
                                                   rows[m][8 + r] * axes[1][i] +
                                                   rows[m][16 + r] * axes[2][i];
          }
  }


  void
  MixedElement::strain_matrix(StrainMatrix &B) const
  {
    const VariationAtVertices variation(geometry, gradients);

    for (const Modes::Group &group : Modes::groups)
      {
        // parts of the strain at the vertex of a column and at an adjacent one
        PartVector value;
        for (unsigned int k = 0; k < n_of_part; ++k)
          value[k] = group.value_at_vertex(k / 3) / 4;
        const std::array<double, 2> at_neighbor{
          {group.varies[0] ? -1. : 1., group.varies[1] ? -1. : 1.}};

        for (unsigned int i = 0; i < group.sampled; ++i)
          {
            const unsigned int s    = group.strains[i];
            const double       face = sign_of_face(s);
            auto              &row  = B[group.first_mode + i];
            for (unsigned int k = 0; k < n_of_part; ++k)
              {
                row[k] =
                  value[k] * (variation.own[s][k] +
                              at_neighbor[0] * variation.neighbor[0][s][k] +
                              at_neighbor[1] * variation.neighbor[1][s][k]);
                row[n_of_part + k] =
                  face * row[k] + value[k] * variation.director[s][k];
              }
          }
        for (unsigned int i = group.sampled; i < group.size; ++i)
          B[group.first_mode + i].fill(0);
      }
  }


  namespace
  {
    /**
     * The second variation of the strains, weighted by resultants, as
     * matrices: a half of each, which together with its transpose is the
     * whole.
     *
     * Products of displacements of a face couple equal parts by their sum over
     * the faces and different parts by the difference of the faces, since
     * @f$v^\pm=\bar v\pm\tilde v@f$. The director depends on the half
     * difference alone.
     */
    struct SecondVariation
    {
      /** Products of two displacements. */
      alignas(64) PartMatrix sum{}, difference{};
      /** Products of a director, the rows, and a displacement of a face. */
      alignas(64) PartMatrix director_sum{}, director_difference{};

      /** What is sampled at the vertices.
       *
       * @param resultants the weighted resultants at the vertices. */
      void
      add_vertices(const ElementGeometry                   &geometry,
                   const std::array<Resultants::Vector, 4> &resultants);

      /** All of it for a Quadrilateral. */
      void
      add_vectors(const ElementGeometry          &geometry,
                  const Quadrilateral::NodalForm &form);
    };


    void
    SecondVariation::add_vectors(const ElementGeometry          &geometry,
                                 const Quadrilateral::NodalForm &form)
    {
      for (unsigned int q = 0; q < 4; ++q)
        for (unsigned int r = 0; r < 4; ++r)
          {
            const Tensor<2, 3> turn    = geometry.turn(q, r);
            const double       by_mean = form[q][r] / 2;
            const double       mixed   = form[4 + q][r];
            const double       by_half = form[4 + q][4 + r] / 2 - by_mean;
            for (unsigned int i = 0; i < 3; ++i)
              for (unsigned int j = 0; j < 3; ++j)
                {
                  const unsigned int k = 3 * q + i, l = 3 * r + j;
                  sum[k][l] += by_mean * turn[i][j];
                  director_sum[k][l] += mixed * turn[i][j];
                  director_difference[k][l] += by_half * turn[i][j];
                }
          }
    }


    void
    SecondVariation::add_vertices(
      const ElementGeometry                   &geometry,
      const std::array<Resultants::Vector, 4> &resultants)
    {
      const auto add = [](PartMatrix         &matrix,
                          const unsigned int  row,
                          const unsigned int  column,
                          const Tensor<2, 3> &block) {
        for (unsigned int i = 0; i < 3; ++i)
          for (unsigned int j = 0; j < 3; ++j)
            matrix[3 * row + i][3 * column + j] += block[i][j];
      };
      const auto add_scalar = [](PartMatrix        &matrix,
                                 const unsigned int row,
                                 const unsigned int column,
                                 const double       value) {
        for (unsigned int i = 0; i < 3; ++i)
          matrix[3 * row + i][3 * column + i] += value;
      };

      // half of the symmetric matrix, to which add_tangent() adds its transpose
      for (unsigned int q = 0; q < 4; ++q)
        {
          const ElementGeometry::Vertex &vertex = geometry.vertices[q];
          const GeometricCoupling        coupling =
            GeometricCoupling(resultants[q], vertex.metric)
              .along_faces(vertex.face_slope);

          const std::array<unsigned int, 2> neighbor{{q ^ 1, q ^ 2}};
          const std::array<double, 2>      &slope  = vertex.slope;
          const double                      d_beta = 2 / vertex.thickness;

          // g_a = own_a v_q - slope_a v_neighbor, see ElementGeometry
          std::array<Tensor<2, 3>, 2> own;
          for (unsigned int a = 0; a < 2; ++a)
            {
              own[a] = vertex.connection[a];
              for (unsigned int i = 0; i < 3; ++i)
                own[a][i][i] += slope[a];
            }

          // in the mean and half the difference, the faces enter by the sum and
          // the difference of their terms
          const auto add_products = [&](const double sign,
                                        PartMatrix  &of_faces,
                                        PartMatrix  &of_director) {
            std::array<double, 3> gg;
            for (unsigned int k = 0; k < 3; ++k)
              gg[k] = coupling.gg[1][k] + sign * coupling.gg[0][k];
            std::array<double, 2> gb;
            for (unsigned int a = 0; a < 2; ++a)
              gb[a] = coupling.gb[1][a] + sign * coupling.gb[0][a];

            // coupled[a] = sum_c gg_ac own_c
            const std::array<Tensor<2, 3>, 2> coupled{
              {gg[0] * own[0] + gg[2] * own[1],
               gg[1] * own[1] + gg[2] * own[0]}};
            add(of_faces,
                q,
                q,
                0.5 * (transpose(own[0]) * coupled[0] +
                       transpose(own[1]) * coupled[1]));
            for (unsigned int a = 0; a < 2; ++a)
              {
                add(of_faces, neighbor[a], q, -slope[a] * coupled[a]);
                add_scalar(of_faces,
                           neighbor[a],
                           neighbor[a],
                           slope[a] * slope[a] * gg[a] / 2);
              }
            add_scalar(
              of_faces, neighbor[0], neighbor[1], slope[0] * slope[1] * gg[2]);

            add(of_director, q, q, d_beta * (gb[0] * own[0] + gb[1] * own[1]));
            for (unsigned int a = 0; a < 2; ++a)
              add_scalar(
                of_director, q, neighbor[a], -slope[a] * d_beta * gb[a]);
          };
          add_products(1, sum, director_sum);
          add_products(-1, difference, director_difference);
          add_scalar(
            director_difference, q, q, d_beta * d_beta * coupling.bb / 2);
        }
    }
  } // namespace


  void
  MixedElement::shear_matrix(const StrainMatrix &B, ShearMatrix &G) const
  {
    for (auto &rows : G)
      for (auto &row : rows)
        row.fill(0);
    NormalThickness::for_shear_modes(
      tangents(),
      [&](const unsigned int  a,
          const unsigned int  i,
          const Modes::Group &group,
          const double        of_mode) {
        for (unsigned int g = 0; g < Modes::n_gauss_points; ++g)
          {
            const double value =
              of_mode * Modes::value_at_gauss_point(group, g) / 2;
            for (unsigned int k = 0; k < n_dofs; ++k)
              G[g][a][k] += value * B[i][k];
          }
      });
  }


  void
  MixedElement::subtract_shear(const ShearMatrix &G, StrainMatrix &B) const
  {
    for (unsigned int m = 0; m < 4; ++m)
      for (unsigned int g = 0; g < Modes::n_gauss_points; ++g)
        {
          const double factor =
            Modes::value_at_gauss_point(Modes::groups[m], g) /
            (Modes::n_gauss_points * Modes::groups[m].weight());
          for (unsigned int a = 0; a < 2; ++a)
            for (unsigned int k = 0; k < n_dofs; ++k)
              B[NormalThickness::mode(m)][k] -=
                factor * shear[g][a] * G[g][a][k];
        }
  }


  void
  MixedElement::subtract_second_variation(const ShearMatrix   &G,
                                          const Modes::Vector &H,
                                          StrainMatrix        &DB) const
  {
    const auto H_33 = NormalThickness::thickness_resultants(H);
    NormalThickness::for_shear_modes(
      tangents(),
      [&](const unsigned int  a,
          const unsigned int  i,
          const Modes::Group &group,
          const double        of_mode) {
        for (unsigned int g = 0; g < Modes::n_gauss_points; ++g)
          {
            const double factor =
              of_mode * geometry.weight / (2 * Modes::n_gauss_points) *
              Modes::value_at_gauss_point(group, g) * H_33[g];
            for (unsigned int k = 0; k < n_dofs; ++k)
              DB[i][k] -= factor * G[g][a][k];
          }
      });
  }


  BIFACE_VECTORIZED
  void
  MixedElement::add_tangent(const ModeStiffness &stiffness,
                            const Modes::Vector &resultants,
                            NodalMatrix         &K,
                            const Modes::Matrix *added) const
  {
    Modes::Vector H = resultants;
    if (with_normal_thickness())
      H += NormalThickness::resultants(shear, resultants, tangents());

    alignas(64) StrainMatrix B;
    SecondVariation          variation;
    if (of_vectors())
      {
        strain_matrix_of_vectors(B);
        variation.add_vectors(geometry,
                              geometry.quadrilateral->at_nodes(
                                second_variation(geometry.weight * H)));
      }
    else
      {
        strain_matrix(B);
        variation.add_vertices(geometry,
                               Modes::to_vertices(geometry.weight * H));
      }
    alignas(64) ShearMatrix G;
    if (with_normal_thickness())
      {
        shear_matrix(B, G);
        subtract_shear(G, B);
      }

    // D B with the weights
    alignas(64) StrainMatrix DB;
    for (unsigned int m = 0; m < Modes::groups.size(); ++m)
      {
        const Modes::Group &group = Modes::groups[m];
        for (unsigned int i = 0; i < stiffness.size(group); ++i)
          {
            std::array<double, Resultants::n> D;
            for (unsigned int j = 0; j < stiffness.size(group); ++j)
              D[j] = geometry.weight * group.weight(i) * stiffness(m, i, j);
            alignas(64) std::array<double, n_dofs> row{};
            for (unsigned int j = 0; j < stiffness.size(group); ++j)
              for (unsigned int k = 0; k < n_dofs; ++k)
                row[k] += D[j] * B[group.first_mode + j][k];
            DB[group.first_mode + i] = row;
          }
      }

    // the rows are weighted already, since they are derivatives of an energy
    if (added)
      for (unsigned int m = 0; m < Modes::n; ++m)
        for (unsigned int n = 0; n < Modes::n; ++n)
          {
            const double c = geometry.weight * (*added)[m][n];
            for (unsigned int k = 0; k < n_dofs; ++k)
              DB[m][k] += c * B[n][k];
          }
    if (with_normal_thickness())
      subtract_second_variation(G, H, DB);

    std::array<unsigned int, Modes::n> modes;
    unsigned int                       n_modes = 0;
    for (const Modes::Group &group : Modes::groups)
      for (unsigned int i = 0; i < stiffness.size(group); ++i)
        modes[n_modes++] = group.first_mode + i;

    // rows of the tangent, with columns part by part
    const auto add_row = [&](const unsigned int k,
                             const Part         part,
                             const PartVector  &by_mean,
                             const PartVector  &by_half_difference) {
      alignas(64) std::array<double, n_dofs> row;
      for (unsigned int l = 0; l < n_of_part; ++l)
        {
          row[l]             = by_mean[l];
          row[n_of_part + l] = by_half_difference[l];
        }
      for (unsigned int n = 0; n < n_modes; ++n)
        {
          const double b  = B[modes[n]][n_of_part * part + k];
          const auto  &db = DB[modes[n]];
          for (unsigned int l = 0; l < n_dofs; ++l)
            row[l] += b * db[l];
        }
      auto &of_dof = K[dof(k / 3, k % 3, part)];
      for (unsigned int q = 0; q < 4; ++q)
        for (unsigned int i = 0; i < 3; ++i)
          for (const auto other : {mean, half_difference})
            of_dof[dof(q, i, other)] += row[n_of_part * other + 3 * q + i];
    };

    // B^T DB, and the symmetric sum of each half of the second variation and
    // its transpose
    for (unsigned int k = 0; k < n_of_part; ++k)
      {
        PartVector sum, difference, mean_by_half, half_by_half;
        for (unsigned int l = 0; l < n_of_part; ++l)
          {
            sum[l] = variation.sum[k][l] + variation.sum[l][k];
            const double d =
              variation.difference[k][l] + variation.difference[l][k];
            difference[l]   = d + variation.director_sum[k][l];
            mean_by_half[l] = d + variation.director_sum[l][k];
            half_by_half[l] = sum[l] + variation.director_difference[k][l] +
                              variation.director_difference[l][k];
          }
        add_row(k, mean, sum, mean_by_half);
        add_row(k, half_difference, difference, half_by_half);
      }
  }
} // namespace Biface
