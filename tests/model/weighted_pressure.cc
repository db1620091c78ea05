// SPDX-License-Identifier: LGPL-2.1-or-later

// The mean of the contact pressure by the force that it carries, and its
// deviation, are those of the integrals: of a constant pressure, its value and
// zero; of one that grows linearly from zero, 2/3 of the maximum and 8^(-1/2).

#include <cmath>

#include <biface/model/contact/contact_interaction.h>
#include <biface/model/contact/contact_pair.h>
#include <biface/model/contact/contact_parameters.h>
#include <biface/model/contact/contact_summary.h>
#include <biface/model/state/loads.h>

#include "cord_shells.h"
#include <tests.h>

using namespace dealii;
using namespace Biface;

namespace
{
  ContactSummary
  summary_of(const double at_begin, const double at_end)
  {
    const auto mesh =
      free_shell(std::make_unique<Biface::Plane>(), {{"0:4:200", "0:2:2"}});
    const ContactInteraction contact(*mesh, ContactParameters());
    State                    state(*mesh);
    for (unsigned int n = 0; n < mesh->nodes.size(); ++n)
      {
        const double part           = mesh->nodes[n].alpha[0] / 4;
        state.contacts[0].active[n] = true;
        state.contacts[0].multipliers[n] =
          Tensor<1, 3>({-(at_begin + part * (at_end - at_begin)), 0, 0});
      }
    return summarize(contact.ground(), state, Loads());
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const ContactSummary constant = summary_of(0.3, 0.3);
  const ContactSummary linear   = summary_of(0, 0.3);
  if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
    return 0;
  // the round-off of a sum over 1600 corners of cells
  check_small("constant", constant.weighted_pressure - 0.3, 1e-12);
  check_small("its deviation", constant.pressure_variation, 1e-12);
  check_small("linear", linear.weighted_pressure - 0.2, 1e-4, 0.2);
  check_small(
    "its deviation", linear.pressure_variation - std::sqrt(1. / 8), 1e-4);
}
