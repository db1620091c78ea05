// SPDX-License-Identifier: LGPL-2.1-or-later

// Each command line of the table command_lines.txt, and each file NAME.prm of
// this folder, is answered with the exit code and the sentence that it expects,
// on any number of ranks; one process tries all. A coarse mesh gives most of
// the answers; the others are those with the mesh of the file.

#include <algorithm>
#include <iomanip>
#include <map>

#include "../run_file.h"

using namespace dealii;

namespace
{
  struct Case
  {
    std::string name;
    /** The arguments of the program, as typed in a shell. */
    std::string arguments;
    /** Exit code and message. */
    std::string expected;
  };


  bool
  starts_with(const std::string &line, const std::string &word)
  {
    return line.compare(0, word.size(), word) == 0;
  }


  /** A case from its lines: after @p arguments_key those of the program, after
   * @p expected_key the answer, each continued by indented lines. */
  Case
  read_case(const std::string              &name,
            const std::vector<std::string> &lines,
            const std::string              &arguments_key,
            const std::string              &expected_key)
  {
    Case         result{name, "", ""};
    std::string *text = nullptr;
    for (const std::string &line : lines)
      if (starts_with(line, arguments_key))
        *(text = &result.arguments) = line.substr(arguments_key.size());
      else if (starts_with(line, expected_key))
        *(text = &result.expected) = line.substr(expected_key.size());
      else if (text != nullptr && starts_with(line, "  "))
        *text += ' ' + Utilities::trim(line);
      else
        text = nullptr;
    return result;
  }


  /** The rows of the table, whose first lines describe it. */
  std::vector<Case>
  read_table(const std::string &file)
  {
    std::vector<Case>        cases;
    std::vector<std::string> row;
    const auto               end_row = [&]() {
      if (!row.empty())
        cases.push_back(read_case(
          row[0].substr(0, row[0].find(':')), row, "$ biface ", "-> "));
      row.clear();
    };
    std::ifstream lines(file);
    std::string   line;
    while (std::getline(lines, line))
      {
        // a shell joins lines that end with a backslash
        if (!line.empty() && line.back() == '\\')
          line.pop_back();
        if (line.empty() || line[0] == '#')
          end_row();
        else
          row.push_back(starts_with(line, "  ") ? line.substr(2) : line);
      }
    end_row();
    return cases;
  }


  /** The case of a parameter file, given by its comments. */
  Case
  read_file(const std::filesystem::path &file)
  {
    std::vector<std::string> comments;
    std::ifstream            lines(file);
    std::string              line;
    while (std::getline(lines, line))
      if (starts_with(line, "# "))
        comments.push_back(line.substr(2));
    Case result =
      read_case(file.stem().string(), comments, "arguments: ", "expect: ");
    result.arguments += ' ' + file.filename().string();
    return result;
  }


  /** Coarse meshes of shipped files, by the file: alpha_1 and alpha_2. */
  const std::pair<std::string, std::string> coarse_tire{
    "-120:-45:2, -45:45:4, 45:120:2",
    "-180:-15:2:smooth, -15:15:4, 15:180:2:smooth"};
  const std::map<std::string, std::pair<std::string, std::string>>
    coarse_meshes{{"prm/bias_tire.prm", coarse_tire},
                  {"prm/rolling_tire.prm", coarse_tire},
                  {"prm/tire_modes.prm", coarse_tire},
                  {"prm/tire_test.prm", coarse_tire},
                  {"prm/imperfect_cylinder.prm", {"0:510:6", "-180:180:12"}},
                  {"prm/composite_panel.prm", {"0:300:4", "0:300:4"}}};


  std::vector<std::string>
  split(const std::string &arguments)
  {
    std::vector<std::string> words;
    std::istringstream       stream(arguments);
    std::string              word;
    while (stream >> std::quoted(word))
      words.push_back(word);
    return words;
  }


  /** The settings of a coarse mesh, if the file has one and the arguments do
   * not name the mesh. */
  std::vector<std::string>
  coarse_mesh(const std::vector<std::string> &words)
  {
    for (const auto &[file, intervals] : coarse_meshes)
      if (std::count(words.begin(), words.end(), file) > 0 &&
          std::none_of(words.begin(), words.end(), [](const std::string &word) {
            return starts_with(word, "Mesh/");
          }))
        return {"--set",
                "Mesh/Intervals alpha_1=" + intervals.first,
                "--set",
                "Mesh/Intervals alpha_2=" + intervals.second};
    return {};
  }


  /** Exit code and message of each of the cases that differ from what is
   * expected. */
  std::string
  differences(const std::vector<Case> &cases, const std::string &folder)
  {
    const std::string results = std::filesystem::absolute("results");
    const std::string root    = ROOT_DIR "/";
    const auto        start   = std::filesystem::current_path();
    std::filesystem::current_path(folder);
    std::string differences;
    const auto  answer = [&](const std::vector<std::string> &arguments) {
      auto [code, message] = run_command(arguments, results, MPI_COMM_WORLD);
      message              = Utilities::trim(
        replace(replace(message, results, "results"), root, ""));
      // the other ranks print nothing
      return Utilities::MPI::broadcast(
        MPI_COMM_WORLD,
        std::to_string(code) + (message.empty() ? "" : ' ' + message));
    };
    for (const Case &one : cases)
      {
        const auto words = split(one.arguments), coarse = coarse_mesh(words);
        auto       all = words;
        all.insert(all.end(), coarse.begin(), coarse.end());
        std::string found = answer(all);
        if (found != one.expected && !coarse.empty())
          found = answer(words);
        if (found != one.expected)
          differences += one.name + "\n  answer:   " + found +
                         "\n  expected: " + one.expected + '\n';
      }
    std::filesystem::current_path(start);
    return differences;
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const std::string folder = SOURCE_DIR;
  const auto        table  = read_table(folder + "/command_lines.txt");
  std::vector<Case> files;
  for (const auto &entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".prm")
      files.push_back(read_file(entry.path()));
  std::sort(files.begin(), files.end(), [](const Case &a, const Case &b) {
    return a.name < b.name;
  });

  const std::string found =
    differences(table, ROOT_DIR) + differences(files, folder);
  if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
    std::cout << "command lines: " << (table.empty() ? "none" : "tried")
              << "\nfiles: " << (files.empty() ? "none" : "tried")
              << "\ndifferent answers: " << (found.empty() ? "none" : found)
              << std::endl;
}
