// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_output_summary_table_h
#define biface_output_summary_table_h

#include <ostream>
#include <vector>

#include <biface/model/contact/contact_summary.h>
#include <biface/model/mesh/named_points.h>
#include <biface/model/mesh/shell_mesh.h>
#include <biface/output/failure_maxima.h>

namespace Biface
{
  struct State;
  struct StepReport;


  /** The table at the end of a run: a line per step. */
  class SummaryTable
  {
  public:
    /** Add the line of a step. Must be called on all ranks. */
    void
    add(const StepReport                  &report,
        const State                       &state,
        const ShellMesh                   &mesh,
        const std::vector<FailureMaximum> &failure_maxima);

    /**
     * Print the table: the load factor and the pressure if not zero, the
     * displacements and forces of supports that move, the contact zone of steps
     * with contact, critical points, the maxima of failure indices, and for
     * each named point the component of the displacement that is largest at the
     * end, for as many points as fit. Nothing without steps.
     */
    void
    print(const ShellMesh &mesh, std::ostream &out) const;

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
      /** The displacements and forces of supports, see reaction_values(). */
      std::vector<double> reactions;
      /** The kind of the critical point that the step has passed; empty for
       * none. */
      std::string critical_point;
      /** Cartesian displacements of the middle surface at the named points, one
       * after the other. */
      std::vector<double>         displacements;
      std::vector<FailureMaximum> failure_maxima;

      template <class Archive>
      void
      serialize(Archive &archive, const unsigned int)
      {
        archive &step &factor &pressure &approach &in_contact &contact.force;
        archive &contact.n_nodes &contact.area            &contact.max_pressure;
        archive &reactions &critical_point &displacements &failure_maxima;
      }
    };

    std::vector<Line> lines;
  };
} // namespace Biface

#endif
