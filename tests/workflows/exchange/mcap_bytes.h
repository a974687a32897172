// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "workflows/exchange/mcap_file_internal.h"

namespace gaitwright::synthetic {

/// A whole number in little-endian bytes.
inline std::string LittleEndian(std::uint64_t value, int size) {
  std::string bytes;
  for (int i = 0; i < size; ++i) bytes += static_cast<char>(value >> (8 * i) & 0xff);
  return bytes;
}

inline std::string LongText(const std::string& text) { return LittleEndian(text.size(), 4) + text; }

inline std::string McapRecord(int code, const std::string& content) {
  return static_cast<char>(code) + LittleEndian(content.size(), 8) + content;
}

inline const std::string kMagicOfMcap("\x89MCAP0\r\n", 8);

inline std::string McapHead() { return kMagicOfMcap + McapRecord(1, LongText("ros2") + LongText("by hand")); }

inline std::string SchemaRecord(std::uint16_t id, const std::string& type) {
  return McapRecord(3, LittleEndian(id, 2) + LongText(type) + LongText("ros2msg") + LongText("float64 x\n"));
}

inline std::string ChannelRecord(std::uint16_t id, std::uint16_t schema, const std::string& topic,
                                 const std::string& encoding = "cdr") {
  return McapRecord(
      4, LittleEndian(id, 2) + LittleEndian(schema, 2) + LongText(topic) + LongText(encoding) + LongText(""));
}

inline std::string MessageRecord(std::uint16_t channel, std::uint64_t time_ns, const std::string& data) {
  return McapRecord(
      5, LittleEndian(channel, 2) + LittleEndian(7, 4) + LittleEndian(time_ns, 8) + LittleEndian(time_ns, 8) + data);
}

inline std::string ChunkRecord(const std::string& packed, std::size_t size, const std::string& compression,
                               std::uint32_t crc = 0) {
  return McapRecord(6, LittleEndian(0, 8) + LittleEndian(0, 8) + LittleEndian(size, 8) + LittleEndian(crc, 4) +
                           LongText(compression) + LittleEndian(packed.size(), 8) + packed);
}

/// Data end, an empty summary and the footer.
inline std::string McapTail() {
  return McapRecord(15, LittleEndian(0, 4)) +
         McapRecord(2, LittleEndian(0, 8) + LittleEndian(0, 8) + LittleEndian(0, 4)) + kMagicOfMcap;
}

/// A message with copies of what a recording has of it.
struct SeenMessage {
  RecordedTopic topic;
  std::int64_t log_time_ns = 0;
  std::string data;

  bool operator==(const SeenMessage&) const = default;
};

inline std::vector<SeenMessage> MessagesIn(const std::string& mcap, bool* ended = nullptr) {
  std::vector<SeenMessage> seen;
  const bool whole = ReadMcap(mcap, [&](const RecordedMessage& message) {
    seen.push_back({message.topic, message.log_time_ns, std::string(message.data)});
  });
  if (ended != nullptr) *ended = whole;
  return seen;
}

/// The text of what `work` throws.
template <class Error, class Work>
std::string WhatOf(const Work& work) {
  try {
    work();
  } catch (const Error& error) {
    return error.what();
  }
  return "nothing was thrown";
}

}  // namespace gaitwright::synthetic
