// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_output_atomic_file_h
#define biface_output_atomic_file_h

#include <cstddef>
#include <string>

namespace Biface
{
  /**
   * A file that is there as a whole or not at all, whenever the program ends:
   * it is written under the name with ".tmp" at its end, and gets its own name
   * when it is complete. For one rank; what goes wrong is remembered and told
   * by error().
   */
  class AtomicFile
  {
  public:
    /** Open the temporary file. */
    explicit AtomicFile(const std::string &path);

    /** Remove the temporary file, if it still is there. */
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

    /** Bring all that was written to the disk, where it outlives the machine.
     */
    void
    sync();

    /** Close the file and give it its name. Does nothing after an error. */
    void
    commit();

    /** Why something did not succeed; empty where all is well. */
    const std::string &
    error() const
    {
      return reason;
    }

  private:
    /** Remember the reason of the system's last error. */
    void
    failed();

    const std::string path;
    const std::string temporary;
    int               file;
    std::string       reason;
  };


  /** Bring a file or a directory to the disk.
   * @return why it did not succeed; empty where it did. */
  std::string
  sync_to_disk(const std::string &path);
} // namespace Biface

#endif
