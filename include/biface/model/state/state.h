// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_state_state_h
#define biface_model_state_state_h

#include <deal.II/base/point.h>
#include <deal.II/base/table.h>
#include <deal.II/base/tensor.h>

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <biface/base/linear_algebra.h>
#include <biface/contact/contact_condition.h>
#include <biface/contact/friction.h>
#include <biface/contact/rigid_foundation.h>
#include <biface/contact/rolling.h>
#include <biface/element/modes.h>
#include <biface/model/mesh/shell_mesh.h>

namespace Biface
{
  class TangentialLaw;


  /** The results of earlier stages that belong to the undeformed shape since
   * InternalForces::take_as_prestress(). */
  struct Prestress
  {
    /** One per locally owned cell, those of the laminate included. */
    std::vector<Modes::Vector> resultants;
    /** The strains that caused them. */
    std::vector<Modes::Vector> strains;
    /** Constant forces on the owned nodes, see InternalForces::balance(); none
     * if empty. */
    LA::Vector balancing_forces;
  };


  /** What a ForceTerm remembers of earlier steps: its internal variables. */
  struct TermState
  {
    /** The same on all ranks. */
    std::vector<double> numbers;
    /** A row for each node of this rank, and for each locally owned cell; empty
     * if the term does not need it. */
    dealii::Table<2, double> at_nodes, at_cells;
  };


  /**
   * Everything that changes while the shell is loaded. A copy is a complete
   * restore point.
   */
  struct State
  {
    /** An empty state, to be assigned to. */
    State() = default;

    /** The unloaded shell. */
    explicit State(const ShellMesh &mesh);

    /** The nodal unknowns, see MixedElement::Part, readable at all nodes of
     * this rank. */
    LA::Vector displacement;

    /** The resultants @f$\mathbf H@f$ of each locally owned cell, an unknown
     * of the mixed iteration. Initial resultants are not included. */
    std::vector<Modes::Vector> resultants;

    /** The strains of each locally owned cell at which the law of cords that go
     * slack is linearized, another unknown of the mixed iteration. Empty if
     * these are the strains of the displacements, as in all converged
     * states. */
    std::vector<Modes::Vector> predicted_strains;

    /** The active set: the nodes of this rank in contact. */
    ActiveSet active;

    /**
     * The contact multipliers at the nodes of this rank, bilinear on the outer
     * face, @cite GrigolyukKulikovPlotnikova2004, eq. (10): the traction on the
     * shell per area of the middle surface. The first component, along the
     * normal of the foundation, is minus the pressure; the two tangential
     * components, see RigidFoundation::tangents(), are zero without friction.
     * In the iteration, the first component is an unknown like the resultants:
     * the solution of the last linear system, zero at nodes that have just
     * entered. In converged states it is that of the clearance.
     * Unit: force/area.
     */
    std::vector<dealii::Tensor<1, 3>> multipliers;

    /** How the foundation holds the nodes of this rank sideways, and the points
     * of the foundation at rest to which they stick. In a step a node may begin
     * and cease to slip; everything else is the history of friction up to the
     * end of the last step, see TangentialLaw::commit_step(). While the
     * shell rolls, friction has no history: the grips tell where it slips, and
     * the stick points are those from which it could stand. */
    std::vector<Grip>             grips;
    std::vector<dealii::Point<3>> stick_points;

    /** What the force terms remember, by ForceTerm::name(). */
    std::map<std::string, TermState> terms;

    /** That of earlier stages, which copies share; null if there is none but
     * that of the laminate. */
    std::shared_ptr<const Prestress> prestress;

    /** The state about which the strains are linearized; null in nonlinear
     * theory. */
    std::shared_ptr<const State> linearization_point;

    /** Contact pressure at a node, by its position in ShellMesh::nodes. */
    double
    contact_pressure(const unsigned int node) const
    {
      return active[node] ? -multipliers[node][0] : 0.;
    }
  };


  /** The loads on the shell. */
  struct Loads
  {
    /** See PressureLoad. Unit: force/area. */
    double pressure = 0;

    /** Factor of the dead loads and prescribed displacements. */
    double factor = 0;

    /** The factor at which prescribed displacements vanish, see
     * Progress::factor_of_shape. */
    double factor_of_shape = 0;

    /** Whether the gas that exerts the pressure is sealed in, so that the
     * pressure follows from the state, see Gas. */
    bool sealed_gas = false;

    std::optional<RigidFoundation> foundation;

    /** How it holds the nodes sideways; null if it does not. */
    std::shared_ptr<const TangentialLaw> law;

    /** Set if the shell rolls. */
    std::optional<Rolling> rolling;
  };


  /** Derivatives of the loads by a parameter. */
  struct LoadRates
  {
    double pressure = 0;
    double factor   = 0;
    /** Travel of the foundation. */
    double travel = 0;
    /** See Rolling. */
    double angular_velocity = 0;
  };


  /** Strain-displacement relations of a stage. */
  enum class StrainTheory
  {
    nonlinear,
    /** Linearized about the state at the start of the stage. */
    linear
  };


  /** The update of the resultants in an iteration, see
   * ShellEquations::update(). */
  enum class NewtonIteration
  {
    /** The resultants are unknowns of the Hu-Washizu functional and are set to
     * their linearized prediction. */
    mixed,
    /** The resultants follow from the displacements. */
    substituted
  };
} // namespace Biface

#endif
