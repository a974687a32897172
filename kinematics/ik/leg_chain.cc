// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/ik/leg_chain.h"

#include <fmt/format.h>

#include <algorithm>

#include "kinematics/base/result.h"

namespace gaitwright {
namespace {

const Leg& LegOf(const RobotModel& model, int leg) {
  if (leg < 0 || leg >= static_cast<int>(model.legs.size())) {
    throw InvalidArgument(
        fmt::format("leg {}: robot '{}' has legs 0 to {}", leg, model.name, static_cast<int>(model.legs.size()) - 1));
  }
  return model.legs[static_cast<std::size_t>(leg)];
}

bool Uses(const RobotModel& model, const Leg& leg, int dof) {
  return std::any_of(leg.joints.begin(), leg.joints.end(),
                     [&](int joint) { return model.joints[static_cast<std::size_t>(joint)].dof == dof; });
}

/// Multiplies X by the motion of one joint.
void Advance(const LegChain::Link& link, double position, Pose& X) {
  if (!link.turns) {
    X.translation() += X.linear() * (position * link.axis_B);
    return;
  }
  const Matrix3 R = Eigen::AngleAxisd(position, link.axis_B).toRotationMatrix();
  X.translation() += X.linear() * (link.point_B - R * link.point_B);
  X.linear() = (X.linear() * R).eval();
}

}  // namespace

LegChain::LegChain(const RobotModel& model, int leg) {
  const Leg& chain = LegOf(model, leg);
  const Foot& foot = model.feet[static_cast<std::size_t>(chain.foot)];
  foot_name = foot.name;
  AddLinks(model, chain);
  X_BF_zero = X_BF_zero * foot.X_BF;
  length_m = std::max(chain.length_m, 1e-3);
  const auto n = static_cast<Eigen::Index>(dofs.size());
  lower.resize(n);
  upper.resize(n);
  standing.resize(n);
  for (Eigen::Index c = 0; c < n; ++c) {
    const int dof = dofs[static_cast<std::size_t>(c)];
    lower[c] = model.dof_lower(dof);
    upper[c] = model.dof_upper(dof);
    standing[c] = model.standing_joints[dof];
    for (std::size_t other = 0; other < model.legs.size(); ++other) {
      if (static_cast<int>(other) == leg || !Uses(model, model.legs[other], dof)) continue;
      shared_dofs.push_back(dof);
      break;
    }
  }
  ChooseRows(foot);
}

void LegChain::AddLinks(const RobotModel& model, const Leg& leg) {
  for (const int j : leg.joints) {
    const Joint& joint = model.joints[static_cast<std::size_t>(j)];
    X_BF_zero = X_BF_zero * joint.X_PJ;
    auto at = std::find(dofs.begin(), dofs.end(), joint.dof);
    if (at == dofs.end()) at = dofs.insert(dofs.end(), joint.dof);
    links.push_back({joint.name, X_BF_zero.linear() * joint.axis_J, X_BF_zero.translation(), !joint.is_prismatic(),
                     static_cast<int>(at - dofs.begin()), joint.multiplier, joint.offset});
  }
}

void LegChain::ChooseRows(const Foot& foot) {
  // For a sole, level has priority over heading. A line has no ankle joint to roll it.
  const std::array<int, 6> sole = {0, 1, 2, 4, 3, 5}, line = {0, 1, 2, 4, 5, 3};
  rows = foot.type == FootType::kLine ? line : sole;
  num_rows = foot.has_sole() ? std::clamp(num_coordinates(), 3, 6) : 3;
}

bool LegChain::IsPlain() const {
  return dofs.size() == links.size() &&
         std::all_of(links.begin(), links.end(), [](const Link& link) { return link.turns && link.multiplier != 0.0; });
}

Pose LegChain::FootPose(const VectorX& coordinates) const {
  Pose X = Pose::Identity();
  for (const Link& link : links) Advance(link, link.multiplier * coordinates[link.coordinate] + link.offset, X);
  return X * X_BF_zero;
}

Pose LegChain::FootPose(const VectorX& coordinates, Jacobian& screws, Jacobian& J) const {
  Pose X = Pose::Identity();
  for (std::size_t i = 0; i < links.size(); ++i) {
    const Link& link = links[i];
    const auto column = static_cast<Eigen::Index>(i);
    screws.col(column) << X * link.point_B, X.linear() * link.axis_B;
    Advance(link, link.multiplier * coordinates[link.coordinate] + link.offset, X);
  }
  X = X * X_BF_zero;
  J.setZero();
  for (std::size_t i = 0; i < links.size(); ++i) {
    const Vector6 screw = screws.col(static_cast<Eigen::Index>(i));
    const Vector3 axis = links[i].multiplier * screw.tail<3>();
    auto column = J.col(links[i].coordinate);
    if (!links[i].turns) {
      column.head<3>() += axis;
      continue;
    }
    column.head<3>() += axis.cross(X.translation() - screw.head<3>());
    column.tail<3>() += X.linear().transpose() * axis;
  }
  return X;
}

}  // namespace gaitwright
