// SPDX-License-Identifier: LGPL-2.1-or-later

// Nodes that alternately touch and leave a ground are held in contact until
// they are released; if they cycle again, the failure names them.

#include <iostream>

#include <biface/laminate/layup.h>
#include <biface/model/contact/approach.h>
#include <biface/model/contact/contact_interaction.h>
#include <biface/model/contact/contact_pair.h>
#include <biface/model/contact/contact_parameters.h>
#include <biface/model/state/loads.h>
#include <biface/model/state/placed_body.h>
#include <biface/solver/active_set_iteration.h>

#include "../model/coarse_torus.h"
#include <cord_ply.h>
#include <tests.h>

using namespace dealii;
using namespace Biface;

int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  ConditionalOStream               out(std::cout,
                         Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0);

  const Layup              layup(Layup::Parameters(), cord_ply());
  const auto               mesh = coarse_torus(layup);
  const ContactInteraction contact(*mesh, ContactParameters());
  State                    state(*mesh);

  // the ground goes to and fro, and the shell stands still
  Loads near, far;
  near.place(0,
             {contact.ground().moving_body.after_travel(
                travel_at_first_contact(contact.ground(), state) + 12),
              contact.ground().laws()});
  far.place(0,
            {contact.ground().moving_body.after_travel(
               travel_at_first_contact(contact.ground(), state) + 1),
             contact.ground().laws()});

  ActiveSetIteration zone(contact, out);
  const auto         print = [&](const std::string &what) {
    const unsigned int n_active = contact.count_active(state);
    out << what << ": " << n_active << " in contact" << std::endl;
  };
  zone.update(state, near);
  print("near");
  zone.update(state, far);
  print("far");
  for (unsigned int k = 0; k < 3; ++k)
    zone.update(state, k % 2 == 0 ? near : far);
  print("near, held");
  const unsigned int n_changes = zone.update(state, far);
  out << n_changes << " changes" << std::endl;
  print("far, held");
  const unsigned int n_released = zone.settle(state, far);
  out << n_released << " changes" << std::endl;
  print("far, released");
  for (unsigned int k = 0; k < 5; ++k)
    zone.update(state, k % 2 == 0 ? near : far);
  out << zone.failure() << std::endl;
}
