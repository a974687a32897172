// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

namespace gaitwright::onnx {

/// One field of a protobuf message, see https://protobuf.dev/programming-guides/encoding/. Numbers of 4 and 8 bytes and
/// varints are in `value`; texts, messages and packed lists are in `bytes`.
struct WireField {
  enum class Kind { kVarint = 0, kFixed64 = 1, kBytes = 2, kFixed32 = 5 };

  int number = 0;
  Kind kind = Kind::kVarint;
  std::uint64_t value = 0;
  std::string_view bytes = {};

  std::int64_t Whole() const { return static_cast<std::int64_t>(value); }
  float Float() const;
};

/// All fields of a message in their order. Fields of groups, which no ONNX file has, are refused.
/// @throws InvalidArgument if the message is truncated or malformed.
std::vector<WireField> FieldsOf(std::string_view message);

/// Adds the numbers of a repeated field, packed or not, to a list. @throws InvalidArgument for a field of another kind.
void AddWholes(const WireField& field, std::vector<std::int64_t>& list);
void AddFloats(const WireField& field, std::vector<float>& list);
void AddDoubles(const WireField& field, std::vector<float>& list);

/// The text of a field. @throws InvalidArgument for a number.
std::string_view BytesOf(const WireField& field);

/// Numbers from little-endian bytes. @pre enough bytes
float FloatFrom(const char* bytes);
double DoubleFrom(const char* bytes);
std::uint64_t LittleEndian(const char* bytes, int count);

}  // namespace gaitwright::onnx
