// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/check/check_robot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string>

#include "kinematics/check/check_parts_internal.h"
#include "kinematics/collision/collision_checker.h"
#include "kinematics/collision/shape_extent.h"
#include "kinematics/dynamics/dynamics.h"
#include "kinematics/dynamics/foot_contact.h"
#include "kinematics/model/body_tree.h"

namespace gaitwright {
namespace {

constexpr double kSunk = 0.005;  // [m] depth of a part below the ground in the standing posture

/// Sense of a leg's joint relative to that of the mirrored leg, at joint positions zero: 1 if equal positions mirror
/// each other, -1 if opposite positions do, 0 otherwise. Reflection at the plane y = 0 maps the axis (x, y, z) of a
/// revolute joint to (-x, y, -z), and that of a prismatic joint to (x, -y, z).
int MirroredSense(const RobotModel& model, const std::vector<Pose>& X_OB, int left, int right) {
  constexpr double kAlike = 0.999;
  const auto axis = [&](int j) -> Vector3 {
    return X_OB[static_cast<std::size_t>(j) + 1].linear() * model.joints[static_cast<std::size_t>(j)].axis_J;
  };
  Vector3 mirrored = axis(left);
  const bool slides = model.joints[static_cast<std::size_t>(left)].is_prismatic();
  mirrored =
      slides ? Vector3(mirrored.x(), -mirrored.y(), mirrored.z()) : Vector3(-mirrored.x(), mirrored.y(), -mirrored.z());
  const double same = mirrored.dot(axis(right));
  return same > kAlike ? 1 : same < -kAlike ? -1 : 0;
}

/// Whether the joint positions of two legs are mirror images at joint positions zero.
bool MirrorAtZero(const std::vector<Pose>& X_OB, const Leg& left, const Leg& right) {
  constexpr double kOff = 0.02;  // share of the leg's length
  for (std::size_t i = 0; i < left.joints.size(); ++i) {
    const Vector3 a = X_OB[static_cast<std::size_t>(left.joints[i]) + 1].translation();
    const Vector3 b = X_OB[static_cast<std::size_t>(right.joints[i]) + 1].translation();
    if ((a - Vector3(b.x(), -b.y(), b.z())).norm() > kOff * left.length_m) return false;
  }
  return true;
}

/// A value with its unit. @param value  infinite where the limit is not known.
std::string ValueText(double value, const char* unit) {
  return std::isfinite(value) ? fmt::format("{:.4g}{}", value, unit) : "unknown (no limit)";
}

/// A position range with its unit. @param unlimited  the text for a range that is infinite on both sides.
std::string RangeText(double lower, double upper, const char* unit, const char* unlimited) {
  if (!std::isfinite(lower) && !std::isfinite(upper)) return unlimited;
  const auto end = [](double limit) { return std::isfinite(limit) ? fmt::format("{:.4g}", limit) : "no limit"; };
  return fmt::format("{} to {} {}", end(lower), end(upper), unit);
}

/// The limit of effort or speed as the file means it: numbers that stand for an unknown one are infinite.
double KnownLimit(double limit, bool is_placeholder) {
  return is_placeholder && limit > 0.0 ? std::numeric_limits<double>::infinity() : limit;
}

/// Compares the range of a joint with that of its mirror, both ends, for legs that are mirror images at zero.
void CompareRanges(const Joint& a, const Joint& b, int sense, std::vector<Finding>& findings) {
  constexpr double kOfRange = 0.03;  // share of the range by which the stops of both sides may differ
  const double lower = sense < 0 ? -b.upper : b.lower, upper = sense < 0 ? -b.lower : b.upper;
  const double least = kOfRange * std::max(a.upper - a.lower, b.upper - b.lower);
  const auto apart = [&](double one, double other) {
    return NumbersDiffer(one, other) && !(std::abs(one - other) <= least && std::isfinite(one - other));
  };
  const bool differ =
      sense == 0 ? NumbersDiffer(a.upper - a.lower, b.upper - b.lower) : apart(a.lower, lower) || apart(a.upper, upper);
  if (!differ) return;
  const char* unit = a.is_prismatic() ? "m" : "rad";
  findings.push_back(
      {FindingLevel::kWarning, FailureCode::kSidesDiffer, RobotPart{PartKind::kJoint, a.name}, 0,
       fmt::format("its range is {}, but its mirror '{}' has {}{}", RangeText(a.lower, a.upper, unit, "unlimited"),
                   b.name, RangeText(b.lower, b.upper, unit, "no limits"),
                   sense < 0 ? ", where signs are opposite" : "")});
}

/// Compares left and right of a pair of legs that mirror each other.
void CheckPair(const RobotModel& model, const Leg& left, const Leg& right, std::vector<Finding>& findings) {
  if (left.joints.size() != right.joints.size()) {
    findings.push_back({FindingLevel::kWarning, FailureCode::kSidesDiffer, RobotPart{PartKind::kLeg, left.name}, 0,
                        fmt::format("it has {} joints, but its mirror '{}' has {}", left.joints.size(), right.name,
                                    right.joints.size())});
    return;
  }
  const std::vector<Pose> X_OB = BodyPoses(model, VectorX::Zero(model.num_dofs()));
  const bool mirror_at_zero = MirrorAtZero(X_OB, left, right);
  for (std::size_t i = 0; i < left.joints.size(); ++i) {
    const Joint& a = model.joints[static_cast<std::size_t>(left.joints[i])];
    const Joint& b = model.joints[static_cast<std::size_t>(right.joints[i])];
    const auto compare = [&](const char* what, double of_a, double of_b, const char* unit) {
      if (!NumbersDiffer(of_a, of_b)) return;
      findings.push_back({FindingLevel::kWarning, FailureCode::kSidesDiffer, RobotPart{PartKind::kJoint, a.name}, 0,
                          fmt::format("its {} is {}, but that of its mirror '{}' is {}", what, ValueText(of_a, unit),
                                      b.name, ValueText(of_b, unit))});
    };
    const bool slides = a.is_prismatic();
    compare("effort limit", KnownLimit(a.effort_limit, a.effort_limit_is_placeholder),
            KnownLimit(b.effort_limit, b.effort_limit_is_placeholder), slides ? " N" : " N m");
    compare("speed limit", KnownLimit(a.velocity_limit, a.velocity_limit_is_placeholder),
            KnownLimit(b.velocity_limit, b.velocity_limit_is_placeholder), slides ? " m/s" : " rad/s");
    CompareRanges(a, b, mirror_at_zero ? MirroredSense(model, X_OB, left.joints[i], right.joints[i]) : 0, findings);
    compare("distance from the joint before", a.X_PJ.translation().norm(), b.X_PJ.translation().norm(), " m");
    compare("link's mass", model.bodies[static_cast<std::size_t>(left.joints[i]) + 1].mass,
            model.bodies[static_cast<std::size_t>(right.joints[i]) + 1].mass, " kg");
  }
}

void CheckSides(const RobotModel& model, std::vector<Finding>& findings) {
  for (std::size_t i = 0; i < model.legs.size(); ++i) {
    const int mirror = model.legs[i].mirror;
    if (mirror > static_cast<int>(i))
      CheckPair(model, model.legs[i], model.legs[static_cast<std::size_t>(mirror)], findings);
  }
}

/// Feet are longer in front of the ankle than backward it. If this is not so for all legs, the robot may face backward.
void CheckFacing(const RobotModel& model, std::vector<Finding>& findings) {
  constexpr double kShorter = 0.7;  // share of the part backward the ankle
  DynamicsScratch scratch(model);
  ForwardKinematics(model, StandingConfiguration(model), scratch);
  double forward = 0.0, backward = 0.0;
  for (std::size_t i = 0; i < model.legs.size(); ++i) {
    const std::vector<Vector3> corners_W = ContactPoints(model, scratch, static_cast<int>(i));
    if (corners_W.size() < 3) return;
    const double ankle = scratch.p_WB[static_cast<std::size_t>(model.legs[i].joints.back()) + 1].x();
    const auto by_x = [](const Vector3& a, const Vector3& b) { return a.x() < b.x(); };
    const auto [back, front] = std::minmax_element(corners_W.begin(), corners_W.end(), by_x);
    forward = front->x() - ankle;
    backward = ankle - back->x();
    if (forward > kShorter * backward) return;
  }
  if (model.legs.empty()) return;
  findings.push_back({FindingLevel::kWarning, FailureCode::kFacesBack, RobotPart(), 0,
                      fmt::format("its feet reach {:.0f} mm in front of the ankles and {:.0f} mm behind them, as if it "
                                  "faced backward; if so, set 'ahead' and 'up' in robot.yaml",
                                  1e3 * forward, 1e3 * backward)});
}

/// Compares the mass of the robot with the cube of its leg length: an A1 has 200 kg/m^3, the lightest walking robots
/// have 25 kg/m^3.
void CheckSize(const RobotModel& model, std::vector<Finding>& findings) {
  constexpr double kLightest = 3.0, kHeaviest = 2e4;  // [kg/m^3]
  const double length = model.leg_length_m(), density = model.total_mass_kg / (length * length * length);
  if (!(length > 0.0) || (density >= kLightest && density <= kHeaviest)) return;
  findings.push_back({FindingLevel::kWarning, FailureCode::kOddSize, RobotPart(), 0,
                      fmt::format("it has {:.3g} kg and legs of {:.3g} m, too {} for its size; if the file's lengths "
                                  "are not in m, set 'scale' in robot.yaml",
                                  model.total_mass_kg, length, density < kLightest ? "light" : "heavy")});
}

void CheckStanding(const RobotModel& model, std::vector<Finding>& findings) {
  DynamicsScratch scratch(model);
  ForwardKinematics(model, StandingConfiguration(model), scratch);
  std::set<std::string> reported;
  for (const Shape& shape : model.collision_shapes) {
    if (IsShapeOfAFoot(model, shape)) continue;
    const double z = LowestPoint(scratch, shape).z();
    if (z >= -kSunk || !reported.insert(shape.link).second) continue;
    findings.push_back({FindingLevel::kWarning, FailureCode::kInTheGround, RobotPart{PartKind::kLink, shape.link}, 0,
                        fmt::format("it is {:.1f} mm below the ground in the standing posture", -1e3 * z)});
  }
  const CollisionChecker collision(model);
  for (const LeftOutPair& pair : collision.left_out()) {
    if (pair.adjacent) continue;
    findings.push_back({FindingLevel::kInfo, FailureCode::kSelfCollision, RobotPart{PartKind::kLink, pair.link_a}, 0,
                        fmt::format("contact with '{}' is not checked: {}", pair.link_b, pair.reason)});
  }
}

}  // namespace

std::vector<Finding> CheckRobot(const RobotModel& model) {
  std::vector<Finding> findings = model.findings;
  CheckBodies(model, findings);
  CheckRanges(model, findings);
  CheckMotors(model, findings);
  CheckHolding(model, findings);
  CheckSides(model, findings);
  CheckFacing(model, findings);
  CheckSize(model, findings);
  CheckStanding(model, findings);
  return findings;
}

}  // namespace gaitwright
