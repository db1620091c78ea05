// SPDX-License-Identifier: LGPL-2.1-or-later

#include <array>

#include <biface/element/director_tilt.h>
#include <biface/model/mesh/pressed_directors.h>
#include <biface/model/mesh/strip.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    /** The stiffness of a layer without thickness stress against equal strains
     * in all directions along its faces, which does not depend on axes, by the
     * face that gets the force. */
    std::array<double, 2>
    stiffness_of_faces(const Laminate &layer)
    {
      using namespace Resultants;
      const Matrix         &D = layer.stiffness();
      std::array<double, 2> result{};
      for (unsigned int face = 0; face < 2; ++face)
        for (unsigned int a = 0; a < 2; ++a)
          for (unsigned int other = 0; other < 2; ++other)
            for (unsigned int b = 0; b < 2; ++b)
              {
                const unsigned int row    = tangential(a, face),
                                   column = tangential(b, other);
                result[face] += D[row][column] - D[row][thickness] *
                                                   D[thickness][column] /
                                                   D[thickness][thickness];
              }
      return result;
    }
  } // namespace


  PressedDirectors::PressedDirectors(const ShellMesh       &mesh,
                                     const Resultants::Face face,
                                     const bool             follows)
    : distances(mesh.cells.size())
  {
    if (mesh.formulation == Formulation::paper || !follows)
      return;

    for (const unsigned int wall : mesh.walls)
      {
        const auto [first, end] = mesh.layers_of(wall);
        double total            = 0;
        for (unsigned int c = first; c < end; ++c)
          for (const double of_face :
               stiffness_of_faces(mesh.strips[mesh.cells[c].strip].laminate))
            total += of_face;

        double             passed = 1;
        const unsigned int n      = end - first;
        for (unsigned int k = 0; k < n; ++k)
          {
            const unsigned int c =
              (face == Resultants::inner ? first + k : end - 1 - k);
            const Laminate &layer = mesh.strips[mesh.cells[c].strip].laminate;
            const auto      of_faces = stiffness_of_faces(layer);
            // what acts on the loaded face passes through nothing of the layer
            distances[c] =
              layer.thickness() * (passed - of_faces[face] / total);
            passed -= (of_faces[0] + of_faces[1]) / total;
          }
      }
  }


  double
  PressedDirectors::volume(const Cell                      &cell,
                           const MixedElement::NodalVector &V) const
  {
    return -distances[cell.position] * DirectorTilt(cell.geometry).value(V);
  }


  void
  PressedDirectors::add_force(const double                     pressure,
                              const Cell                      &cell,
                              const MixedElement::NodalVector &V,
                              MixedElement::NodalVector       &force) const
  {
    DirectorTilt(cell.geometry)
      .add_gradient(-pressure * distances[cell.position], V, force);
  }


  void
  PressedDirectors::add_mean_force(const double                     pressure,
                                   const Cell                      &cell,
                                   const MixedElement::NodalVector &start,
                                   const MixedElement::NodalVector &end,
                                   MixedElement::NodalVector       &force) const
  {
    DirectorTilt(cell.geometry)
      .add_mean_gradient(
        -pressure * distances[cell.position], start, end, force);
  }


  void
  PressedDirectors::add_derivative(const double                     pressure,
                                   const Cell                      &cell,
                                   const MixedElement::NodalVector &V,
                                   MixedElement::NodalMatrix       &K) const
  {
    DirectorTilt(cell.geometry)
      .add_second_derivative(-pressure * distances[cell.position], V, K);
  }
} // namespace Biface
