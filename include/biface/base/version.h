// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_base_version_h
#define biface_base_version_h

#include <string>

namespace Biface
{
  /** The version of the library, such as "0.2.0". */
  std::string
  version();

  /**
   * The BLAS library loaded by the process: the file that contains dgemm. With
   * the reference BLAS, direct solvers are several times slower than with
   * OpenBLAS.
   */
  std::string
  blas_library();

  /**
   * Limit OpenBLAS, if it is the BLAS, to one thread per process unless the
   * environment sets OPENBLAS_NUM_THREADS: ranks and threads would compete for
   * the same cores.
   */
  void
  limit_blas_threads();
} // namespace Biface

#endif
