// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <sstream>
#include <string_view>

#include "kinematics/base/options.h"
#include "kinematics/base/text.h"
#include "kinematics/description/mjcf_attributes_internal.h"
#include "kinematics/description/mjcf_document_internal.h"

namespace gaitwright {
namespace {

constexpr std::size_t kLongestMjcfName = 500;  // [byte]
constexpr double kLargestMjcfNumber = 1e9;

constexpr std::array<std::string_view, 5> kMjcfOrientations = {"quat", "axisangle", "euler", "xyaxes", "zaxis"};
constexpr std::array<std::string_view, 5> kMjcfPartial = {"size", "gear", "gainprm", "biasprm", "polycoef"};

template <class Names>
bool IsAmong(const Names& names, const std::string& key) {
  return std::find(names.begin(), names.end(), key) != names.end();
}

std::vector<std::string> MjcfWords(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

double MjcfNumber(const std::string& word, const std::string& where) {
  double value = 0.0;
  const char* begin = word.data() + (word.front() == '+' ? 1 : 0);
  const auto [end, error] = std::from_chars(begin, word.data() + word.size(), value);
  if (error != std::errc{} || end != word.data() + word.size() || !std::isfinite(value))
    RefuseMjcf(FailureCode::kMjcfNumber, fmt::format("{}: '{}' is not a finite number", where, ShownMjcf(word)));
  if (std::abs(value) > kLargestMjcfNumber)
    RefuseMjcf(FailureCode::kMjcfNumber,
               fmt::format("{}: {} is too large; at most {} is accepted", where, word, kLargestMjcfNumber));
  return value;
}

}  // namespace

std::string MjcfAttributes::Text(const std::string& key) const {
  const auto at = values_.find(key);
  return at == values_.end() ? "" : at->second;
}

std::string MjcfAttributes::Name(const std::string& key) const {
  std::string name = Text(key);
  if (name.size() > kLongestMjcfName)
    RefuseMjcf(FailureCode::kMjcfName,
               fmt::format("{}: '{}' has {} bytes; at most {} are read", owner_, key, name.size(), kLongestMjcfName));
  if (!IsPlainText(name) || name.find_first_of("\t\r\n") != std::string::npos)
    RefuseMjcf(FailureCode::kMjcfName,
               fmt::format("{}: '{}' is not valid UTF-8 or contains a control character", owner_, key));
  return name;
}

std::vector<double> MjcfAttributes::Numbers(const std::string& key, std::size_t least, std::size_t most) const {
  if (!Has(key)) return {};
  std::vector<double> numbers;
  for (const std::string& word : MjcfWords(Text(key)))
    numbers.push_back(MjcfNumber(word, fmt::format("{}: '{}'", owner_, key)));
  if (numbers.size() < least || numbers.size() > most) {
    const std::string needed = least == most ? fmt::format("{}", least) : fmt::format("{} to {}", least, most);
    RefuseMjcf(FailureCode::kMjcfNumber, fmt::format("{}: '{}' is '{}', which has {} numbers; {} are needed", owner_,
                                                     key, ShownMjcf(Text(key)), numbers.size(), needed));
  }
  return numbers;
}

double MjcfAttributes::Number(const std::string& key, double fallback) const {
  const std::vector<double> numbers = Numbers(key, 1, 1);
  return numbers.empty() ? fallback : numbers.front();
}

Vector3 MjcfAttributes::Three(const std::string& key, const Vector3& fallback) const {
  const std::vector<double> numbers = Numbers(key, 3, 3);
  return numbers.empty() ? fallback : Vector3(numbers[0], numbers[1], numbers[2]);
}

std::string MjcfAttributes::Choice(const std::string& key, const std::vector<std::string>& choices,
                                   const std::string& fallback) const {
  if (!Has(key)) return fallback;
  std::string text = Text(key);
  if (std::find(choices.begin(), choices.end(), text) == choices.end())
    RefuseMjcf(FailureCode::kMjcfChoice,
               fmt::format("{}: '{}' is '{}'; accepted: {}", owner_, key, ShownMjcf(text), QuotedList(choices)));
  return text;
}

bool MjcfAttributes::Flag(const std::string& key, bool fallback) const {
  return Choice(key, {"true", "false"}, fallback ? "true" : "false") == "true";
}

bool MjcfAttributes::IsLimited(const std::string& flag, const std::string& range, bool autolimits) const {
  const std::string said = Choice(flag, {"true", "false", "auto"}, "auto");
  if (said == "false") return false;
  const std::vector<double> ends = Numbers(range, 2, 2);
  const bool has_range = !ends.empty() && (ends[0] != 0.0 || ends[1] != 0.0);
  if (said == "auto" && !(autolimits && has_range)) return false;
  if (!has_range)
    RefuseMjcf(FailureCode::kMjcfRange, fmt::format("{}: it is limited, but '{}' is missing", owner_, range));
  if (ends[0] >= ends[1])
    RefuseMjcf(FailureCode::kMjcfRange, fmt::format("{}: the lower end {} of its '{}' is not below the upper end {}",
                                                    owner_, ends[0], range, ends[1]));
  return true;
}

void MergeMjcfValues(MjcfAttributes::Values& values, const MjcfAttributes::Values& over) {
  const bool turns =
      std::any_of(over.begin(), over.end(), [](const auto& value) { return IsAmong(kMjcfOrientations, value.first); });
  if (turns) std::erase_if(values, [](const auto& value) { return IsAmong(kMjcfOrientations, value.first); });
  for (const auto& [key, text] : over) {
    std::string& kept = values[key];
    std::string merged = text;
    if (IsAmong(kMjcfPartial, key)) {
      const std::vector<std::string> old = MjcfWords(kept);
      for (std::size_t i = MjcfWords(text).size(); i < old.size(); ++i) merged += " " + old[i];
    }
    kept = merged;
  }
}

}  // namespace gaitwright
