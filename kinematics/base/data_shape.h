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
  double lowest = -std::numeric_limits<double>::infinity();  ///< of a number
  double highest = std::numeric_limits<double>::infinity();
  bool over_lowest = false;                         ///< the lowest value itself is excluded
  std::vector<std::string> choices = {};            ///< of a text; empty for any
  std::vector<ShapeMember> members;                 ///< of an object, whose keys are known
  std::vector<DataShape> of;                        ///< one: of each value of a map, whose keys are not, or of a list
  std::size_t least = 0, most = std::string::npos;  ///< how many there are in a list or a map
  std::vector<DataShape> or_else;                   ///< accepted too
  bool or_null = false;                             ///< null is accepted too
  std::vector<std::vector<std::string>> one_of;     ///< of an object: of each list exactly one key is needed

  /// Keys of an object: all, those that are needed, and the others.
  std::vector<std::string> Keys() const;
  std::vector<std::string> NeededKeys() const;
  std::vector<std::string> OtherKeys() const;
  /// The member of that key. @throws InvalidArgument if it does not exist.
  const DataShape& At(const std::string& key) const;
};

/// A key of an object.
struct ShapeMember {
  std::string key;
  DataShape shape;
  std::string meaning = "";
  bool needed = true;
};

/// Short names for writing shapes down.
namespace shapes {
/// Any value; a truth value; a text, optionally one of several; a number, optionally within a range.
DataShape Anything();
DataShape Truth();
DataShape Text(std::vector<std::string> choices = {});
DataShape Number();
DataShape Number(double lowest, double highest);
/// Over zero, and up to `highest`.
DataShape Positive(double highest = std::numeric_limits<double>::infinity());
/// From `lowest` to `highest`.
DataShape Whole(double lowest = 0.0, double highest = std::numeric_limits<double>::infinity());
DataShape List(DataShape of, std::size_t least = 0, std::size_t most = std::string::npos);
/// So many numbers, or any number of them.
DataShape Numbers(std::size_t count);
DataShape Numbers();
DataShape MapOf(DataShape of, std::size_t least = 0);
DataShape Object(std::vector<ShapeMember> members, std::vector<std::vector<std::string>> one_of = {});
DataShape OrNull(DataShape shape);
DataShape NumberOrNull();
DataShape Either(DataShape shape, DataShape other);

/// An option's field as a key that may be left out, with its range and meaning.
ShapeMember Field(const OptionField& field);

/// A key that may be left out.
ShapeMember Optional(std::string key, DataShape shape, std::string meaning = "");

}  // namespace shapes

/// The JSON schema (draft 2020-12) of a shape; deterministic to the byte.
std::string SchemaOf(const DataShape& shape, const std::string& title, const std::string& description);

}  // namespace gaitwright
