// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_forces_nodal_forces_h
#define biface_model_forces_nodal_forces_h

#include <array>
#include <map>
#include <string>

#include <biface/base/linear_algebra.h>
#include <biface/model/forces/force_term.h>
#include <biface/model/mesh/shell_mesh.h>

namespace Biface
{
  /** The forces on the nodes in one state, sorted by their sources, regardless
   * of supports, whose forces are what is missing for equilibrium: see
   * ShellEquations::nodal_forces(). The vectors contain the locally owned
   * entries. */
  class NodalForces
  {
  public:
    /** Forces of zero. */
    explicit NodalForces(const ShellMesh &mesh)
      : forces{{mesh.owned_vector(),
                mesh.owned_vector(),
                mesh.owned_vector(),
                mesh.owned_vector()}}
    {}

    const LA::Vector &
    operator[](const ForceTerm::Source source) const
    {
      return forces[static_cast<unsigned int>(source)];
    }

    LA::Vector &
    operator[](const ForceTerm::Source source)
    {
      return forces[static_cast<unsigned int>(source)];
    }

    /** The forces of the bodies beside the ground, by name; they are not
     * among the other forces. */
    std::map<std::string, LA::Vector> of_bodies;

    /** Collect the entries that other ranks have added. */
    void
    compress()
    {
      for (LA::Vector &vector : forces)
        vector.compress(dealii::VectorOperation::add);
      for (auto &[name, vector] : of_bodies)
        vector.compress(dealii::VectorOperation::add);
    }

  private:
    std::array<LA::Vector, 4> forces;
  };
} // namespace Biface

#endif
