// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "kinematics/base/options.h"

namespace gaitwright {

struct ShapeMember;

/// Structure of a file or an object. The reader and the JSON schema both use it, so they have the same keys and ranges.
struct DataShape {
  enum class Kind { kAnything, kObject, kMap, kList, kNumber, kWhole, kText, kTruth };

  Kind kind = Kind::kAnything;
  double lowest = -std::numeric_limits<double>::infinity();  ///< lowest value of a number
  double highest = std::numeric_limits<double>::infinity();
  bool over_lowest = false;                         ///< the lowest value itself is excluded
  std::vector<std::string> choices = {};            ///< accepted texts; empty for any text
  std::vector<ShapeMember> members;                 ///< keys of an object
  std::vector<DataShape> of;                        ///< one element: shape of each value of a list or a map
  std::size_t least = 0, most = std::string::npos;  ///< smallest and largest size of a list or a map
  std::vector<DataShape> or_else;                   ///< other accepted shapes
  bool or_null = false;                             ///< null is accepted too
  std::vector<std::vector<std::string>> one_of;     ///< lists of keys; an object needs exactly one key of each list

  /// Keys of an object: all keys, required keys, and optional keys.
  std::vector<std::string> Keys() const;
  std::vector<std::string> NeededKeys() const;
  std::vector<std::string> OtherKeys() const;
  /// The member with this key. @throws InvalidArgument if it does not exist.
  const DataShape& At(const std::string& key) const;
};

/// A key of an object.
struct ShapeMember {
  std::string key;
  DataShape shape;
  std::string meaning = "";
  bool needed = true;
};

/// Short functions to write shapes.
namespace shapes {
/// Any value; a truth value; a text, optionally one of several; a number, optionally within a range.
DataShape Anything();
DataShape Truth();
DataShape Text(std::vector<std::string> choices = {});
DataShape Number();
DataShape Number(double lowest, double highest);
/// A number above zero, up to `highest`.
DataShape Positive(double highest = std::numeric_limits<double>::infinity());
/// A whole number from `lowest` to `highest`.
DataShape Whole(double lowest = 0.0, double highest = std::numeric_limits<double>::infinity());
DataShape List(DataShape of, std::size_t least = 0, std::size_t most = std::string::npos);
/// A list of `count` numbers, or of any length.
DataShape Numbers(std::size_t count);
DataShape Numbers();
DataShape MapOf(DataShape of, std::size_t least = 0);
DataShape Object(std::vector<ShapeMember> members, std::vector<std::vector<std::string>> one_of = {});
DataShape OrNull(DataShape shape);
DataShape NumberOrNull();
DataShape Either(DataShape shape, DataShape other);

/// An optional key for the field of an option, with its range and meaning.
ShapeMember Field(const OptionField& field);

/// An optional key.
ShapeMember Optional(std::string key, DataShape shape, std::string meaning = "");

}  // namespace shapes

/// The JSON schema (draft 2020-12) of a shape; deterministic to the byte.
std::string SchemaOf(const DataShape& shape, const std::string& title, const std::string& description);

}  // namespace gaitwright
