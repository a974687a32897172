// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/body_tree.h"

#include <algorithm>
#include <utility>

namespace gaitwright {
namespace {

/// Pose of a joint's body in the joint's frame.
Pose MovedBy(const Joint& joint, const VectorX& joints) {
  const double position = joint.multiplier * joints[joint.dof] + joint.offset;
  Pose X_JB = Pose::Identity();
  if (joint.is_prismatic()) {
    X_JB.translation() = position * joint.axis_J;
  } else {
    X_JB.linear() = Eigen::AngleAxisd(position, joint.axis_J).toRotationMatrix();
  }
  return X_JB;
}

}  // namespace

std::vector<Pose> BodyPoses(const RobotModel& model, const VectorX& joints) {
  std::vector<Pose> X_OB(model.bodies.size(), Pose::Identity());
  for (std::size_t j = 0; j < model.joints.size(); ++j) {
    const Joint& joint = model.joints[j];
    X_OB[j + 1] = X_OB[static_cast<std::size_t>(joint.parent_body)] * joint.X_PJ * MovedBy(joint, joints);
  }
  return X_OB;
}

Pose PoseAlong(const RobotModel& model, const std::vector<int>& chain, const VectorX& joints) {
  Pose X_OB = Pose::Identity();
  for (const int j : chain) {
    const Joint& joint = model.joints[static_cast<std::size_t>(j)];
    X_OB = X_OB * joint.X_PJ * MovedBy(joint, joints);
  }
  return X_OB;
}

std::vector<int> ChainTo(const RobotModel& model, int body) {
  std::vector<int> chain;
  for (int b = body; b > 0; b = model.joints[static_cast<std::size_t>(b - 1)].parent_body) chain.push_back(b - 1);
  std::reverse(chain.begin(), chain.end());
  return chain;
}

std::vector<std::vector<int>> Limbs(const RobotModel& model) {
  std::vector<bool> is_leaf(model.bodies.size(), true);
  for (const Joint& joint : model.joints) is_leaf[static_cast<std::size_t>(joint.parent_body)] = false;
  std::vector<std::vector<int>> limbs;
  for (std::size_t b = 1; b < model.bodies.size(); ++b) {
    if (!is_leaf[b]) continue;
    std::vector<int> chain = ChainTo(model, static_cast<int>(b));
    if (chain.size() >= 2) limbs.push_back(std::move(chain));
  }
  return limbs;
}

bool Carries(const RobotModel& model, int ancestor, int body) {
  while (body > ancestor) body = model.joints[static_cast<std::size_t>(body - 1)].parent_body;
  return body == ancestor;
}

std::vector<bool> BodiesOfLegs(const RobotModel& model) {
  std::vector<bool> of_leg(model.bodies.size(), false);
  for (const Leg& leg : model.legs) {
    for (const int joint : leg.joints) of_leg[static_cast<std::size_t>(joint) + 1] = true;
  }
  return of_leg;
}

std::vector<bool> DofsOfLegs(const RobotModel& model) {
  const std::vector<int> legs = LegsOfDofs(model);
  std::vector<bool> of_leg;
  for (const int leg : legs) of_leg.push_back(leg >= 0);
  return of_leg;
}

std::vector<int> LegsOfDofs(const RobotModel& model) {
  std::vector<int> legs(static_cast<std::size_t>(model.num_dofs()), -1);
  for (std::size_t leg = 0; leg < model.legs.size(); ++leg) {
    for (const int joint : model.legs[leg].joints)
      legs[static_cast<std::size_t>(model.joints[static_cast<std::size_t>(joint)].dof)] = static_cast<int>(leg);
  }
  return legs;
}

}  // namespace gaitwright
