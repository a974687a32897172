// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

namespace gaitwright {

/// The first and last bytes of an MCAP file.
inline constexpr std::string_view kMcapMagic = "\x89MCAP0\r\n";

/// The kinds of its records that are read or written; others are skipped.
enum class McapOpcode : unsigned char {
  kHeader = 0x01,
  kFooter = 0x02,
  kSchema = 0x03,
  kChannel = 0x04,
  kMessage = 0x05,
  kChunk = 0x06,
  kMessageIndex = 0x07,
  kChunkIndex = 0x08,
  kStatistics = 0x0b,
  kSummaryOffset = 0x0e,
  kDataEnd = 0x0f,
};

}  // namespace gaitwright
