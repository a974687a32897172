// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <yaml-cpp/yaml.h>

#include <optional>
#include <string>
#include <vector>

namespace gaitwright {

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

  const std::vector<Entry>& entries() const { return entries_; }
  /// Refuses the map where it lacks one of these.
  void Require(const std::vector<std::string>& needed) const;
  /// The value, or null where the key is not there.
  const YAML::Node* Find(const std::string& key) const;

  std::string Text(const std::string& key) const;  ///< "" where it is not there
  std::optional<double> Number(const std::string& key) const;
  /// A number over zero.
  std::optional<double> Positive(const std::string& key) const;

 private:
  YAML::Node node_;
  std::string what_;
  std::vector<Entry> entries_;
};

}  // namespace gaitwright
