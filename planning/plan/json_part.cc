// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <set>
#include <utility>

#include "kinematics/base/nearest_name.h"
#include "kinematics/base/options.h"
#include "kinematics/base/result.h"
#include "kinematics/base/text.h"
#include "planning/plan/json_part_internal.h"

namespace gaitwright {
namespace {

using Json = JsonPart::Json;

/// Short description of a value.
std::string Described(const Json& json) {
  if (json.is_object()) return "an object";
  if (json.is_array()) return fmt::format("a list of {}", json.size());
  if (json.is_null()) return "null";
  if (json.is_boolean()) return json.get<bool>() ? "true" : "false";
  if (!json.is_string()) return json.dump();
  constexpr std::size_t kLongest = 30;
  const auto& text = json.get_ref<const std::string&>();
  return "'" + (text.size() > kLongest ? FirstBytes(text, kLongest) + "..." : text) + "'";
}

/// Finds the last key before a syntax error, and the position of the error.
struct BreakFinder : nlohmann::json_sax<Json> {
  bool null() override { return true; }
  bool boolean(bool /*value*/) override { return true; }
  bool number_integer(number_integer_t /*value*/) override { return true; }
  bool number_unsigned(number_unsigned_t /*value*/) override { return true; }
  bool number_float(number_float_t /*value*/, const string_t& /*text*/) override { return true; }
  bool string(string_t& /*value*/) override { return true; }
  bool binary(binary_t& /*value*/) override { return true; }
  bool start_object(std::size_t /*size*/) override { return true; }
  bool key(string_t& value) override {
    last_key = value;
    return true;
  }
  bool end_object() override { return true; }
  bool start_array(std::size_t /*size*/) override { return true; }
  bool end_array() override { return true; }
  bool parse_error(std::size_t position, const std::string& /*token*/, const Json::exception& /*error*/) override {
    byte = position;
    return false;
  }

  std::string last_key;
  std::size_t byte = 0;  ///< counted from 1
};

/// Checks JSON while it is parsed. @throws InvalidArgument for a duplicate key and for JSON beyond the limits.
class BoundsWatch {
 public:
  void See(Json::parse_event_t event, const Json& parsed) {
    switch (event) {
      case Json::parse_event_t::object_start:
      case Json::parse_event_t::array_start:
        Count();
        if (open_.size() >= kDeepestJson)
          throw InvalidArgument(
              fmt::format("its lists and objects are nested more than {} levels deep, the maximum", kDeepestJson));
        open_.emplace_back();
        break;
      case Json::parse_event_t::object_end:
      case Json::parse_event_t::array_end:
        open_.pop_back();
        break;
      case Json::parse_event_t::key:
        SeeKey(parsed.get_ref<const std::string&>());
        break;
      default:
        Count();
    }
  }

 private:
  void Count() {
    if (++values_ > kMostJsonValues)
      throw InvalidArgument(fmt::format("it has more than {} values, the maximum", kMostJsonValues));
  }
  void SeeKey(const std::string& key) {
    std::set<std::string>& keys = open_.back();
    if (!keys.insert(key).second) throw InvalidArgument(fmt::format("the key '{}' appears twice in one object", key));
    if (keys.size() > kMostJsonKeys)
      throw InvalidArgument(fmt::format("an object has more than {} keys, the maximum", kMostJsonKeys));
  }

  std::vector<std::set<std::string>> open_;  // the keys of the open objects; empty sets for open lists
  std::size_t values_ = 0;
};

/// The run of letters, digits, signs and points around a position.
std::string WordAt(const std::string& text, std::size_t at) {
  const auto belongs = [&](std::size_t i) {
    return std::isalnum(static_cast<unsigned char>(text[i])) != 0 || text[i] == '-' || text[i] == '+' || text[i] == '.';
  };
  std::size_t first = at, last = at;
  while (first > 0 && belongs(first - 1)) --first;
  while (last < text.size() && belongs(last)) ++last;
  return text.substr(first, last - first);
}

bool IsNoFiniteNumber(std::string word) {
  word = LowerCase(std::move(word));
  if (!word.empty() && (word[0] == '-' || word[0] == '+')) word.erase(0, 1);
  if (word == "nan" || word == "inf" || word == "infinity") return true;
  // A number that overflows, such as 1e999.
  return !word.empty() &&
         std::all_of(word.begin(), word.end(),
                     [](char c) {
                       return std::isdigit(static_cast<unsigned char>(c)) != 0 || c == 'e' || c == '+' || c == '-' ||
                              c == '.';
                     }) &&
         std::isdigit(static_cast<unsigned char>(word[0])) != 0 && !std::isfinite(std::strtod(word.c_str(), nullptr));
}

}  // namespace

void JsonPart::Refuse(const std::string& what) const {
  throw InvalidArgument(path_.empty() ? "it " + what : fmt::format("'{}' {}", path_, what));
}

void JsonPart::NeedsA(const char* kind) const { Refuse(fmt::format("is {}; {} is needed", Described(*json_), kind)); }

const JsonPart& JsonPart::Object(const std::vector<std::string>& required,
                                 const std::vector<std::string>& optional) const {
  if (!json_->is_object()) NeedsA("an object");
  std::vector<std::string> known = required;
  known.insert(known.end(), optional.begin(), optional.end());
  for (const auto& [key, value] : json_->items()) {
    if (std::find(known.begin(), known.end(), key) == known.end())
      Refuse(fmt::format("has an unknown key '{}'{}", key, NearestOrAll(key, known)));
  }
  for (const std::string& key : required) {
    if (!json_->contains(key)) Refuse(fmt::format("lacks '{}'", key));
  }
  return *this;
}

JsonPart JsonPart::At(const std::string& key) const {
  if (!json_->is_object()) NeedsA("an object");
  if (!json_->contains(key)) Refuse(fmt::format("lacks '{}'", key));
  return {json_->at(key), path_.empty() ? key : path_ + "." + key};
}

std::vector<JsonPart> JsonPart::List() const {
  if (!json_->is_array()) NeedsA("a list");
  std::vector<JsonPart> parts;
  for (std::size_t i = 0; i < json_->size(); ++i)
    parts.push_back(JsonPart((*json_)[i], fmt::format("{}[{}]", path_, i)));
  return parts;
}

double JsonPart::Number() const {
  if (!json_->is_number()) NeedsA("a number");
  const double number = json_->get<double>();
  if (!(std::abs(number) <= kLargestNumber))
    Refuse(fmt::format("is {}; at most +-{} is accepted", number, kLargestNumber));
  return number;
}

double JsonPart::NumberIn(double lowest, double highest) const {
  const double number = Number();
  if (!(number >= lowest && number <= highest))
    Refuse(fmt::format("is {}; accepted: {} to {}", number, lowest, highest));
  return number;
}

double JsonPart::NumberFrom(double lowest) const {
  const double number = Number();
  if (!(number >= lowest)) Refuse(fmt::format("is {}; it must be at least {}", number, lowest));
  return number;
}

int JsonPart::Whole(int lowest, int highest) const {
  if (!json_->is_number_integer()) NeedsA("a whole number");
  const double value = json_->get<double>();
  if (value < lowest || value > highest)
    Refuse(fmt::format("is {}; accepted: {} to {}", json_->dump(), lowest, highest));
  return json_->get<int>();
}

std::uint64_t JsonPart::Natural() const {
  if (!json_->is_number_unsigned()) NeedsA("a whole number, 0 or more,");
  return json_->get<std::uint64_t>();
}

bool JsonPart::Truth() const {
  if (!json_->is_boolean()) Refuse("is neither true nor false");
  return json_->get<bool>();
}

std::string JsonPart::Text() const {
  if (!json_->is_string()) NeedsA("a text");
  std::string text = json_->get<std::string>();
  if (text.find('\0') != std::string::npos) Refuse("contains a byte 0x00");
  return text;
}

int JsonPart::Choice(const std::vector<std::string>& choices) const {
  const auto found = std::find(choices.begin(), choices.end(), Text());
  if (found == choices.end()) Refuse(fmt::format("is {}; accepted: {}", Described(*json_), QuotedList(choices)));
  return static_cast<int>(found - choices.begin());
}

std::vector<double> JsonPart::Numbers() const {
  if (!json_->is_array()) NeedsA("a list of numbers");
  std::vector<double> numbers;
  numbers.reserve(json_->size());
  for (std::size_t i = 0; i < json_->size(); ++i) {
    const Json& member = (*json_)[i];
    const double number = member.is_number() ? member.get<double>() : kLargestNumber * 2.0;
    numbers.push_back(std::abs(number) <= kLargestNumber ? number
                                                         : JsonPart(member, fmt::format("{}[{}]", path_, i)).Number());
  }
  return numbers;
}

VectorX JsonPart::Vector(std::size_t count) const {
  const std::vector<double> numbers = Numbers();
  if (numbers.size() != count) Refuse(fmt::format("has {} numbers; {} are needed", numbers.size(), count));
  return Eigen::Map<const VectorX>(numbers.data(), static_cast<Eigen::Index>(count));
}

Pose JsonPart::ToPose() const {
  constexpr double kUnit = 1e-6;
  const VectorX v = Vector(7);
  const double length = v.tail<4>().norm();
  if (!(std::abs(length - 1.0) <= kUnit))
    Refuse(fmt::format("has a quaternion of length {:.6g}; it must be 1", length));
  Pose X = Pose::Identity();
  X.translation() = v.head<3>();
  X.linear() = Quaternion(v[6], v[3], v[4], v[5]).normalized().toRotationMatrix();
  return X;
}

Json ParseJsonOnce(const std::string& text) {
  if (text.size() > kLargestJson)
    throw InvalidArgument(fmt::format("it has {} bytes; at most {} are read", text.size(), kLargestJson));
  BoundsWatch watch;
  return Json::parse(text, [&watch](int, Json::parse_event_t event, Json& parsed) {
    watch.See(event, parsed);
    return true;
  });
}

std::string ReasonNoJson(const std::string& text) {
  if (text.empty()) return "it is empty";
  BreakFinder finder;
  if (Json::sax_parse(text, &finder)) return "it is not JSON";
  const std::string place = finder.last_key.empty() ? "" : fmt::format(", after the key '{}'", finder.last_key);
  if (finder.byte > text.size()) return fmt::format("its JSON is cut short at byte {}{}", text.size(), place);
  const std::string word = WordAt(text, finder.byte - 1);
  if (IsNoFiniteNumber(word))
    return fmt::format("'{}' contains {} (byte {}); every number must be finite", finder.last_key, word, finder.byte);
  return fmt::format("its JSON has a syntax error at byte {}{}", finder.byte, place);
}

}  // namespace gaitwright
