// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/base/law.h"

#include <algorithm>
#include <ostream>

namespace gaitwright {

const std::vector<std::string>& LawNames() {
  static const std::vector<std::string> names = {
      "consistency",   "start_posture",  "joint_position", "joint_velocity", "joint_acceleration", "joint_jerk",
      "reach",         "self_collision", "foot_clearance", "body_clearance", "zmp_support",        "unilateral",
      "friction_cone", "flight",         "dynamics",       "joint_torque",   "torque_speed",       "continuous_torque"};
  return names;
}

const std::vector<Law>& AllLaws() {
  static const std::vector<Law> laws = [] {
    std::vector<Law> all;
    for (std::size_t i = 0; i < LawNames().size(); ++i) all.push_back(static_cast<Law>(i));
    return all;
  }();
  return laws;
}

const std::string& LawName(Law law) { return LawNames().at(static_cast<std::size_t>(law)); }

std::optional<Law> LawOfName(std::string_view name) {
  const auto& names = LawNames();
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) return std::nullopt;
  return static_cast<Law>(found - names.begin());
}

std::ostream& operator<<(std::ostream& out, Law law) { return out << LawName(law); }

}  // namespace gaitwright
