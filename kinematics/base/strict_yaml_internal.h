// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <yaml-cpp/yaml.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "kinematics/base/data_shape.h"

namespace gaitwright {

/// Limits of a YAML text: size [byte], number of values including those repeated by aliases, depth of nested lists and
/// maps, and size of one text or word [byte].
inline constexpr std::size_t kLargestYaml = std::size_t{16} << 20, kMostYamlValues = 1000000, kDeepestYaml = 32,
                             kLongestYamlText = 65536;

/// Limits for files that may be larger than usual. Each value needs about 600 bytes of memory.
struct YamlBounds {
  std::size_t bytes = kLargestYaml, values = kMostYamlValues;
};

/// The only document of a text; null for an empty text. @throws YAML::Exception for invalid YAML, InvalidArgument
/// `line N: message` for a second document, an alias to a node that contains it, and a text beyond the limits.
YAML::Node LoadYaml(const std::string& text, const YamlBounds& bounds = {});

/// Throws InvalidArgument: `line N: message`.
[[noreturn]] void RefuseYaml(const YAML::Node& node, const std::string& message);

int LineOf(const YAML::Node& node);

/// The kind of a value, for messages.
const char* KindOf(const YAML::Node& node);

/// A text, a finite number, a list. Each function refuses other kinds of values; the message names `what`.
std::string TextOf(const YAML::Node& node, const std::string& what);
double NumberOf(const YAML::Node& node, const std::string& what);
/// A number from `low` to `high`.
double NumberOf(const YAML::Node& node, const std::string& what, double low, double high);
/// A number that the shape accepts.
double NumberOf(const YAML::Node& node, const std::string& what, const DataShape& shape);
std::vector<YAML::Node> ListOf(const YAML::Node& node, const std::string& what);

/// A map of keys to values, each key once. Refuses other kinds of values, duplicate keys and, unless `known` is empty,
/// unknown keys, with the nearest known key.
class YamlMap {
 public:
  struct Entry {
    std::string key;
    YAML::Node key_node, value;
  };

  YamlMap(const YAML::Node& node, const std::string& what, const std::vector<std::string>& known = {});
  /// Accepts the keys of an object's shape and requires its required keys. `shape` must outlive the map.
  YamlMap(const YAML::Node& node, const std::string& what, const DataShape& shape);

  const std::vector<Entry>& entries() const { return entries_; }
  /// Refuses the map if one of these keys is missing.
  void Require(const std::vector<std::string>& needed) const;
  /// The value of a key, or null if the key is missing.
  const YAML::Node* Find(const std::string& key) const;

  std::string Text(const std::string& key) const;  ///< "" if the key is missing
  std::optional<double> Number(const std::string& key) const;
  /// A number above zero.
  std::optional<double> Positive(const std::string& key) const;
  /// A number that the map's shape accepts for this key.
  std::optional<double> InRange(const std::string& key) const;

 private:
  YAML::Node node_;
  std::string what_;
  const DataShape* shape_ = nullptr;
  std::vector<Entry> entries_;
};

}  // namespace gaitwright
