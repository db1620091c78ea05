// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_output_summary_table_h
#define biface_output_summary_table_h

#include <ostream>
#include <vector>

#include <biface/model/shell_mesh.h>
#include <biface/model/state.h>
#include <biface/stepping/step_report.h>

namespace Biface
{
  /** The table at the end of a run: a line per step. */
  class SummaryTable
  {
  public:
    /** Must be called on all ranks. */
    void
    add(const StepReport &report, const State &state, const ShellMesh &mesh);

    /**
     * Print the load factor and the pressure if they differ from 0, the contact
     * zone of steps with contact, and of named points the component of the
     * displacement that is the largest in the end; as many points as there is
     * room for. Nothing without steps.
     * @param points those of the mesh.
     */
    void
    print(const std::vector<NamedPoint> &points, std::ostream &out) const;

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &lines;
    }

  private:
    struct Line
    {
      unsigned int   step;
      double         factor, pressure, approach;
      bool           in_contact;
      ContactSummary contact;
      /** Of the middle at the named points, Cartesian, one after the other. */
      std::vector<double> displacements;

      template <class Archive>
      void
      serialize(Archive &archive, const unsigned int)
      {
        archive &step &factor &pressure &approach &in_contact &contact.force;
        archive &contact.n_nodes &contact.area &contact.max_pressure;
        archive                                &displacements;
      }
    };

    std::vector<Line> lines;
  };
} // namespace Biface

#endif
