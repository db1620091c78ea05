// SPDX-License-Identifier: LGPL-2.1-or-later

// Feeds files, and the files of folders, to a fuzz target, as libFuzzer does.

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

#include "fuzz.h"

int
main(int argc, char *argv[])
{
  namespace fs = std::filesystem;

  LLVMFuzzerInitialize(&argc, &argv);
  std::vector<fs::path> files;
  for (int i = 1; i < argc; ++i)
    if (fs::is_directory(argv[i]))
      {
        for (const auto &file : fs::directory_iterator(argv[i]))
          if (file.is_regular_file())
            files.push_back(file.path());
      }
    else
      files.emplace_back(argv[i]);
  std::sort(files.begin(), files.end());
  if (files.empty())
    {
      std::cerr << "There is no file to replay." << std::endl;
      return 1;
    }

  for (const fs::path &file : files)
    {
      // the last one named is the one that failed
      std::cout << file.string() << std::endl;
      std::ifstream     stream(file, std::ios::binary);
      const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
      if (!stream)
        {
          std::cerr << "It cannot be read." << std::endl;
          return 1;
        }
      LLVMFuzzerTestOneInput(
        reinterpret_cast<const std::uint8_t *>(bytes.data()), bytes.size());
    }
  return 0;
}
