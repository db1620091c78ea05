// SPDX-License-Identifier: LGPL-2.1-or-later

// Any study file gives samples and the settings of the first one, or is refused
// with one sentence. Files of samples are not read.

#include <biface/input/parameter_text.h>
#include <biface/problem/parameters.h>
#include <biface/study/sampling.h>
#include <biface/study/study_parameters.h>

#include "fuzz.h"

namespace Fuzz::StudyFiles
{
  using namespace Biface;

  namespace
  {
    Parameters               base;
    dealii::ParameterHandler base_prm;
  } // namespace


  void
  initialize()
  {
    parse_parameters(
      PRM_DIR "/bias_tire.prm", {}, MPI_COMM_SELF, base, base_prm);
  }


  void
  try_input(const std::string &input)
  {
    read(input, [&]() {
      StudyParameters          study;
      dealii::ParameterHandler prm;
      study.add_parameters(prm);
      const std::string text = join_lines("study.prm", input);
      check_parameter_text("study.prm", text);
      parse_parameter_text(prm, "study.prm", text);
      if (study.sampling.type == Sampling::Type::file)
        return;
      const auto samples = study.sampling.samples("", MPI_COMM_SELF);
      settings(study.sampling.variables, samples[0], base_prm, "--study");
      for (const DesignVariable &variable : study.sampling.variables)
        variable.value(base_prm);
    });
  }
} // namespace Fuzz::StudyFiles
