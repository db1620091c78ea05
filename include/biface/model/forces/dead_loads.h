// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_forces_dead_loads_h
#define biface_model_forces_dead_loads_h

#include <deal.II/base/parameter_handler.h>

#include <array>
#include <string>
#include <vector>

#include <biface/base/linear_algebra.h>
#include <biface/input/formula.h>
#include <biface/model/forces/edge_moments.h>
#include <biface/model/forces/force_term.h>
#include <biface/model/forces/pressure_load.h>
#include <biface/model/mesh/shell_mesh.h>

namespace Biface
{
  /** A force that keeps its direction. */
  struct DeadForce
  {
    dealii::Tensor<1, 3> components;
    /** Whether the components refer to the frame @f$\mathbf e_i@f$. */
    bool local = false;
    /** The fractions on the two faces. */
    std::array<double, 2> faces{{0.5, 0.5}};
    /** The position of its factor in Loads::factors. */
    unsigned int factor = 0;
  };

  struct PointForce
  {
    std::string point;
    DeadForce   force;
  };

  struct EdgeForce
  {
    /** The text of the user. */
    std::string text;
    Edge        edge;
    /** Per length. */
    DeadForce force;
    /** The ply in whose middle the force acts, counted from 1 at the inner
     * face; 0 for the faces of the force. */
    unsigned int ply = 0;
    /** Whether the length is that of the edge at the height where the force
     * acts, and not on the reference surface. */
    bool true_length = false;
  };

  /** A force on a face: formulas of the position for its components. */
  struct Traction
  {
    /** Three, or none for no force. */
    std::vector<Formula> components;
    bool                 local = false;
    /** See DeadForce. */
    unsigned int factor = 0;
  };


  /** Read a comma-separated list of forces, 'name: F_1 F_2 F_3' and so on.
   * Throw InputError if it is malformed. */
  std::vector<PointForce>
  parse_point_forces(const std::string &entry, const std::string &text);
  std::vector<EdgeForce>
  parse_edge_forces(const std::string &entry, const std::string &text);

  /** Read a force on a face: three formulas separated by semicolons, optionally
   * followed by '; local'. Throws InputError if it is malformed. */
  Traction
  parse_traction(const std::string &entry, const std::string &text);


  /**
   * Loads proportional to a load factor, given for the factor 1: dead
   * forces at named points, on edges, on faces and on the whole shell, and dead
   * or follower moments along edges.
   */
  struct DeadLoads
  {
    std::vector<PointForce> point_forces;
    std::vector<EdgeForce>  edge_forces;
    std::vector<EdgeMoment> edge_moments;
    /** By the face. */
    std::array<Traction, 2> tractions;
    dealii::Tensor<1, 3>    area_force;
    /** The position of its factor in Loads::factors. */
    unsigned int factor_of_area_force = 0;

    void
    add_parameters(dealii::ParameterHandler &prm);

    /**
     * The nodal forces of all these loads except follower moments, regardless
     * of supports: for each of the factors in Loads::factors, those of the
     * loads that have it.
     *
     * @param area the area to which tractions refer.
     *
     * Throws InputError if a named point does not exist, or if a formula is not
     * finite at a node.
     */
    std::vector<LA::Vector>
    assemble(const ShellMesh &mesh, const AreaMeasure area) const;
  };


  /** The forces of dead loads, independent of the displacements. */
  class DeadForces : public ForceTerm
  {
  public:
    /** @param area see DeadLoads::assemble(), which throws. */
    DeadForces(const ShellMesh  &mesh,
               const DeadLoads  &loads,
               const AreaMeasure area)
      : at_unit_factor(loads.assemble(mesh, area))
    {}

    bool
    acts_on(const unsigned int, const State &, const Loads &) const override
    {
      return false;
    }

    void
    add(const CellState &, CellForces &) const override
    {}

    void
    add_dead_forces(const LoadRates &loads,
                    LA::Vector      &nodal_forces) const override
    {
      for (unsigned int i = 0; i < at_unit_factor.size(); ++i)
        nodal_forces.add(factor_at(loads.factors, i), at_unit_factor[i]);
    }

  private:
    const std::vector<LA::Vector> at_unit_factor;
  };
} // namespace Biface

#endif
