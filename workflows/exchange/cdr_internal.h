// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace gaitwright {

/// A text of a recording in UTF-8; other bytes are taken for Latin-1.
std::string RecordedText(std::string_view bytes);

/// Reads a message of ROS 2 in plain CDR, of either byte order: a head of four bytes, then values aligned to their
/// size, counted from the end of the head. Object Management Group, DDSI-RTPS 2.5, chapter 10; CORBA 3.3, part 2, 9.3.
/// All functions throw InvalidArgument, which names the byte, where the message is too short.
class CdrReader {
 public:
  /// @throws InvalidArgument for another encoding, such as parameter lists.
  explicit CdrReader(std::string_view message);

  std::int32_t Int32() { return static_cast<std::int32_t>(Uint32()); }
  std::uint32_t Uint32() { return static_cast<std::uint32_t>(Whole(4)); }
  double Number();
  std::string Text();             ///< see RecordedText
  std::vector<double> Numbers();  ///< a sequence
  std::vector<std::string> Texts();
  /// The length of a sequence of elements that have at least `least` bytes each.
  std::size_t Length(std::size_t least);
  void Skip(std::size_t numbers);

 private:
  std::uint64_t Whole(std::size_t size);

  std::string_view bytes_;  ///< after the head
  std::size_t at_ = 0;
  bool big_endian_ = false;
};

/// Writes a message in little-endian plain CDR.
class CdrWriter {
 public:
  CdrWriter() : bytes_("\0\1\0\0", 4) {}

  void Int32(std::int32_t value) { Whole(static_cast<std::uint32_t>(value), 4); }
  void Uint32(std::uint32_t value) { Whole(value, 4); }
  void Number(double value);
  void Text(std::string_view text);
  void Texts(const std::vector<std::string>& texts);
  void Numbers(const double* numbers, std::size_t count);  ///< a sequence

  std::string Take() { return std::move(bytes_); }

 private:
  void Whole(std::uint64_t value, std::size_t size);

  std::string bytes_;
};

}  // namespace gaitwright
