// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_supports_h
#define biface_model_supports_h

#include <deal.II/base/parameter_handler.h>

#include <array>

namespace Biface
{
  /** What holds an edge of the shell. */
  enum class Support
  {
    /** Nothing. */
    free,
    /** No displacement of either face. */
    fixed,
    /** No displacement of either face across the edge: the edge lies in a
     * plane of symmetry. */
    symmetry
  };

  /** The supports of the four edges, indexed by Edge. */
  struct Supports
  {
    std::array<Support, 4> edges{
      {Support::fixed, Support::fixed, Support::free, Support::free}};

    void
    add_parameters(dealii::ParameterHandler &prm);
  };
} // namespace Biface

#endif
