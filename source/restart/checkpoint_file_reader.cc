// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <numeric>

#include <biface/base/errors.h>
#include <biface/restart/checkpoint_file.h>
#include <biface/restart/checkpoint_format.h>

namespace Biface
{
  using namespace dealii;

  namespace CheckpointFile
  {
    namespace
    {
      /** Reads numbers from a file, as far as it goes. */
      class Source
      {
      public:
        explicit Source(const std::string &path) : file(path, std::ios::binary)
        {}

        template <typename Number>
        Number
        number()
        {
          Number number = 0;
          file.read(reinterpret_cast<char *>(&number), sizeof(number));
          return number;
        }

        std::string
        text()
        {
          std::string text(number<std::uint64_t>(), ' ');
          file.read(&text[0], text.size());
          return text;
        }

        std::ifstream file;
      };


      /** What is wrong with a file, as the end of a sentence that begins with
       * its name; empty if nothing is. */
      std::string
      damage(const std::string &path)
      {
        std::error_code error;
        if (!std::filesystem::exists(path, error))
          return "is not there";
        errno = 0;
        Source source(path);
        if (!source.file)
          return std::string("cannot be read (") +
                 (errno != 0 ? std::strerror(errno) : "unknown reason") + ")";

        const std::uint64_t size = std::filesystem::file_size(path, error);
        if (error || size < magic.size() + 4 * sizeof(std::uint64_t))
          return "is cut off";
        std::array<char, 8> begin;
        source.file.read(begin.data(), begin.size());
        if (begin != magic)
          return "is no checkpoint";
        if (source.number<std::uint32_t>() != format)
          return "has the form of another version of the program";
        if (source.number<std::uint32_t>() != byte_order)
          return "is from a machine that stores numbers otherwise";

        Checksum          checksum;
        std::vector<char> buffer(piece);
        source.file.seekg(0);
        for (std::uint64_t left = size - sizeof(std::uint64_t); left > 0;)
          {
            const std::uint64_t n = std::min<std::uint64_t>(left, piece);
            source.file.read(buffer.data(), n);
            checksum.process_bytes(buffer.data(), n);
            left -= n;
          }
        const auto expected = source.number<std::uint64_t>();
        if (!source.file)
          return "cannot be read";
        if (expected != checksum.checksum())
          return "is damaged (its checksum is wrong)";
        return "";
      }
    } // namespace


    Reader::Reader(const std::string &path, const MPI_Comm communicator)
      : communicator(communicator), path(path)
    {
      std::string reason;
      using Head = std::pair<std::string,
                             std::map<std::string, std::vector<std::uint64_t>>>;
      Head head;
      if (Utilities::MPI::this_mpi_process(communicator) == 0)
        {
          reason = damage(path);
          if (reason.empty())
            {
              Source source(path);
              source.file.seekg(magic.size() + 2 * sizeof(std::uint32_t));
              head.first          = source.text();
              const auto n_tables = source.number<std::uint64_t>();
              std::vector<std::string> names;
              for (unsigned int i = 0; i < n_tables; ++i)
                {
                  names.push_back(source.text());
                  const auto width          = source.number<std::uint64_t>();
                  const auto n_rows         = source.number<std::uint64_t>();
                  head.second[names.back()] = {width, n_rows, 0};
                }
              std::uint64_t offset = source.file.tellg();
              for (const std::string &name : names)
                {
                  auto &entry = head.second[name];
                  entry[2]    = offset;
                  offset += entry[0] * entry[1] * sizeof(double);
                }
            }
        }
      reason = Utilities::MPI::broadcast(communicator, reason);
      if (!reason.empty())
        throw InputError("the checkpoint '" + path + "' " + reason + ".");
      head   = Utilities::MPI::broadcast(communicator, head);
      header = head.first;
      for (const auto &entry : head.second)
        tables[entry.first] = {
          entry.second[0], entry.second[1], entry.second[2]};
    }


    std::vector<double>
    Reader::rows(const std::string                &name,
                 const std::vector<std::uint64_t> &numbers) const
    {
      const Entry             &entry = tables.at(name);
      std::vector<double>      values(numbers.size() * entry.width);
      std::vector<std::size_t> order(numbers.size());
      std::iota(order.begin(), order.end(), 0);
      std::sort(order.begin(), order.end(), [&](const auto a, const auto b) {
        return numbers[a] < numbers[b];
      });

      std::ifstream file;
      if (Utilities::MPI::this_mpi_process(communicator) == 0)
        {
          file.open(path, std::ios::binary);
          file.seekg(entry.offset);
        }
      auto                next = order.begin();
      const std::uint64_t step = piece / entry.width;
      for (std::uint64_t begin = 0; begin < entry.n_rows; begin += step)
        {
          const std::uint64_t end = std::min(begin + step, entry.n_rows);
          std::vector<double> part;
          if (file.is_open())
            {
              part.resize((end - begin) * entry.width);
              file.read(reinterpret_cast<char *>(part.data()),
                        part.size() * sizeof(double));
              AssertThrow(file, ExcIO());
            }
          part = Utilities::MPI::broadcast(communicator, part);
          for (; next != order.end() && numbers[*next] < end; ++next)
            std::copy_n(part.begin() + (numbers[*next] - begin) * entry.width,
                        entry.width,
                        values.begin() + *next * entry.width);
        }
      AssertThrow(next == order.end(), ExcInternalError());
      return values;
    }
  } // namespace CheckpointFile
} // namespace Biface
