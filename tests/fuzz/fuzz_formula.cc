// SPDX-License-Identifier: LGPL-2.1-or-later

// Any text is accepted as a formula with finite values, or is refused with one
// sentence.

#include <biface/input/formula.h>

#include "fuzz.h"

extern "C" int
LLVMFuzzerInitialize(int *, char ***)
{
  return 0;
}


extern "C" int
LLVMFuzzerTestOneInput(const std::uint8_t *data, const std::size_t size)
{
  const std::string input(reinterpret_cast<const char *>(data), size);
  Fuzz::read(input, [&]() {
    const Biface::Formula formula("entry", input, {"x", "alpha_1", "table"});
    formula({1.5, -120, 0});
    formula({0, 0, 0});
  });
  return 0;
}
