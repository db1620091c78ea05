// SPDX-License-Identifier: LGPL-2.1-or-later

#include <cstdlib>
#include <filesystem>

#include <biface/base/version.h>

#include <dlfcn.h>

namespace Biface
{
  std::string
  version()
  {
    return BIFACE_VERSION;
  }


  std::string
  blas_library()
  {
    Dl_info info;
    void   *dgemm = dlsym(RTLD_DEFAULT, "dgemm_");
    if (dgemm == nullptr || dladdr(dgemm, &info) == 0)
      return "unknown";

    // Debian's file is a link to the library chosen on this machine
    std::error_code             error;
    const std::filesystem::path file =
      std::filesystem::canonical(info.dli_fname, error);
    return error ? info.dli_fname : file.string();
  }


  void
  limit_blas_threads()
  {
    for (const char *variable : {"OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS"})
      if (std::getenv(variable) != nullptr)
        return;
    if (void *set_threads = dlsym(RTLD_DEFAULT, "openblas_set_num_threads"))
      reinterpret_cast<void (*)(int)>(set_threads)(1);
  }
} // namespace Biface
