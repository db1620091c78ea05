// SPDX-License-Identifier: LGPL-2.1-or-later

// Any text is accepted as a formula with finite values, or is refused with one
// sentence.

#include <biface/input/formula.h>

#include "fuzz.h"

namespace Fuzz::Formulas
{
  void
  initialize()
  {}


  void
  try_input(const std::string &input)
  {
    read(input, [&]() {
      const Biface::Formula formula("entry", input, {"x", "alpha_1", "table"});
      formula({1.5, -120, 0});
      formula({0, 0, 0});
    });
  }
} // namespace Fuzz::Formulas
