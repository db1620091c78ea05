// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_output_mode_vtu_h
#define biface_output_mode_vtu_h

#include <string>
#include <vector>

#include <biface/output/shell_vtu.h>
#include <biface/output/vtu_series.h>

namespace Biface
{
  /**
   * Both faces of the loaded shell with the displacements of a mode of
   * vibration: one quadrilateral per face of every locally owned cell.
   */
  class ModePatches : public VertexPatches<2>
  {
  public:
    ModePatches(const ShellMesh  &mesh,
                const LA::Vector &displacement,
                const LA::Vector &shape);
  };


  /** modes-NNNN.pvd and modes-NNNN-MMM.vtu: the modes of vibration at the end
   * of a stage, with the number of the mode for the time. */
  class ModeVtu : public ResultFile
  {
  public:
    /** @param stages those of the run, to see whether there are any modes. */
    ModeVtu(const ShellVtu::Parameters &parameters,
            const std::vector<Stage>   &stages,
            ResultsDirectory           &directory,
            const ShellEquations       &equations);

    std::string
    description() const override
    {
      return name + " (for ParaView)";
    }

    bool
    is_wanted() const override
    {
      return wanted;
    }

  private:
    bool
    contains(const StepReport &report) const override
    {
      return report.modes != nullptr;
    }

    void
    write(const StepReport &report, const State &state) override;

    const bool wanted;
  };
} // namespace Biface

#endif
