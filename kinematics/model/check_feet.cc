// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/check_feet.h"

#include <fmt/format.h>

#include <algorithm>

#include "kinematics/model/body_tree.h"
#include "kinematics/model/yaml_line.h"

namespace gaitwright {
namespace {

Failure Refused(const FootOverride& foot, const std::string& message) {
  return {FailureKind::kBadInput,
          FailureCode::kRobotFeet,
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

std::optional<Failure> CheckFeetAreKnown(const RobotModel& model, const std::vector<FootOverride>& given,
                                         const std::vector<MissingMesh>& missing) {
  const auto body_of = [&](const std::string& link) {
    return model.frames[static_cast<std::size_t>(model.FrameIndex(link))].body;
  };
  for (const Foot& foot : model.feet) {
    const auto gone = std::find_if(missing.begin(), missing.end(),
                                   [&](const MissingMesh& mesh) { return body_of(mesh.link) == foot.body; });
    const bool is_seen = std::any_of(model.collision_shapes.begin(), model.collision_shapes.end(),
                                     [&](const Shape& shape) { return shape.body == foot.body; });
    const bool is_told = std::any_of(given.begin(), given.end(), [&](const FootOverride& f) {
      return f.link == foot.link && (f.type || f.radius_m > 0.0 || !f.sole_m.empty());
    });
    if (gone == missing.end() || is_seen || is_told) continue;
    std::string feet;
    for (const Foot& f : model.feet)
      feet += fmt::format("{}{{link: {}, radius_m: R}}", feet.empty() ? "" : ", ", f.link);
    return Failure{
        FailureKind::kBadInput,
        FailureCode::kUnknownFoot,
        "LoadRobot",
        fmt::format("link '{}': its collision shape cannot be had: {}; it ends a leg, and nothing else tells "
                    "how that foot meets the ground",
                    gone->link, gone->why),
        {"put the mesh there",
         fmt::format("say it in robot.yaml: feet: [{}], R in m; of a foot with a sole, its corners: 'sole_m'", feet)}};
  }
  return std::nullopt;
}

}  // namespace gaitwright
