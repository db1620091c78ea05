// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_forces_cavity_h
#define biface_model_forces_cavity_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <optional>
#include <vector>

#include <biface/base/linear_algebra.h>
#include <biface/laminate/resultants.h>
#include <biface/model/forces/gaps_at_folds.h>
#include <biface/model/mesh/pressed_directors.h>
#include <biface/model/mesh/shell_mesh.h>

namespace Biface
{
  class EntryDeclarations;
  struct State;


  /**
   * The space inside the shell that a gas fills. The undeformed volume is the
   * flux through the exact face under pressure of a vector field with the
   * divergence 1: for a surface of revolution
   * @f[
   *   V_0 = \int \mathbf F\cdot\mathbf n\,dA,\qquad
   *   \mathbf F = \frac{r^2-r_0^2}{2r}\,\mathbf e_r ,
   * @f]
   * which does not pass through the cylinder of the rim, of radius
   * @f$r_0@f$, nor through planes that contain the axis or are orthogonal to
   * it: these may close the cavity. The change of the volume is that of the
   * flux through the faces of the cells, see FollowerPressure::flux(), of
   * @f$\mathbf s/2@f$ with @f$\mathbf s = r\mathbf e_r@f$; what remains,
   * @f$-r_0^2/(2r)\,\mathbf e_r@f$, has the flux of what planes at the edges
   * of the first coordinate sweep within the rim as they move along the axis
   * with the edge. The gradient of the volume is the force of a unit pressure,
   * with that of the planes, wherever the edges move in planes and cylinders
   * that close the cavity.
   *
   * On a mesh from a file the faces of the cells and the gaps at folds, see
   * GapAtFold, are closed except in planes of symmetry, through which the field
   * does not pass, and at edges that do not move. The field is a third of
   * the position, a half or all of its components along the planes, or the
   * distance from a plane if there are planes normal to all three axes.
   */
  class Cavity
  {
  public:
    /** Entries of the section 'Gas' on the cavity. */
    struct Parameters
    {
      /** The volume under the undeformed shell; computed from its shape if not
       * set. Unit: length^3. */
      std::optional<double> volume;
      /** The radius @f$r_0@f$ of the rim; if not set, the smallest radius of
       * the face at the edges of the first coordinate. Unit: length. */
      std::optional<double> rim_radius;

      void
      add_parameters(EntryDeclarations &prm);

      /** Throws InputError if a value is invalid.
       * @param is_known whether the volume follows from the shape of the shell,
       * and need not be given. */
      void
      check(const bool is_known) const;
    };

    /** The space under a face. Throws InputError on all ranks if its volume is
     * not positive, or if a mesh from a file is open.
     * @param mesh kept by reference.
     * @param face the face under pressure.
     * @param follows whether the pressure follows the face; see
     * PressedDirectors. */
    Cavity(const ShellMesh       &mesh,
           const Parameters      &parameters,
           const Resultants::Face face,
           const bool             follows = true);

    /** The radius of the cylinder that closes the cavity toward the axis; 0 if
     * there is none. Unit: length. */
    double
    get_rim_radius() const
    {
      return rim_radius;
    }

    /** The volume of the cavity, on all ranks. Unit: length^3. */
    double
    volume(const State &state) const;

    /** The derivative of the volume with respect to the nodal unknowns. */
    LA::Vector
    volume_gradient(const State &state) const;

  private:
    /** Choose the field on a mesh from a file. */
    void
    set_field_of_mesh(const Parameters &parameters);

    /** The vector field @f$\mathbf F@f$ at a point; for a plane @f$z\,\mathbf
     * e_z@f$. */
    dealii::Tensor<1, 3>
    field(const dealii::Point<3> &x) const;

    /** The sum of the fluxes of the linear part of the field through the
     * deformed faces of the cells and the gaps of this rank.
     * @param V null in the undeformed shell.
     * @param gradient its derivative by the nodal unknowns is added, unless
     * null. */
    double
    flux(const LA::Vector *V, LA::Vector *gradient = nullptr) const;

    /** The flux of the linear part of the field through the deformed face of a
     * cell.
     * @param gradient its derivative is added, unless null. */
    double
    flux(const Cell                      &cell,
         const MixedElement::NodalVector &V,
         MixedElement::NodalVector       *gradient = nullptr) const;

    /** The flux through the undeformed face of a cell. */
    double
    exact_flux(const Cell &cell) const;

    /** The height of the face of a cell at a vertex above the reference
     * surface. Unit: length. */
    double
    height(const Cell &cell, const unsigned int vertex) const;

    /** The smallest radius of the undeformed face at the edges of the first
     * coordinate; zero without an axis. */
    double
    radius_of_edges() const;

    const ShellMesh       &mesh;
    const Resultants::Face face;
    /** The axis of revolution; zero if there is none. */
    const dealii::Tensor<1, 3> axis;
    const double               rim_radius;
    /** The linear part of the field, @f$\mathbf A\mathbf x@f$. */
    dealii::Tensor<2, 3> linear_part;
    /** The point from which @f$\mathbf x@f$ counts. */
    dealii::Tensor<1, 3> origin;
    /** The gaps at folds of the face. */
    const std::vector<GapAtFold> gaps;
    const PressedDirectors       directors;
    /** The derivative of what planes within the rim at the edges sweep. */
    LA::Vector within_rim;
    /** The volume under the undeformed shell, less the flux of its cells. */
    double constant;
  };
} // namespace Biface

#endif
