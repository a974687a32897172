// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/base/text.h"

#include <utf8cpp/utf8.h>

#include <algorithm>
#include <iterator>

namespace gaitwright {
namespace {

/// Nothing if the bytes are not UTF-16.
std::optional<std::string> FromUtf16(const std::string& bytes, bool little) {
  std::u16string units;
  for (std::size_t i = 2; i + 1 < bytes.size(); i += 2) {
    const auto a = static_cast<unsigned char>(bytes[i]), b = static_cast<unsigned char>(bytes[i + 1]);
    units.push_back(static_cast<char16_t>(little ? b << 8 | a : a << 8 | b));
  }
  std::string text;
  try {
    utf8::utf16to8(units.begin(), units.end(), std::back_inserter(text));
  } catch (const utf8::exception&) {
    return std::nullopt;
  }
  return text;
}

}  // namespace

std::string Trimmed(const std::string& text) {
  constexpr const char* kBlank = " \t\r\n";
  const std::size_t first = text.find_first_not_of(kBlank);
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(kBlank) - first + 1);
}

std::string LowerCase(std::string text) {
  for (char& c : text) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return text;
}

bool IsPlainText(const std::string& text) {
  const auto is_control = [](char c) {
    return (static_cast<unsigned char>(c) < 0x20 && c != '\t' && c != '\n' && c != '\r') || c == 0x7f;
  };
  return std::none_of(text.begin(), text.end(), is_control) && utf8::is_valid(text.begin(), text.end());
}

std::optional<std::string> InUtf8(const std::string& text) {
  const bool little = text.starts_with("\xFF\xFE");
  if (little || text.starts_with("\xFE\xFF")) {
    if (auto converted = FromUtf16(text, little)) return converted;
  }
  if (utf8::is_valid(text.begin(), text.end())) return std::nullopt;
  std::string mended;
  for (const char c : text)
    utf8::append(static_cast<char32_t>(static_cast<unsigned char>(c)), std::back_inserter(mended));
  return mended;
}

std::string FirstBytes(const std::string& text, std::size_t most) {
  constexpr std::size_t kMostBehindFirst = 3;  // bytes of a character
  if (text.size() <= most) return text;
  std::size_t end = most;
  while (end > 0 && most - end < kMostBehindFirst && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) --end;
  return text.substr(0, end);
}

std::string Shortened(const std::string& text) {
  constexpr std::size_t kLongest = 60;
  if (text.size() <= kLongest) return text;
  return FirstBytes(text, kLongest) + "...";
}

std::string EscapedXml(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      case '\'':
        escaped += "&#39;";
        break;
      default:
        if (static_cast<unsigned char>(c) >= 0x20 || c == '\n' || c == '\t') escaped += c;
    }
  }
  return escaped;
}

}  // namespace gaitwright
