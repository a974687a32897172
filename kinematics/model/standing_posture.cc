// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/standing_posture.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <set>

#include "kinematics/model/build_model.h"
#include "kinematics/model/find_feet.h"
#include "kinematics/model/hang_limbs.h"
#include "kinematics/spatial/rotation.h"

namespace gaitwright {
namespace {

constexpr double kCrouchedShare = 0.62;  // hip to foot over straight leg, for legs without a sole
constexpr double kUprightShare = 0.92;   // hip to ankle over straight, for legs with a sole

double Clamped(const RobotModel& model, int dof, double value) {
  return std::clamp(value, model.dof_lower(dof), std::max(model.dof_lower(dof), model.dof_upper(dof)));
}

/// Difference of a foot from where it is wanted: position, and rotation when it has a sole.
VectorX FootError(const RobotModel& model, const Foot& foot, const VectorX& joints, const Pose& wanted) {
  const Pose X_OF = BodyPoses(model, joints)[static_cast<std::size_t>(foot.body)] * foot.X_BF;
  VectorX error = VectorX::Zero(foot.sole_F.empty() ? 3 : 6);
  error.head<3>() = wanted.translation() - X_OF.translation();
  if (!foot.sole_F.empty()) error.tail<3>() = 0.2 * RotationLog(wanted.linear() * X_OF.linear().transpose());
  return error;
}

/// Damped least squares on the leg's coordinates, by differences: run once for a model, so speed does not matter.
void MoveFoot(const RobotModel& model, const Leg& leg, const Pose& wanted, VectorX& joints) {
  const Foot& foot = model.feet[static_cast<std::size_t>(leg.foot)];
  std::set<int> unique;
  for (const int joint : leg.joints) unique.insert(model.joints[static_cast<std::size_t>(joint)].dof);
  const std::vector<int> dofs(unique.begin(), unique.end());
  const auto n = static_cast<Eigen::Index>(dofs.size());
  for (int iteration = 0; iteration < 200; ++iteration) {
    const VectorX error = FootError(model, foot, joints, wanted);
    if (error.norm() < 1e-12) return;
    MatrixX J(error.size(), n);
    for (Eigen::Index c = 0; c < n; ++c) {
      constexpr double kStep = 1e-7;
      VectorX moved = joints;
      moved[dofs[static_cast<std::size_t>(c)]] += kStep;
      J.col(c) = (error - FootError(model, foot, moved, wanted)) / kStep;
    }
    const MatrixX normal = J.transpose() * J + 1e-9 * MatrixX::Identity(n, n);
    const VectorX step = normal.ldlt().solve(J.transpose() * error);
    const double scale = std::min(1.0, 0.2 / std::max(step.cwiseAbs().maxCoeff(), 1e-12));
    for (Eigen::Index c = 0; c < n; ++c) {
      const int dof = dofs[static_cast<std::size_t>(c)];
      joints[dof] = Clamped(model, dof, joints[dof] + scale * step[c]);
    }
  }
}

/// Bends hip, knee and ankle of a leg and brings the foot under its hip.
void BendLeg(const RobotModel& model, const Leg& leg, VectorX& joints) {
  const Foot& foot = model.feet[static_cast<std::size_t>(leg.foot)];
  const std::vector<int> pitch = PitchJoints(model, leg);
  const std::vector<Pose> zero = BodyPoses(model, VectorX::Zero(model.num_dofs()));
  const bool has_sole = !foot.sole_F.empty();
  const Pose X_OF = zero[static_cast<std::size_t>(foot.body)] * foot.X_BF;
  Pose wanted = Pose::Identity();
  wanted.translation() = X_OF.translation();
  if (pitch.size() >= 2) {
    const double share = has_sole ? kUprightShare : kCrouchedShare;
    const Vector3 hip = zero[static_cast<std::size_t>(pitch.front() + 1)].translation();
    const double ankle_height =
        has_sole ? std::abs((zero[static_cast<std::size_t>(foot.body)].linear() * foot.X_BF.translation()).z())
                 : foot.radius;
    const double straight = leg.length_m - ankle_height;
    wanted.translation().z() = hip.z() - share * straight - (has_sole ? ankle_height : 0.0);
    if (!has_sole) wanted.translation().x() = hip.x();
    const double bend = std::acos(share);
    const double signs[] = {-1.0, 2.0, -1.0};
    const double knee_axis = (zero[static_cast<std::size_t>(pitch[1] + 1)].linear() *
                              model.joints[static_cast<std::size_t>(pitch[1])].axis_J)
                                 .y();
    for (std::size_t i = 0; i < pitch.size() && i < 3; ++i) {
      const Joint& joint = model.joints[static_cast<std::size_t>(pitch[i])];
      const double axis = (zero[static_cast<std::size_t>(pitch[i] + 1)].linear() * joint.axis_J).y();
      const double angle = signs[i] * bend * leg.knee_sign * (axis * knee_axis > 0.0 ? 1.0 : -1.0);
      joints[joint.dof] = Clamped(model, joint.dof, angle);
    }
  }
  MoveFoot(model, leg, wanted, joints);
}

}  // namespace

void DeriveStanding(RobotModel& model, const VectorX& given) {
  VectorX joints(model.num_dofs());
  for (int dof = 0; dof < model.num_dofs(); ++dof) joints[dof] = Clamped(model, dof, 0.0);
  for (const Leg& leg : model.legs) BendLeg(model, leg, joints);
  for (int dof = 0; dof < model.num_dofs(); ++dof) {
    if (std::isfinite(given[dof])) joints[dof] = given[dof];
  }
  const std::vector<std::string> hung = HangLimbs(model, given, joints);
  model.notes.insert(model.notes.end(), hung.begin(), hung.end());
  model.standing_joints = joints;
  const std::vector<Pose> X_OB = BodyPoses(model, joints);
  double lowest = 1e9;
  for (Foot& foot : model.feet) {
    const Pose& X_OE = X_OB[static_cast<std::size_t>(foot.body)];
    if (foot.sole_F.empty()) foot.X_BF.linear() = X_OE.linear().transpose();
    lowest = std::min(lowest, (X_OE * foot.X_BF).translation().z() - foot.radius);
  }
  model.standing_base_height_m = -lowest;
  const double froude_speed = std::sqrt(kGravity * model.leg_length_m());
  const bool soles = std::any_of(model.feet.begin(), model.feet.end(), [](const Foot& f) { return !f.sole_F.empty(); });
  model.nominal_speed_m_s = (soles ? 0.04 : 0.15) * froude_speed;
}

}  // namespace gaitwright
