// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_study_study_parameters_h
#define biface_study_study_parameters_h

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

#include <biface/problem/parameters.h>
#include <biface/study/sampling.h>

namespace Biface
{
  /** The parameters of a study: many analyses of one parameter file, in which
   * design variables take other values. */
  struct StudyParameters
  {
    /** A result, see ScalarResults, of the run or of a stage. */
    struct Output
    {
      enum class Of
      {
        end,
        maximum,
        minimum
      };
      Of          of = Of::end;
      std::string result;
      /** The name of the stage; empty for the run. */
      std::string stage;

      /** The name of the column in study.csv. */
      std::string
      name() const
      {
        const char *const words[] = {"", "maximum ", "minimum "};
        return words[static_cast<int>(of)] + result +
               (stage.empty() ? "" : " @ " + stage);
      }
    };

    std::string           base_file;
    std::string           directory  = "study";
    unsigned int          group_size = 1;
    bool                  warm_start = true;
    std::vector<Override> settings;
    std::vector<Output>   outputs;
    Sampling              sampling;

    /** Declare the section 'Study'. */
    void
    add_parameters(dealii::ParameterHandler &handler);
  };
} // namespace Biface

#endif
