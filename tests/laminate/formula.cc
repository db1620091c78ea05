// SPDX-License-Identifier: LGPL-2.1-or-later

// A formula is evaluated with its variables in order; it knows pi; copies are
// equal; and a value that is not one finite number is refused.

#include <functional>

#include <biface/base/errors.h>
#include <biface/input/formula.h>

#include <tests.h>

using namespace Biface;

namespace
{
  void
  refuse(const std::string &what, const std::function<void()> &function)
  {
    try
      {
        function();
        std::cout << what << ": FAILED, accepted" << std::endl;
      }
    catch (const InputError &error)
      {
        std::cout << what << ": " << error.what() << std::endl;
      }
  }
} // namespace


int
main()
{
  const double pi = std::acos(-1.);

  const Formula f("entry", "x - 2*y^2", {"x", "y"});
  check_small("order of the variables", f({3., 5.}) + 47, 0);
  check_small("another place", f({5., 3.}) + 13, 0);
  const Formula copy = f;
  check_small("copy", copy({1., 1.}) + 1, 0);
  check_small(
    "pi, of no variables", Formula("entry", "2*pi", {})({}) - 2 * pi, 0);
  check_small(
    "a number", Formula("entry", " 1.25e-2 ", {"x"})({7.}) - 0.0125, 0);
  check_small("functions",
              Formula("entry", "max(abs(x), sqrt(4)) * cos(pi)", {"x"})({-3.}) +
                3,
              1e-15);
  check_small("conditions",
              Formula("entry", "x <= 0 && x != 1 ? 1 : 2", {"x"})({-1.}) - 1,
              0);

  for (const std::string text : {"", "x +", "sin(x", "z", "1, 2", "x = 3"})
    refuse("'" + text + "'", [&]() { Formula("entry", text, {"x", "y"}); });
  const Formula inverse("entry", "1/x", {"x"});
  check_small("where it is finite", inverse({4.}) - 0.25, 0);
  refuse("where it is not", [&]() { inverse({0.}); });
  refuse("where it is no number",
         [&]() { Formula("entry", "sqrt(x)", {"x"})({-1.}); });
}
