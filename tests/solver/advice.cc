// SPDX-License-Identifier: LGPL-2.1-or-later

// What a failed step advises: no more cuts if the iterations of the step are
// used up, and the regularization that the stage has.

#include <iostream>

#include <biface/solver/failure.h>
#include <biface/stepping/stage.h>

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

  failure.cause = FailureCause::contact_cycle;
  std::cout << advice(failure, in_use) << std::endl;
  Stage stage;
  stage.laws.penalty_stiffness = 1.;
  std::cout << advice(failure, stage.in_use(3)) << std::endl;

  failure.further_remedies = "softer bristles";
  std::cout << advice(failure, in_use) << std::endl;
}
