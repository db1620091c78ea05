// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_output_plies_file_h
#define biface_output_plies_file_h

#include <biface/output/requested_criteria.h>
#include <biface/output/result_file.h>

namespace Biface
{
  class EntryDeclarations;


  /** plies-NNNN.csv: strains and stresses within the plies at the named
   * points. */
  class PliesFile : public ResultFile
  {
  public:
    struct Parameters
    {
      /** Number of heights within each ply. */
      unsigned int points_per_ply = 3;

      void
      add_parameters(EntryDeclarations &prm);
    };

    PliesFile(const Parameters      &parameters,
              const FailureCriteria &criteria,
              ResultsDirectory      &directory,
              const ShellEquations  &equations);

    /** Whether a point is named. */
    bool
    is_wanted() const override;

    std::vector<std::string>
    warnings() const override;

  private:
    void
    write(const StepReport &report, const State &state) override;

    const Parameters      parameters;
    const FailureCriteria criteria;
  };
} // namespace Biface

#endif
