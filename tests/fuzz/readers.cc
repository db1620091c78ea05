// SPDX-License-Identifier: LGPL-2.1-or-later

// The readers under arbitrary input in one program, whose first argument
// chooses: compiling each for itself would take four times as long.

#include <deal.II/base/mpi.h>

#include <functional>
#include <map>

#include "fuzz.h"

namespace Fuzz
{
#define READERS(name)                    \
  namespace name                         \
  {                                      \
    void                                 \
    initialize();                        \
                                         \
    void                                 \
    try_input(const std::string &input); \
  }
  READERS(ParameterFiles)
  READERS(CsvFiles)
  READERS(Formulas)
  READERS(StudyFiles)
#undef READERS

  namespace
  {
    struct Readers
    {
      void (*initialize)();
      void (*try_input)(const std::string &);
    };

    const std::map<std::string, Readers> all = {
      {"parameters", {ParameterFiles::initialize, ParameterFiles::try_input}},
      {"csv", {CsvFiles::initialize, CsvFiles::try_input}},
      {"formula", {Formulas::initialize, Formulas::try_input}},
      {"study", {StudyFiles::initialize, StudyFiles::try_input}}};

    Readers chosen;
  } // namespace
} // namespace Fuzz


extern "C" int
LLVMFuzzerInitialize(int *argc, char ***argv)
{
  const auto found = Fuzz::all.find(*argc > 1 ? (*argv)[1] : "");
  if (found == Fuzz::all.end())
    {
      std::cerr << "The first argument must be one of:";
      for (const auto &readers : Fuzz::all)
        std::cerr << ' ' << readers.first;
      std::cerr << std::endl;
      std::exit(1);
    }
  Fuzz::chosen = found->second;
  (*argv)[1]   = (*argv)[0];
  --*argc;
  ++*argv;

  static dealii::Utilities::MPI::MPI_InitFinalize mpi(*argc, *argv, 1);
  Fuzz::chosen.initialize();
  return 0;
}


extern "C" int
LLVMFuzzerTestOneInput(const std::uint8_t *data, const std::size_t size)
{
  Fuzz::chosen.try_input(
    std::string(reinterpret_cast<const char *>(data), size));
  return 0;
}
