// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_solver_active_set_iteration_h
#define biface_solver_active_set_iteration_h

#include <deal.II/base/conditional_ostream.h>

#include <mpi.h>

#include <deque>
#include <string>

#include <biface/contact/contact_condition.h>
#include <biface/model/contact_interaction.h>
#include <biface/model/shell_mesh.h>
#include <biface/model/state.h>

namespace Biface
{
  /**
   * Notices that the active sets of an iteration are cycling: the same two to
   * four sets come in turn, which the primal-dual active set method is not
   * safe from where the matrix is no M-matrix
   * @cite HintermuellerItoKunisch2002.
   */
  class ActiveSetCycle
  {
  public:
    explicit ActiveSetCycle(const MPI_Comm communicator)
      : communicator(communicator)
    {}

    /** Take the set after one more iteration, of the nodes of this rank.
     * @return whether sets have come in the same turn twice, the same on all
     * ranks. */
    bool
    closes_with(const ActiveSet &active);

    /** The nodes that are in some sets of the cycle that was found, and not in
     * others. */
    const ActiveSet &
    toggling_nodes() const
    {
      return toggling;
    }

    /** Forget the sets taken so far. */
    void
    restart()
    {
      sets.clear();
    }

  private:
    static constexpr unsigned int longest = 4;

    const MPI_Comm communicator;
    /** Newest first. */
    std::deque<ActiveSet> sets;
    ActiveSet             toggling;
  };


  /** How many nodes are marked, and where the first of them are on the
   * reference surface, in its coordinates: the same on any number of ranks. */
  std::string
  name_nodes(const ShellMesh &mesh, const ActiveSet &marked);


  /**
   * The active set of the contact in the iterations of one step. Where it is
   * cycling, the nodes that toggle are held in contact, until the iteration has
   * converged with them and they are released. A second cycle is not broken.
   */
  class ActiveSetIteration
  {
  public:
    /** The objects are kept by reference. */
    ActiveSetIteration(const ContactInteraction   &contact,
                       dealii::ConditionalOStream &out);

    /** Decide anew which nodes are in contact.
     * @return the number of changes, on all ranks. */
    unsigned int
    update(State &state, const Loads &loads);

    /** Let go of nodes that are held.
     * @return the number of changes, on all ranks. */
    unsigned int
    release(State &state, const Loads &loads);

    /** Of the cycle that was not broken: a sentence; empty without one. */
    const std::string &
    failure() const
    {
      return message;
    }

  private:
    const ContactInteraction   &contact;
    dealii::ConditionalOStream &out;
    ActiveSetCycle              cycle;
    ActiveSet                   held;
    bool                        was_held = false;
    std::string                 message;
  };
} // namespace Biface

#endif
