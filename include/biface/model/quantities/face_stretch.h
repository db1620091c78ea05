// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_quantities_face_stretch_h
#define biface_model_quantities_face_stretch_h

#include <biface/base/linear_algebra.h>
#include <biface/model/mesh/shell_mesh.h>

namespace Biface
{
  /** The area of a face around each node in the deformed shell, relative to
   * that in the undeformed one: the entries of MixedElement::mean in the third
   * component of owned nodes. Cells count as flat quadrilaterals. Must be
   * called on all ranks.
   * @param displacement a vector with ghosts. */
  LA::Vector
  area_stretch(const ShellMesh       &mesh,
               const LA::Vector      &displacement,
               const Resultants::Face face);
} // namespace Biface

#endif
