// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_forces_dead_loads_h
#define biface_model_forces_dead_loads_h

#include <array>
#include <string>
#include <vector>

#include <biface/base/linear_algebra.h>
#include <biface/input/formula.h>
#include <biface/model/forces/edge_moments.h>
#include <biface/model/forces/force_term.h>
#include <biface/model/forces/pressure_load.h>
#include <biface/model/mesh/shell_mesh.h>
#include <biface/model/state/load_rates.h>

namespace Biface
{
  class EntryDeclarations;


  /** A force that keeps its direction. */
  struct DeadForce
  {
    dealii::Tensor<1, 3> components;
    /** Whether the components refer to the frame @f$\mathbf e_i@f$ of the
     * surface. */
    bool local = false;
    /** The fractions of the force on the inner and the outer face. */
    std::array<double, 2> faces{{0.5, 0.5}};
    /** The position of the load factor in Loads::factors. */
    unsigned int factor = 0;
  };

  /** A force at a named point. */
  struct PointForce
  {
    std::string point;
    DeadForce   force;
  };

  /** A force along an edge. */
  struct EdgeForce
  {
    /** The text of the user. */
    std::string text;
    /** The name of the edge, see MeshNodes::edges. */
    std::string edge;
    /** The force per length, for the load factor 1. Unit: force/length. */
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
    /** The formulas of the three components, or none for no force. Unit:
     * force/area. */
    std::vector<Formula> components;
    bool                 local = false;
    /** The position of the load factor in Loads::factors. */
    unsigned int factor = 0;
  };


  /** Read a comma-separated list of forces at points, 'name: F_1 F_2 F_3'.
   * Throws InputError if it is malformed. */
  std::vector<PointForce>
  parse_point_forces(const std::string &entry, const std::string &text);
  /** Read a comma-separated list of forces along edges, 'edge: F_1 F_2 F_3' and
   * so on. Throws InputError if it is malformed. */
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
    /** The tractions on the inner and the outer face. */
    std::array<Traction, 2> tractions;
    dealii::Tensor<1, 3>    area_force;
    /** The position of the load factor of the area force in Loads::factors. */
    unsigned int factor_of_area_force = 0;

    void
    add_parameters(EntryDeclarations &prm);

    /**
     * The nodal forces of all these loads except follower moments, regardless
     * of supports: for each of the factors in Loads::factors, those of the
     * loads that have it.
     *
     * Throws InputError if a named point does not exist, or if a formula is not
     * finite at a node.
     */
    std::vector<LA::Vector>
    assemble(const ShellMesh &mesh) const;
  };


  /** The forces of dead loads, independent of the displacements. */
  class DeadForces : public ForceTerm
  {
  public:
    /** The forces of loads on a mesh. Throws InputError, see
     * DeadLoads::assemble(). */
    DeadForces(const ShellMesh &mesh, const DeadLoads &loads)
      : at_unit_factor(loads.assemble(mesh))
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
