// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_air_air_column_h
#define biface_model_air_air_column_h

#include <deal.II/base/tensor.h>

#include <optional>
#include <utility>
#include <vector>

#include <biface/base/linear_algebra.h>
#include <biface/laminate/resultants.h>
#include <biface/model/mesh/pressed_directors.h>
#include <biface/model/mesh/shell_mesh.h>

namespace Biface
{
  class EntryDeclarations;
  struct State;


  /** Small motions of the air in the cavity of a shell of revolution along its
   * circumference, in a given state. The cells between neighboring lines of the
   * second coordinate are a piece of the column. */
  struct AirMotion
  {
    /** @f$V_c/B@f$ of each piece, with its volume and the adiabatic bulk
     * modulus. Unit: length^5/force. */
    std::vector<double> compliances;

    /** A section between two pieces, through which air moves from the first to
     * the second. */
    struct Section
    {
      unsigned int from, to;
      /** The inertia against the volume that has moved, @f$\varrho\ell/A@f$.
       * Unit: mass/length^4. */
      double inertia;
      /** Unit: length^2. */
      double area;
      /** The unit vector toward the second piece. */
      dealii::Tensor<1, 3> direction;
    };
    std::vector<Section> sections;

    /** The derivatives of the volumes of the pieces by the displacements of the
     * wall: the owned unknowns of this rank, supported ones included, that are
     * not zero. */
    std::vector<std::vector<std::pair<dealii::types::global_dof_index, double>>>
      gradients;

    /** Whether the column is closed around the axis, so that the air can
     * circulate. */
    bool is_closed = false;

    /** An estimate of @f$\omega^2@f$ of the first wave around a closed, rigid
     * column. */
    double
    first_wave() const;

    /** Whether the unknowns of the air are those of this rank: the last one. */
    static bool
    is_on_this_rank(const MPI_Comm communicator);
  };


  /**
   * The air in the cavity as a column along the circumference, with plane waves
   * (Webster's equation). With the volumes @f$q_j@f$ that have moved through
   * the sections, the pressure of a piece rises by
   * @f$-B\,(\partial V_c/\partial\mathbf V\cdot\mathbf
   * u+q_{c+1}-q_c)/V_c@f$, and acts on the wall of the piece.
   *
   * The motion in a section is that of a vortex, @f$\propto 1/r@f$, so that per
   * angle the inertia is @f$\varrho/\int dA/r@f$, and the volume
   * @f$\int r\,dA@f$; both are those of the deformed section, which the
   * cylinder of the rim closes. Waves in a rigid cavity of constant section
   * have the frequencies @f$n\,(c/2\pi)\sqrt{\int dA/r\,/\int r\,dA}@f$.
   */
  class AirColumn
  {
  public:
    /** Entries of the section 'Gas' on the motion of the air. */
    struct Parameters
    {
      /** The speed of sound; not set for air without inertia. Unit:
       * length/time. */
      std::optional<double> sound_speed;
      /** The adiabatic exponent @f$\gamma@f$ in
       * @f$B=\gamma\,(p+p_a)@f$. */
      double exponent = 1.4;

      void
      add_parameters(EntryDeclarations &prm);

      /** Throws InputError if a value is invalid. */
      void
      check() const;
    };

    /** The air in the cavity of a mesh, which is kept by reference.
     * @param parameters with a sound speed.
     * @param rim_radius of the cylinder that closes the cavity; positive. Unit:
     * length.
     * @param face under pressure. */
    AirColumn(const ShellMesh       &mesh,
              const Parameters      &parameters,
              const double           ambient_pressure,
              const double           rim_radius,
              const Resultants::Face face)
      : mesh(mesh)
      , parameters(parameters)
      , ambient_pressure(ambient_pressure)
      , rim_radius(rim_radius)
      , face(face)
      , directors(mesh, face)
    {}

    /** The motions about a state under a pressure. Must be called on all
     * ranks. */
    AirMotion
    about(const State &state, const double pressure) const;

  private:
    const ShellMesh       &mesh;
    const Parameters       parameters;
    const double           ambient_pressure, rim_radius;
    const Resultants::Face face;
    const PressedDirectors directors;
  };
} // namespace Biface

#endif
