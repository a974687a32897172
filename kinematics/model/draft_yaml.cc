// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/draft_yaml.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "kinematics/model/ball_joints.h"
#include "kinematics/model/body_tree.h"
#include "kinematics/model/build_model.h"
#include "kinematics/model/lowest_reach.h"
#include "kinematics/model/mend_urdf.h"
#include "kinematics/model/urdf_check.h"
#include "kinematics/model/urdf_shapes.h"

namespace gaitwright {
namespace {

struct LimbEnd {
  std::string link, joints;
  double lowest_m = 0.0;
};

/// The link of a body that is farthest from its joint.
std::string EndLinkOf(const RobotModel& model, int body) {
  std::string link = model.bodies[static_cast<std::size_t>(body)].name;
  double farthest = -1.0;
  for (const Frame& frame : model.frames) {
    if (frame.body != body || frame.X_BF.translation().norm() <= farthest) continue;
    farthest = frame.X_BF.translation().norm();
    link = frame.name;
  }
  return link;
}

/// The ends of all limbs, the lowest first.
std::vector<LimbEnd> EndsOf(const RobotModel& model, const std::vector<std::vector<int>>& limbs) {
  std::vector<LimbEnd> ends;
  for (const std::vector<int>& chain : limbs) {
    LimbEnd end;
    end.link = EndLinkOf(model, chain.back() + 1);
    for (const int joint : chain) {
      end.joints += end.joints.empty() ? "" : ", ";
      end.joints += model.joints[static_cast<std::size_t>(joint)].name;
    }
    end.lowest_m = LowestReach(model, chain);
    ends.push_back(end);
  }
  std::stable_sort(ends.begin(), ends.end(), [](const auto& a, const auto& b) { return a.lowest_m < b.lowest_m; });
  return ends;
}

/// All chains of one joint, for a robot whose limbs have one joint each.
std::vector<std::vector<int>> LimbsOfOneJoint(const RobotModel& model) {
  std::vector<std::vector<int>> limbs;
  for (int j = 0; j < static_cast<int>(model.joints.size()); ++j) limbs.push_back({j});
  return limbs;
}

std::string Quoted(const std::string& name) {
  std::string quoted = "'";
  for (const char c : name) quoted += c == '\'' ? std::string("''") : std::string(1, c);
  return quoted + "'";
}

}  // namespace

bool WantsRobotYaml(const Failure& failure) {
  return failure.code == FailureCode::kNoLegs || failure.code == FailureCode::kManyLegs ||
         failure.code == FailureCode::kUnknownFoot;
}

std::string DraftRobotYaml(const std::string& urdf_text, const Failure& why) {
  constexpr double kAsLow = 0.6;  // share of the reach of the lowest limb
  const std::string mended = MendUrdf(urdf_text).text;
  if (CheckUrdf(mended)) return "";
  const std::string tree = WithoutBallJoints(mended);
  if (CheckUrdf(tree)) return "";
  UrdfParts parts = SplitUrdf(tree, 1.0);
  std::erase_if(parts.collision, [](const Shape& shape) { return shape.type == ShapeType::kMesh; });
  const Result<RobotModel> model = BuildModel(parts, "robot", 1.0);
  if (!model) return "";
  const std::vector<std::vector<int>> limbs = Limbs(*model);
  const std::vector<LimbEnd> ends = EndsOf(*model, limbs.empty() ? LimbsOfOneJoint(*model) : limbs);
  if (ends.empty()) return "";
  std::string text = fmt::format(
      "# A draft of robot.yaml: correct it and save it beside the URDF under that name.\n# The robot was refused: "
      "{}\n\n# The ends of all limbs, lowest first. Keep those that the robot stands on. Give a type (sole, line, "
      "sphere, point),\n# a radius_m or the corners of a sole (sole_m) if the shapes of the link do not show "
      "them.\nfeet:\n",
      why.message);
  for (const LimbEnd& end : ends) {
    const double lowest_m = ends.front().lowest_m;
    const bool foot = (end.lowest_m < 0.0 && end.lowest_m <= kAsLow * lowest_m) ||
                      (limbs.empty() && end.lowest_m == lowest_m);  // the end may have no shape
    text += fmt::format("{}- {{link: {}}}  # joints {}; lowest point at z = {:.3f} m\n", foot ? "  " : "  # ",
                        Quoted(end.link), end.joints, end.lowest_m);
  }
  if (limbs.empty())
    text +=
        "# Each limb has one joint: the robot can stand on them, but cannot walk, because a stepping foot needs at "
        "least two\n# joints.\n";
  text +=
      "\n# The axes of the root link that point forward and up, if they are not x and z:\n# ahead: x\n# up: z\n\n# "
      "Joint positions of the standing posture [rad], to replace derived ones:\n# standing: {}\n";
  return text;
}

}  // namespace gaitwright
