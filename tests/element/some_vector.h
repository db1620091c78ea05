// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_tests_some_vector_h
#define biface_tests_some_vector_h

#include <deal.II/base/tensor.h>

#include "one_cell.h"

/** Pseudo-random entries of at most @p size. */
template <int n>
dealii::Tensor<1, n>
some_vector(const double size, const unsigned int seed)
{
  dealii::Tensor<1, n> vector;
  for (unsigned int i = 0; i < n; ++i)
    vector[i] = size * some_number(100 * seed + i);
  return vector;
}

#endif
