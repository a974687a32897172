// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "kinematics/base/hash.h"
#include "kinematics/base/version.h"
#include "kinematics/dynamics/foot_contact.h"
#include "playback/policy/commanded_plan_internal.h"

namespace gaitwright {
namespace {

constexpr double kRowStep = 0.02, kLongest = 3600.0;  // [s]

/// Contact points of all feet in W.
std::vector<Vector3> SolePoints(const RobotModel& model, const VectorX& q) {
  DynamicsScratch scratch(model);
  ForwardKinematics(model, q, scratch);
  std::vector<Vector3> points;
  for (int foot = 0; foot < static_cast<int>(model.feet.size()); ++foot) {
    const std::vector<Vector3> of_foot = ContactPoints(model, scratch, foot);
    points.insert(points.end(), of_foot.begin(), of_foot.end());
  }
  return points;
}

/// Normal of the plane nearest to the points (least squares of heights); up if the points do not define a plane.
Vector3 NormalOf(const std::vector<Vector3>& points) {
  constexpr double kSpread = 1e-4;  // smallest variance of a plane's points in any direction [m^2]
  Vector3 mean = Vector3::Zero();
  for (const Vector3& p : points) mean += p / static_cast<double>(points.size());
  Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
  Vector2 rise = Vector2::Zero();
  for (const Vector3& p : points) {
    const Vector3 d = p - mean;
    spread += d.head<2>() * d.head<2>().transpose() / static_cast<double>(points.size());
    rise += d.z() * d.head<2>() / static_cast<double>(points.size());
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(spread);
  if (points.empty() || solver.eigenvalues()[0] < kSpread) return Vector3::UnitZ();
  const Vector2 slope = spread.ldlt().solve(rise);
  return Vector3(-slope.x(), -slope.y(), 1.0).normalized();
}

double LowestOf(const std::vector<Vector3>& points) {
  double lowest = points.empty() ? 0.0 : points.front().z();
  for (const Vector3& p : points) lowest = std::min(lowest, p.z());
  return lowest;
}

/// Everything that makes the policy and its commands, for the plan's hash.
std::vector<std::pair<std::string, std::string>> OptionsOf(const FittedPolicy& policy) {
  std::string rows;
  for (const TimedCommand& row : policy.commands.rows)
    rows += fmt::format("{}{} s: {} m/s, {} m/s, {} rad/s", rows.empty() ? "" : "; ", row.time_s, row.speed_m_s,
                        row.lateral_speed_m_s, row.yaw_rate_rad_s);
  std::string joints;
  for (const PolicyJoint& joint : policy.joints) joints += (joints.empty() ? "" : ", ") + joint.name;
  return {{"policy", policy.source.name},
          {"policy.hash", policy.source.hash},
          {"policy.joints", joints},
          {"policy.commands", rows}};
}

/// Moves the base in plan view for one row, at a constant command: along an arc.
void Advance(const TimedCommand& command, double time_s, PlanarPose& pose) {
  const double middle = pose.yaw_rad + 0.5 * command.yaw_rate_rad_s * time_s;
  const double turn = 0.5 * command.yaw_rate_rad_s * time_s;
  const double chord = std::abs(turn) > 1e-9 ? std::sin(turn) / turn : 1.0;
  const Vector2 step =
      chord * time_s * (Eigen::Rotation2Dd(middle) * Vector2(command.speed_m_s, command.lateral_speed_m_s));
  pose.x_m += step.x();
  pose.y_m += step.y();
  pose.yaw_rad += command.yaw_rate_rad_s * time_s;
}

}  // namespace

VectorX StartOfPolicy(const RobotModel& model, const FittedPolicy& policy) {
  constexpr double kMostTilt = 0.2;  // [rad]
  VectorX q = StandingConfiguration(model);
  for (const PolicyJoint& joint : policy.joints) q[7 + joint.dof] = joint.default_position;
  q.head<3>().setZero();
  q.segment<4>(3) << 0.0, 0.0, 0.0, 1.0;
  const Vector3 normal_B = NormalOf(SolePoints(model, q));
  const Quaternion level = Quaternion::FromTwoVectors(normal_B, Vector3::UnitZ());
  if (std::acos(std::clamp(normal_B.z(), -1.0, 1.0)) <= kMostTilt) q.segment<4>(3) = level.coeffs();
  q[2] = -LowestOf(SolePoints(model, q));
  return q;
}

double UnevenFeet(const RobotModel& model, const FittedPolicy& policy) {
  const std::vector<Vector3> points = SolePoints(model, StartOfPolicy(model, policy));
  double highest = 0.0;
  for (const Vector3& p : points) highest = std::max(highest, p.z());
  return highest;
}

MotionPlan CommandedPlan(const RobotModel& model, const FittedPolicy& policy, const Terrain& terrain,
                         double duration_s) {
  if (!(duration_s > 0.0 && duration_s <= kLongest))
    throw InvalidArgument(
        fmt::format("the duration of the policy is {} s; accepted: more than 0, up to {} s", duration_s, kLongest));
  const VectorX start = StartOfPolicy(model, policy);
  const Quaternion level(Eigen::Vector4d(start.segment<4>(3)));
  MotionPlan plan;
  plan.robot = model.name;
  plan.robot_hash = model.hash;
  plan.urdf_text = model.urdf_text;
  plan.yaml_text = model.yaml_text;
  plan.meshes = model.meshes;
  plan.provenance = {Version(), "CommandedPlan", OptionsOf(policy), 0};
  plan.terrain = terrain;
  WholeBodyTrajectory& w = plan.whole_body;
  const auto rows = static_cast<int>(std::ceil(duration_s / kRowStep - 1e-9)) + 1;
  w.step_s = duration_s / (rows - 1);
  PlanarPose pose;
  double ground_m = GroundAt(terrain, Vector2::Zero()).height_m;
  for (int k = 0; k < rows; ++k) {
    const TimedCommand& command = policy.commands.At(k * w.step_s);
    const GroundPoint below = GroundAt(terrain, Vector2(pose.x_m, pose.y_m));
    if (below.patch >= 0) ground_m = below.height_m;
    VectorX q = start, v = VectorX::Zero(model.nv());
    q.head<3>() = Vector3(pose.x_m, pose.y_m, start[2] + ground_m);
    q.segment<4>(3) = (Quaternion(Eigen::AngleAxisd(pose.yaw_rad, Vector3::UnitZ())) * level).coeffs();
    v.head<2>() = Eigen::Rotation2Dd(pose.yaw_rad) * Vector2(command.speed_m_s, command.lateral_speed_m_s);
    v[5] = command.yaw_rate_rad_s;
    w.q.push_back(std::move(q));
    w.v.push_back(std::move(v));
    w.a.emplace_back(VectorX::Zero(model.nv()));
    plan.goal = pose;
    Advance(command, w.step_s, pose);
  }
  return plan;
}

}  // namespace gaitwright
