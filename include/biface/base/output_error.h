// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_base_output_error_h
#define biface_base_output_error_h

#include <stdexcept>
#include <string>

namespace Biface
{
  /**
   * A file of results that cannot be written, for want of space, say. The
   * message is one plain sentence that names the file and the reason.
   *
   * It must be thrown on all ranks alike.
   */
  class OutputError : public std::runtime_error
  {
  public:
    OutputError(const std::string &file, const std::string &reason)
      : std::runtime_error("the file '" + file + "' cannot be written (" +
                           reason + "), but results must go somewhere.")
    {}
  };
} // namespace Biface

#endif
