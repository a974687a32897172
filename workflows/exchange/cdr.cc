// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <bit>
#include <limits>

#include "kinematics/base/result.h"
#include "kinematics/base/text.h"
#include "workflows/exchange/cdr_internal.h"

namespace gaitwright {
namespace {

constexpr std::size_t kCdrHead = 4;

constexpr std::size_t PaddingBefore(std::size_t at, std::size_t size) { return (size - at % size) % size; }

}  // namespace

std::string RecordedText(std::string_view bytes) {
  const std::string text(bytes);
  return InUtf8(text).value_or(text);
}

CdrReader::CdrReader(std::string_view message) {
  if (message.size() < kCdrHead)
    throw InvalidArgument(fmt::format("it has {} bytes; a message of CDR has at least {}", message.size(), kCdrHead));
  const int kind = static_cast<unsigned char>(message[0]) << 8 | static_cast<unsigned char>(message[1]);
  if (kind != 0 && kind != 1) {
    throw InvalidArgument(fmt::format(
        "its encoding is {:#06x}; accepted: plain CDR, 0x0000 (big endian) and 0x0001 (little endian)", kind));
  }
  big_endian_ = kind == 0;
  bytes_ = message.substr(kCdrHead);
}

std::uint64_t CdrReader::Whole(std::size_t size) {
  const std::size_t from = at_ + PaddingBefore(at_, size);
  if (from + size > bytes_.size())
    throw InvalidArgument(fmt::format("it is cut off at byte {}", kCdrHead + bytes_.size()));
  at_ = from + size;
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < size; ++i) {
    const std::size_t place = big_endian_ ? from + i : from + size - 1 - i;
    value = value << 8U | static_cast<unsigned char>(bytes_[place]);
  }
  return value;
}

double CdrReader::Number() { return std::bit_cast<double>(Whole(8)); }

std::size_t CdrReader::Length(std::size_t least) {
  const std::size_t length = Uint32();
  if (length > (bytes_.size() - at_) / least) {
    throw InvalidArgument(
        fmt::format("the list of {} elements at byte {} is longer than the message", length, kCdrHead + at_ - 4));
  }
  return length;
}

std::string CdrReader::Text() {
  const std::size_t length = Length(1);  // with the zero at its end
  const std::string_view text = bytes_.substr(at_, length);
  at_ += length;
  if (!text.empty() && text.back() != '\0')
    throw InvalidArgument(fmt::format("the text at byte {} does not end with a zero", kCdrHead + at_ - length));
  return RecordedText(text.substr(0, text.empty() ? 0 : text.size() - 1));
}

std::vector<double> CdrReader::Numbers() {
  std::vector<double> numbers(Length(8));
  for (double& number : numbers) number = Number();
  return numbers;
}

std::vector<std::string> CdrReader::Texts() {
  std::vector<std::string> texts(Length(4));
  for (std::string& text : texts) text = Text();
  return texts;
}

void CdrReader::Skip(std::size_t numbers) {
  for (std::size_t i = 0; i < numbers; ++i) Number();
}

void CdrWriter::Whole(std::uint64_t value, std::size_t size) {
  bytes_.append(PaddingBefore(bytes_.size() - kCdrHead, size), '\0');
  for (std::size_t i = 0; i < size; ++i) bytes_ += static_cast<char>(value >> 8U * i & 0xffU);
}

void CdrWriter::Number(double value) { Whole(std::bit_cast<std::uint64_t>(value), 8); }

void CdrWriter::Text(std::string_view text) {
  Uint32(static_cast<std::uint32_t>(text.size() + 1));
  bytes_ += text;
  bytes_ += '\0';
}

void CdrWriter::Texts(const std::vector<std::string>& texts) {
  Uint32(static_cast<std::uint32_t>(texts.size()));
  for (const std::string& text : texts) Text(text);
}

void CdrWriter::Numbers(const double* numbers, std::size_t count) {
  Uint32(static_cast<std::uint32_t>(count));
  for (std::size_t i = 0; i < count; ++i) Number(numbers[i]);
}

}  // namespace gaitwright
