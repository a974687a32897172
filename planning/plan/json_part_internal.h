// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "kinematics/base/data_shape.h"
#include "kinematics/spatial/pose.h"

namespace gaitwright {

/// The value as a JSON number, or null if it is missing or not finite.
inline nlohmann::ordered_json JsonOrNull(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? nlohmann::ordered_json(*value) : nlohmann::ordered_json(nullptr);
}

/// A part of a JSON text and its path, such as `footholds[3].pose`, for strict reading. Every error throws
/// InvalidArgument with the path, the value found and what is accepted.
class JsonPart {
 public:
  using Json = nlohmann::ordered_json;

  /// The whole JSON text. `json` must outlive this part and all parts of it.
  explicit JsonPart(const Json& json) : json_(&json) {}

  /// An object with all of `required` and no other keys than `optional`. The error for an unknown key names the nearest
  /// known key.
  const JsonPart& Object(const std::vector<std::string>& required, const std::vector<std::string>& optional = {}) const;
  /// An object with the keys of a shape.
  const JsonPart& Object(const DataShape& shape) const { return Object(shape.NeededKeys(), shape.OtherKeys()); }
  JsonPart At(const std::string& key) const;
  bool Has(const std::string& key) const { return json_->contains(key); }
  const Json& json() const { return *json_; }

  /// The members of a list.
  std::vector<JsonPart> List() const;

  /// A number with |x| <= kLargestNumber.
  double Number() const;
  double NumberFrom(double lowest) const;
  double NumberIn(double lowest, double highest) const;
  int Whole(int lowest, int highest) const;
  std::uint64_t Natural() const;
  std::string Text() const;
  bool Truth() const;
  /// @return index of the text in `choices`.
  int Choice(const std::vector<std::string>& choices) const;

  std::vector<double> Numbers() const;
  /// A list of exactly `count` numbers.
  VectorX Vector(std::size_t count) const;
  /// [x, y, z, qx, qy, qz, qw]; the quaternion has unit length to 1e-6.
  Pose ToPose() const;

  /// @throws InvalidArgument with the text "'<path>' <what>".
  [[noreturn]] void Refuse(const std::string& what) const;

 private:
  JsonPart(const Json& json, std::string path) : json_(&json), path_(std::move(path)) {}
  [[noreturn]] void NeedsA(const char* kind) const;

  const Json* json_;
  std::string path_;
};

/// Limits of JSON input: size of the text [byte], number of values, keys of one object, nesting depth of lists and
/// objects.
inline constexpr std::size_t kLargestJson = std::size_t{512} << 20, kMostJsonValues = 20000000, kMostJsonKeys = 5000,
                             kDeepestJson = 64;

/// Largest absolute value of a number in a plan or a log, in any unit.
inline constexpr double kLargestNumber = 1e12;

/// Parses JSON. @throws Json::exception for invalid JSON; InvalidArgument for a duplicate key and for JSON beyond the
/// limits.
JsonPart::Json ParseJsonOnce(const std::string& text);

/// Reason why a text is not JSON: it is cut short, has a syntax error, or contains a number that is not finite.
std::string ReasonNoJson(const std::string& text);

}  // namespace gaitwright
