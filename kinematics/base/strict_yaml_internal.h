// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <yaml-cpp/yaml.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "kinematics/base/data_shape.h"

namespace gaitwright {

/// Bounds of what is read as YAML: of the text [byte], of values with those that aliases repeat, of lists and maps in
/// one another, and of one text or word in it [byte].
inline constexpr std::size_t kLargestYaml = std::size_t{16} << 20, kMostYamlValues = 1000000, kDeepestYaml = 32,
                             kLongestYamlText = 65536;

/// How much of it is read, where more than the usual is to be: about 600 bytes of memory for each value.
struct YamlBounds {
  std::size_t bytes = kLargestYaml, values = kMostYamlValues;
};

/// The one document of a text; null for an empty one. @throws YAML::Exception for what is no YAML, InvalidArgument
/// `line N: message` for a second document, an alias of what it stands in, and what is beyond the bounds.
YAML::Node LoadYaml(const std::string& text, const YamlBounds& bounds = {});

/// Throws InvalidArgument: `line N: message`.
[[noreturn]] void RefuseYaml(const YAML::Node& node, const std::string& message);

int LineOf(const YAML::Node& node);

/// The kind of a value, for people.
const char* KindOf(const YAML::Node& node);

/// Text, a finite number, a list. Each refuses another kind of value, naming `what`.
std::string TextOf(const YAML::Node& node, const std::string& what);
double NumberOf(const YAML::Node& node, const std::string& what);
/// One from `low` to `high`.
double NumberOf(const YAML::Node& node, const std::string& what, double low, double high);
/// One that the shape accepts.
double NumberOf(const YAML::Node& node, const std::string& what, const DataShape& shape);
std::vector<YAML::Node> ListOf(const YAML::Node& node, const std::string& what);

/// A map of keys to values, each key once. Refuses another kind of value, a key that stands there twice, and unless
/// `known` is empty a key that is not in it, with the nearest that is.
class YamlMap {
 public:
  struct Entry {
    std::string key;
    YAML::Node key_node, value;
  };

  YamlMap(const YAML::Node& node, const std::string& what, const std::vector<std::string>& known = {});
  /// The keys of an object's shape, of which those that are needed must be there. `shape` outlives the map.
  YamlMap(const YAML::Node& node, const std::string& what, const DataShape& shape);

  const std::vector<Entry>& entries() const { return entries_; }
  /// Refuses the map where it lacks one of these.
  void Require(const std::vector<std::string>& needed) const;
  /// The value, or null where the key is not there.
  const YAML::Node* Find(const std::string& key) const;

  std::string Text(const std::string& key) const;  ///< "" where it is not there
  std::optional<double> Number(const std::string& key) const;
  /// A number over zero.
  std::optional<double> Positive(const std::string& key) const;
  /// A number that the map's shape accepts under that key.
  std::optional<double> InRange(const std::string& key) const;

 private:
  YAML::Node node_;
  std::string what_;
  const DataShape* shape_ = nullptr;
  std::vector<Entry> entries_;
};

}  // namespace gaitwright
