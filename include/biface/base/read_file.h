// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_base_read_file_h
#define biface_base_read_file_h

#include <mpi.h>

#include <string>

namespace Biface
{
  /**
   * The text of a file. The first rank reads it for all; must be called on all
   * ranks. Throws InputError on all of them where the file cannot be read.
   */
  std::string
  read_file(const std::string &file_name, const MPI_Comm communicator);
} // namespace Biface

#endif
