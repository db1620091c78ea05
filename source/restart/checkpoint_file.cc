// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>
#include <numeric>

#include <biface/base/errors.h>
#include <biface/base/gather.h>
#include <biface/output/atomic_file.h>
#include <biface/restart/checkpoint_file.h>

#include <boost/crc.hpp>

namespace Biface
{
  using namespace dealii;

  namespace CheckpointFile
  {
    namespace
    {
      /** The first bytes of a file. */
      constexpr std::array<char, 8> magic{
        {'b', 'i', 'f', 'a', 'c', 'e', '\r', '\n'}};
      /** Read as a different number on machines with another byte order. */
      constexpr std::uint32_t byte_order = 0x01020304;

      /** The number of values that the first rank handles at once. */
      constexpr std::uint64_t piece = 1 << 20;

      /** CRC-64/XZ. */
      using Checksum = boost::crc_optimal<64,
                                          0x42F0E1EBA9EA3693,
                                          0xFFFFFFFFFFFFFFFF,
                                          0xFFFFFFFFFFFFFFFF,
                                          true,
                                          true>;


      /** Writes numbers to a file and adds them to its checksum. */
      class Sink
      {
      public:
        explicit Sink(const std::string &path) : file(path)
        {}

        void
        put(const void *data, const std::size_t size)
        {
          checksum.process_bytes(data, size);
          file.write(data, size);
        }

        template <typename Number>
        void
        put_number(const Number number)
        {
          put(&number, sizeof(number));
        }

        void
        put_text(const std::string &text)
        {
          put_number<std::uint64_t>(text.size());
          put(text.data(), text.size());
        }

        AtomicFile file;
        Checksum   checksum;
      };


      /** The rows of all ranks with numbers from @p begin to @p end, in their
       * order; on the first rank.
       * @param order the rows of this rank by their numbers. */
      std::vector<double>
      gather(const NumberedRows             &rows,
             const std::vector<std::size_t> &order,
             const std::uint64_t             begin,
             const std::uint64_t             end,
             const MPI_Comm                  communicator)
      {
        const auto before = [&](const std::size_t i, const std::uint64_t n) {
          return rows.numbers[i] < n;
        };
        std::vector<std::uint64_t> numbers;
        std::vector<double>        values;
        for (auto i =
               std::lower_bound(order.begin(), order.end(), begin, before);
             i != order.end() && rows.numbers[*i] < end;
             ++i)
          {
            numbers.push_back(rows.numbers[*i]);
            const auto row = rows.values.begin() + *i * rows.width;
            values.insert(values.end(), row, row + rows.width);
          }

        // collective, also for ranks without rows in this piece
        numbers = gather_numbers(communicator, numbers);
        values  = gather_numbers(communicator, values);
        Assert(Utilities::MPI::this_mpi_process(communicator) != 0 ||
                 numbers.size() == end - begin,
               ExcInternalError());
        std::vector<double> ordered(values.size());
        for (std::size_t i = 0; i < numbers.size(); ++i)
          std::copy_n(values.begin() + i * rows.width,
                      rows.width,
                      ordered.begin() + (numbers[i] - begin) * rows.width);
        return ordered;
      }


      /** The number of rows of each table in the file: none if all of its
       * values are zero. */
      std::vector<std::uint64_t>
      n_written_rows(const std::vector<Table> &tables,
                     const MPI_Comm            communicator)
      {
        // zeros take no space; the reader makes them again
        std::vector<unsigned int> any(tables.size());
        for (unsigned int t = 0; t < tables.size(); ++t)
          for (const double value : tables[t].second.values)
            if (value != 0)
              {
                any[t] = 1;
                break;
              }
        Utilities::MPI::max(any, communicator, any);
        std::vector<std::uint64_t> n_rows;
        for (unsigned int t = 0; t < tables.size(); ++t)
          n_rows.push_back(any[t] ? tables[t].second.n_rows : 0);
        return n_rows;
      }
    } // namespace


    void
    write(const std::string        &path,
          const std::string        &previous,
          const std::string        &header,
          const std::vector<Table> &tables,
          const MPI_Comm            communicator)
    {
      const bool is_root = Utilities::MPI::this_mpi_process(communicator) == 0;
      const std::vector<std::uint64_t> n_rows =
        n_written_rows(tables, communicator);
      std::unique_ptr<Sink> sink;
      if (is_root)
        {
          sink = std::make_unique<Sink>(path);
          sink->put(magic.data(), magic.size());
          sink->put_number(format);
          sink->put_number(byte_order);
          sink->put_text(header);
          sink->put_number<std::uint64_t>(tables.size());
          for (unsigned int t = 0; t < tables.size(); ++t)
            {
              sink->put_text(tables[t].first);
              sink->put_number<std::uint64_t>(tables[t].second.width);
              sink->put_number(n_rows[t]);
            }
        }

      for (unsigned int t = 0; t < tables.size(); ++t)
        {
          const NumberedRows      &rows = tables[t].second;
          std::vector<std::size_t> order(rows.numbers.size());
          std::iota(order.begin(), order.end(), 0);
          std::sort(
            order.begin(), order.end(), [&](const auto a, const auto b) {
              return rows.numbers[a] < rows.numbers[b];
            });
          const std::uint64_t step = piece / rows.width;
          // all ranks go through all pieces, since each is gathered from all of
          // them
          for (std::uint64_t begin = 0; begin < n_rows[t]; begin += step)
            {
              const auto values = gather(rows,
                                         order,
                                         begin,
                                         std::min(begin + step, n_rows[t]),
                                         communicator);
              if (is_root)
                sink->put(values.data(), values.size() * sizeof(double));
            }
        }

      std::string reason;
      if (is_root)
        {
          sink->put_number<std::uint64_t>(sink->checksum.checksum());
          AtomicFile &file = sink->file;
          // the data must be on the disk before its name is
          file.sync();
          // between the two renames, the older file is the latest
          if (file.error().empty() &&
              std::rename(path.c_str(), previous.c_str()) != 0 &&
              errno != ENOENT)
            reason = std::strerror(errno);
          else
            {
              file.commit();
              reason = file.error();
            }
          if (reason.empty())
            // the new names, too
            reason = sync_to_disk(
              std::filesystem::absolute(path).parent_path().string());
        }
      reason = Utilities::MPI::broadcast(communicator, reason);
      if (!reason.empty())
        throw OutputError(path, reason);
    }


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


      /** The error in a file, as the end of a sentence that starts with its
       * name; empty if there is none. */
      std::string
      damage(const std::string &path)
      {
        std::error_code error;
        if (!std::filesystem::exists(path, error))
          return "does not exist";
        errno = 0;
        Source source(path);
        if (!source.file)
          return std::string("cannot be read (") +
                 (errno != 0 ? std::strerror(errno) : "unknown reason") + ")";

        const std::uint64_t size = std::filesystem::file_size(path, error);
        if (error || size < magic.size() + 4 * sizeof(std::uint64_t))
          return "is truncated";
        std::array<char, 8> begin;
        source.file.read(begin.data(), begin.size());
        // in this order: of another file, version or machine the checksum says
        // nothing
        if (begin != magic)
          return "is not a checkpoint";
        if (source.number<std::uint32_t>() != format)
          return "was written by another version of the program";
        if (source.number<std::uint32_t>() != byte_order)
          return "was written on a machine with another byte order";

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
          return "is damaged (wrong checksum)";
        return "";
      }
    } // namespace


    Reader::Reader(const std::string &path, const MPI_Comm communicator)
      : communicator(communicator), path(path)
    {
      // the first rank alone reads, but all must throw
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
              // the checksum was right, so that sizes and offsets can be
              // trusted
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
      const Entry        &entry = tables.at(name);
      std::vector<double> values(numbers.size() * entry.width);
      if (entry.n_rows == 0)
        return values;
      // pieces of the table come in ascending order and are not stored
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
