// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <regex>
#include <sstream>
#include <utility>

#include <biface/base/errors.h>
#include <biface/input/parameter_tools.h>
#include <biface/input/read_file.h>
#include <biface/model/equations/shell_equations.h>
#include <biface/output/atomic_file.h>
#include <biface/output/csv.h>
#include <biface/output/result_file.h>
#include <biface/stepping/step_report.h>
#include <biface/surface/reference_surface.h>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

namespace Biface
{
  using namespace dealii;
  namespace fs = std::filesystem;

  ResultsDirectory::ResultsDirectory(const std::string &name,
                                     const MPI_Comm     communicator,
                                     const Units       &units)
    : communicator(communicator), units(units), name(name)
  {
    std::string reason;
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
      {
        std::error_code error;
        fs::create_directories(name, error);
        if (error)
          reason = "the directory cannot be created (" + error.message() + ")";
        else
          {
            // the system gives it up when the process ends, however it ends;
            // some file systems have no locks
            lock = open(name.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
            if (lock >= 0 && flock(lock, LOCK_EX | LOCK_NB) != 0 &&
                errno == EWOULDBLOCK)
              reason = "another run is writing its results there; wait until "
                       "it has ended, or choose another directory";
          }
      }
    // all ranks throw or none: those left would wait in the next collective
    // call
    reason = Utilities::MPI::broadcast(communicator, reason);
    if (!reason.empty())
      {
        unlock();
        throw InputError("Output/Directory", name, reason);
      }
  }


  ResultsDirectory::~ResultsDirectory()
  {
    unlock();
  }


  void
  ResultsDirectory::unlock()
  {
    if (lock >= 0)
      close(lock);
    lock = -1;
  }


  void
  ResultsDirectory::remove(const std::string                 &names,
                           const std::optional<unsigned long> last_step) const
  {
    if (Utilities::MPI::this_mpi_process(communicator) != 0)
      return;
    const std::regex pattern(names);
    std::error_code  error;
    for (fs::directory_iterator entry(name, error), end; !error && entry != end;
         entry.increment(error))
      {
        std::smatch       match;
        const std::string file = entry->path().filename().string();
        std::error_code   failed;
        if (!std::regex_match(file, match, pattern) ||
            !fs::is_regular_file(entry->symlink_status(failed)))
          continue;
        if (last_step &&
            !(match.size() > 1 && match[1].matched &&
              std::strtoul(match[1].str().c_str(), nullptr, 10) > *last_step))
          continue;
        // input files are kept, under whatever path they were given
        if (std::none_of(
              kept.begin(), kept.end(), [&](const std::string &path) {
                return fs::equivalent(path, entry->path(), failed);
              }))
          fs::remove(entry->path(), failed);
      }
  }


  void
  ResultsDirectory::refuse_input(const std::string &names) const
  {
    // refused before the first result: later, the input would be lost
    std::string found;
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
      for (const std::string &path : kept)
        {
          std::error_code error;
          const fs::path  file = fs::absolute(path, error);
          if (!error &&
              std::regex_match(file.filename().string(), std::regex(names)) &&
              fs::equivalent(file.parent_path(), name, error))
            found = path;
        }
    found = Utilities::MPI::broadcast(communicator, found);
    if (!found.empty())
      throw InputError("the input file " + quoted(found, 300) +
                       " would be overwritten: it lies in 'Output/Directory' "
                       "and has the name of a file of results; choose another "
                       "name or directory.");
  }


  std::string
  ResultsDirectory::path(const std::string &file)
  {
    return *unsynced.insert(name + "/" + file).first;
  }


  void
  ResultsDirectory::sync()
  {
    // what a checkpoint counts on must outlive a crash of the machine
    std::pair<std::string, std::string> file_and_reason;
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
      for (const std::string &file : unsynced)
        if (file_and_reason.second.empty())
          file_and_reason = {file, sync_to_disk(file)};
    unsynced.clear();
    file_and_reason = Utilities::MPI::broadcast(communicator, file_and_reason);
    if (!file_and_reason.second.empty())
      throw OutputError(file_and_reason.first, file_and_reason.second);
  }


  ResultFile::ResultFile(const std::string    &name,
                         ResultsDirectory     &directory,
                         const ShellEquations &equations)
    : name(name)
    , communicator(directory.communicator)
    , directory(directory)
    , equations(equations)
  {}


  std::string
  ResultFile::names_of_files() const
  {
    std::string names;
    for (const char c : name)
      names += (c == '*'   ? "([0-9]{4,})"
                : c == '.' ? "\\."
                           : std::string(1, c));
    return names;
  }


  void
  ResultFile::resume(const std::vector<unsigned int> &steps)
  {
    this->steps = steps;
    // files of later steps would be taken for results of the continued run
    directory.remove(names_of_files(), steps.empty() ? 0 : steps.back());
    cut_back();
  }


  void
  ResultFile::write_step(const StepReport &report, const State &state)
  {
    if (!contains(report))
      return;
    steps.push_back(report.step);
    write(report, state);
  }


  std::string
  ResultFile::path(const unsigned int step, const std::string &part) const
  {
    std::string file = name;
    const auto  star = file.find('*');
    if (star != std::string::npos)
      {
        const std::string before = part.empty() ? "" : part + "-";
        file.replace(star,
                     1,
                     with_underscores(before) +
                       Utilities::int_to_string(step, 4));
      }
    return directory.path(file);
  }


  StepTable::StepTable(const std::string    &name,
                       const std::string    &header,
                       const unsigned int    lines_per_step,
                       ResultsDirectory     &directory,
                       const ShellEquations &equations,
                       const bool            wanted)
    : ResultFile(name, directory, equations)
    , header(header)
    , lines_per_step(lines_per_step)
    , wanted(wanted)
  {}


  void
  StepTable::start()
  {
    write_text(path(), header + '\n', false, communicator);
  }


  void
  StepTable::cut_back()
  {
    const std::vector<unsigned int> &steps = get_steps();
    const std::string                path  = this->path();

    std::istringstream lines(read_file(path, communicator));
    std::string        line;
    if (!std::getline(lines, line) || line != header)
      throw InputError("the file '" + path +
                       "' does not have the columns that a restart continues.");
    std::string kept = header + '\n';
    // complete steps, and lines of the next one
    std::size_t n_complete = 0, n_lines = 0;
    // a last line without a line end is incomplete
    while (n_complete < steps.size() && std::getline(lines, line) &&
           !lines.eof() &&
           std::strtoul(line.c_str(), nullptr, 10) == steps[n_complete])
      {
        kept += line + '\n';
        if (++n_lines == n_lines_of(line))
          {
            ++n_complete;
            n_lines = 0;
          }
      }
    if (n_complete < steps.size())
      throw InputError("the file '" + path + "' contains only " +
                       std::to_string(n_complete) + " of the " +
                       std::to_string(steps.size()) +
                       " steps of the checkpoint.");
    write_text(path, kept, false, communicator);
  }


  unsigned int
  StepTable::n_lines_of(const std::string &line) const
  {
    if (lines_per_step > 0)
      return lines_per_step;
    // a table whose steps differ in length has it in its second column
    const auto comma = line.find(',');
    return comma == std::string::npos
             ? 0
             : std::strtoul(line.c_str() + comma + 1, nullptr, 10);
  }


  void
  StepTable::append(const std::string &lines) const
  {
    write_text(path(), lines, true, communicator);
  }


  double
  chart_coordinate(const ReferenceSurface &surface,
                   const Node             &node,
                   const unsigned int      a)
  {
    // without the round-off of the unit, so that rows of several files with the
    // same coordinates can be joined
    return std::round(node.alpha[a] / surface.coordinate_unit(a) * 1e9) / 1e9;
  }
} // namespace Biface
