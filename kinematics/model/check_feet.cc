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
          {"run 'gaitwright robots show' on the URDF alone to list the feet that it finds"}};
}

/// Whether the link of a foot whose shapes are missing marks the contact point. Many files have such a link: it has no
/// shape, it is the lowest link of its body in the standing posture, and it is below the last joint.
bool IsContactFrame(const RobotModel& model, const Foot& foot, const std::vector<MissingMesh>& missing) {
  constexpr double kDown = 0.7;  // cosine to straight down, from the last joint
  const std::vector<Pose> X_OB = BodyPoses(model, model.standing_joints);
  const Pose& X_OE = X_OB[static_cast<std::size_t>(foot.body)];
  const auto below = [&](const Frame& frame) { return -(X_OE.linear() * frame.X_BF.translation()).z(); };
  const Frame& own = model.frames[static_cast<std::size_t>(model.FrameIndex(foot.link))];
  if (below(own) <= 0.0 || below(own) < kDown * own.X_BF.translation().norm()) return false;
  const auto has_shape = [&](const std::string& link) {
    const auto of_link = [&](const auto& part) { return part.link == link; };
    return std::any_of(missing.begin(), missing.end(), of_link) ||
           std::any_of(model.visual_shapes.begin(), model.visual_shapes.end(), of_link);
  };
  return !has_shape(own.name) && std::none_of(model.frames.begin(), model.frames.end(), [&](const Frame& other) {
    return other.body == foot.body && below(other) > below(own);
  });
}

/// Whether a link is farther from the last joint than the foot's link, so that its missing shape would be the foot.
bool EndsBeyond(const RobotModel& model, const std::string& link, const Foot& foot) {
  constexpr double kBeyond = 1e-3;  // [m]
  const auto distance = [&](const std::string& name) {
    return model.frames[static_cast<std::size_t>(model.FrameIndex(name))].X_BF.translation().norm();
  };
  return link != foot.link && distance(link) > distance(foot.link) + kBeyond;
}

}  // namespace

std::optional<Failure> CheckNamedFeet(const RobotModel& model, const std::vector<FootOverride>& feet,
                                      const std::vector<int>& ends) {
  for (std::size_t i = 0; i < feet.size(); ++i) {
    const std::string& link = feet[i].link;
    if (ends[i] == 0) {
      return Refused(
          feet[i],
          fmt::format(
              "foot '{}' is fixed to the base; a foot must be at the end of a chain of at least one moving joint",
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
      return Refused(
          feet[i],
          fmt::format("foot '{}' is on the chain to foot '{}'; one leg cannot have two feet; name only the last one",
                      before ? link : other, before ? other : link));
    }
  }
  return std::nullopt;
}

std::optional<Failure> CheckFeetAreKnown(RobotModel& model, const std::vector<FootOverride>& given,
                                         const std::vector<MissingMesh>& missing) {
  constexpr std::size_t kSoleJoints = 5;  // a leg with so many joints has a sole; a point does not describe it
  const auto body_of = [&](const std::string& link) {
    return model.frames[static_cast<std::size_t>(model.FrameIndex(link))].body;
  };
  for (const Foot& foot : model.feet) {
    const auto gone = std::find_if(missing.begin(), missing.end(),
                                   [&](const MissingMesh& mesh) { return body_of(mesh.link) == foot.body; });
    const bool is_seen = std::any_of(model.collision_shapes.begin(), model.collision_shapes.end(),
                                     [&](const Shape& shape) { return shape.body == foot.body; });
    const bool is_reported = std::any_of(given.begin(), given.end(), [&](const FootOverride& f) {
      return f.link == foot.link && (f.type || f.radius_m > 0.0 || !f.sole_m.empty());
    });
    if (gone == missing.end() || is_reported) continue;
    if (is_seen) {
      if (EndsBeyond(model, gone->link, foot)) {
        model.findings.push_back({FindingLevel::kWarning, FailureCode::kMissingMesh,
                                  RobotPart{PartKind::kLink, gone->link}, 0,
                                  fmt::format("{}: it ends a leg, and the foot was derived from the shape of link '{}' "
                                              "instead; set the foot in robot.yaml (feet)",
                                              gone->why, foot.link)});
      }
      continue;
    }
    const auto leg = std::find_if(model.legs.begin(), model.legs.end(),
                                  [&](const Leg& l) { return &model.feet[static_cast<std::size_t>(l.foot)] == &foot; });
    if (leg != model.legs.end() && leg->joints.size() < kSoleJoints && IsContactFrame(model, foot, missing)) {
      model.findings.push_back(
          {FindingLevel::kWarning, FailureCode::kMissingMesh, RobotPart{PartKind::kLink, gone->link}, 0,
           fmt::format("{}: it ends a leg, and the origin of link '{}', which is fixed to it, is used as a point foot; "
                       "set its radius in robot.yaml: feet: [{{link: '{}', radius_m: R}}, ...]",
                       gone->why, foot.link, foot.link)});
      continue;
    }
    std::string feet;
    for (const Foot& f : model.feet)
      feet += fmt::format("{}{{link: {}, radius_m: R}}", feet.empty() ? "" : ", ", f.link);
    return Failure{
        FailureKind::kBadInput,
        FailureCode::kUnknownFoot,
        "LoadRobot",
        fmt::format("link '{}': its collision shape cannot be loaded: {}; it ends a leg, and nothing else describes "
                    "the foot's contact",
                    gone->link, gone->why),
        {"add the mesh as an .stl, .obj or .dae file",
         fmt::format("describe the foot in robot.yaml: feet: [{}], with R in m; for a sole, give its corners: 'sole_m'",
                     feet)},
        {},
        RobotPart{PartKind::kLink, gone->link}};
  }
  return std::nullopt;
}

}  // namespace gaitwright
