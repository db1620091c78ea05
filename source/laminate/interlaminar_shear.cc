// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <algorithm>
#include <cmath>

#include <biface/laminate/interlaminar_shear.h>
#include <biface/laminate/thickness_functions.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    /** Scale rows and columns to a largest entry of 1.
     * @return the factors of the rows and of the columns. */
    std::array<Vector<double>, 2>
    equilibrate(FullMatrix<double> &matrix)
    {
      const unsigned int            n = matrix.m();
      std::array<Vector<double>, 2> scales{
        {Vector<double>(n), Vector<double>(n)}};
      for (const bool rows : {false, true})
        for (unsigned int i = 0; i < n; ++i)
          {
            double largest = 0;
            for (unsigned int j = 0; j < n; ++j)
              largest =
                std::max(largest, std::abs(rows ? matrix(i, j) : matrix(j, i)));
            const double scale = (largest > 0 ? 1 / largest : 1.);
            for (unsigned int j = 0; j < n; ++j)
              (rows ? matrix(i, j) : matrix(j, i)) *= scale;
            scales[rows ? 0 : 1][i] = scale;
          }
      return scales;
    }
  } // namespace


  InterlaminarShear::InterlaminarShear(
    const std::vector<TransverseShear> &layers, const TransverseShear &wall)
    : layers(layers)
  {
    // exact for a distribution that is quadratic in each ply
    static const QGauss<1> quadrature(2);
    unsigned int           number = 0;
    double                 bottom = 0;
    for (const TransverseShear &layer : layers)
      {
        Tensor<2, 2> part;
        for (const TransverseShear::Ply &ply : layer.get_plies())
          {
            for (unsigned int q = 0; q < quadrature.size(); ++q)
              {
                const double z =
                  ply.begin + (ply.end - ply.begin) * quadrature.point(q)[0];
                part += quadrature.weight(q) * (ply.end - ply.begin) *
                        wall.distribution(number, bottom + z);
              }
            ++number;
          }
        parts_of_wall.push_back(part);
        bottom += layer.get_thickness();
      }

    const unsigned int n_layers = layers.size();
    const unsigned int n        = 2 * (n_layers + 1);
    for (unsigned int c = 0; c < 2; ++c)
      {
        // the strains with gradients, and the stresses of equilibrium along
        // alpha_c and across
        const std::array<unsigned int, 2> strains{{c, 2}};

        // by equation; a column for each strain of each face
        FullMatrix<double> matrix(n, n);
        for (unsigned int k = 0; k < n_layers; ++k)
          {
            const double h = layers[k].get_thickness();
            for (const TransverseShear::Ply &ply : layers[k].get_plies())
              {
                const FaceMoments N(ply.begin, ply.end, h);
                for (unsigned int i = 0; i < 2; ++i)
                  for (unsigned int j = 0; j < 2; ++j)
                    for (unsigned int p = 0; p < 2; ++p)
                      {
                        const unsigned int column = 2 * (k + p) + j;
                        const double       q =
                          ply.plane_stress[strains[i]][strains[j]];
                        // membrane force
                        matrix(i, column) += q * N.first[p];
                        // shear forces of this layer: what is below adds its
                        // change of the membrane force over the whole height,
                        // each height z what is left above it
                        matrix(2 + 2 * k + i, column) -= q * h * N.second[0][p];
                        for (unsigned int m = k + 1; m < n_layers; ++m)
                          matrix(2 + 2 * m + i, column) -=
                            q * N.first[p] * layers[m].get_thickness();
                      }
              }
          }
        // rows of membrane and of shear forces differ by a length, columns by
        // the moduli of plies, which may be of different magnitudes
        const auto scales = equilibrate(matrix);
        matrix.gauss_jordan();

        // membrane forces have no gradient, so that the first two columns of
        // the inverse are not needed; each other one belongs to a unit shear
        // force of a layer, along or across
        for (unsigned int row = 2; row < n; ++row)
          {
            std::vector<Tensor<1, 3>> of_faces(n_layers + 1);
            for (unsigned int face = 0; face <= n_layers; ++face)
              for (unsigned int j = 0; j < 2; ++j)
                {
                  const unsigned int column = 2 * face + j;
                  of_faces[face][strains[j]] =
                    scales[1][column] * matrix(column, row) * scales[0][row];
                }
            gradients[c].push_back(of_faces);
          }
      }
  }


  Tensor<1, 2>
  InterlaminarShear::stress(const std::vector<Tensor<1, 2>> &shear_forces,
                            const unsigned int               layer,
                            const unsigned int               ply,
                            const double                     z) const
  {
    AssertDimension(shear_forces.size(), layers.size());
    Tensor<1, 2> total;
    for (const Tensor<1, 2> &Q : shear_forces)
      total += Q;

    // the equilibrium from the inner face up to the height: stresses by the law
    // of a layer jump between layers
    Tensor<1, 2> stress;
    for (unsigned int k = 0; k <= layer; ++k)
      {
        const auto        &plies = layers[k].get_plies();
        const unsigned int last  = (k < layer ? plies.size() - 1 : ply);
        for (unsigned int c = 0; c < 2; ++c)
          {
            std::array<Tensor<1, 3>, 2> of_faces;
            for (unsigned int m = 0; m < shear_forces.size(); ++m)
              {
                // bending along both coordinates is superposed; where plies at
                // an angle couple them, the forces across are parts of those of
                // the wall
                const Tensor<2, 2> &part = parts_of_wall[m];
                const double        along =
                  shear_forces[m][c] - part[c][1 - c] * total[1 - c];
                const double across = part[1 - c][c] * total[c];
                for (unsigned int p = 0; p < 2; ++p)
                  of_faces[p] += along * gradients[c][2 * m][k + p] +
                                 across * gradients[c][2 * m + 1][k + p];
              }
            // minus the gradients of the stresses, summed from the inner face
            // to the height: there are no tractions on the face itself
            for (unsigned int i = 0; i <= last; ++i)
              {
                const double end = (k == layer && i == ply ? z : plies[i].end);
                const FaceMoments N(
                  plies[i].begin, end, layers[k].get_thickness());
                const Tensor<1, 3> change =
                  plies[i].plane_stress *
                  (N.first[0] * of_faces[0] + N.first[1] * of_faces[1]);
                stress[c] -= change[c];
                stress[1 - c] -= change[2];
              }
          }
      }
    return stress;
  }
} // namespace Biface
