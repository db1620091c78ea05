// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_output_shell_vtu_h
#define biface_output_shell_vtu_h

#include <deal.II/base/tensor.h>

#include <vector>

#include <biface/output/vtu_series.h>

namespace Biface
{
  class EntryDeclarations;
  struct Loads;


  /**
   * Both faces of the deformed shell: one quadrilateral per face of every
   * locally owned cell. Data: the displacement, the contact pressure, the
   * active set, the face, the resultants, friction, and, if the shell moves or
   * rolls, the velocity or the slip velocity.
   */
  class FacePatches : public VertexPatches<2>
  {
  public:
    /** @param slip_velocities see StepReport; empty unless the shell
     * rolls. */
    FacePatches(const ShellEquations                    &equations,
                const State                             &state,
                const Loads                             &loads,
                const std::vector<dealii::Tensor<1, 3>> &slip_velocities = {});
  };


  /** shell-NNNN.vtu and shell.pvd: both faces of the deformed shell. */
  class ShellVtu : public VtuSeries
  {
  public:
    struct Parameters
    {
      bool write = true;

      void
      add_parameters(EntryDeclarations &prm);
    };

    ShellVtu(const Parameters     &parameters,
             ResultsDirectory     &directory,
             const ShellEquations &equations);

  private:
    void
    write(const StepReport &report, const State &state) override;
  };
} // namespace Biface

#endif
