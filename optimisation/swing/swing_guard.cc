// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/swing/swing_guard.h"

#include <algorithm>
#include <utility>

#include "kinematics/collision/shape_extent.h"
#include "optimisation/swing/refine_swing.h"
#include "planning/plan/sample_plan.h"

namespace gaitwright {
namespace {

constexpr double kTouching = 1e-4;  // [m] that solver and rounding may be off by
constexpr int kSamples = 60;

/// The foot's frame F (of a sphere: its centre) where its contact frame is.
Pose FootFrame(const Foot& foot, Pose X_WF) {
  X_WF.translation() += foot.radius * X_WF.linear().col(2);
  return X_WF;
}

}  // namespace

SwingGuard::SwingGuard(const RobotModel& model, const Terrain& terrain, BaseMotion base)
    : model_(model), watch_(model, terrain), base_(std::move(base)), scratch_(model) {
  parts_.resize(model.feet.size());
  if (!base_) return;
  for (std::size_t f = 0; f < model.feet.size(); ++f) {
    ik_.emplace_back(model, static_cast<int>(f));
    for (const Shape& shape : model.collision_shapes) {
      const auto& joints = model.legs[f].joints;
      const bool of_leg = std::find(joints.begin(), joints.end(), shape.body - 1) != joints.end();
      if (of_leg && !IsShapeOfAFoot(model, shape)) parts_[f].push_back({PreparedShape(shape), shape.body});
    }
  }
}

double SwingGuard::AskedAtMost(const SwingTrajectory& swing, double clearance_m) const {
  constexpr double kShare = 0.9;  // of what is had beside the footholds
  double asked = clearance_m;
  for (Pose X_WF : {swing.X_WF_start, swing.X_WF_end}) {
    X_WF.translation().z() += clearance_m;
    const Foot& foot = model_.feet[static_cast<std::size_t>(swing.foot)];
    const NearestSolid nearest = watch_.NearestToFoot(swing.foot, FootFrame(foot, X_WF), clearance_m);
    if (nearest.distance_m < clearance_m) asked = std::min(asked, std::max(kShare * nearest.distance_m, 0.0));
  }
  return asked;
}

std::optional<SwingHit> SwingGuard::Check(const SwingTrajectory& swing, double clearance_m) const {
  const Foot& foot = model_.feet[static_cast<std::size_t>(swing.foot)];
  const double asked_at_most = AskedAtMost(swing, clearance_m);
  const SwingCurve curve = CurveOf(swing);
  for (int k = 0; k <= kSamples; ++k) {
    const double u = static_cast<double>(k) / kSamples, time_s = swing.start_s + u * (swing.end_s - swing.start_s);
    const double asked = asked_at_most * ClearanceRamp(u) - kTouching;
    const Pose X_WF = FootFrame(foot, Evaluate(curve, time_s).X_WF);
    const NearestSolid nearest = watch_.NearestToFoot(swing.foot, X_WF, asked + kTouching);
    if (nearest.solid >= 0 && nearest.distance_m < asked)
      return SwingHit{time_s, foot.link, watch_.solids().SolidName(nearest.solid), nearest.distance_m, asked};
  }
  return base_ ? CheckLeg(swing) : std::nullopt;
}

std::optional<SwingHit> SwingGuard::CheckLeg(const SwingTrajectory& swing) const {
  const Foot& foot = model_.feet[static_cast<std::size_t>(swing.foot)];
  const LegIk& ik = ik_[static_cast<std::size_t>(swing.foot)];
  const SwingCurve curve = CurveOf(swing);
  VectorX q = StandingConfiguration(model_);
  VectorX guess(static_cast<Eigen::Index>(ik.dofs().size()));
  for (Eigen::Index i = 0; i < guess.size(); ++i) guess[i] = q[7 + ik.dofs()[static_cast<std::size_t>(i)]];
  for (int k = 0; k <= kSamples; ++k) {
    const double time_s = swing.start_s + (swing.end_s - swing.start_s) * k / kSamples;
    const Pose X_WB = base_(time_s);
    const auto leg = ik.Solve(X_WB.inverse() * FootFrame(foot, Evaluate(curve, time_s).X_WF), guess);
    if (!leg) continue;  // for the whole-body stage to tell
    guess = leg->joints;
    for (Eigen::Index i = 0; i < guess.size(); ++i) q[7 + ik.dofs()[static_cast<std::size_t>(i)]] = guess[i];
    q.head<3>() = X_WB.translation();
    q.segment<4>(3) = Quaternion(X_WB.linear()).coeffs();
    ForwardKinematics(model_, q, scratch_);
    if (auto hit = CheckLegAt(swing.foot, time_s)) return hit;
  }
  return std::nullopt;
}

std::optional<SwingHit> SwingGuard::CheckLegAt(int foot, double time_s) const {
  for (const LegPart& part : parts_[static_cast<std::size_t>(foot)]) {
    const Shape& shape = part.shape.shape();
    const NearestSolid nearest =
        watch_.solids().Nearest(part.shape, FramePose(scratch_, shape.body, shape.X_BS), kTouching);
    if (nearest.solid >= 0 && nearest.distance_m < 0.0)
      return SwingHit{time_s, shape.link, watch_.solids().SolidName(nearest.solid), nearest.distance_m, 0.0};
  }
  return std::nullopt;
}

}  // namespace gaitwright
