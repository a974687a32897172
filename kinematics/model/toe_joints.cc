// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/toe_joints.h"

#include <tinyxml2.h>

#include <algorithm>
#include <cmath>

#include "kinematics/model/body_tree.h"
#include "kinematics/model/derive_legs.h"
#include "kinematics/model/flat_bottom.h"
#include "kinematics/spatial/convex_hull.h"

namespace gaitwright {
namespace {

constexpr std::size_t kJointsWithToe = 6;  // joints of a limb with a toe; a leg with a sole has five or more

/// The flat bottom of a body at joint positions zero, as a sole; an empty sole if it has no flat bottom.
Foot BottomOf(const RobotModel& model, const std::vector<Pose>& X_OB, int body) {
  std::vector<const Shape*> shapes;
  for (const Shape& shape : model.collision_shapes) {
    if (shape.body == body) shapes.push_back(&shape);
  }
  Foot bottom;
  bottom.body = body;
  if (!FindFlatBottom(X_OB[static_cast<std::size_t>(body)], shapes, std::nullopt, bottom)) bottom.sole_F.clear();
  return bottom;
}

bool IsToe(const RobotModel& model, const std::vector<Pose>& X_OB, int joint) {
  constexpr double kSameLevel = 3e-3, kLevelAxis = 0.3;  // [m], sine to the horizontal
  constexpr double kSmallestHeel = 0.25;                 // share of the toe's area
  const Joint& toe = model.joints[static_cast<std::size_t>(joint)];
  const auto follows = [&](const Joint& other) { return &other != &toe && other.is_mimic && other.dof == toe.dof; };
  if (toe.is_mimic || toe.is_prismatic() || std::any_of(model.joints.begin(), model.joints.end(), follows))
    return false;
  const Vector3 axis = X_OB[static_cast<std::size_t>(joint) + 1].linear() * toe.axis_J;
  if (std::abs(axis.z()) > kLevelAxis) return false;
  const Foot heel = BottomOf(model, X_OB, toe.parent_body), end = BottomOf(model, X_OB, joint + 1);
  if (heel.sole_F.empty() || end.sole_F.empty() || Area(heel.sole_F) < kSmallestHeel * Area(end.sole_F)) return false;
  const auto level = [&](const Foot& foot) {
    return (X_OB[static_cast<std::size_t>(foot.body)] * foot.X_BF).translation().z();
  };
  return std::abs(level(heel) - level(end)) <= kSameLevel;
}

}  // namespace

std::vector<std::string> ToeJoints(const RobotModel& model) {
  const std::vector<Pose> X_OB = BodyPoses(model, VectorX::Zero(model.num_dofs()));
  std::vector<std::string> toes;
  for (const int end : EndBodies(model)) {
    if (ChainTo(model, end).size() >= kJointsWithToe && IsToe(model, X_OB, end - 1))
      toes.push_back(model.joints[static_cast<std::size_t>(end) - 1].name);
  }
  return toes;
}

std::string WithFixedJoints(const std::string& urdf_text, const std::vector<std::string>& joints) {
  tinyxml2::XMLDocument document;
  document.Parse(urdf_text.c_str(), urdf_text.size());
  tinyxml2::XMLElement& robot = *document.RootElement();
  for (auto* j = robot.FirstChildElement("joint"); j != nullptr; j = j->NextSiblingElement("joint")) {
    if (std::find(joints.begin(), joints.end(), j->Attribute("name")) != joints.end()) j->SetAttribute("type", "fixed");
  }
  tinyxml2::XMLPrinter printer;
  document.Print(&printer);
  return printer.CStr();
}

}  // namespace gaitwright
