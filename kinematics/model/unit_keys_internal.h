// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fmt/format.h>

#include <optional>
#include <string>

#include "kinematics/base/strict_yaml_internal.h"

namespace gaitwright {

/// One of two keys of a joint or a motor, by its unit; notes in `turning` and `sliding` which kind was used.
struct UnitKeys {
  const YamlMap& map;
  bool turning = false, sliding = false;

  std::optional<double> Take(const std::string& of_turning, const std::string& of_sliding) {
    turning = turning || map.Find(of_turning) != nullptr;
    sliding = sliding || map.Find(of_sliding) != nullptr;
    return map.InRange(map.Find(of_turning) != nullptr ? of_turning : of_sliding);
  }
  /// @param who  such as "joint 'knee'", for the message about keys of both kinds.
  bool Sliding(const YAML::Node& node, const std::string& who) const {
    if (turning && sliding) {
      const std::string kind = who.substr(0, who.find(' '));
      RefuseYaml(node,
                 fmt::format("{} has keys of both a revolute {} and a prismatic one; use only one kind", who, kind));
    }
    return sliding;
  }
};

}  // namespace gaitwright
