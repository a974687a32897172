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

/// The limit moved towards the standing position by `by`, at most half of the distance.
double Narrowed(double limit, double standing, double by) {
  const double distance = standing - limit;
  return limit + std::copysign(std::min(by, 0.5 * std::abs(distance)), distance);
}

/// The data of a model for the inverse kinematics of one leg, with limits reduced by the margin.
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
  throw InvalidArgument(fmt::format("the margin of a leg's workspace is {}; accepted: 0 to 0.2", reserve));
}

std::uint64_t Mixed(std::uint64_t x) {
  x ^= x >> 33;
  x *= 0xff51afd7ed558ccdULL;
  x ^= x >> 33;
  x *= 0xc4ceb9fe1a85ec53ULL;
  return x ^ (x >> 33);
}

constexpr std::int64_t kCellsToASide = 512;  // along each direction

}  // namespace

LegWorkspace::LegWorkspace(const RobotModel& model, int leg, double reserve)
    : narrow_(WithReserve(model, CheckedReserve(reserve))),
      ik_(*narrow_, leg),
      chain_(*narrow_, leg),
      balls_(model, leg) {
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
  const Cell middle = {};
  for (int halved = 0; halved < 6 && !WorkOut(middle); ++halved) reserve_m_ *= halved < 5 ? 0.5 : 0.0;
}

bool LegWorkspace::CellOf(const Pose& X_BF, Cell& cell) const {
  const Vector3 away = (X_BF.translation() - X_BF_standing_.translation()) / cell_m_;
  cell[0] = std::lround(away.x());
  cell[1] = std::lround(side_ * away.y());
  cell[2] = std::lround(away.z());
  cell[3] = cell[4] = cell[5] = 0;
  if (turned_) {
    const Matrix3 R = X_BF.linear() * X_BF_standing_.linear().transpose();
    cell[3] = std::lround(side_ * std::atan2(R(1, 0), R(0, 0)) / kAngle);
    cell[4] = std::lround(-std::asin(std::clamp(R(2, 0), -1.0, 1.0)) / kAngle);
    cell[5] = std::lround(side_ * std::atan2(R(2, 1), R(2, 2)) / kAngle);
  }
  return std::all_of(std::begin(cell), std::end(cell), [](std::int64_t c) { return std::abs(c) < kCellsToASide; });
}

std::size_t LegWorkspace::Find(const Cell& cell) {
  std::uint64_t key = 1;
  for (const std::int64_t c : cell) key = (key << 10U) | static_cast<std::uint64_t>(c + kCellsToASide);
  key <<= 1U;  // 62 bits; the lowest holds the answer
  const auto place = [&] {
    const std::size_t mask = table_.size() - 1;
    std::size_t at = Mixed(key) & mask;
    while (table_[at].key != 0 && (table_[at].key & ~std::uint64_t{1}) != key) at = (at + 1) & mask;
    return at;
  };
  const std::size_t at = place();
  if (table_[at].key != 0) return at;
  table_[at].key = key | (WorkOut(cell) ? 1U : 0U);
  if (2 * static_cast<std::size_t>(++known_) <= table_.size()) return at;
  Grow();
  return place();
}

bool LegWorkspace::Reaches(const Pose& X_BF) {
  Cell cell;
  return CellOf(X_BF, cell) && (table_[Find(cell)].key & 1U) != 0;
}

bool LegWorkspace::BallsAt(const Pose& X_BF, std::vector<Ball>& balls) {
  balls.clear();
  Cell cell;
  if (!CellOf(X_BF, cell)) return false;
  Entry& entry = table_[Find(cell)];
  if ((entry.key & 1U) == 0) return false;
  const Vector3 middle = InCell(cell, 0.0, 0).translation();
  if (entry.posture < 0) {
    entry.posture = static_cast<int>(centres_.size() / std::max<std::size_t>(balls_.size(), 1));
    balls_.CentresAt(JointsAt(InCell(cell, 0.0, 0), standing_).value(), centres_);
  }
  // The offset of the foot from the centre of the cell moves a ball in proportion to its position between hip and foot.
  const Vector3 off = X_BF.translation() - middle, along = middle - p_BH_;
  const std::size_t first = static_cast<std::size_t>(entry.posture) * balls_.size();
  for (std::size_t i = 0; i < balls_.size(); ++i) {
    const Vector3& p = centres_[first + i];
    const double share = std::clamp((p - p_BH_).dot(along) / along.squaredNorm(), 0.0, 1.0);
    balls.push_back({p + share * off, balls_.radius_m(i)});
  }
  return true;
}

Pose LegWorkspace::InCell(const Cell& cell, double share, unsigned corner) const {
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

bool LegWorkspace::WorkOut(const Cell& cell) const {
  const Pose X_BF = InCell(cell, 0.0, 0);
  const std::optional<VectorX> centre = JointsAt(X_BF, standing_);
  if (!centre) return false;
  const Vector3 from_hip = X_BF.translation() - p_BH_;
  Pose farther = X_BF;
  farther.translation() += reserve_m_ * from_hip.normalized();
  const std::optional<VectorX> far = reserve_m_ > 0.0 ? JointsAt(farther, *centre) : centre;
  if (!far) return false;
  // Largest rotation of the joints within the cell: the angle of the foot about the hip, larger for folded legs, and
  // the rotation of the foot.
  constexpr double kLeverage = 2.0;
  const double within = kLeverage * (cell_m_ / from_hip.norm() + (turned_ ? kAngle : 0.0));
  if (std::min(MarginOf(*centre), MarginOf(*far)) > within) return true;
  for (unsigned corner = 0; corner < 8; ++corner)
    if (!JointsAt(InCell(cell, 1.0, corner), *centre)) return false;
  return true;
}

/// @param guess  from which an iterative search starts.
std::optional<VectorX> LegWorkspace::JointsAt(const Pose& X_BF, const VectorX& guess) const {
  constexpr int kStarts = 4;  // starts of the damped search; a failed search needs far more time than a success
  if (ik_.method() == LegIk::Method::kDamped) {
    DampedSearch found = SearchPose(chain_, X_BF, chain_.lower, chain_.upper, guess, kStarts);
    if (!found.converged) return std::nullopt;
    return std::move(found.coordinates);
  }
  Result<LegIk::Solution> solution = ik_.Solve(X_BF, standing_);
  if (!solution) return std::nullopt;
  return std::move(solution->joints);
}

/// Distance of the nearest joint from its limit.
double LegWorkspace::MarginOf(const VectorX& joints) const {
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

LegWorkspace& LegWorkspaces::Of(const RobotModel& model, int leg, double reserve) {
  std::unique_ptr<LegWorkspace>& workspace = of_[{leg, reserve}];
  if (workspace == nullptr) workspace = std::make_unique<LegWorkspace>(model, leg, reserve);
  return *workspace;
}

}  // namespace gaitwright
