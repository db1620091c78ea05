// SPDX-License-Identifier: LGPL-2.1-or-later

#include <cerrno>
#include <cstdio>
#include <cstring>

#include <biface/output/atomic_file.h>

#include <fcntl.h>
#include <unistd.h>

namespace Biface
{
  AtomicFile::AtomicFile(const std::string &path)
    : path(path)
    , temporary(path + ".tmp")
    , file(::open(
        temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666))
  {
    if (file < 0)
      failed();
  }


  AtomicFile::~AtomicFile()
  {
    // what was not committed is incomplete
    if (file < 0)
      return;
    ::close(file);
    ::unlink(temporary.c_str());
  }


  void
  AtomicFile::write(const void *data, const std::size_t size)
  {
    const char *at   = static_cast<const char *>(data);
    std::size_t left = size;
    while (reason.empty() && left > 0)
      {
        // less than asked may be written, and nothing where a signal came
        const ssize_t written = ::write(file, at, left);
        if (written > 0)
          {
            at += written;
            left -= written;
          }
        else if (written == 0 || errno != EINTR)
          failed();
      }
  }


  void
  AtomicFile::sync()
  {
    if (reason.empty() && ::fsync(file) != 0)
      failed();
  }


  void
  AtomicFile::commit()
  {
    if (!reason.empty())
      return;
    // some file systems report only now that there is no space
    const int result = ::close(file);
    file             = -1;
    // a reader finds the old file or the new one, never a part of it
    if (result != 0 || std::rename(temporary.c_str(), path.c_str()) != 0)
      {
        failed();
        ::unlink(temporary.c_str());
      }
  }


  void
  AtomicFile::failed()
  {
    reason = (errno != 0 ? std::strerror(errno) : "unknown reason");
  }


  std::string
  sync_to_disk(const std::string &path)
  {
    const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (file < 0)
      return std::strerror(errno);
    // some file systems do not support this for directories and do not need it
    const bool        failed = (::fsync(file) != 0 && errno != EINVAL);
    const std::string reason = (failed ? std::strerror(errno) : "");
    ::close(file);
    return reason;
  }
} // namespace Biface
