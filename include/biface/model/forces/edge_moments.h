// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_forces_edge_moments_h
#define biface_model_forces_edge_moments_h

#include <deal.II/base/tensor.h>

#include <array>
#include <string>
#include <vector>

#include <biface/model/forces/force_term.h>
#include <biface/model/mesh/shell_mesh.h>

namespace Biface
{
  /** A moment along an edge. */
  struct EdgeMoment
  {
    /** The text of the user. */
    std::string text;
    /** The name of the edge, see MeshNodes::edges. */
    std::string edge;
    /** The moment per length on the reference surface, for the load factor 1.
     * Unit: force. */
    double moment;
    /** Whether the moment does work on the rotation of the director, or is a
     * couple of forces with constant directions. */
    bool follower;
    /** The position of the load factor in Loads::factors. */
    unsigned int factor = 0;
  };

  /** Read a comma-separated list of moments along edges, 'edge: M dead' or
   * 'edge: M follower'. Throws InputError if it is malformed. */
  std::vector<EdgeMoment>
  parse_edge_moments(const std::string &entry, const std::string &text);


  /** A moment along the side of a cell on an edge, lumped at its vertices. */
  struct SideMoment
  {
    /** The wall beside the edge, whose half differences at the vertices of the
     * side are those of its section: the thickness of the wall times half the
     * weighted mean of the displacements of all faces of the layers whose
     * weights are the forces that a plane section with the unit moment exerts
     * on these faces, by the initial stiffness of the plies. Where
     * displacements are linear over the wall, they are those of its two
     * faces. */
    Cell section;
    /** The numbers of the vertices in the cell. */
    std::array<unsigned int, 2> vertices;
    /** The moment at each vertex, per unit of the load factor. Unit: force
     * times length. */
    double moment;
    /** The axes of the moment at both vertices in the frames of the nodes, see
     * BoundarySegment::axes: the moment pushes the outer face outward beyond
     * the edge, in the direction @f$\boldsymbol\omega\times\mathbf e_3@f$. */
    std::array<dealii::Tensor<1, 3>, 2> axes;
    /** The position of the factor of the moment in Loads::factors. */
    unsigned int factor;

    /** Add a force on the outer face at a vertex, and the opposite one on the
     * inner face. */
    static void
    add_couple(const dealii::Tensor<1, 3> &force,
               const unsigned int          vertex,
               MixedElement::NodalVector  &forces);
  };


  /** The moments along edges on the cells of this rank.
   * @param follower whether to return follower or dead moments. */
  std::vector<SideMoment>
  side_moments(const std::vector<EdgeMoment> &moments,
               const bool                     follower,
               const ShellMesh               &mesh);


  /**
   * The couple of opposite forces on the outer and the inner face of a moment
   * about a fixed axis @f$\boldsymbol\omega@f$ that does work on the angle by
   * which the director @f$\mathbf d@f$ (from the inner to the outer face, of
   * a section of several layers see SideMoment) rotates about it, whatever its
   * length:
   * @f$\mathbf F = M\,\boldsymbol\omega\times\mathbf d/|\mathbf d_\perp|^2@f$,
   * where @f$\mathbf d_\perp@f$ is the part of the director normal to the axis.
   * It has a potential, so that its derivative is symmetric.
   */
  struct FollowerCouple
  {
    dealii::Tensor<1, 3> force;
    /** The derivative of the force by the director. */
    dealii::Tensor<2, 3> derivative;

    FollowerCouple(const double                moment,
                   const dealii::Tensor<1, 3> &axis,
                   const dealii::Tensor<1, 3> &director);
  };


  /** The forces of follower moments along edges. */
  class FollowerMoments : public ForceTerm
  {
  public:
    FollowerMoments(const ShellMesh               &mesh,
                    const std::vector<EdgeMoment> &edge_moments);

    std::vector<const Cell *>
    elements() const override;

    void
    add(const CellState &at, CellForces &forces) const override;

    void
    add_load_derivative(const CellState           &at,
                        const LoadRates           &rates,
                        MixedElement::NodalVector &force) const override;

  private:
    /** The couple at one of the vertices of a moment, 0 or 1, for the load
     * factor 1. */
    static FollowerCouple
    couple(const CellState   &at,
           const SideMoment  &moment,
           const unsigned int end);

    const std::vector<SideMoment> moments;
  };
} // namespace Biface

#endif
