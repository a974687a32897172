// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/swing/swing_guard.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "kinematics/collision/shape_extent.h"
#include "kinematics/model/actuator.h"
#include "optimisation/swing/refine_swing.h"
#include "planning/audit/swing_depth.h"
#include "planning/plan/sample_plan.h"

namespace gaitwright {
namespace {

constexpr double kTouchingDepth = 1e-4;  // [m] tolerance for solver and rounding errors

/// The foot's frame F (sphere: its centre) for a pose of its contact frame.
Pose FootFrame(const Foot& foot, Pose X_WF) {
  X_WF.translation() += foot.radius * X_WF.linear().col(2);
  return X_WF;
}

}  // namespace

SwingGuard::SwingGuard(const RobotModel& model, const Terrain& terrain, FormerMotion former)
    : model_(model), watch_(model, terrain), former_(std::move(former)), scratch_(model) {
  parts_.resize(model.feet.size());
  if (!former_.base) return;
  for (std::size_t f = 0; f < model.feet.size(); ++f) {
    ik_.emplace_back(model, static_cast<int>(f));
    for (const Shape& shape : model.collision_shapes) {
      const auto& joints = model.legs[f].joints;
      const bool of_leg = std::find(joints.begin(), joints.end(), shape.body - 1) != joints.end();
      if (of_leg && !IsShapeOfAFoot(model, shape)) parts_[f].push_back({PreparedShape(shape), shape.body});
    }
  }
}

std::vector<Pose> SwingGuard::FootPoses(const SwingTrajectory& swing) const {
  const Foot& foot = model_.feet[static_cast<std::size_t>(swing.foot)];
  const SwingCurve curve = CurveOf(swing);
  const SwingRoll roll = RollOf(swing);
  std::vector<Pose> poses;
  for (int k = 0; k <= kSamples; ++k) {
    poses.push_back(FootFrame(foot, Evaluate(curve, TimeOf(swing, k)).X_WF));
    poses.back().translation() += roll.At(static_cast<double>(k) / kSamples);
  }
  return poses;
}

double SwingGuard::AskedAtMost(const SwingTrajectory& swing, double clearance_m) const {
  constexpr double kShare = 0.9;  // share of the distance beside the footholds
  double asked = clearance_m;
  for (Pose X_WF : {swing.X_WF_start, swing.X_WF_end}) {
    X_WF.translation().z() += clearance_m;
    const Foot& foot = model_.feet[static_cast<std::size_t>(swing.foot)];
    const NearestSolid nearest = watch_.NearestToFoot(swing.foot, FootFrame(foot, X_WF), clearance_m);
    if (nearest.distance_m < clearance_m) asked = std::min(asked, std::max(kShare * nearest.distance_m, 0.0));
  }
  return asked;
}

std::optional<SwingHit> SwingGuard::Check(const SwingTrajectory& swing, double clearance_m, bool with_leg) const {
  constexpr double kShare = 0.5;  // share of the audit's tolerance
  const Foot& foot = model_.feet[static_cast<std::size_t>(swing.foot)];
  const double asked_at_most = AskedAtMost(swing, clearance_m);
  const std::vector<Pose> X_WF = FootPoses(swing);
  const auto depth = [&](const Pose& at) { return -watch_.NearestToFoot(swing.foot, at, kTouchingDepth).distance_m; };
  const double stands_m = std::max(depth(X_WF.front()), depth(X_WF.back()));
  for (int k = 0; k <= kSamples; ++k) {
    const double u = static_cast<double>(k) / kSamples;
    const double deep = std::max(kShare * SwingDepth(u), (stands_m + kTouchingDepth) * SwingEndShare(u));
    const double asked = asked_at_most * ClearanceRamp(u) - std::max(deep, kTouchingDepth);
    const NearestSolid nearest =
        watch_.NearestToFoot(swing.foot, X_WF[static_cast<std::size_t>(k)], asked + kTouchingDepth);
    if (nearest.solid >= 0 && nearest.distance_m < asked)
      return SwingHit{TimeOf(swing, k), foot.link, watch_.solids().SolidName(nearest.solid), nearest.distance_m, asked};
  }
  return with_leg && former_.base ? CheckLeg(swing, 1) : std::nullopt;
}

VectorX SwingGuard::StandingLeg(int foot) const {
  const std::vector<int>& dofs = ik_[static_cast<std::size_t>(foot)].dofs();
  const VectorX standing = StandingConfiguration(model_);
  VectorX leg(static_cast<Eigen::Index>(dofs.size()));
  for (Eigen::Index i = 0; i < leg.size(); ++i) leg[i] = standing[7 + dofs[static_cast<std::size_t>(i)]];
  return leg;
}

namespace {

/// Joints of a leg for a pose of its foot: those near the guess, or others. A search for others takes a hundred times
/// longer, and only finds what a swing reaches continuously if it is the first.
std::optional<VectorX> AnySolution(const LegIk& ik, const Pose& X_BF, const VectorX& guess) {
  if (std::optional<VectorX> near = ik.SolveNear(X_BF, guess)) return near;
  Result<LegIk::Solution> other = ik.Solve(X_BF, guess);
  return other ? std::optional(std::move(other->joints)) : std::nullopt;
}

/// Whether motors can move the leg's joints by `change` in the given time. Other joints of a transmission do not move.
bool MotorsFollow(const std::vector<Actuator>& motors, const std::vector<int>& dofs, const VectorX& change,
                  double step_s) {
  for (const Actuator& motor : motors) {
    double turned = 0.0;
    for (const Actuator::Term& term : motor.terms) {
      const auto at = std::find(dofs.begin(), dofs.end(), term.dof);
      if (at != dofs.end()) turned += term.by_speed * change[at - dofs.begin()];
    }
    if (std::abs(turned) > motor.velocity_limit * step_s) return false;
  }
  return true;
}

}  // namespace

bool SwingGuard::LegFollows(const SwingTrajectory& swing) const {
  if (!former_.base) return true;
  const LegIk& ik = ik_[static_cast<std::size_t>(swing.foot)];
  const double step_s = (swing.end_s - swing.start_s) / kSamples;
  const std::vector<Pose> X_WF = FootPoses(swing);
  VectorX guess = StandingLeg(swing.foot);
  std::vector<Actuator> motors;
  for (const int dof : ik.dofs()) motors.push_back(ActuatorOf(model_, dof));
  for (int k = 0; k <= kSamples; ++k) {
    const Pose X_BF = former_.base(TimeOf(swing, k)).inverse() * X_WF[static_cast<std::size_t>(k)];
    const std::optional<VectorX> leg = k == 0 ? AnySolution(ik, X_BF, guess) : ik.SolveNear(X_BF, guess);
    if (!leg) return false;
    if (k > 0 && !MotorsFollow(motors, ik.dofs(), *leg - guess, step_s)) return false;
    guess = *leg;
  }
  return true;
}

std::optional<SwingHit> SwingGuard::CheckLeg(const SwingTrajectory& swing, int stride) const {
  const LegIk& ik = ik_[static_cast<std::size_t>(swing.foot)];
  const std::vector<Pose> X_WF = FootPoses(swing);
  VectorX q = StandingConfiguration(model_);
  VectorX guess = StandingLeg(swing.foot);
  for (int k = 0; k <= kSamples; k += stride) {
    const Pose X_WB = former_.base(TimeOf(swing, k));
    const Pose X_BF = X_WB.inverse() * X_WF[static_cast<std::size_t>(k)];
    const std::optional<VectorX> leg = k == 0 ? AnySolution(ik, X_BF, guess) : ik.SolveNear(X_BF, guess);
    if (!leg) continue;  // checked by LegFollows and the whole-body stage
    guess = *leg;
    for (Eigen::Index i = 0; i < guess.size(); ++i) q[7 + ik.dofs()[static_cast<std::size_t>(i)]] = guess[i];
    q.head<3>() = X_WB.translation();
    q.segment<4>(3) = Quaternion(X_WB.linear()).coeffs();
    ForwardKinematics(model_, q, scratch_);
    if (auto hit = CheckLegAt(swing.foot, TimeOf(swing, k))) return hit;
  }
  return std::nullopt;
}

std::optional<SwingHit> SwingGuard::CheckLegAt(int foot, double time_s) const {
  for (const LegPart& part : parts_[static_cast<std::size_t>(foot)]) {
    const Shape& shape = part.shape.shape();
    const NearestSolid nearest =
        watch_.solids().Nearest(part.shape, FramePose(scratch_, shape.body, shape.X_BS), kTouchingDepth);
    if (nearest.solid >= 0 && nearest.distance_m < 0.0)
      return SwingHit{time_s, shape.link, watch_.solids().SolidName(nearest.solid), nearest.distance_m, 0.0};
  }
  return std::nullopt;
}

}  // namespace gaitwright
