// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_output_reaction_columns_h
#define biface_output_reaction_columns_h

#include <string>
#include <vector>

#include <biface/model/quantities/forces_on_shell.h>

namespace Biface
{
  /** The names of the columns of displacements and forces of supports, two for
   * each of SupportedNodes::motions. */
  std::vector<std::string>
  reaction_columns(const ShellMesh &mesh);

  /** The values in these columns. */
  std::vector<double>
  reaction_values(const ShellMesh                 &mesh,
                  const Loads                     &loads,
                  const std::vector<ForceOnShell> &forces);

  /** The columns of the forces at critical loads: the compressive force on the
   * ground, 0 without one; the magnitude of the largest force of a support on
   * the part that is modeled, 0 without one; and reaction_columns(). Separated
   * by commas. */
  std::string
  columns_of_forces(const ShellMesh &mesh);

  /** The values in these columns, each after a comma. */
  std::string
  values_of_forces(const ShellMesh                 &mesh,
                   const Loads                     &loads,
                   const std::vector<ForceOnShell> &forces);
} // namespace Biface

#endif
