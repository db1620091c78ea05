// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_mesh_pressed_directors_h
#define biface_model_mesh_pressed_directors_h

#include <vector>

#include <biface/laminate/resultants.h>
#include <biface/model/mesh/shell_mesh.h>

namespace Biface
{
  /**
   * What a pressure on a face lacks because directors are interpolated.
   *
   * The wall passes the pressure on from the loaded face to where its tension
   * acts, at the distance @f$\bar z@f$. Directors that tilt in turn from node
   * to node by @f$\pm\theta@f$ keep the thickness at the nodes and have no
   * shear, but let the face between them move by @f$\bar z\theta^2/2@f$ toward
   * the tension, and the pressure does work: cells longer than
   * @f$\sqrt{4D/(p\bar z)}@f$, with the bending stiffness D, would be unstable.
   * The pressure therefore acts on the face at its distance without this loss,
   * that is, the volume behind the face is less by
   * @f[
   *   \sum_k \bar z_k\,T_k, \qquad \bar z_k=\int_k s\,dz,
   * @f]
   * over the layers k, with the DirectorTilt @f$T_k@f$ and the part s of the
   * pressure that passes through the height z: one at the loaded face, less the
   * part of the initial stiffness of the wall against strains along its faces
   * up to there. The sum of the @f$\bar z_k@f$ is @f$\bar z@f$. It vanishes
   * with the square of the length of the cells.
   *
   * With Formulation::paper, and for a dead pressure, there is nothing to add.
   */
  class PressedDirectors
  {
  public:
    /** @param mesh kept by reference.
     * @param face the loaded face.
     * @param follows whether the pressure follows the face. */
    PressedDirectors(const ShellMesh       &mesh,
                     const Resultants::Face face,
                     const bool             follows = true);

    /** Whether an element, by its position in ShellMesh::cells, is a layer for
     * which there is something to add. */
    bool
    act_on(const unsigned int cell) const
    {
      return distances[cell] > 0;
    }

    /** The change of the volume behind the face due to an element. Unit:
     * length^3.
     * @param V its nodal displacements. */
    double
    volume(const Cell &cell, const MixedElement::NodalVector &V) const;

    /** Add the forces of a pressure, the derivative of the volume times the
     * pressure. */
    void
    add_force(const double                     pressure,
              const Cell                      &cell,
              const MixedElement::NodalVector &V,
              MixedElement::NodalVector       &force) const;

    /** Add the mean of the forces between two states, which does the work of
     * the change of the volume. */
    void
    add_mean_force(const double                     pressure,
                   const Cell                      &cell,
                   const MixedElement::NodalVector &start,
                   const MixedElement::NodalVector &end,
                   MixedElement::NodalVector       &force) const;

    /** Add the derivative of the forces. */
    void
    add_derivative(const double                     pressure,
                   const Cell                      &cell,
                   const MixedElement::NodalVector &V,
                   MixedElement::NodalMatrix       &K) const;

  private:
    /** The distances @f$\bar z_k@f$ by the position of the layer in
     * ShellMesh::cells. Unit: length. */
    std::vector<double> distances;
  };
} // namespace Biface

#endif
