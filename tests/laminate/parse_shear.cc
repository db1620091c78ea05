// SPDX-License-Identifier: LGPL-2.1-or-later

// The law of transverse shear is named, or a factor, which may be a formula.

#include <biface/laminate/transverse_shear.h>

#include <tests.h>

using namespace Biface;

int
main()
{
  using Kind      = TransverseShearLaw::Kind;
  const auto read = [](const std::string &text) {
    return parse_transverse_shear("Laminate/Transverse shear", text).value();
  };
  check_true("constant strain",
             read("constant strain").kind == Kind::constant_strain);
  check_true("equilibrium", read("equilibrium").kind == Kind::equilibrium);
  for (const std::string text : {"5/6", "0.833333333333333333", " 5 / 6 "})
    {
      check_true("factor " + text, read(text).kind == Kind::factor);
      check_small("  value", read(text).factor - 5. / 6, 1e-15);
    }
  check_true("automatic",
             !parse_transverse_shear("Laminate/Transverse shear", "automatic"));
  check_small("factor 1", read("1").factor - 1, 0);
}
