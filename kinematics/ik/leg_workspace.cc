// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/ik/leg_workspace.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "kinematics/dynamics/dynamics.h"
#include "kinematics/ik/damped_search.h"
#include "kinematics/spatial/rotation.h"

namespace gaitwright {
namespace {

/// The limit moved towards the standing position by `by`, at most half of the way there.
double Narrowed(double limit, double standing, double by) {
  const double way = standing - limit;
  return limit + std::copysign(std::min(by, 0.5 * std::abs(way)), way);
}

/// What inverse kinematics of one leg needs of a model, its limits narrowed.
std::shared_ptr<const RobotModel> WithReserve(const RobotModel& model, double reserve) {
  auto narrow = std::make_shared<RobotModel>(model);
  narrow->urdf_text.clear();
  narrow->yaml_text.clear();
  narrow->meshes.clear();
  narrow->collision_shapes.clear();
  narrow->visual_shapes.clear();
  for (Joint& joint : narrow->joints) {
    const double range = joint.upper - joint.lower;
    if (!std::isfinite(range)) continue;
    const double standing = joint.multiplier * model.standing_joints[joint.dof] + joint.offset;
    joint.lower = Narrowed(joint.lower, standing, reserve * range);
    joint.upper = Narrowed(joint.upper, standing, reserve * range);
  }
  return narrow;
}

double CheckedReserve(double reserve) {
  if (reserve >= 0.0 && reserve <= 0.2) return reserve;
  throw InvalidArgument(fmt::format("the reserve of a leg's workspace is {}; it must lie in [0, 0.2]", reserve));
}

std::uint64_t Mixed(std::uint64_t x) {
  x ^= x >> 33;
  x *= 0xff51afd7ed558ccdULL;
  x ^= x >> 33;
  x *= 0xc4ceb9fe1a85ec53ULL;
  return x ^ (x >> 33);
}

}  // namespace

LegWorkspace::LegWorkspace(const RobotModel& model, int leg, double reserve)
    : narrow_(WithReserve(model, CheckedReserve(reserve))), ik_(*narrow_, leg), chain_(*narrow_, leg) {
  DynamicsScratch scratch(model);
  ForwardKinematics(model, StandingConfiguration(model), scratch);
  const Leg& described = model.legs[static_cast<std::size_t>(leg)];
  const Foot& foot = model.feet[static_cast<std::size_t>(described.foot)];
  const Pose X_WB = FramePose(scratch, 0, Pose::Identity());
  X_BF_standing_ = X_WB.inverse() * FramePose(scratch, foot.body, foot.X_BF);
  const int hip = std::max(described.hip_joint, described.joints.front());
  p_BH_ = X_WB.inverse() * scratch.p_WB[static_cast<std::size_t>(hip + 1)];
  standing_.resize(static_cast<Eigen::Index>(ik_.dofs().size()));
  for (std::size_t i = 0; i < ik_.dofs().size(); ++i)
    standing_[static_cast<Eigen::Index>(i)] = model.standing_joints[ik_.dofs()[i]];
  cell_m_ = described.length_m / kCellsPerLeg;
  reserve_m_ = reserve * described.length_m;
  side_ = X_BF_standing_.translation().y() < 0.0 ? -1.0 : 1.0;
  turned_ = foot.has_sole();
  table_.resize(1U << 12U);
  const std::int64_t middle[6] = {};
  for (int halved = 0; halved < 6 && !WorkOut(middle); ++halved) reserve_m_ *= halved < 5 ? 0.5 : 0.0;
}

bool LegWorkspace::Reaches(const Pose& X_BF) {
  constexpr std::int64_t kHalf = 512;  // cells along each direction, to both sides
  const Vector3 away = (X_BF.translation() - X_BF_standing_.translation()) / cell_m_;
  std::int64_t cell[6] = {std::lround(away.x()), std::lround(side_ * away.y()), std::lround(away.z()), 0, 0, 0};
  if (turned_) {
    const Matrix3 R = X_BF.linear() * X_BF_standing_.linear().transpose();
    cell[3] = std::lround(side_ * std::atan2(R(1, 0), R(0, 0)) / kAngle);
    cell[4] = std::lround(-std::asin(std::clamp(R(2, 0), -1.0, 1.0)) / kAngle);
    cell[5] = std::lround(side_ * std::atan2(R(2, 1), R(2, 2)) / kAngle);
  }
  std::uint64_t key = 1;
  for (const std::int64_t c : cell) {
    if (std::abs(c) >= kHalf) return false;
    key = (key << 10U) | static_cast<std::uint64_t>(c + kHalf);
  }
  key <<= 1U;  // 62 bits; the lowest holds the answer
  const std::size_t mask = table_.size() - 1;
  std::size_t at = Mixed(key) & mask;
  while (table_[at].key != 0 && (table_[at].key & ~std::uint64_t{1}) != key) at = (at + 1) & mask;
  if (table_[at].key != 0) return (table_[at].key & 1U) != 0;
  const bool reached = WorkOut(cell);
  table_[at].key = key | (reached ? 1U : 0U);
  if (2 * static_cast<std::size_t>(++known_) > table_.size()) Grow();
  return reached;
}

Pose LegWorkspace::InCell(const std::int64_t (&cell)[6], double share, unsigned corner) const {
  const auto at = [&](unsigned axis) {
    const double to_side = (corner >> axis % 3 & 1U) != 0 ? 0.5 : -0.5;
    return static_cast<double>(cell[axis]) + share * to_side;
  };
  Pose X_BF = X_BF_standing_;
  X_BF.translation() += cell_m_ * Vector3(at(0), side_ * at(1), at(2));
  if (!turned_) return X_BF;
  X_BF.linear() = YawRotation(side_ * kAngle * at(3)) * RotationExp(kAngle * at(4) * Vector3::UnitY()) *
                  RotationExp(side_ * kAngle * at(5) * Vector3::UnitX()) * X_BF_standing_.linear();
  return X_BF;
}

bool LegWorkspace::WorkOut(const std::int64_t (&cell)[6]) const {
  const Pose X_BF = InCell(cell, 0.0, 0);
  const Vector3 from_hip = X_BF.translation() - p_BH_;
  Pose farther = X_BF;
  farther.translation() += reserve_m_ * from_hip.normalized();
  const double spare = std::min(SpareOf(X_BF), SpareOf(farther));
  if (spare < 0.0) return false;
  // What the joints may turn by within the cell: the foot's way about the hip, folded legs more, and its own turning.
  constexpr double kLeverage = 2.0;
  const double within = kLeverage * (cell_m_ / from_hip.norm() + (turned_ ? kAngle : 0.0));
  if (spare > within) return true;
  for (unsigned corner = 0; corner < 8; ++corner)
    if (!Solves(InCell(cell, 1.0, corner))) return false;
  return true;
}

double LegWorkspace::SpareOf(const Pose& X_BF) const {
  constexpr int kStarts = 4;  // of the damped search, whose misses cost far more than its finds
  VectorX joints;
  if (ik_.method() == LegIk::Method::kDamped) {
    DampedSearch found = SearchPose(chain_, X_BF, chain_.lower, chain_.upper, standing_, kStarts);
    if (!found.converged) return -1.0;
    joints = std::move(found.coordinates);
  } else {
    Result<LegIk::Solution> solution = ik_.Solve(X_BF, standing_);
    if (!solution) return -1.0;
    joints = std::move(solution->joints);
  }
  return std::max(0.0, std::min((joints - chain_.lower).minCoeff(), (chain_.upper - joints).minCoeff()));
}

void LegWorkspace::Grow() {
  std::vector<Entry> old(2 * table_.size());
  old.swap(table_);
  const std::size_t mask = table_.size() - 1;
  for (const Entry& entry : old) {
    if (entry.key == 0) continue;
    std::size_t at = Mixed(entry.key & ~std::uint64_t{1}) & mask;
    while (table_[at].key != 0) at = (at + 1) & mask;
    table_[at] = entry;
  }
}

}  // namespace gaitwright
