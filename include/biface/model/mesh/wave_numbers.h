// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_mesh_wave_numbers_h
#define biface_model_mesh_wave_numbers_h

#include <optional>
#include <vector>

#include <biface/base/linear_algebra.h>
#include <biface/model/mesh/shell_mesh.h>

namespace Biface
{
  /** The waves of a displacement field on a full turn. */
  struct WaveNumbers
  {
    /** The number of waves around the axis in which most of the square of the
     * displacements lies. */
    unsigned int circumferential;
    /** The number of half waves along the meridian: one more than the changes
     * of sign of the largest component of the waves around the axis. */
    unsigned int meridional;
    /** The part of the waves that travels right-handed about the axis, less the
     * part that travels the other way, between -1 and 1; zero for standing
     * waves. */
    double travel;
  };

  /**
   * The wave numbers of the mean displacements of the faces, from their Fourier
   * integrals around the axis; none if the shell is not closed. Must be called
   * on all ranks.
   *
   * @param parts the displacements, or the real and imaginary parts of those
   * that change with @f$e^{i\omega t}@f$.
   */
  std::optional<WaveNumbers>
  wave_numbers(const ShellMesh &mesh, const std::vector<LA::Vector> &parts);
} // namespace Biface

#endif
