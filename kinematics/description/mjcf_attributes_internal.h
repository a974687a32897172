// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "kinematics/spatial/pose.h"

namespace gaitwright {

/// What an element says, with what its default class says behind it. What cannot be read is refused: each function
/// throws a Failure that names file, line, element and value.
class MjcfAttributes {
 public:
  using Values = std::map<std::string, std::string>;

  /// @param owner  file, line and element, for messages.
  MjcfAttributes(std::string owner, Values values) : owner_(std::move(owner)), values_(std::move(values)) {}

  const std::string& owner() const { return owner_; }
  bool Has(const std::string& key) const { return values_.contains(key); }

  /// The text as it stands; "" where it is not there.
  std::string Text(const std::string& key) const;
  /// A name or path: plain text of one line and at most 500 bytes; "" where it is not there.
  std::string Name(const std::string& key) const;
  /// Finite numbers, `least` to `most` of them; none where the attribute is not there.
  std::vector<double> Numbers(const std::string& key, std::size_t least, std::size_t most) const;
  double Number(const std::string& key, double fallback) const;
  Vector3 Three(const std::string& key, const Vector3& fallback) const;
  /// One of the choices; `fallback` where it is not there.
  std::string Choice(const std::string& key, const std::vector<std::string>& choices,
                     const std::string& fallback) const;
  bool Flag(const std::string& key, bool fallback) const;

  /// Whether a range is in force: as `flag` says; without it where there is a range other than "0 0".
  /// @param autolimits  of the compiler; false: without `flag` it is not.
  bool IsLimited(const std::string& flag, const std::string& range, bool autolimits) const;

 private:
  std::string owner_;
  Values values_;
};

/// Puts an element's attributes over those of its class. Numbers that an element leaves out of `size`, `gear` and the
/// like stay; an orientation replaces another one.
void MergeMjcfValues(MjcfAttributes::Values& values, const MjcfAttributes::Values& over);

}  // namespace gaitwright
