// SPDX-License-Identifier: BSD-3-Clause
#include "tests/fuzz/mutate.h"

#include <algorithm>
#include <array>

namespace gaitwright::fuzz {
namespace {

constexpr std::array kNumbers = {"0",
                                 "-1",
                                 "1",
                                 "-0.0",
                                 "1e-320",
                                 "1e308",
                                 "-1e308",
                                 "1e999",
                                 "nan",
                                 "-inf",
                                 "1e12",
                                 "1e-9",
                                 "65",
                                 "64",
                                 "4294967296",
                                 "2147483648",
                                 "-2147483649",
                                 "99999999999999999999",
                                 "0x10",
                                 "1e",
                                 "",
                                 "1.7976931348623157e308",
                                 "3.14",
                                 "1000000"};
constexpr std::array kNests = {"[", "{", "(", "<a>", "- ", "{\"a\":", "[[", "  ", "&a [*a", "/*"};

bool IsOfNumber(char c) { return (c >= '0' && c <= '9') || c == '.' || c == '-' || c == '+' || c == 'e'; }
bool IsOfWord(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || (c >= '0' && c <= '9'); }

/// The run of characters of a kind around or after a place: first and length; length 0 if there is none.
template <class Kind>
std::pair<std::size_t, std::size_t> RunAt(const std::string& input, std::size_t at, Kind kind) {
  while (at < input.size() && !kind(input[at])) ++at;
  std::size_t first = at, last = at;
  while (first > 0 && kind(input[first - 1])) --first;
  while (last < input.size() && kind(input[last])) ++last;
  return {first, last - first};
}

}  // namespace

std::string Mutator::Mutate(std::string input, const std::string& other, std::size_t most) {
  const std::size_t changes = 1 + Below(4);
  for (std::size_t i = 0; i < changes; ++i) Change(input, other);
  if (input.size() > most) input.resize(most);
  return input;
}

std::string Mutator::Piece(const std::string& of) {
  const std::size_t at = Below(of.size());
  return of.substr(at, 1 + Below(std::min<std::size_t>(of.size(), 200)));
}

void Mutator::ReplaceNumber(std::string& input) {
  const auto [first, length] = RunAt(input, Below(input.size()), IsOfNumber);
  input.replace(first, length, kNumbers[Below(kNumbers.size())]);
}

void Mutator::ReplaceWord(std::string& input) {
  const auto [first, length] = RunAt(input, Below(input.size()), IsOfWord);
  input.replace(first, length, words_.empty() ? Piece(input) : words_[Below(words_.size())]);
}

void Mutator::SwapLines(std::string& input) {
  const auto line = [&](std::size_t at) {
    const std::size_t before = input.rfind('\n', at), after = input.find('\n', at);
    const std::size_t first = before == std::string::npos ? 0 : before + 1;
    return std::pair(first, (after == std::string::npos ? input.size() : after + 1) - std::min(first, input.size()));
  };
  const auto [first, length] = line(Below(input.size()));
  const std::string moved = input.substr(std::min(first, input.size()), length);
  input.erase(std::min(first, input.size()), length);
  input.insert(line(Below(input.size())).first, moved);
}

void Mutator::Nest(std::string& input) {
  const std::string opening = kNests[Below(kNests.size())];
  std::string many;
  for (std::size_t count = std::size_t{1} << Below(12); count > 0; --count) many += opening;
  input.insert(Below(input.size() + 1), many);
}

void Mutator::Change(std::string& input, const std::string& other) {
  const std::size_t at = Below(input.size() + 1);
  switch (Below(12)) {
    case 0:
    case 1:
    case 2:
      return ReplaceNumber(input);
    case 3:
      return ReplaceWord(input);
    case 4:
      if (!words_.empty()) input.insert(at, words_[Below(words_.size())]);
      return;
    case 5:
      input.erase(at, 1 + Below(Below(4) == 0 ? input.size() : 20));
      return;
    case 6: {
      const std::string piece = Piece(input);
      for (std::size_t count = std::size_t{1} << Below(6); count > 0; --count) input.insert(at, piece);
      return;
    }
    case 7:
      return SwapLines(input);
    case 8:
      input.insert(at, Piece(other));
      return;
    case 9:
      if (Below(8) == 0) return Nest(input);
      input.resize(at);
      return;
    default:
      if (at < input.size()) input[at] = static_cast<char>(Below(256));
  }
}

}  // namespace gaitwright::fuzz
