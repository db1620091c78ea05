// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_output_face_patches_h
#define biface_output_face_patches_h

#include <deal.II/base/data_out_base.h>

#include <string>
#include <tuple>
#include <vector>

#include <biface/model/shell_equations.h>
#include <biface/model/state.h>

namespace Biface
{
  /**
   * Both faces of the deformed shell for deal.II's writers: one patch a face of
   * every locally owned cell. Data: the displacement, the contact pressure, the
   * active set, which face it is, and the resultants.
   */
  class FacePatches : public dealii::DataOutInterface<2, 3>
  {
  public:
    FacePatches(const ShellEquations &equations,
                const State          &state,
                const Loads          &loads);

  private:
    const std::vector<dealii::DataOutBase::Patch<2, 3>> &
    get_patches() const override;

    std::vector<std::string>
    get_dataset_names() const override;

    std::vector<std::tuple<
      unsigned int,
      unsigned int,
      std::string,
      dealii::DataComponentInterpretation::DataComponentInterpretation>>
    get_nonscalar_data_ranges() const override;

    std::vector<dealii::DataOutBase::Patch<2, 3>> patches;
  };
} // namespace Biface

#endif
