// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_input_parameter_sentence_h
#define biface_input_parameter_sentence_h

#include <deal.II/base/parameter_handler.h>

#include <string>

namespace Biface
{
  /**
   * What ParameterHandler has to say of a parameter file, as one sentence that
   * names file, line, entry, value and what is allowed; of an unknown name, the
   * nearest one that is known.
   *
   * @param exception what was thrown.
   * @param source what the sentence calls the text.
   * @param text the text of the parameter file.
   * @param prm knows the entries.
   */
  std::string
  parameter_sentence(const dealii::ExceptionBase    &exception,
                     const std::string              &source,
                     const std::string              &text,
                     const dealii::ParameterHandler &prm);
} // namespace Biface

#endif
