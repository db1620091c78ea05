// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_problem_shell_model_h
#define biface_problem_shell_model_h

#include <mpi.h>

#include <memory>

#include <biface/model/air/air_column.h>
#include <biface/model/contact/contact_interaction.h>
#include <biface/model/equations/shell_equations.h>
#include <biface/model/forces/cavity.h>
#include <biface/model/heat/rolling_heat.h>
#include <biface/model/mesh/shell_mesh.h>
#include <biface/problem/parameters.h>
#include <biface/surface/chart_grid.h>

namespace Biface
{
  /** Create the mesh. Throws InputError.
   * @param grid the grid of the mesh; null for that of the parameters. */
  std::shared_ptr<const ShellMesh>
  make_shell_mesh(const Parameters &parameters,
                  const MPI_Comm    communicator,
                  const ChartGrid  *grid = nullptr);


  /** Create the mesh of parameters that differ from those of another mesh at
   * most in the sections of materials and 'Laminate'. Throws InputError. */
  std::shared_ptr<const ShellMesh>
  with_other_plies(const ShellMesh &mesh, const Parameters &parameters);


  /** Everything that acts in an analysis: the shell, its ground, its loads
   * and its gas. */
  struct ShellModel
  {
    /** Set up the contact, the loads and the equations of a mesh. Throws
     * InputError if the parameters are inconsistent.
     * @param mesh that of the parameters, which other models may share. */
    ShellModel(const Parameters                &parameters,
               std::shared_ptr<const ShellMesh> mesh);

    const std::shared_ptr<const ShellMesh> mesh;
    const ContactInteraction               contact;
    /** The space that the gas fills; null if it cannot be sealed in. */
    const std::unique_ptr<const Cavity> cavity;
    /** The air in the cavity, if it has inertia in vibrations; else null. */
    const std::unique_ptr<const AirColumn> air;
    ShellEquations                         equations;
    /** The heat of the plies of a rolling wheel; null if it cannot roll, or if
     * none loses energy. */
    const std::unique_ptr<const RollingHeat> heat;
  };
} // namespace Biface

#endif
