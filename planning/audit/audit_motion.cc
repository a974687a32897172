// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "kinematics/model/leg_plane.h"
#include "kinematics/spatial/rotation.h"
#include "planning/audit/auditor.h"
#include "planning/audit/swing_depth.h"
#include "planning/audit/tolerances.h"
#include "planning/plan/heel_off_internal.h"

namespace gaitwright {

using namespace tolerance;

void Auditor::CheckStanceFeet(double time_s) {
  for (int f = 0; f < static_cast<int>(model_.feet.size()); ++f) {
    const auto i = static_cast<std::size_t>(f);
    if (!Contains(stance_, f)) continue;
    const int index = footing_[i].foothold;
    if (index < 0) continue;
    const Foothold& foothold = plan_.footsteps.footholds[static_cast<std::size_t>(index)];
    const Foot& foot = model_.feet[i];
    const Pose& X_WF = X_WF_[i];
    if (foot.radius > 0.0) {
      // The material point under a sphere must not move; the contact point moves as the sphere rolls.
      const Vector3 p_BQ = scratch_.R_WB[static_cast<std::size_t>(foot.body)].transpose() *
                           (X_WF.translation() - scratch_.p_WB[static_cast<std::size_t>(foot.body)]);
      if (foothold_[i] != index) {
        foothold_[i] = index;
        slip_W_[i].setZero();
        const double off = (X_WF.translation() - foothold.X_WF.translation()).norm();
        if (!(off <= kPosition))
          findings_.Note(Law::kConsistency, FootName(f) + " off its foothold", time_s, off, kPosition, "m");
      }
      slip_W_[i] += PointVelocity(scratch_, foot.body, p_BQ).head<3>() / options_.rate_hz;
      if (!(slip_W_[i].norm() <= kPosition))
        findings_.Note(Law::kConsistency, FootName(f) + " slides", time_s, slip_W_[i].norm(), kPosition, "m");
      continue;
    }
    if (foot.has_sole() && StandsOnEdge(foothold, time_s)) {
      CheckOnEdge(f, foothold, time_s);
      continue;
    }
    const double off = (X_WF.translation() - foothold.X_WF.translation()).norm();
    const double turned = RotationLog(X_WF.linear() * foothold.X_WF.linear().transpose()).norm();
    if (!(off <= kPosition))
      findings_.Note(Law::kConsistency, FootName(f) + " off its foothold", time_s, off, kPosition, "m");
    if (foot.type == FootType::kSole && !(turned <= kRotation)) {
      findings_.Note(Law::kConsistency, FootName(f) + " rotated from its foothold", time_s, turned, kRotation, "rad");
    }
  }
}

/// The edge stays in place, and the sole turns about nothing else.
void Auditor::CheckOnEdge(int foot, const Foothold& foothold, double time_s) {
  const auto i = static_cast<std::size_t>(foot);
  const EdgeTurn turn = EdgeTurnOf(model_.feet[i], foothold.X_WF, X_WF_[i]);
  if (!(turn.off_m <= kPosition))
    findings_.Note(Law::kConsistency, FootName(foot) + " front edge off its foothold", time_s, turn.off_m, kPosition,
                   "m");
  if (!(turn.turned_rad <= kRotation))
    findings_.Note(Law::kConsistency, FootName(foot) + " rotated from its front edge", time_s, turn.turned_rad,
                   kRotation, "rad");
}

/// Depth allowed by SwingDepth, from the footholds before and after the swing.
double Auditor::DepthLetPass(int foot, double time_s) const {
  if (Contains(stance_, foot)) return kPosition;
  const auto& all = plan_.footsteps.footholds;
  const int from = footing_[static_cast<std::size_t>(foot)].foothold;
  if (from < 0) return kTouching;
  const auto next = std::find_if(all.begin() + from + 1, all.end(), [&](const Foothold& f) { return f.foot == foot; });
  if (next == all.end()) return kTouching;
  const double start_s = all[static_cast<std::size_t>(from)].liftoff_s, duration = next->touchdown_s - start_s;
  return duration > 0.0 ? SwingDepth((time_s - start_s) / duration) : kTouching;
}

void Auditor::CheckFeetHeights(double time_s) {
  for (int f = 0; f < static_cast<int>(model_.feet.size()); ++f) {
    const auto i = static_cast<std::size_t>(f);
    const double limit = -DepthLetPass(f, time_s);
    limits_to_ground_.foot_m[i] = limit;
    const bool in_middle = !Contains(stance_, f) && InMiddle(f, time_s, false);
    for (const Vector3& p : ContactPoints(model_.feet[i], X_WF_[i])) {
      CheckHeight(FootName(f), p, limit, time_s);
      if (!in_middle) continue;
      const double height = p.z() - GroundAt(plan_.terrain, p.head<2>()).height_m;
      findings_.Near(places_.swing[i], time_s, height, 0.0, height);
    }
  }
}

/// A point is under the ground if it is lower than the surface above it and deeper than allowed in every lateral
/// direction, too. The edge of a sole may touch the riser of a step.
void Auditor::CheckHeight(const std::string& where, const Vector3& p_W, double limit, double time_s) {
  const GroundPoint ground = GroundAt(plan_.terrain, p_W.head<2>());
  const double height = p_W.z() - ground.height_m;
  if (ground.patch < 0 || height >= limit) return;
  if (height > -kSolidDepth && watch_.PointDistance(p_W) >= limit) return;
  findings_.Note(Law::kFootClearance, where, time_s, height, limit, "m");
}

void Auditor::CheckBodies(double time_s) {
  for (const Overlap& overlap : collision_.Overlaps(scratch_)) {
    findings_.Note(Law::kSelfCollision, overlap.link_a + " and " + overlap.link_b, time_s, overlap.depth_m, 0.0, "m");
  }
}

/// Call after CheckFeetHeights, which sets the allowed distances of the feet.
void Auditor::CheckSolids(double time_s) {
  for (const GroundHit& hit : watch_.Look(scratch_, limits_to_ground_)) {
    if (hit.foot < 0) {
      findings_.Note(Law::kBodyClearance, *hit.link, time_s, hit.distance_m, limits_to_ground_.body_m, "m");
    } else {
      const double limit = limits_to_ground_.foot_m[static_cast<std::size_t>(hit.foot)];
      findings_.Note(Law::kFootClearance, FootName(hit.foot), time_s, hit.distance_m, limit, "m");
    }
  }
}

/// Updates the smallest distances between links, and between the ground's solids and all links but the feet. Only
/// distances smaller than those found so far are computed.
void Auditor::NearestOfAll(double time_s) {
  constexpr double kFarthest = 0.2;  // [m] limit of the search
  const Overlap pair = collision_.Nearest(scratch_, std::min(findings_.RoomOf(places_.self), kFarthest));
  if (!pair.link_a.empty()) {
    findings_.Near(places_.self, time_s, -pair.depth_m, 0.0, -pair.depth_m);
    findings_.Rename(places_.self, pair.link_a + " and " + pair.link_b);
  }
  GroundLimits limits = limits_to_ground_;
  limits.body_m = std::min(findings_.RoomOf(places_.body), kFarthest);
  for (const GroundHit& hit : watch_.Look(scratch_, limits)) {
    if (hit.foot >= 0 || hit.distance_m >= findings_.RoomOf(places_.body)) continue;
    findings_.Near(places_.body, time_s, hit.distance_m, 0.0, hit.distance_m);
    findings_.Rename(places_.body, *hit.link);
  }
}

void Auditor::CheckReach(double time_s) {
  for (int f = 0; f < static_cast<int>(model_.legs.size()); ++f) {
    if (!Contains(stance_, f)) continue;
    const int index = FootholdAt(plan_.footsteps, f, time_s);
    if (index < 0) continue;
    const Leg& leg = model_.legs[static_cast<std::size_t>(f)];
    const Foot& foot = model_.feet[static_cast<std::size_t>(f)];
    const double length = StraightLength(model_, leg, 0, foot.X_BF.translation()) + foot.radius;
    const Foothold& foothold = plan_.footsteps.footholds[static_cast<std::size_t>(index)];
    const Vector3 hip = scratch_.p_WB[static_cast<std::size_t>(leg.joints.front() + 1)];
    const bool turns = foot.has_sole() && StandsOnEdge(foothold, time_s);
    const Pose& X_WF = turns ? X_WF_[static_cast<std::size_t>(f)] : foothold.X_WF;
    const double distance = (X_WF.translation() - hip).norm();
    findings_.Hold(places_.reach[static_cast<std::size_t>(f)], time_s, distance, length, length - distance, kPosition);
  }
}

}  // namespace gaitwright
