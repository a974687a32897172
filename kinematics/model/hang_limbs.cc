// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/hang_limbs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "kinematics/model/body_tree.h"

namespace gaitwright {
namespace {

constexpr double kAside = 0.4;       // [rad]
constexpr double kHeavy = 1e-3;      // of weight times leg length: what a joint has to lower to matter
constexpr double kUpsideDown = 2.0;  // [rad] farther than this, a part stands rather than hangs
constexpr double kStraight = 0.5;    // the axis's part along x that makes a joint turn a limb aside

/// Sum of mass times position of all that a joint carries, in the base frame [kg m].
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

/// A revolute joint of its own, in no leg and not given.
bool CanHang(const RobotModel& model, int joint, const VectorX& given) {
  const Joint& j = model.joints[static_cast<std::size_t>(joint)];
  if (j.is_prismatic() || j.is_mimic || std::isfinite(given[j.dof])) return false;
  return std::none_of(model.legs.begin(), model.legs.end(),
                      [&](const Leg& leg) { return std::count(leg.joints.begin(), leg.joints.end(), joint) > 0; });
}

/// Moves a joint to where its load hangs lowest. False where it stays.
bool Hang(const RobotModel& model, int joint, VectorX& joints) {
  // Heights turn with the angle as a + b cos + c sin.
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

/// Turns a limb outwards by the first of its joints that can. @return that joint, or -1.
int TurnAside(const RobotModel& model, int limb, const VectorX& given, VectorX& joints) {
  const double side = CarriedMoment(model, limb, joints).y() > 0.0 ? 1.0 : -1.0;
  for (int j = limb; j < static_cast<int>(model.joints.size()); ++j) {
    if (!CanHang(model, j, given) || !Carries(model, limb + 1, j + 1)) continue;
    const Joint& joint = model.joints[static_cast<std::size_t>(j)];
    const double along = (BodyPoses(model, joints)[static_cast<std::size_t>(j) + 1].linear() * joint.axis_J).x();
    const double angle = joints[joint.dof] + side * (along > 0.0 ? kAside : -kAside);
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
  std::vector<int> limbs;  // their first joints
  for (int j = 0; j < static_cast<int>(model.joints.size()); ++j) {
    if (!CanHang(model, j, given) || !Hang(model, j, joints)) continue;
    const bool beyond =
        std::any_of(limbs.begin(), limbs.end(), [&](int limb) { return Carries(model, limb + 1, j + 1); });
    if (!beyond) limbs.push_back(j);
  }
  for (const int limb : limbs) {
    const int aside = TurnAside(model, limb, given, joints);
    done.push_back(fmt::format("the limb beyond joint '{}' hangs{}", model.joints[static_cast<std::size_t>(limb)].name,
                               aside < 0 ? ""
                                         : fmt::format(", {} rad away from the body by '{}'", kAside,
                                                       model.joints[static_cast<std::size_t>(aside)].name)));
  }
  return done;
}

}  // namespace gaitwright
