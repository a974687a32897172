// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/check_feet.h"

#include <fmt/format.h>

#include "kinematics/model/body_tree.h"
#include "kinematics/model/yaml_line.h"

namespace gaitwright {
namespace {

Failure Refused(const FootOverride& foot, const std::string& message) {
  return {FailureKind::kBadInput,
          "robot_feet",
          "LoadRobot",
          AtYamlLine(foot.line, message),
          {"'gaitwright robots show' of the URDF alone lists the feet that it finds"}};
}

}  // namespace

std::optional<Failure> CheckNamedFeet(const RobotModel& model, const std::vector<FootOverride>& feet,
                                      const std::vector<int>& ends) {
  for (std::size_t i = 0; i < feet.size(); ++i) {
    const std::string& link = feet[i].link;
    if (ends[i] == 0) {
      return Refused(feet[i],
                     fmt::format("foot '{}' is on the base, with no joint between; a foot is at the end of a chain of "
                                 "at least one moving joint",
                                 link));
    }
    for (std::size_t j = 0; j < i; ++j) {
      const std::string& other = feet[j].link;
      if (link == other) return Refused(feet[i], fmt::format("foot '{}' is listed twice; list each foot once", link));
      if (ends[i] == ends[j]) {
        return Refused(feet[i], fmt::format("feet '{}' and '{}' are on one body; name one of them", other, link));
      }
      const bool before = Carries(model, ends[i], ends[j]);
      if (!before && !Carries(model, ends[j], ends[i])) continue;
      return Refused(feet[i],
                     fmt::format("foot '{}' is on the way to foot '{}': one leg cannot have two feet; name the last",
                                 before ? link : other, before ? other : link));
    }
  }
  return std::nullopt;
}

}  // namespace gaitwright
