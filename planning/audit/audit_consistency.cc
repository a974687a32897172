// SPDX-License-Identifier: BSD-3-Clause
// Check `consistency`: schedule, gait, command and footholds against the grid and against each other.
#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "kinematics/spatial/rotation.h"
#include "kinematics/stability/polygon.h"
#include "planning/audit/auditor.h"
#include "planning/audit/tolerances.h"
#include "planning/plan/carried_plan.h"
#include "planning/plan/heel_off_internal.h"
#include "planning/plan/sole_support.h"

namespace gaitwright {

using namespace tolerance;
namespace {

/// Pose after a constant planar twist of the base from the origin.
PlanarPose Arc(double forward_m_s, double lateral_m_s, double yaw_rate_rad_s, double duration_s) {
  const double yaw = yaw_rate_rad_s * duration_s;
  const double half = 0.5 * yaw;
  const double chord = duration_s * (std::abs(half) < 1e-9 ? 1.0 : std::sin(half) / half);
  return {chord * (std::cos(half) * forward_m_s - std::sin(half) * lateral_m_s),
          chord * (std::sin(half) * forward_m_s + std::cos(half) * lateral_m_s), yaw};
}

/// The pose `p`, given in the frame of pose `origin`, in the outer frame.
PlanarPose Carried(const PlanarPose& origin, const PlanarPose& p) {
  const double c = std::cos(origin.yaw_rad), s = std::sin(origin.yaw_rad);
  return {origin.x_m + c * p.x_m - s * p.y_m, origin.y_m + s * p.x_m + c * p.y_m, origin.yaw_rad + p.yaw_rad};
}

}  // namespace

void Auditor::CheckSchedule() {
  const WholeBodyTrajectory& w = plan_.whole_body;
  Expect("start of the schedule", w.start_s, std::abs(plan_.schedule.start_s() - w.start_s), w.step_s, "s");
  Expect("end of the schedule", w.end_s(), std::abs(plan_.schedule.end_s() - w.end_s()), w.step_s, "s");
  const auto feet = static_cast<double>(model_.legs.size());
  for (const MotionPart& part : plan_.parts) {
    const auto phases = static_cast<double>(part.gait.phase.size());
    const auto duties = static_cast<double>(part.gait.duty_factor.size());
    if (phases != feet)
      findings_.Note(Law::kConsistency, "number of the gait's phases", part.start_s, phases, feet, "1");
    if (duties != feet)
      findings_.Note(Law::kConsistency, "number of the gait's duty factors", part.start_s, duties, feet, "1");
  }
}

/// The parts must follow each other from the start of the grid to its end, and the last goal must be the plan's goal.
/// While a part stands still, no foot leaves the ground.
void Auditor::CheckParts() {
  const WholeBodyTrajectory& w = plan_.whole_body;
  PlanarPose from = BaseInPlan(w.q.front());
  double since_s = w.start_s;
  for (const MotionPart& part : plan_.parts) {
    Expect("start of a part", part.start_s, std::abs(part.start_s - since_s), w.step_s, "s");
    CheckCommand(part, from);
    if (StandsStill(part.gait)) CheckStand(part);
    if (Hangs(part.gait)) CheckHanging(part);
    from = part.goal;
    since_s = part.end_s;
  }
  Expect("end of the last part", since_s, std::abs(since_s - w.end_s()), w.step_s, "s");
  const double apart = std::hypot(from.x_m - plan_.goal.x_m, from.y_m - plan_.goal.y_m);
  Expect("goal against the last part's", since_s, apart, kPosition, "m");
}

void Auditor::CheckStand(const MotionPart& part) {
  const FootSet all = AllFeet(static_cast<int>(model_.legs.size()));
  for (const ContactPhase& phase : plan_.schedule.phases) {
    const bool within = phase.end_s > part.start_s + kTime && phase.start_s < part.end_s - kTime;
    if (within && (phase.stance & all) != all) {
      findings_.Note(Law::kConsistency, "feet on the ground while the robot stands",
                     std::max(part.start_s, phase.start_s), std::popcount(phase.stance & all),
                     static_cast<double>(model_.legs.size()), "1");
    }
  }
}

/// The goal of a part must be the previous goal moved by the command; for the first part, the start pose of the base
/// moved by the command. For a number of steps the goal is known only to within a step of each foot. For a turn on the
/// spot by a default angle only the position is checked.
void Auditor::CheckCommand(const MotionPart& part, const PlanarPose& start) {
  const WalkCommand& c = part.command;
  const double position = kGoalShare * model_.leg_length_m(), start_s = part.start_s;
  const auto compare = [&](const char* where, const PlanarPose& expected) {
    const PlanarPose goal = Carried(start, expected);
    Expect(where, start_s, std::hypot(goal.x_m - part.goal.x_m, goal.y_m - part.goal.y_m), position, "m");
    const double turned = std::abs(WrapAngle(goal.yaw_rad - part.goal.yaw_rad));
    Expect(std::string(where) + ", heading", start_s, turned, kGoalHeading, "rad");
  };
  const bool leads = c.extent == WalkCommand::Extent::kGoal;  // also for a body that moves over feet that stay
  if (!leads && (StandsStill(part.gait) || Hangs(part.gait))) {
    compare(StandsStill(part.gait) ? "goal of standing still" : "goal of hanging", {});
    return;
  }
  if (leads) {
    compare("goal against the command's pose", {c.goal_x_m, c.goal_y_m, c.goal_yaw_rad});
    return;
  }
  const bool own_speed = c.speed_m_s == 0.0 && c.lateral_speed_m_s == 0.0;
  if (c.extent == WalkCommand::Extent::kDistance && !(own_speed && c.yaw_rate_rad_s != 0.0)) {
    const double forward = own_speed ? model_.nominal_speed_m_s : c.speed_m_s;
    const double duration = c.distance_m / std::hypot(forward, c.lateral_speed_m_s);
    compare("goal against the command's distance", Arc(forward, c.lateral_speed_m_s, c.yaw_rate_rad_s, duration));
  } else if (c.extent == WalkCommand::Extent::kSteps && own_speed && c.yaw_rate_rad_s == 0.0) {
    const double distance = std::hypot(part.goal.x_m - start.x_m, part.goal.y_m - start.y_m);
    const double most = c.steps * std::abs(c.step_length_m);
    const double least = most - static_cast<double>(model_.feet.size()) * std::abs(c.step_length_m);
    if (!(distance <= most + position && distance >= least - position))
      findings_.Note(Law::kConsistency, "goal against the command's steps", start_s, distance, most, "m");
  }
}

void Auditor::CheckFoothold(const Foothold& foothold, const ContactInterval& interval) {
  const std::string& foot = FootName(foothold.foot);
  const auto time = [&](const char* what, double value, double limit) {
    if (!(std::abs(value - limit) <= kTime))
      findings_.Note(Law::kConsistency, foot + " foothold's " + what + " against schedule", limit, value, limit, "s");
  };
  time("touch-down", foothold.touchdown_s, interval.start_s);
  time("lift-off", foothold.liftoff_s, interval.end_s);
  if (!HoldsSurface(foothold.patch)) {
    findings_.Note(Law::kConsistency, foot + " foothold's patch", foothold.touchdown_s, foothold.patch,
                   plan_.terrain.num_surfaces() - 1.0, "1");
    return;
  }
  const auto surface = static_cast<std::size_t>(foothold.patch);
  if (surface < plan_.terrain.patches.size() && RestsAcross(foothold)) {
    CheckAcross(foothold);
  } else if (surface < plan_.terrain.patches.size()) {
    CheckOnPatch(foothold, plan_.terrain.patches[surface]);
  } else {
    CheckOnField(foothold);
  }
  CheckHeelOff(foothold);
  const Foot& of_foot = model_.feet[static_cast<std::size_t>(foothold.foot)];
  if (of_foot.type != FootType::kSole) return;
  const double share = Area(SupportOf(of_foot, foothold, plan_.terrain, 0.0)) / Area(of_foot.sole_F);
  if (!(share >= kOnPatchShare))
    findings_.Note(Law::kConsistency, foot + " sole's share on its patch", foothold.touchdown_s, share, kOnPatchShare,
                   "1");
}

/// Only a sole can stand on its front edge, and the ground must carry the whole edge.
void Auditor::CheckHeelOff(const Foothold& foothold) {
  if (!foothold.heel_off_s) return;
  const std::string& foot = FootName(foothold.foot);
  const Foot& of_foot = model_.feet[static_cast<std::size_t>(foothold.foot)];
  const double at_s = *foothold.heel_off_s;
  const double outside_s = std::max(foothold.touchdown_s - at_s, at_s - foothold.liftoff_s);
  Expect(foot + " heel-off outside of its stance", at_s, std::max(outside_s, 0.0), kTime, "s");
  if (!of_foot.has_sole()) {
    findings_.Note(Law::kConsistency, foot + " heel-off of a foot without a sole", at_s, 1.0, 0.0, "1");
    return;
  }
  const Polygon support_F = SupportOf(of_foot, foothold, plan_.terrain, 0.0);
  for (const Vector2& corner : FrontEdge(of_foot.sole_F)) {
    const double off = support_F.empty() ? corner.norm() : std::max(-SignedDistance(support_F, corner), 0.0);
    Expect(foot + " front edge off its patch", at_s, off, kPosition, "m");
  }
}

/// True for a sole that is tilted against the surface under its middle and also overlaps another surface.
bool Auditor::RestsAcross(const Foothold& foothold) const {
  const Foot& foot = model_.feet[static_cast<std::size_t>(foothold.foot)];
  if (LiesOn(plan_.terrain.patches[static_cast<std::size_t>(foothold.patch)], foothold.X_WF)) return false;
  return std::any_of(foot.sole_F.begin(), foot.sole_F.end(), [&](const Vector2& corner) {
    const Vector3 p_W = foothold.X_WF * Vector3(corner.x(), corner.y(), 0.0);
    return GroundAt(plan_.terrain, p_W.head<2>()).patch != foothold.patch;
  });
}

/// A sole across several surfaces must have its corners on the ground and must not be inside the ground.
void Auditor::CheckAcross(const Foothold& foothold) {
  constexpr int kAcross = 9;
  const std::string& foot = FootName(foothold.foot);
  const std::vector<Vector2>& sole_F = model_.feet[static_cast<std::size_t>(foothold.foot)].sole_F;
  const auto gap = [&](const Vector2& at_F) {
    const Vector3 p_W = foothold.X_WF * Vector3(at_F.x(), at_F.y(), 0.0);
    const GroundPoint ground = GroundAt(plan_.terrain, p_W.head<2>());
    return ground.patch < 0 ? std::numeric_limits<double>::infinity() : p_W.z() - ground.height_m;
  };
  double widest = 0.0, deepest = 0.0;
  for (const Vector2& a : sole_F) {
    widest = std::max(widest, std::abs(gap(a)));
    for (const Vector2& b : sole_F) {
      for (int i = 1; i < kAcross; ++i) deepest = std::max(deepest, -gap(a + (b - a) * i / kAcross));
    }
  }
  Expect(foot + " foothold off its patch", foothold.touchdown_s, std::max(widest, deepest), kPosition, "m");
}

void Auditor::CheckOnPatch(const Foothold& foothold, const TerrainPatch& patch) {
  const std::string& foot = FootName(foothold.foot);
  const Pose& X_WT = patch.X_WT;
  const Vector3 normal_W = X_WT.linear().col(2), p_TF = X_WT.inverse() * foothold.X_WF.translation();
  const double beyond = patch.outline_T.empty() ? 0.0 : -SignedDistance(patch.outline_T, p_TF.head<2>());
  Expect(foot + " foothold off its patch", foothold.touchdown_s, std::max(beyond, std::abs(p_TF.z())), kPosition, "m");
  Expect(foot + " foothold tilted from its patch", foothold.touchdown_s,
         normal_W.cross(foothold.X_WF.linear().col(2)).norm(), kRotation, "rad");
}

/// A point or a sphere must be on the height field. A sole must be on the highest ground under it and not inside the
/// ground. Both must be tilted like the mean of the field.
void Auditor::CheckOnField(const Foothold& foothold) {
  const std::string& foot = FootName(foothold.foot);
  const Foot& of_foot = model_.feet[static_cast<std::size_t>(foothold.foot)];
  const Pose& X_WF = foothold.X_WF;
  constexpr int kAcross = 5;
  Vector2 low = Vector2::Constant(-of_foot.radius), high = -low;
  for (const Vector2& corner : of_foot.sole_F) low = low.cwiseMin(corner), high = high.cwiseMax(corner);
  double least = std::numeric_limits<double>::infinity();
  Vector3 normal_W = Vector3::Zero();
  for (int i = 0; i < kAcross; ++i) {
    for (int j = 0; j < kAcross; ++j) {
      const Vector2 share(i / (kAcross - 1.0), j / (kAcross - 1.0)), at_F = low + share.cwiseProduct(high - low);
      const Vector3 p_W = X_WF * Vector3(at_F.x(), at_F.y(), 0.0);
      const GroundPoint ground = GroundAt(plan_.terrain, p_W.head<2>());
      if (ground.patch != foothold.patch) continue;
      normal_W += ground.normal_W;
      least = std::min(least, p_W.z() - ground.height_m);
    }
  }
  if (of_foot.sole_F.empty()) {
    const Vector3& p_WF = X_WF.translation();
    const GroundPoint ground = GroundAt(plan_.terrain, p_WF.head<2>());
    least = ground.patch == foothold.patch ? p_WF.z() - ground.height_m : std::numeric_limits<double>::infinity();
  }
  const double limit = of_foot.sole_F.empty() ? kPosition : kOnField;
  Expect(foot + " foothold off its patch", foothold.touchdown_s, std::abs(least), limit, "m");
  Expect(foot + " foothold tilted from its patch", foothold.touchdown_s,
         normal_W.normalized().cross(X_WF.linear().col(2)).norm(), kFieldTilt, "rad");
}

void Auditor::CheckFootholds() {
  const int feet = static_cast<int>(model_.feet.size());
  for (int f = 0; f < feet; ++f) {
    const auto intervals = IntervalsOf(plan_.schedule, f);
    std::size_t i = 0;
    for (const Foothold& foothold : plan_.footsteps.footholds) {
      if (foothold.foot != f) continue;
      if (i < intervals.size()) CheckFoothold(foothold, intervals[i]);
      ++i;
    }
    if (i != intervals.size()) {
      findings_.Note(Law::kConsistency, FootName(f) + " number of footholds", plan_.schedule.start_s(),
                     static_cast<double>(i), static_cast<double>(intervals.size()), "1");
    }
  }
  for (const Foothold& foothold : plan_.footsteps.footholds) {
    if (foothold.foot < 0 || foothold.foot >= feet)
      findings_.Note(Law::kConsistency, "foothold of an unknown foot", foothold.touchdown_s, foothold.foot, feet - 1.0,
                     "1");
  }
}

}  // namespace gaitwright
