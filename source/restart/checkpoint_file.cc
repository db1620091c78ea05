// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <numeric>

#include <biface/base/errors.h>
#include <biface/base/gather.h>
#include <biface/output/atomic_file.h>
#include <biface/restart/checkpoint_file.h>
#include <biface/restart/checkpoint_format.h>

namespace Biface
{
  using namespace dealii;

  namespace CheckpointFile
  {
    namespace
    {
      /** Puts numbers into a file, and into its checksum. */
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
    } // namespace


    void
    write(const std::string        &path,
          const std::string        &previous,
          const std::string        &header,
          const std::vector<Table> &tables,
          const MPI_Comm            communicator)
    {
      const bool is_root = Utilities::MPI::this_mpi_process(communicator) == 0;
      std::unique_ptr<Sink> sink;
      if (is_root)
        {
          sink = std::make_unique<Sink>(path);
          sink->put(magic.data(), magic.size());
          sink->put_number(format);
          sink->put_number(byte_order);
          sink->put_text(header);
          sink->put_number<std::uint64_t>(tables.size());
          for (const Table &table : tables)
            {
              sink->put_text(table.first);
              sink->put_number<std::uint64_t>(table.second.width);
              sink->put_number(table.second.n_rows);
            }
        }

      for (const Table &table : tables)
        {
          const NumberedRows      &rows = table.second;
          std::vector<std::size_t> order(rows.numbers.size());
          std::iota(order.begin(), order.end(), 0);
          std::sort(
            order.begin(), order.end(), [&](const auto a, const auto b) {
              return rows.numbers[a] < rows.numbers[b];
            });
          const std::uint64_t step = piece / rows.width;
          for (std::uint64_t begin = 0; begin < rows.n_rows; begin += step)
            {
              const auto values = gather(rows,
                                         order,
                                         begin,
                                         std::min(begin + step, rows.n_rows),
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
          file.sync();
          // between the two changes of names, the older file is the newest
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
            reason = sync_to_disk(
              std::filesystem::absolute(path).parent_path().string());
        }
      reason = Utilities::MPI::broadcast(communicator, reason);
      if (!reason.empty())
        throw OutputError(path, reason);
    }
  } // namespace CheckpointFile
} // namespace Biface
