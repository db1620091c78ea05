// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_solver_active_set_iteration_h
#define biface_solver_active_set_iteration_h

#include <deal.II/base/conditional_ostream.h>

#include <mpi.h>

#include <deque>
#include <string>

#include <biface/contact/active_set.h>
#include <biface/model/mesh/shell_mesh.h>

namespace Biface
{
  class ContactInteraction;
  struct Loads;
  struct State;


  /**
   * Detects cycles of the active set, in which the same two to four sets recur.
   * They can occur in the primal-dual active set method unless the matrix is an
   * M-matrix @cite HintermuellerItoKunisch2002.
   */
  class ActiveSetCycle
  {
  public:
    explicit ActiveSetCycle(const MPI_Comm communicator)
      : communicator(communicator)
    {}

    /** Record the active set of this rank, that of all pairs, after another
     * iteration.
     * @return whether the same sequence of sets has occurred twice, the same on
     * all ranks. */
    bool
    closes_with(const ActiveSet &active);

    /** The nodes that belong to some sets of the detected cycle but not to
     * all. */
    const ActiveSet &
    toggling_nodes() const
    {
      return toggling;
    }

    /** Forget the recorded sets. */
    void
    restart()
    {
      sets.clear();
    }

  private:
    static constexpr unsigned int longest = 4;

    const MPI_Comm communicator;
    /** The recorded sets, latest first. */
    std::deque<ActiveSet> sets;
    ActiveSet             toggling;
  };


  /** The number of marked nodes and the coordinates of the first of them, as
   * text: the same on any number of ranks. */
  std::string
  name_nodes(const ShellMesh &mesh, const ActiveSet &marked);


  /**
   * The active set in the iterations of a step. If it is cycling, the nodes
   * that toggle are no longer glued: glue may lift a node off the ground to
   * which the node returns without it, so that no active set is a solution. If
   * none of them is glued, they are held in contact until the iteration has
   * converged with them; then they are released. A second cycle of these is a
   * failure.
   */
  class ActiveSetIteration
  {
  public:
    /** The objects are kept by reference. */
    ActiveSetIteration(const ContactInteraction   &contact,
                       dealii::ConditionalOStream &out);

    /** Update the active set.
     * @return the number of changes, on all ranks. */
    unsigned int
    update(State &state, const Loads &loads);

    /** With an iteration that has converged, set the multipliers to those of
     * the displacements, and release the nodes that are held.
     * @return the number of changes, on all ranks. */
    unsigned int
    settle(State &state, const Loads &loads);

    /** The message on a second cycle; empty without one. */
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
