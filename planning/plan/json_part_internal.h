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

/// A part of a JSON text and the way to it, such as `footholds[3].pose`, for reading strictly: whatever is not as it
/// must be throws InvalidArgument with that way, what stands there and what is accepted.
class JsonPart {
 public:
  using Json = nlohmann::ordered_json;

  /// The whole of a text. `json` must outlive this and all parts of it.
  explicit JsonPart(const Json& json) : json_(&json) {}

  /// An object that has each of `required` and nothing else but `optional`; an unknown key is refused with the nearest.
  const JsonPart& Object(const std::vector<std::string>& required, const std::vector<std::string>& optional = {}) const;
  /// The same of an object's shape.
  const JsonPart& Object(const DataShape& shape) const { return Object(shape.NeededKeys(), shape.OtherKeys()); }
  JsonPart At(const std::string& key) const;
  bool Has(const std::string& key) const { return json_->contains(key); }
  const Json& json() const { return *json_; }

  /// The members of a list.
  std::vector<JsonPart> List() const;

  /// At most kLargestNumber up or down.
  double Number() const;
  double NumberFrom(double lowest) const;
  double NumberIn(double lowest, double highest) const;
  int Whole(int lowest, int highest) const;
  std::uint64_t Natural() const;
  std::string Text() const;
  bool Truth() const;
  /// @return the index of the text among the choices.
  int Choice(const std::vector<std::string>& choices) const;

  std::vector<double> Numbers() const;
  /// A list of exactly `count` numbers.
  VectorX Vector(std::size_t count) const;
  /// [x, y, z, qx, qy, qz, qw], the quaternion of unit length to 1e-6.
  Pose ToPose() const;

  /// @throws InvalidArgument "'way' <what>".
  [[noreturn]] void Refuse(const std::string& what) const;

 private:
  JsonPart(const Json& json, std::string way) : json_(&json), way_(std::move(way)) {}
  [[noreturn]] void NeedsA(const char* kind) const;

  const Json* json_;
  std::string way_;
};

/// Bounds of what is read as JSON: of the text [byte], of values, of keys of one object, of lists and objects in one
/// another.
inline constexpr std::size_t kLargestJson = std::size_t{512} << 20, kMostJsonValues = 20000000, kMostJsonKeys = 5000,
                             kDeepestJson = 64;

/// Largest that a number of a plan or a log may be, in whatever unit it has.
inline constexpr double kLargestNumber = 1e12;

/// The text as JSON. @throws Json::exception for what is none, InvalidArgument for a key that stands twice and for what
/// is beyond the bounds.
JsonPart::Json ParseJsonOnce(const std::string& text);

/// Why a text is no JSON: cut short, or broken where, or with a number that is none.
std::string WhyNoJson(const std::string& text);

}  // namespace gaitwright
