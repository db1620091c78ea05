// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_study_study_parameters_h
#define biface_study_study_parameters_h

#include <deal.II/base/parameter_handler.h>

#include <array>
#include <string>
#include <vector>

#include <biface/problem/override.h>
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
        minimum,
        first_maximum
      };
      /** The words before the result, by Of. */
      static constexpr std::array<const char *, 4> words{
        {"", "maximum ", "minimum ", "first maximum "}};

      Of          of = Of::end;
      std::string result;
      /** The name of the stage; empty for the run. */
      std::string stage;

      /** The name of the column in study.csv. */
      std::string
      name() const
      {
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
    /** The number of the sample to whose outputs those of all are related, from
     * 1; 0 for none. */
    unsigned int reference_sample = 0;
    Sampling     sampling;

    /** Declare the section 'Study'. */
    void
    add_parameters(dealii::ParameterHandler &handler);
  };
} // namespace Biface

#endif
