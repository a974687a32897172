// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "kinematics/spatial/pose.h"

namespace gaitwright {

/// The attributes of an element; its default class supplies missing ones. Each function throws a Failure for an invalid
/// value, with file, line, element and value.
class MjcfAttributes {
 public:
  using Values = std::map<std::string, std::string>;

  /// @param owner  file, line and element, for messages.
  MjcfAttributes(std::string owner, Values values) : owner_(std::move(owner)), values_(std::move(values)) {}

  const std::string& owner() const { return owner_; }
  bool Has(const std::string& key) const { return values_.contains(key); }

  /// The unchanged text; "" for a missing attribute.
  std::string Text(const std::string& key) const;
  /// A name or path: plain text of one line and at most 500 bytes; "" for a missing attribute.
  std::string Name(const std::string& key) const;
  /// `least` to `most` finite numbers; empty for a missing attribute.
  std::vector<double> Numbers(const std::string& key, std::size_t least, std::size_t most) const;
  double Number(const std::string& key, double fallback) const;
  Vector3 Three(const std::string& key, const Vector3& fallback) const;
  /// One of the choices; `fallback` for a missing attribute.
  std::string Choice(const std::string& key, const std::vector<std::string>& choices,
                     const std::string& fallback) const;
  bool Flag(const std::string& key, bool fallback) const;

  /// Whether a range is active. `flag` decides; without `flag`, a range other than "0 0" is active.
  /// @param autolimits  setting of the compiler; if false, a range without `flag` is not active.
  bool IsLimited(const std::string& flag, const std::string& range, bool autolimits) const;

 private:
  std::string owner_;
  Values values_;
};

/// Replaces attributes of a class by those of an element. If the element gives fewer numbers, for example of `size` or
/// `gear`, the other numbers of the class stay. An orientation replaces an orientation of another kind.
void MergeMjcfValues(MjcfAttributes::Values& values, const MjcfAttributes::Values& over);

}  // namespace gaitwright
