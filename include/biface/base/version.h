// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_base_version_h
#define biface_base_version_h

#include <string>

namespace Biface
{
  /** The version of the library, as in "0.1.0". */
  std::string
  version();

  /**
   * Which BLAS the process has loaded: the file that holds dgemm. The reference
   * BLAS makes direct solvers several times slower than OpenBLAS.
   */
  std::string
  blas_library();

  /**
   * Let OpenBLAS, if that is the BLAS, use one thread a process unless
   * the environment says otherwise (OPENBLAS_NUM_THREADS): ranks and
   * threads would compete for the same cores.
   */
  void
  limit_blas_threads();
} // namespace Biface

#endif
