// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_time_inertia_h
#define biface_model_time_inertia_h

#include <algorithm>
#include <string>
#include <vector>

#include <biface/model/forces/force_term.h>

namespace Biface
{
  /**
   * The forces of inertia of a shell that moves, with those of the damping that
   * is proportional to the mass:
   * @f$-\mathbf M\,\bigl((\mathbf v_1-\mathbf v_0)/\Delta t+
   * a\,(\mathbf V_1-\mathbf V_0)/\Delta t\bigr)@f$ over a StepInTime, with the
   * mass matrix of element_mass() and @f$a@f$ of DampingInTime::of_mass. In
   * equilibrium there are none.
   */
  class Inertia : public ForceTerm
  {
  public:
    /** The mesh is kept by reference. */
    explicit Inertia(const ShellMesh &mesh) : mesh(mesh)
    {}

    bool
    acts_on(const unsigned int cell,
            const State       &state,
            const Loads       &loads) const override;

    void
    add_over_step(const CellState &start,
                  const CellState &end,
                  CellForces      &forces) const override;

    /** The forces of Coriolis in a step, of which the loads know nothing, make
     * the tangent of a wheel that rolls unsymmetric. */
    bool
    is_symmetric(const Loads &loads) const override;

    Source
    source() const override
    {
      return Source::shell;
    }

    /** The name of the forces, under which a State also contains what the next
     * step needs for its error, see remember_motion(). */
    static constexpr const char *body = "inertia";

    /** Whether inertia is one of the terms: whether a stage of the run goes
     * through time. */
    static bool
    is_among(const std::vector<const ForceTerm *> &terms)
    {
      return std::any_of(terms.begin(), terms.end(), [](const ForceTerm *term) {
        return term->other_body() == body;
      });
    }

    std::string
    other_body() const override
    {
      return body;
    }

  private:
    const ShellMesh &mesh;
  };
} // namespace Biface

#endif
