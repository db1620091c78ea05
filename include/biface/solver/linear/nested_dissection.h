// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_solver_linear_nested_dissection_h
#define biface_solver_linear_nested_dissection_h

#include <vector>

#include <biface/base/linear_algebra.h>

namespace Biface
{
  /**
   * An order in which to eliminate the unknowns of a matrix with little
   * fill-in: nested dissection by METIS @cite KarypisKumar1998 of the graph of
   * its nodes, groups of successive rows with entries in the same columns.
   * Must be called on all ranks.
   *
   * @return on the first rank, the position of each unknown, from 0; on the
   * others, nothing. Nothing at all if METIS fails.
   */
  std::vector<int>
  nested_dissection(const LA::SparseMatrix &A);
} // namespace Biface

#endif
