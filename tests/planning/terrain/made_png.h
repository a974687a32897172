// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace gaitwright::made_png {

/// The bytes of a PNG, written only from its specification (ISO/IEC 15948), with data stored without compression.
/// @param colour  0 for grey, 2 for RGB; @param data  rows without their filter bytes, 16-bit values high byte first.
inline std::string Png(int columns, int rows, int depth, int colour, const std::string& data) {
  const auto word = [](std::uint32_t v) {
    return std::string{static_cast<char>(v >> 24U), static_cast<char>(v >> 16U & 255U),
                       static_cast<char>(v >> 8U & 255U), static_cast<char>(v & 255U)};
  };
  const auto crc = [](const std::string& bytes) {
    std::uint32_t c = 0xFFFFFFFFU;
    for (const char b : bytes) {
      c ^= static_cast<unsigned char>(b);
      for (int k = 0; k < 8; ++k) c = (c & 1U) != 0 ? 0xEDB88320U ^ (c >> 1U) : c >> 1U;
    }
    return c ^ 0xFFFFFFFFU;
  };
  const auto chunk = [&](const std::string& type, const std::string& body) {
    return word(static_cast<std::uint32_t>(body.size())) + type + body + word(crc(type + body));
  };
  const std::size_t length = data.size() / static_cast<std::size_t>(rows);
  std::string raw;
  for (int row = 0; row < rows; ++row)
    raw += std::string(1, '\0') + data.substr(static_cast<std::size_t>(row) * length, length);
  std::uint32_t a = 1, b = 0;  // Adler-32
  for (const char c : raw) {
    a = (a + static_cast<unsigned char>(c)) % 65521U;
    b = (b + a) % 65521U;
  }
  const auto size = static_cast<std::uint16_t>(raw.size());  // one stored block
  const auto low_first = [](std::uint16_t v) {
    return std::string{static_cast<char>(v & 255U), static_cast<char>(v >> 8U)};
  };
  const std::string zlib = std::string("\x78\x01\x01", 3) + low_first(size) +
                           low_first(static_cast<std::uint16_t>(~size)) + raw + word(b << 16U | a);
  const std::string head = word(static_cast<std::uint32_t>(columns)) + word(static_cast<std::uint32_t>(rows)) +
                           std::string{static_cast<char>(depth), static_cast<char>(colour), 0, 0, 0};
  return "\x89PNG\r\n\x1a\n" + chunk("IHDR", head) + chunk("IDAT", zlib) + chunk("IEND", "");
}

}  // namespace gaitwright::made_png
