// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_output_forces_file_h
#define biface_output_forces_file_h

#include <deal.II/base/point.h>

#include <biface/output/result_file.h>

namespace Biface
{
  class EntryDeclarations;


  /** forces.csv: the forces and moments on the shell of each of its supports,
   * of the ground and of the loads, a line per body and step; see
   * forces_on_shell(). */
  class ForcesFile : public StepTable
  {
  public:
    struct Parameters
    {
      dealii::Point<3> moment_center;

      void
      add_parameters(EntryDeclarations &prm);
    };

    /** The table for a center of moments. Throws InputError if that is
     * invalid. */
    ForcesFile(const Parameters     &parameters,
               ResultsDirectory     &directory,
               const ShellEquations &equations);

  private:
    void
    write(const StepReport &report, const State &state) override;

    const Parameters parameters;
  };
} // namespace Biface

#endif
