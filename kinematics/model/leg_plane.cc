// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/leg_plane.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "kinematics/model/body_tree.h"
#include "kinematics/spatial/rotation.h"

namespace gaitwright {
namespace {

constexpr double kAlike = 0.9;       // cosine of 25 degrees
constexpr double kLevelSine = 0.43;  // sine of 25 degrees
constexpr double kNothing = 0.01;    // share of the leg below which a distance counts as zero
constexpr double kNoBend = 0.1;      // [rad] limits favour neither side if their middle is within half of this

/// Joint axes, origins and the foot of a leg at joint positions zero.
struct ZeroPose {
  ZeroPose(const RobotModel& model, const Leg& leg, const Foot& foot) {
    const std::vector<Pose> X_OB = BodyPoses(model, VectorX::Zero(model.num_dofs()));
    for (const int joint : leg.joints) {
      const auto j = static_cast<std::size_t>(joint);
      axis_O.push_back(X_OB[j + 1].linear() * model.joints[j].axis_J);
      p_OJ.push_back(X_OB[j + 1].translation());
    }
    p_OF = (X_OB[static_cast<std::size_t>(foot.body)] * foot.X_BF).translation();
  }
  std::vector<Vector3> axis_O, p_OJ;
  Vector3 p_OF;
};

Vector3 Level(const Vector3& v) { return {v.x(), v.y(), 0.0}; }

bool Turns(const RobotModel& model, int joint) { return !model.joints[static_cast<std::size_t>(joint)].is_prismatic(); }

/// Indices into leg.joints of the joints that can bend the leg.
std::vector<std::size_t> LevelJoints(const RobotModel& model, const Leg& leg, const Foot& foot, const ZeroPose& zero) {
  const double size = std::max((zero.p_OF - zero.p_OJ.front()).norm(), 1e-9);
  std::vector<std::size_t> level;
  for (std::size_t i = 0; i < leg.joints.size(); ++i) {
    const double lever = zero.axis_O[i].cross(zero.p_OF - zero.p_OJ[i]).norm();
    const bool spins = foot.sole_F.empty() && i + 1 == leg.joints.size() && lever < kNothing * size;
    if (Turns(model, leg.joints[i]) && std::abs(zero.axis_O[i].z()) < kLevelSine && !spins) level.push_back(i);
  }
  return level;
}

std::vector<std::size_t> LargestGroup(const std::vector<std::size_t>& level, const ZeroPose& zero) {
  std::vector<std::size_t> best;
  const auto across = [&](const auto& group) { return std::abs(zero.axis_O[group.front()].y()); };
  for (const std::size_t first : level) {
    std::vector<std::size_t> group;
    for (const std::size_t i : level) {
      if (i >= first && std::abs(zero.axis_O[i].dot(zero.axis_O[first])) > kAlike) group.push_back(i);
    }
    const bool more = group.size() > best.size();
    if (more || (group.size() == best.size() && across(group) > across(best) + 1e-9)) best = group;
  }
  return best;
}

/// Length of a straight leg in its plane: the distances between the axes of its bending joints, plus the distance from
/// the last one to the foot (for a sole the height of the ankle). An offset between joints across the plane does not
/// make the leg longer. Nothing for legs with prismatic joints, without a knee, or with a sole but without an ankle.
std::optional<double> LengthInPlane(const RobotModel& model, const Leg& leg, const Foot& foot, const LegPlane& plane) {
  const bool has_sole = !foot.sole_F.empty();
  const std::size_t needed = has_sole ? 3 : 2;
  const bool slides = std::any_of(leg.joints.begin(), leg.joints.end(), [&](int j) { return !Turns(model, j); });
  if (slides || plane.joints.size() < needed) return std::nullopt;
  const std::vector<Pose> X_OB = BodyPoses(model, VectorX::Zero(model.num_dofs()));
  const auto origin = [&](std::size_t i) { return X_OB[static_cast<std::size_t>(plane.joints[i]) + 1].translation(); };
  const auto across = [&](const Vector3& v) { return (v - plane.normal_O * plane.normal_O.dot(v)).norm(); };
  const std::size_t last = has_sole ? 2 : plane.joints.size() - 1;
  const Vector3 p_OF = (X_OB[static_cast<std::size_t>(foot.body)] * foot.X_BF).translation();
  const Vector3 rest = p_OF - origin(last);
  double length = has_sole ? std::abs(rest.z()) : across(rest);
  for (std::size_t i = 0; i < last; ++i) length += across(origin(i + 1) - origin(i));
  return length;
}

/// Whether all revolute joints before index `first` have upright axes, and there is at least one.
bool SwungAbout(const RobotModel& model, const Leg& leg, const ZeroPose& zero, std::size_t first, Vector3& p_OY) {
  bool upright = false;
  for (std::size_t i = 0; i < first; ++i) {
    if (!Turns(model, leg.joints[i])) continue;
    if (std::abs(zero.axis_O[i].z()) < kAlike) return false;
    upright = true;
    p_OY = zero.p_OJ[i];
  }
  return upright;
}

}  // namespace

LegPlane FindLegPlane(const RobotModel& model, const Leg& leg, const Foot& foot) {
  const ZeroPose zero(model, leg, foot);
  const std::vector<std::size_t> group = LargestGroup(LevelJoints(model, leg, foot, zero), zero);
  LegPlane plane;
  for (const std::size_t i : group) plane.joints.push_back(leg.joints[i]);
  const std::size_t first = group.empty() ? 0 : group.front();
  if (!group.empty()) plane.normal_O = Level(zero.axis_O[first]).normalized();
  const Vector3& n = plane.normal_O;
  if (std::abs(n.y()) > 1e-6 ? n.y() < 0.0 : n.x() < 0.0) plane.normal_O = -n;
  plane.outward_O = plane.normal_O.cross(Vector3::UnitZ());
  const Vector3& hip = zero.p_OJ[first];
  plane.p_OY = hip;
  plane.sprawls = !group.empty() && foot.sole_F.empty() && SwungAbout(model, leg, zero, first, plane.p_OY);
  double out = plane.outward_O.dot(zero.p_OF - plane.p_OY);
  if (std::abs(out) < kNothing * (zero.p_OF - hip).norm()) out = plane.outward_O.dot(hip);
  if (out < 0.0) plane.outward_O = -plane.outward_O;
  return plane;
}

double StraightLength(const RobotModel& model, const Leg& leg, std::size_t first, const Vector3& p_BF) {
  double length = 0.0;
  for (std::size_t i = first; i < leg.joints.size(); ++i) {
    const Joint& joint = model.joints[static_cast<std::size_t>(leg.joints[i])];
    const bool last = i + 1 == leg.joints.size();
    const Vector3 next =
        last ? p_BF : Vector3(model.joints[static_cast<std::size_t>(leg.joints[i + 1])].X_PJ.translation());
    if (joint.is_prismatic()) {
      length += std::max((joint.lower * joint.axis_J + next).norm(), (joint.upper * joint.axis_J + next).norm());
    } else {
      length += next.norm();
    }
  }
  return length;
}

double KneeBend(const RobotModel& model, const Leg& leg, const Foot& foot, const VectorX& joints) {
  const std::vector<int> bending = FindLegPlane(model, leg, foot).joints;
  if (bending.size() < 2) return 0.0;
  const std::vector<Pose> X_OB = BodyPoses(model, joints);
  const auto pose = [&](std::size_t i) -> const Pose& { return X_OB[static_cast<std::size_t>(bending[i]) + 1]; };
  const Vector3 axis = pose(1).linear() * model.joints[static_cast<std::size_t>(bending[1])].axis_J;
  const Vector3 end = bending.size() > 2 ? Vector3(pose(2).translation())
                                         : (X_OB[static_cast<std::size_t>(foot.body)] * foot.X_BF).translation();
  const Vector3 thigh = pose(1).translation() - pose(0).translation(), shank = end - pose(1).translation();
  return std::atan2(axis.dot(thigh.cross(shank)), thigh.dot(shank) - axis.dot(thigh) * axis.dot(shank));
}

void MeasureLeg(const RobotModel& model, Leg& leg, const Foot& foot) {
  const LegPlane plane = FindLegPlane(model, leg, foot);
  leg.hip_joint = plane.joints.empty() ? leg.joints.front() : plane.joints.front();
  const auto first =
      static_cast<std::size_t>(std::find(leg.joints.begin(), leg.joints.end(), leg.hip_joint) - leg.joints.begin());
  const VectorX zeros = VectorX::Zero(model.num_dofs());
  const std::vector<Pose> X_OB = BodyPoses(model, zeros);
  Vector3 p_BF = foot.X_BF.translation();
  if (!foot.sole_F.empty()) {  // only the height of the ankle counts
    const Matrix3& R_OE = X_OB[static_cast<std::size_t>(foot.body)].linear();
    p_BF = R_OE.transpose() * Vector3(0.0, 0.0, (R_OE * p_BF).z());
  }
  const std::optional<double> in_plane = LengthInPlane(model, leg, foot, plane);
  leg.length_m = in_plane.value_or(StraightLength(model, leg, first, p_BF)) + foot.radius;
  if (plane.joints.size() < 2) return;
  leg.knee_joint = plane.joints[1];
  const Joint& knee = model.joints[static_cast<std::size_t>(leg.knee_joint)];
  const Vector3 axis_O = X_OB[static_cast<std::size_t>(leg.knee_joint) + 1].linear() * knee.axis_J;
  const double middle = 0.5 * (knee.lower + knee.upper);  // without limits, the bend at zero decides
  double side = WrapAngle(KneeBend(model, leg, foot, zeros) + (std::isfinite(middle) ? middle : 0.0));
  if (std::abs(side) <= 0.5 * kNoBend) {
    // The limits favour neither side. The knee of a sprawling leg bends upward, that of a leg without a sole backward,
    // and that of a leg with a sole forward.
    const double back = -axis_O.dot(plane.normal_O);
    side = plane.sprawls ? -axis_O.cross(plane.outward_O).z() : foot.sole_F.empty() ? back : -back;
  }
  leg.knee_sign = side > 0.0 ? 1.0 : -1.0;
}

}  // namespace gaitwright
