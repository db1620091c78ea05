// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_output_atomic_file_h
#define biface_output_atomic_file_h

#include <cstddef>
#include <string>

namespace Biface
{
  /**
   * A file that exists completely or not at all, whenever the program ends: it
   * is written under its name with ".tmp" appended, and renamed when complete.
   * For a single rank. After a failure, error() says why.
   */
  class AtomicFile
  {
  public:
    /** Open the temporary file. */
    explicit AtomicFile(const std::string &path);

    /** Remove the temporary file, if it still exists. */
    ~AtomicFile();

    AtomicFile(const AtomicFile &) = delete;
    AtomicFile &
    operator=(const AtomicFile &) = delete;

    void
    write(const void *data, const std::size_t size);

    void
    write(const std::string &text)
    {
      write(text.data(), text.size());
    }

    /** Flush what was written to the disk. */
    void
    sync();

    /** Close and rename the file. Does nothing after an error. */
    void
    commit();

    /** The reason of a failure; empty without one. */
    const std::string &
    error() const
    {
      return reason;
    }

  private:
    /** Store the reason of the last error of the system. */
    void
    failed();

    const std::string path;
    const std::string temporary;
    int               file;
    std::string       reason;
  };


  /** Flush a file or a directory to the disk.
   * @return the reason of a failure; empty on success. */
  std::string
  sync_to_disk(const std::string &path);
} // namespace Biface

#endif
