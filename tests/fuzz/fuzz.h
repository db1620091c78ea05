// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_tests_fuzz_fuzz_h
#define biface_tests_fuzz_fuzz_h

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <string>

#include <biface/base/errors.h>

/** Called first by libFuzzer, or by replay.cc in its place: the first argument
 * names the readers. */
extern "C" int
LLVMFuzzerInitialize(int *argc, char ***argv);

/** Called for each input. */
extern "C" int
LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size);

namespace Fuzz
{
  /**
   * Call a reader. It may refuse @p input with one plain sentence; anything
   * else aborts the program.
   */
  template <typename Function>
  void
  read(const std::string &input, const Function &reader)
  {
    try
      {
        reader();
      }
    catch (const Biface::InputError &error)
      {
        const std::string sentence = error.what();
        bool              plain = (!sentence.empty() && sentence.back() == '.');
        for (const char c : sentence)
          plain = plain && static_cast<unsigned char>(c) >= 0x20 && c != 0x7F;
        for (const char *word : {"xception", "dealii::", "std::", "MAX_DOUBLE"})
          plain = plain && (sentence.find(word) == std::string::npos ||
                            input.find(word) != std::string::npos);
        if (!plain)
          {
            std::cerr << "Not one plain sentence: " << sentence << std::endl;
            std::abort();
          }
      }
  }
} // namespace Fuzz

#endif
