// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_forces_viscous_damping_h
#define biface_model_forces_viscous_damping_h

#include <biface/model/forces/force_term.h>

namespace Biface
{
  /**
   * Dashpots between the faces of the wall and the space around them. They
   * hold a shell that loses its stability, so that it moves to its next
   * equilibrium over a few steps instead of a jump that no iteration finds.
   *
   * The traction on the wall is @f$-c\,\dot{\mathbf v}@f$, where
   * the dot is the derivative by the time of which a stage takes 1, so that
   * @f$c@f$ is a force per volume; by the implicit Euler method it is
   * @f$-c\,\Delta\mathbf v/\Delta\tau@f$ in a step that is the part
   * @f$\Delta\tau@f$ of the stage. It is lumped at the vertices of the cells,
   * half on the inner and half on the outer face.
   *
   * The term remembers the displacements of each wall element in the last
   * converged state, and the tractions that hold it: also in the first step of
   * an undamped stage, in which they vanish.
   */
  class ViscousDamping : public ForceTerm
  {
  public:
    /** Whether dashpots hold a state. */
    static bool
    is_active(const State &state);

    /** The mesh is kept by reference. */
    explicit ViscousDamping(const ShellMesh &mesh) : mesh(mesh)
    {}

    bool
    acts_on(const unsigned int cell,
            const State       &state,
            const Loads       &loads) const override;

    void
    add(const CellState &at, CellForces &forces) const override;

    std::string
    name() const override
    {
      return "damping";
    }

    void
    start_stage(const Loads &loads, State &state) const override;

    void
    commit_step(const State        &before,
                const Loads        &loads,
                const TimeInterval &time,
                State              &after) const override;

    Source
    source() const override
    {
      return Source::damping;
    }

    /** Whether linear strain theory linearizes the term: no, since steps of a
     * linear stage start from the last equilibrium, too. */
    bool
    is_linearized() const override
    {
      return false;
    }

  private:
    const ShellMesh &mesh;
  };
} // namespace Biface

#endif
