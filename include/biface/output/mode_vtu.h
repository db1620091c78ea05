// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_output_mode_vtu_h
#define biface_output_mode_vtu_h

#include <string>
#include <vector>

#include <biface/output/shell_vtu.h>
#include <biface/output/vtu_series.h>
#include <biface/stepping/step_report.h>

namespace Biface
{
  class ShellMesh;
  struct Stage;


  /**
   * Both faces of the loaded shell with the displacements of a mode: one
   * quadrilateral per face of every locally owned cell.
   *
   * @param shape the displacements, or their real and imaginary parts.
   */
  class ModePatches : public VertexPatches<2>
  {
  public:
    ModePatches(const ShellMesh                       &mesh,
                const LA::Vector                      &displacement,
                const std::vector<const LA::Vector *> &shape);
  };


  /** A series of files for ParaView with the shapes of the end of a stage:
   * NAME-NNNN.pvd and one NAME-NNNN-MMM.vtu per shape, with the number of the
   * shape for the time. */
  class ShapesVtu : public ParaViewFiles
  {
  public:
    /** @param name such as "modes".
     * @param wanted whether there are any shapes and they are requested. */
    ShapesVtu(const std::string    &name,
              const bool            wanted,
              ResultsDirectory     &directory,
              const ShellEquations &equations);

    std::string
    names_of_files() const override
    {
      return prefix + "-([0-9]{4,})(?:\\.pvd|-[0-9]{3,}\\.vtu)";
    }

  protected:
    /** Write shapes of a step, each with its parts, see ModePatches. */
    void
    write_shapes(const unsigned int                                  step,
                 const State                                        &state,
                 const std::vector<std::vector<const LA::Vector *>> &shapes);

  private:
    const std::string prefix;
  };


  /** modes-NNNN.pvd: the modes of vibration. */
  class ModeVtu : public ShapesVtu
  {
  public:
    /** The series, which is written if a stage asks for modes.
     * @param stages those of the run, to see whether there are any modes. */
    ModeVtu(const ShellVtu::Parameters &parameters,
            const std::vector<Stage>   &stages,
            ResultsDirectory           &directory,
            const ShellEquations       &equations);

  private:
    bool
    contains(const StepReport &report) const override
    {
      return report.modes != nullptr;
    }

    void
    write(const StepReport &report, const State &state) override;
  };


  /** buckling-NNNN.pvd: the shapes in which the shell buckles. */
  class BucklingVtu : public ShapesVtu
  {
  public:
    /** The series, which is written if a stage asks for buckling loads.
     * @param stages those of the run, to see whether there are any. */
    BucklingVtu(const ShellVtu::Parameters &parameters,
                const std::vector<Stage>   &stages,
                ResultsDirectory           &directory,
                const ShellEquations       &equations);

  private:
    bool
    contains(const StepReport &report) const override
    {
      return report.buckling != nullptr;
    }

    void
    write(const StepReport &report, const State &state) override;
  };
} // namespace Biface

#endif
