// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_solver_active_set_cycle_h
#define biface_solver_active_set_cycle_h

#include <mpi.h>

#include <deque>
#include <string>

#include <biface/contact/contact_conditions.h>
#include <biface/model/shell_mesh.h>

namespace Biface
{
  /**
   * Notices that the active sets of an iteration go round in a circle: the same
   * two to four sets in turn, which the primal-dual active set method is not
   * safe from where the matrix is no M-matrix
   * @cite HintermuellerItoKunisch2002.
   */
  class ActiveSetCycle
  {
  public:
    using ActiveSet = ContactConditions::ActiveSet;

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
  name_nodes(const ShellMesh &mesh, const ContactConditions::ActiveSet &marked);
} // namespace Biface

#endif
