// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_contact_bristle_lines_h
#define biface_model_contact_bristle_lines_h

#include <deal.II/base/tensor.h>

#include <functional>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include <biface/contact/bristles.h>
#include <biface/model/forces/force_term.h>
#include <biface/model/mesh/shell_mesh.h>
#include <biface/model/mesh/streamlines.h>

namespace Biface
{
  struct ContactState;
  struct PlacedBody;
  struct RollingStep;


  /**
   * The bristles of a footprint, on all its streamlines, see BristleLaw: each
   * rank has those of its own nodes, and knows on which nodes before them they
   * depend, on any rank. Without bristles there are no lines, and all that
   * they add is zero.
   */
  class BristleLines
  {
  public:
    /** Compute the bristles, those that have moved on over the step of the
     * state if it has one, see State::rolling_step. Must be called on all
     * ranks.
     * @param face that touches the body.
     * @param number that of the pair, see ContactPair::number.
     * @param zone what happens between both.
     * @param body whose laws may have bristles; null if it is not there.
     * @param rolling null if the shell stands. */
    BristleLines(const ShellMesh       &mesh,
                 const Streamlines     &streamlines,
                 const Resultants::Face face,
                 const unsigned int     number,
                 const State           &state,
                 const ContactState    &zone,
                 const PlacedBody      *body,
                 const Rolling         *rolling);

    /** Whether the body holds the shell by bristles. */
    bool
    exist() const
    {
      return law != nullptr;
    }

    /** The bristle at a node of this rank; null if it does not touch, or lies
     * on no line. */
    const BristleLaw::Bristle *
    at(const unsigned int node) const;

    /** Set the state and the tangential multipliers of all nodes with a
     * bristle. */
    void
    set_multipliers(ContactState &zone) const;

    /** The slip velocity of the tip of a bristle. */
    dealii::Tensor<1, 3>
    slip_velocity(const unsigned int node) const;

    /** The powers that the bristles turn into heat. Unit: force *
     * length/time. */
    struct Powers
    {
      /** The power of the tips that slip over the ground. */
      double sliding = 0;
      /** The power lost where bristles leave the ground, with the elastic
       * energy that they then have. */
      double release = 0;
    };

    /** The powers of the bristles of all ranks. Must be called on all of them.
     * @param angular_velocity that of the wheel. */
    Powers
    powers(const double angular_velocity) const;

    /** Add the forces of the bristles on the nodes that belong to this rank:
     * their tractions times the areas of the nodes. */
    void
    add_forces(LA::Vector &nodal_forces) const;

    /** Add the derivatives of the forces of add_forces() by the
     * displacements. */
    void
    add_couplings(std::vector<ForceTerm::Coupling> &couplings) const;

    /** Add the change of the forces of add_forces() with the rates of the
     * loads. */
    void
    add_load_derivative(const LoadRates &rates, LA::Vector &nodal_forces) const;

    /** Add the derivatives of the work of the forces of add_forces() in a
     * motion of the positions, over a StepInTime those halfway: by the unknowns
     * of all nodes, and for each of the rates.
     * @param transposed_derivative of the motion, times a force; null if it is
     * the same everywhere.
     * @return the work. */
    double
    add_work(
      const std::function<dealii::Tensor<1, 3>(const dealii::Tensor<1, 3> &)>
        &motion,
      const std::function<dealii::Tensor<1, 3>(const dealii::Tensor<1, 3> &)>
                                   &transposed_derivative,
      const std::vector<LoadRates> &rates,
      LA::Vector                   &gradient,
      std::vector<double>          &per_load) const;

  private:
    /** A node of a line, as all ranks know it. */
    struct LineNode
    {
      dealii::types::global_cell_index number;
      unsigned int                     line, place;
      bool                             touches;
      dealii::Point<3>                 x;
      /** The pressure at the node, see ContactState::multipliers. Unit:
       * force/area. */
      double pressure;
      /** The area of the node, from the cells of the rank that sends it, later
       * the sum of all. */
      double area;
      /** Whether the rank that sends the node owns it; only then it has
       * unknowns. */
      bool owned;
      /** The derivatives of the position by the free unknowns. */
      std::vector<dealii::types::global_dof_index> dofs;
      std::vector<dealii::Tensor<1, 3>>            per_dof;
      /** What it was at the start of the step, if there is one. */
      BristleLaw::Past past;

      template <class Archive>
      void
      serialize(Archive &archive, const unsigned int /*version*/)
      {
        archive &number &line &place &touches &x &pressure &area &owned &dofs
          &per_dof &past;
      }
    };

    /** Nodes that follow each other in the direction in which the material
     * passes, with their bristles. */
    struct Line
    {
      std::vector<LineNode>            nodes;
      std::vector<BristleLaw::Station> stations;
      std::vector<BristleLaw::Bristle> bristles;
    };

    /** The nodes of this rank that touch or have a neighbor that does, or have
     * at the start of the step. */
    std::vector<LineNode>
    own_nodes(const Streamlines  &streamlines,
              const State        &state,
              const ContactState &zone) const;

    /** What a node was at the start of the step. */
    BristleLaw::Past
    at_start(const unsigned int node) const;

    /** Append the lines of a set of nodes with the same number of the line. */
    void
    append_lines(const std::map<unsigned int, LineNode> &by_place,
                 const Rolling                          &rolling);

    /** Call a function with each node that belongs to this rank, its line, and
     * its position in it. */
    template <typename Function>
    void
    for_own_bristles(const Function &function) const;

    /** The force of the bristle on a node, zero where it does not touch. */
    dealii::Tensor<1, 3>
    force(const Line &line, const unsigned int position) const;

    /** The derivative of the force on a node by the position of the same node
     * or of one before. */
    dealii::Tensor<2, 3>
    force_derivative(const Line        &line,
                     const unsigned int position,
                     const unsigned int by) const;

    /** The change of the force on a node for the given rates. */
    dealii::Tensor<1, 3>
    force_rate(const Line        &line,
               const unsigned int position,
               const LoadRates   &rates) const;

    /** Add a force on the face at a node of this rank. */
    void
    add_to_nodes(const unsigned int          node,
                 const dealii::Tensor<1, 3> &force,
                 LA::Vector                 &nodal_forces) const;

    const ShellMesh       &mesh;
    const Resultants::Face face;
    const PlacedBody      *body;
    /** The law of the bristles; null if there are none. */
    const BristleLaw *law;
    /** The step over which the bristles have moved; null in steady rolling. */
    const RollingStep *step;
    /** Whether forces do their work in the shape halfway: over a StepInTime. */
    const bool         halfway;
    const unsigned int number;
    std::vector<Line>  lines;
    /** The line of each node of this rank and the position in it; not set for
     * nodes without a bristle. Empty if there are none. */
    std::vector<std::optional<std::pair<unsigned int, unsigned int>>> places;
  };
} // namespace Biface

#endif
