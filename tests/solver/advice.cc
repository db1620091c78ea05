// SPDX-License-Identifier: LGPL-2.1-or-later

// What a failed step advises: no more cuts if the iterations of the step are
// used up.

#include <iostream>

#include <biface/solver/failure.h>

using namespace Biface;

int
main()
{
  InUse in_use;
  in_use.contact            = true;
  in_use.arc_length_control = true;
  Failure failure{FailureCause::divergence, "divergence"};
  std::cout << advice(failure, in_use) << std::endl;
  failure.iterations_used_up = true;
  std::cout << advice(failure, in_use) << std::endl;
  failure.further_remedies = "softer bristles";
  std::cout << advice(failure, in_use) << std::endl;
}
