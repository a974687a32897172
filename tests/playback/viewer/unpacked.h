// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstring>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace gaitwright::unpacked {

using Json = nlohmann::ordered_json;

/// The bytes of base64, decoded independently of the code that wrote it.
inline std::string Bytes(const std::string& text) {
  const std::string letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bits, bytes;
  for (const char c : text) {
    const std::size_t value = letters.find(c);
    if (value == std::string::npos) break;
    for (int bit = 5; bit >= 0; --bit) bits += value >> bit & 1U ? '1' : '0';
  }
  for (std::size_t i = 0; i + 8 <= bits.size(); i += 8)
    bytes += static_cast<char>(std::stoi(bits.substr(i, 8), nullptr, 2));
  return bytes;
}

template <class Number>
std::vector<Number> Numbers(const Json& packed, const char* kind) {
  const std::string bytes = Bytes(packed.at(kind).get<std::string>());
  std::vector<Number> numbers(bytes.size() / sizeof(Number));
  std::memcpy(numbers.data(), bytes.data(), numbers.size() * sizeof(Number));
  return numbers;
}

inline std::vector<float> Floats(const Json& packed) { return Numbers<float>(packed, "f32"); }

}  // namespace gaitwright::unpacked
