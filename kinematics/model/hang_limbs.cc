// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/hang_limbs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "kinematics/model/body_tree.h"

namespace gaitwright {
namespace {

constexpr double kOutward = 0.4;     // [rad]
constexpr double kHeavy = 1e-3;      // share of mass times leg length; a joint with a smaller load is left at zero
constexpr double kUpsideDown = 2.0;  // [rad] a part whose lowest angle is farther than this is upright
constexpr double kStraight = 0.5;    // smallest part of an axis along x for a joint that moves a limb sideways

/// Sum of mass times position over all bodies that a joint moves, in the base frame [kg m].
Vector3 CarriedMoment(const RobotModel& model, int joint, const VectorX& joints) {
  const std::vector<Pose> X_OB = BodyPoses(model, joints);
  Vector3 moment = Vector3::Zero();
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    if (Carries(model, joint + 1, static_cast<int>(b)))
      moment += model.bodies[b].mass * (X_OB[b] * model.bodies[b].p_BC);
  }
  return moment;
}

Vector3 MomentAt(const RobotModel& model, int joint, VectorX joints, double angle) {
  joints[model.joints[static_cast<std::size_t>(joint)].dof] = angle;
  return CarriedMoment(model, joint, joints);
}

/// Whether a joint may be moved: it is revolute, mimics no other joint, is in no leg, and its position is not given.
bool CanHang(const RobotModel& model, int joint, const VectorX& given) {
  const Joint& j = model.joints[static_cast<std::size_t>(joint)];
  if (j.is_prismatic() || j.is_mimic || std::isfinite(given[j.dof])) return false;
  return std::none_of(model.legs.begin(), model.legs.end(),
                      [&](const Leg& leg) { return std::count(leg.joints.begin(), leg.joints.end(), joint) > 0; });
}

/// Moves a joint to the angle at which its load hangs lowest. False if the joint keeps its position.
bool Hang(const RobotModel& model, int joint, VectorX& joints) {
  // The moment's height is a + b cos(angle) + c sin(angle).
  const double front = MomentAt(model, joint, joints, 0.0).z();
  const double back = MomentAt(model, joint, joints, std::numbers::pi).z();
  const double side = MomentAt(model, joint, joints, 0.5 * std::numbers::pi).z();
  const double b = 0.5 * (front - back), c = side - 0.5 * (front + back);
  if (std::hypot(b, c) < kHeavy * model.total_mass_kg * model.leg_length_m()) return false;
  const double lowest = std::atan2(-c, -b);
  const int dof = model.joints[static_cast<std::size_t>(joint)].dof;
  if (std::abs(lowest) > kUpsideDown || lowest < model.dof_lower(dof) || lowest > model.dof_upper(dof)) return false;
  joints[dof] = lowest;
  return true;
}

/// Rotates a limb outward with the first of its joints that can do it. @return this joint, or -1.
int TurnOutward(const RobotModel& model, int limb, const VectorX& given, VectorX& joints) {
  const double side = CarriedMoment(model, limb, joints).y() > 0.0 ? 1.0 : -1.0;
  for (int j = limb; j < static_cast<int>(model.joints.size()); ++j) {
    if (!CanHang(model, j, given) || !Carries(model, limb + 1, j + 1)) continue;
    const Joint& joint = model.joints[static_cast<std::size_t>(j)];
    const double along = (BodyPoses(model, joints)[static_cast<std::size_t>(j) + 1].linear() * joint.axis_J).x();
    const double angle = joints[joint.dof] + side * (along > 0.0 ? kOutward : -kOutward);
    if (std::abs(along) < kStraight || angle < model.dof_lower(joint.dof) || angle > model.dof_upper(joint.dof))
      continue;
    joints[joint.dof] = angle;
    return j;
  }
  return -1;
}

}  // namespace

std::vector<std::string> HangLimbs(const RobotModel& model, const VectorX& given, VectorX& joints) {
  std::vector<std::string> done;
  if (model.legs.size() != 2) return done;
  std::vector<int> limbs;  // first joints of the limbs
  for (int j = 0; j < static_cast<int>(model.joints.size()); ++j) {
    if (!CanHang(model, j, given) || !Hang(model, j, joints)) continue;
    const bool beyond =
        std::any_of(limbs.begin(), limbs.end(), [&](int limb) { return Carries(model, limb + 1, j + 1); });
    if (!beyond) limbs.push_back(j);
  }
  for (const int limb : limbs) {
    const int outward = TurnOutward(model, limb, given, joints);
    done.push_back(fmt::format("the limb beyond joint '{}' hangs{}", model.joints[static_cast<std::size_t>(limb)].name,
                               outward < 0 ? ""
                                           : fmt::format(", rotated {} rad away from the body at joint '{}'", kOutward,
                                                         model.joints[static_cast<std::size_t>(outward)].name)));
  }
  return done;
}

}  // namespace gaitwright
