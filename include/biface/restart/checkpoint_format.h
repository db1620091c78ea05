// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_restart_checkpoint_format_h
#define biface_restart_checkpoint_format_h

#include <array>
#include <cstdint>

#include <boost/crc.hpp>

namespace Biface
{
  /** What the writer and the reader of checkpoints agree on. */
  namespace CheckpointFile
  {
    /** What a file begins with. */
    inline constexpr std::array<char, 8> magic{
      {'b', 'i', 'f', 'a', 'c', 'e', '\r', '\n'}};
    /** Reads otherwise where numbers are stored otherwise. */
    inline constexpr std::uint32_t byte_order = 0x01020304;

    /** Numbers that pass through the first rank at once. */
    inline constexpr std::uint64_t piece = 1 << 20;

    /** CRC-64/XZ. */
    using Checksum = boost::crc_optimal<64,
                                        0x42F0E1EBA9EA3693,
                                        0xFFFFFFFFFFFFFFFF,
                                        0xFFFFFFFFFFFFFFFF,
                                        true,
                                        true>;
  } // namespace CheckpointFile
} // namespace Biface

#endif
