// SPDX-License-Identifier: LGPL-2.1-or-later

#include <optional>

#include <biface/element/mixed_element.h>

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
    for (const auto part : {MixedElement::mean, MixedElement::half_difference})
      {
        const Tensor<1, 3> v = nodal_value(V, q, part);
        for (unsigned int a = 0; a < 2; ++a)
          {
            const Tensor<1, 3> g =
              vertex.slope[a] * (v - nodal_value(V, q ^ (1 << a), part)) +
              vertex.connection[a] * v;
            for (unsigned int face = 0; face < 2; ++face)
              u.g[face][a] += part == MixedElement::mean
                                ? g
                                : MixedElement::face_sign[face] * g;
          }
        if (part == MixedElement::half_difference)
          u.beta = 2 / vertex.thickness * v;
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

      for (const auto part :
           {MixedElement::mean, MixedElement::half_difference})
        {
          Tensor<1, 3> f;
          if (part == MixedElement::half_difference)
            f = 2 / vertex.thickness * conjugate_beta;
          for (unsigned int a = 0; a < 2; ++a)
            {
              const Tensor<1, 3> p = part == MixedElement::mean
                                       ? conjugate.g[1][a] + conjugate.g[0][a]
                                       : conjugate.g[1][a] - conjugate.g[0][a];
              f += vertex.slope[a] * p + p * vertex.connection[a];
              for (unsigned int i = 0; i < 3; ++i)
                force[MixedElement::dof(q ^ (1 << a), i, part)] -=
                  vertex.slope[a] * p[i];
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
    if (with_means())
      {
        change  = StrainMeans::change(geometry, gradients);
        vectors = geometry.undeformed;
        vectors += change;
      }
  }


  Modes::Vector
  MixedElement::strain() const
  {
    std::array<Resultants::Vector, 4> at_vertices;
    for (unsigned int q = 0; q < 4; ++q)
      at_vertices[q] =
        green_lagrange_strain(gradients[q], geometry.vertices[q].metric);
    Modes::Vector E = Modes::from_vertices(at_vertices);
    if (with_means())
      {
        // |d|^2 - |E|^2 = (d - E) . (d + E)
        MeanVectors sum = vectors;
        sum += geometry.undeformed;
        StrainMeans::add_products(geometry, change, sum, 1, E);
      }
    return E;
  }


  Modes::Vector
  MixedElement::strain_variation(const NodalVector &dV) const
  {
    std::array<DisplacementGradient, 4> variation;
    std::array<Resultants::Vector, 4>   at_vertices;
    for (unsigned int q = 0; q < 4; ++q)
      {
        variation[q]   = displacement_gradient(geometry, dV, q);
        at_vertices[q] = Biface::strain_variation(
          gradients[q], variation[q], geometry.vertices[q].metric);
      }
    Modes::Vector E = Modes::from_vertices(at_vertices);
    if (with_means())
      StrainMeans::add_products(
        geometry, vectors, StrainMeans::change(geometry, variation), 2, E);
    return E;
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
    Modes::Vector eta = Modes::from_vertices(at_vertices);
    if (with_means())
      StrainMeans::add_products(geometry, change, change, 1, eta);
    return eta;
  }


  MixedElement::NodalVector
  MixedElement::internal_force(const Modes::Vector &H,
                               const Modes::Vector &H_0) const
  {
    const auto at_vertices = Modes::to_vertices(geometry.weight * H);
    const auto total_at_vertices =
      Modes::to_vertices(geometry.weight * (H + H_0));
    MeanVectors means;
    if (with_means())
      {
        means = StrainMeans::Coupling(geometry, geometry.weight * H)
                  .apply(geometry.undeformed);
        means += StrainMeans::Coupling(geometry, geometry.weight * (H + H_0))
                   .apply(change);
      }

    NodalVector force;
    for (unsigned int q = 0; q < 4; ++q)
      {
        const ThicknessMetric &metric = geometry.vertices[q].metric;
        DisplacementGradient   conjugate =
          linear_conjugate(at_vertices[q], metric);
        conjugate +=
          GeometricCoupling(total_at_vertices[q], metric).apply(gradients[q]);
        if (with_means())
          conjugate += StrainMeans::conjugate_at_vertex(geometry, means, q);
        add_nodal_force(geometry, conjugate, q, force);
      }
    return force;
  }


  MixedElement::NodalVector
  MixedElement::tangent_product(const ModeStiffness &stiffness,
                                const Modes::Vector &H,
                                const NodalVector   &dV) const
  {
    NodalVector force = internal_force(
      stiffness.resultants(strain_variation(dV)), Modes::Vector());

    std::array<DisplacementGradient, 4> variation;
    for (unsigned int q = 0; q < 4; ++q)
      variation[q] = displacement_gradient(geometry, dV, q);
    MeanVectors means;
    if (with_means())
      means = StrainMeans::Coupling(geometry, geometry.weight * H)
                .apply(StrainMeans::change(geometry, variation));

    const auto at_vertices = Modes::to_vertices(geometry.weight * H);
    for (unsigned int q = 0; q < 4; ++q)
      {
        DisplacementGradient conjugate =
          GeometricCoupling(at_vertices[q], geometry.vertices[q].metric)
            .apply(variation[q]);
        if (with_means())
          conjugate += StrainMeans::conjugate_at_vertex(geometry, means, q);
        add_nodal_force(geometry, conjugate, q, force);
      }
    return force;
  }


  void
  MixedElement::strain_matrix(StrainMatrix &B) const
  {
    using namespace Resultants;

    for (auto &row : B)
      row.fill(0);

    for (unsigned int q = 0; q < 4; ++q)
      {
        const ElementGeometry::Vertex &vertex = geometry.vertices[q];
        const DisplacementGradient    &u      = gradients[q];

        // the contribution of vertex q to the modes of a strain
        const auto add_to_modes = [&](const unsigned int strain,
                                      const unsigned int j,
                                      const double       value) {
          for (unsigned int m = 0; m < Modes::groups.size(); ++m)
            if (Modes::mode_of[m][strain] != Modes::n)
              B[Modes::mode_of[m][strain]][j] +=
                Modes::groups[m].value_at_vertex(q) / 4 * value;
        };

        // d(strain) = p . d(beta)
        const auto add_beta = [&](const unsigned int  strain,
                                  const Tensor<1, 3> &p) {
          for (unsigned int i = 0; i < 3; ++i)
            add_to_modes(
              strain, dof(q, i, half_difference), 2 / vertex.thickness * p[i]);
        };

        // d(strain) = p . d(g_a)
        const auto add_g = [&](const unsigned int  strain,
                               const unsigned int  face,
                               const unsigned int  a,
                               const Tensor<1, 3> &p) {
          const Tensor<1, 3> own =
            vertex.slope[a] * p + p * vertex.connection[a];
          for (const auto part : {mean, half_difference})
            {
              const double sign = (part == mean ? 1. : face_sign[face]);
              for (unsigned int i = 0; i < 3; ++i)
                {
                  add_to_modes(strain, dof(q, i, part), sign * own[i]);
                  add_to_modes(strain,
                               dof(q ^ (1 << a), i, part),
                               -sign * vertex.slope[a] * p[i]);
                }
            }
          if (vertex.face_slope[face][a] != 0)
            add_beta(strain, -vertex.face_slope[face][a] * p);
        };

        for (unsigned int face = 0; face < 2; ++face)
          {
            const auto &zeta = vertex.metric.zeta[face];
            const auto &g    = u.g[face];
            for (unsigned int a = 0; a < 2; ++a)
              {
                const unsigned int c = 1 - a;

                Tensor<1, 3> p = g[a] / (zeta[a] * zeta[a]);
                p[a] += 1 / zeta[a];
                add_g(tangential(a, face), face, a, p);

                p = g[c] / (zeta[0] * zeta[1]);
                p[c] += 1 / zeta[a];
                add_g(tangential(2, face), face, a, p);

                const double zeta_bar = vertex.metric.zeta_bar[a];
                p                     = u.beta / zeta_bar;
                p[2] += 1 / zeta_bar;
                add_g(transverse(a, face), face, a, p);

                p = g[a] / zeta_bar;
                p[a] += zeta[a] / zeta_bar;
                add_beta(transverse(a, face), p);
              }
          }
        Tensor<1, 3> p = u.beta;
        p[2] += 1;
        add_beta(thickness, p);
      }
  }


  void
  MixedElement::add_geometric_stiffness(const Modes::Vector &H,
                                        NodalMatrix         &K) const
  {
    const auto resultants = Modes::to_vertices(geometry.weight * H);

    for (unsigned int q = 0; q < 4; ++q)
      {
        const ElementGeometry::Vertex &vertex = geometry.vertices[q];
        const GeometricCoupling        coupling =
          GeometricCoupling(resultants[q], vertex.metric)
            .along_faces(vertex.face_slope);

        const auto add = [&](const unsigned int  node_i,
                             const Part          part_i,
                             const unsigned int  node_j,
                             const Part          part_j,
                             const Tensor<2, 3> &block) {
          for (unsigned int i = 0; i < 3; ++i)
            for (unsigned int j = 0; j < 3; ++j)
              K[dof(node_i, i, part_i)][dof(node_j, j, part_j)] += block[i][j];
        };
        const auto add_with_transpose = [&](const unsigned int  node_i,
                                            const Part          part_i,
                                            const unsigned int  node_j,
                                            const Part          part_j,
                                            const Tensor<2, 3> &block) {
          add(node_i, part_i, node_j, part_j, block);
          add(node_j, part_j, node_i, part_i, transpose(block));
        };
        const auto add_scalar = [&](const unsigned int node_i,
                                    const Part         part_i,
                                    const unsigned int node_j,
                                    const Part         part_j,
                                    const double       value) {
          for (unsigned int i = 0; i < 3; ++i)
            K[dof(node_i, i, part_i)][dof(node_j, i, part_j)] += value;
        };

        const std::array<unsigned int, 2> neighbor{{q ^ 1, q ^ 2}};
        const std::array<double, 2>      &slope  = vertex.slope;
        const double                      d_beta = 2 / vertex.thickness;

        // g_a = own_a v_q - slope_a v_neighbor
        std::array<Tensor<2, 3>, 2> own;
        for (unsigned int a = 0; a < 2; ++a)
          {
            own[a] = vertex.connection[a];
            for (unsigned int i = 0; i < 3; ++i)
              own[a][i][i] += slope[a];
          }

        // equal parts are coupled by the sum over the faces, different parts by
        // the difference
        for (const bool equal : {true, false})
          {
            const double          sign = (equal ? 1. : -1.);
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
            const Tensor<2, 3> diagonal =
              transpose(own[0]) * coupled[0] + transpose(own[1]) * coupled[1];

            for (const auto part : {mean, half_difference})
              {
                const Part other =
                  (part == mean) == equal ? mean : half_difference;
                add(q, part, q, other, diagonal);
                for (unsigned int a = 0; a < 2; ++a)
                  {
                    add_with_transpose(
                      neighbor[a], part, q, other, -slope[a] * coupled[a]);
                    for (unsigned int c = 0; c < 2; ++c)
                      add_scalar(neighbor[a],
                                 part,
                                 neighbor[c],
                                 other,
                                 slope[a] * slope[c] * gg[a == c ? a : 2]);
                  }
              }

            // the director depends on the half difference alone
            const Part part = (equal ? mean : half_difference);
            add_with_transpose(q,
                               half_difference,
                               q,
                               part,
                               d_beta * (gb[0] * own[0] + gb[1] * own[1]));
            for (unsigned int a = 0; a < 2; ++a)
              {
                const double value = -slope[a] * d_beta * gb[a];
                add_scalar(q, half_difference, neighbor[a], part, value);
                add_scalar(neighbor[a], part, q, half_difference, value);
              }
          }
        add_scalar(q,
                   half_difference,
                   q,
                   half_difference,
                   d_beta * d_beta * coupling.bb);
      }
  }


  void
  MixedElement::add_tangent(const ModeStiffness &stiffness,
                            const Modes::Vector &H,
                            NodalMatrix         &K) const
  {
    alignas(64) StrainMatrix B;
    strain_matrix(B);
    std::optional<StrainMeans::Maps> maps;
    if (with_means())
      {
        maps.emplace(geometry);
        add_mean_terms(*maps, B);
      }

    for (const Modes::Group &group : Modes::groups)
      for (unsigned int i = 0; i < stiffness.size(group); ++i)
        {
          // row i of D B
          alignas(64) std::array<double, n_dofs> DB;
          DB.fill(0);
          for (unsigned int j = 0; j < stiffness.size(group); ++j)
            {
              const double d = geometry.weight * group.weight(i) *
                               stiffness(group.strains[i], group.strains[j]);
              const auto &row = B[group.first_mode + j];
              for (unsigned int k = 0; k < n_dofs; ++k)
                DB[k] += d * row[k];
            }

          const auto &row = B[group.first_mode + i];
          for (unsigned int k = 0; k < n_dofs; ++k)
            {
              const double b = row[k];
              for (unsigned int l = 0; l < n_dofs; ++l)
                K[k][l] += b * DB[l];
            }
        }

    add_geometric_stiffness(H, K);
    if (with_means())
      add_geometric_stiffness_of_means(H, *maps, K);
  }


  namespace
  {
    /** Of a node, see MixedElement::dof(): the unknowns of a column of
     * StrainMeans::Maps. */
    constexpr unsigned int
    dof_of_column(const unsigned int column, const MixedElement::Part part)
    {
      return MixedElement::dof(column / 3, column % 3, part);
    }


    using Column = std::array<double, StrainMeans::Maps::n_columns>;

    /** The scalar product of a vector with each column of a matrix. */
    Column
    product(const Tensor<1, 3> &p, const StrainMeans::Maps::Matrix &matrix)
    {
      Column result;
      for (unsigned int k = 0; k < result.size(); ++k)
        result[k] =
          p[0] * matrix[0][k] + p[1] * matrix[1][k] + p[2] * matrix[2][k];
      return result;
    }
  } // namespace


  void
  MixedElement::add_mean_terms(const StrainMeans::Maps &maps,
                               StrainMatrix            &B) const
  {
    using namespace Resultants;
    using StrainMeans::Maps;

    // d(strain) = p . d(slope) + m . d(mean) + b . d(slope of the director),
    // the last ones optional
    const auto add = [&](const unsigned int  mode,
                         const unsigned int  face,
                         const unsigned int  a,
                         const Tensor<1, 3> &p,
                         const Tensor<1, 3> *m,
                         const Tensor<1, 3> *b) {
      std::array<double, n_dofs> &row  = B[mode];
      const unsigned int          c    = 1 - a;
      Column                      v    = product(p, maps.tangent[face][a]);
      const double                sign = face_sign[face];
      for (unsigned int k = 0; k < v.size(); ++k)
        v[k] *= Maps::sign(a, k);
      if (m)
        {
          const Column of_mean = product(*m, maps.tangent[face][c]);
          for (unsigned int k = 0; k < v.size(); ++k)
            v[k] += of_mean[k];
        }
      for (unsigned int k = 0; k < v.size(); ++k)
        {
          row[dof_of_column(k, mean)] += v[k];
          row[dof_of_column(k, half_difference)] += sign * v[k];
        }

      if (b || maps.tapered)
        {
          Tensor<1, 3> along[4];
          for (unsigned int q = 0; q < 4; ++q)
            {
              const double sign_q = MeanVectors::sign(a, q);
              if (b)
                along[q] = sign_q * *b;
              if (maps.tapered)
                {
                  along[q] += sign_q * maps.tilt[face][a][q] * p;
                  if (m)
                    along[q] += maps.tilt[face][c][q] * *m;
                }
            }
          for (unsigned int k = 0; k < v.size(); ++k)
            {
              const Tensor<1, 3> &r = along[k / 3];
              row[dof_of_column(k, half_difference)] +=
                2 / geometry.vertices[k / 3].thickness *
                (r[0] * maps.director[0][k] + r[1] * maps.director[1][k] +
                 r[2] * maps.director[2][k]);
            }
        }
    };

    for (unsigned int a = 0; a < 2; ++a)
      {
        const double phi = -2. / 3 * geometry.mean_factor[a];
        for (unsigned int face = 0; face < 2; ++face)
          {
            const Tensor<1, 3> &slope    = vectors.slope[face][a];
            const double        phi_zeta = phi * geometry.zeta_ratio[face][a];
            add(tangential(a, face), face, a, phi * slope, nullptr, nullptr);

            const Tensor<1, 3> b = phi_zeta * slope;
            add(transverse(a, face),
                face,
                a,
                phi_zeta * vectors.director[a],
                nullptr,
                &b);

            const double       half = face_sign[face] / 2;
            const Tensor<1, 3> m    = half * slope;
            add(StrainMeans::twist_mode(a),
                face,
                a,
                half * vectors.mean[face][1 - a],
                &m,
                nullptr);
          }
      }
  }


  void
  MixedElement::add_geometric_stiffness_of_means(const Modes::Vector     &H,
                                                 const StrainMeans::Maps &maps,
                                                 NodalMatrix &K) const
  {
    using StrainMeans::Maps;
    constexpr unsigned int      n = Maps::n_columns;
    const StrainMeans::Coupling coupling(geometry, geometry.weight * H);
    using Matrix = std::array<Column, n>;

    // Every term is a product of the slope of a tangent and one other vector,
    // so that half of the matrix and its transpose add up to the whole:
    // `of_face` has the displacements of a face on both sides, `of_director`
    // the directors on one; `sum` over the faces, and `difference`.
    alignas(64) Matrix of_face[2];
    alignas(64) Matrix sum, difference;
    Maps::Matrix       director_sum[2], director_difference[2];
    for (unsigned int face = 0; face < 2; ++face)
      {
        alignas(64) std::array<Maps::Matrix, 2> X, Y;
        for (unsigned int a = 0; a < 2; ++a)
          {
            const double slope    = coupling.slope[face][a] / 2;
            const double twist    = coupling.twist[face][a];
            const double director = coupling.director[face][a];
            for (unsigned int i = 0; i < 3; ++i)
              for (unsigned int k = 0; k < n; ++k)
                {
                  X[a][i][k] = Maps::sign(a, k) * maps.tangent[face][a][i][k];
                  Y[a][i][k] = slope * X[a][i][k] +
                               twist * maps.tangent[face][1 - a][i][k];
                  const double x = director * X[a][i][k];
                  director_sum[a][i][k] =
                    (face == 0 ? x : director_sum[a][i][k] + x);
                  director_difference[a][i][k] =
                    (face == 0 ? -x : director_difference[a][i][k] + x);
                }
          }
        for (unsigned int k = 0; k < n; ++k)
          for (unsigned int l = 0; l < n; ++l)
            of_face[face][k][l] =
              X[0][0][k] * Y[0][0][l] + X[0][1][k] * Y[0][1][l] +
              X[0][2][k] * Y[0][2][l] + X[1][0][k] * Y[1][0][l] +
              X[1][1][k] * Y[1][1][l] + X[1][2][k] * Y[1][2][l];
      }

    const auto multiply = [&](const Maps::Matrix(&x)[2], Matrix &result) {
      for (unsigned int q = 0; q < 4; ++q)
        {
          const double             d_beta = 2 / geometry.vertices[q].thickness;
          alignas(64) Maps::Matrix at_q;
          for (unsigned int i = 0; i < 3; ++i)
            for (unsigned int l = 0; l < n; ++l)
              at_q[i][l] = d_beta * (MeanVectors::sign(0, q) * x[0][i][l] +
                                     MeanVectors::sign(1, q) * x[1][i][l]);
          for (unsigned int j = 0; j < 3; ++j)
            for (unsigned int l = 0; l < n; ++l)
              result[3 * q + j][l] = maps.director[0][3 * q + j] * at_q[0][l] +
                                     maps.director[1][3 * q + j] * at_q[1][l] +
                                     maps.director[2][3 * q + j] * at_q[2][l];
        }
    };
    multiply(director_sum, sum);
    multiply(director_difference, difference);

    Matrix of_directors{};
    if (maps.tapered)
      for (unsigned int face = 0; face < 2; ++face)
        for (unsigned int a = 0; a < 2; ++a)
          {
            const double slope    = coupling.slope[face][a] / 2;
            const double twist    = coupling.twist[face][a];
            const double director = coupling.director[face][a];
            for (unsigned int k = 0; k < n; ++k)
              {
                const double d_beta = 2 / geometry.vertices[k / 3].thickness;
                const double sign_k = Maps::sign(a, k);
                const double tilt = d_beta * sign_k * maps.tilt[face][a][k / 3];
                const double tilt_c = d_beta * maps.tilt[face][1 - a][k / 3];
                for (unsigned int l = 0; l < n; ++l)
                  {
                    const double e_beta =
                      2 / geometry.vertices[l / 3].thickness;
                    const double sign_l = Maps::sign(a, l);
                    double       by_own = 0, by_other = 0, both = 0;
                    for (unsigned int i = 0; i < 3; ++i)
                      {
                        const double x = sign_l * maps.tangent[face][a][i][l];
                        const double y = maps.tangent[face][1 - a][i][l];
                        by_own += maps.director[i][k] * x;
                        by_other += maps.director[i][k] * y;
                        both += maps.director[i][k] * maps.director[i][l];
                      }
                    const double value =
                      tilt * (2 * slope * by_own + twist * by_other) +
                      tilt_c * twist * by_own;
                    sum[k][l] += value;
                    difference[k][l] += face_sign[face] * value;
                    of_directors[k][l] +=
                      tilt * both * e_beta *
                      ((slope * maps.tilt[face][a][l / 3] + director) * sign_l +
                       twist * maps.tilt[face][1 - a][l / 3]);
                  }
              }
          }

    for (unsigned int k = 0; k < n; ++k)
      for (unsigned int l = 0; l < n; ++l)
        {
          const double inner = of_face[0][k][l] + of_face[0][l][k];
          const double outer = of_face[1][k][l] + of_face[1][l][k];
          double      *row_of_mean =
            &K[dof_of_column(k, mean)][dof_of_column(l, mean)];
          double *row_of_half =
            &K[dof_of_column(k, half_difference)][dof_of_column(l, mean)];
          row_of_mean[0] += outer + inner;
          row_of_mean[1] += outer - inner + sum[l][k];
          row_of_half[0] += outer - inner + sum[k][l];
          row_of_half[1] += outer + inner + difference[k][l] +
                            difference[l][k] + of_directors[k][l] +
                            of_directors[l][k];
        }
  }
} // namespace Biface
