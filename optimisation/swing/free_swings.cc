// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/swing/free_swings.h"

#include <algorithm>
#include <optional>

#include "kinematics/trajectory/fit_detour.h"
#include "kinematics/trajectory/swing_curve.h"
#include "optimisation/swing/refine_swing.h"
#include "optimisation/swing/swing_planes.h"
#include "planning/plan/sample_plan.h"

namespace gaitwright {
namespace {

/// The swing of a foot of the problem at a time, from the stances before and after it; nothing in stance.
std::optional<RigidSwing> SwingAt(const RigidBodyProblem& problem, int foot, double time_s) {
  std::optional<std::size_t> from;
  for (std::size_t i = 0; i < problem.stances.size(); ++i) {
    if (problem.stances[i].foot != foot) continue;
    if (problem.stances[i].start_s > time_s) return from ? std::optional(RigidSwing{*from, i}) : std::nullopt;
    from = i;
  }
  return std::nullopt;
}

/// Uniform fractions of a swing at which it is checked, and one more at each end, where the foot is slow and the body
/// moves on.
std::vector<double> SharesLookedAt() {
  constexpr int kEven = 32;
  std::vector<double> shares = {0.0, 0.5 / kEven};
  for (int i = 1; i < kEven; ++i) shares.push_back(static_cast<double>(i) / kEven);
  shares.insert(shares.end(), {1.0 - 0.5 / kEven, 1.0});
  return shares;
}

/// Control points of a swing that is a detour, or of the detour nearest to its bump.
std::vector<Vector3> DetourOf(const SwingTrajectory& swing) {
  constexpr int kPoints = 8, kSamples = 40;
  if (!swing.detour_W.empty() && swing.detour_W.size() % 2 == 0) return swing.detour_W;
  const SwingCurve straight = StraightMoveOf(CurveOf(swing));
  std::vector<double> shares;
  std::vector<Vector3> off_W;
  for (int k = 0; k < kSamples; ++k) {
    shares.push_back((k + 1) / (kSamples + 1.0));
    const double time_s = swing.start_s + shares.back() * (swing.end_s - swing.start_s);
    off_W.emplace_back(Evaluate(CurveOf(swing), time_s).X_WF.translation() -
                       Evaluate(straight, time_s).X_WF.translation());
  }
  return FitDetour(shares, off_W, kPoints);
}

double RadiusOf(const RigidBodyProblem& problem, const RigidSwing& swing) {
  return problem.feet[static_cast<std::size_t>(problem.stances[swing.from].foot)].radius_m;
}

/// Planes that separate a swing from nearby solids, each valid from one fraction to the next. The curve is that of the
/// contact point, which is the lowest point of a sphere. Beside a plane that is not level, the sphere needs more room.
std::vector<SwingPlane> PlanesBeside(const Terrain& ground, const SwingCurve& curve, const std::vector<double>& shares,
                                     double radius_m) {
  constexpr int kPieces = 4;
  constexpr double kNear = 0.3, kClearance = 5e-3;  // [m]
  std::vector<SwingPlane> planes;
  for (std::size_t i = 0; i + 1 < shares.size(); ++i) {
    std::vector<Vector3> path_W;
    for (int k = 0; k <= kPieces; ++k) {
      const double share = shares[i] + k * (shares[i + 1] - shares[i]) / kPieces;
      path_W.emplace_back(Evaluate(curve, curve.start_s + share * (curve.end_s - curve.start_s)).X_WF.translation());
    }
    for (const TerrainPatch& patch : ground.patches) {
      const PartingPlane plane = PlaneBefore(patch, path_W);
      if (std::min(plane.Beyond(path_W.front()), plane.Beyond(path_W.back())) > kNear) continue;
      for (const double share : {shares[i], shares[i + 1]}) {
        if (share > 0.0 && share < 1.0)
          planes.push_back(
              {share, plane.normal_W,
               plane.offset_m + radius_m * (1.0 - plane.normal_W.z()) + kClearance * ClearanceRamp(share)});
      }
    }
  }
  return planes;
}

}  // namespace

std::vector<RigidSwing> FreeSwingsOf(const Terrain& ground, const RigidBodyProblem& problem,
                                     const std::vector<SwingTrajectory>& swings, const std::vector<int>& problem_foot,
                                     double start_s) {
  std::vector<RigidSwing> free;
  for (const SwingTrajectory& of : swings) {
    const int foot = problem_foot[static_cast<std::size_t>(of.foot)];
    std::optional<RigidSwing> swing = SwingAt(problem, foot, 0.5 * (of.start_s + of.end_s) - start_s);
    if (!swing) continue;
    swing->free = true;
    swing->cruise = of.cruise;
    swing->detour_W = DetourOf(of);
    swing->shares = SharesLookedAt();
    swing->planes = PlanesBeside(ground, CurveOf(of), swing->shares, RadiusOf(problem, *swing));
    free.push_back(std::move(*swing));
  }
  return free;
}

std::vector<RigidSwing> FreeSwingsOf(const Terrain& ground, const RigidBodyProblem& problem,
                                     const RigidBodyMotion& motion) {
  std::vector<RigidSwing> swings = problem.swings;
  for (std::size_t i = 0; i < swings.size(); ++i) {
    RigidSwing& swing = swings[i];
    if (!swing.free) continue;
    swing.detour_W = motion.detours_W[i];
    swing.planes = PlanesBeside(
        ground, {0.0, 1.0, motion.X_WF[swing.from], motion.X_WF[swing.to], 0.0, swing.detour_W, swing.cruise},
        swing.shares, RadiusOf(problem, swing));
  }
  return swings;
}

SwingTrajectory SwingOf(const RigidBodyProblem& problem, const RigidBodyMotion& motion, std::size_t swing,
                        double start_s) {
  const RigidSwing& of = problem.swings[swing];
  const RigidStance &from = problem.stances[of.from], &to = problem.stances[of.to];
  SwingTrajectory made;
  made.foot = from.foot;
  made.start_s = start_s + from.end_s;
  made.end_s = start_s + to.start_s;
  made.X_WF_start = motion.X_WF[of.from];
  if (!from.moved_W.empty()) made.X_WF_start.translation() += from.moved_W.back();
  made.X_WF_end = motion.X_WF[of.to];
  made.cruise = of.cruise;
  made.lift_m = of.lift_m;
  made.detour_W = of.free ? motion.detours_W[swing] : of.detour_W;
  if (of.free) made.lift_m = LiftAtHalfTime(CurveOf(made));
  return made;
}

void TakeSwings(const std::vector<RigidSwing>& swings, RigidBodyProblem& problem, VectorX& numbers) {
  Eigen::Index at = numbers.size();
  for (const RigidSwing& swing : problem.swings) at -= swing.unknowns();
  problem.swings = swings;
  Eigen::Index size = at;
  for (const RigidSwing& swing : swings) size += swing.unknowns();
  numbers.conservativeResize(size);
  for (const RigidSwing& swing : swings) {
    for (int k = 0; k < swing.unknowns(); k += 3, at += 3)
      numbers.segment<3>(at) = swing.detour_W[static_cast<std::size_t>(k / 3)];
  }
}

}  // namespace gaitwright
