// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/exchange/foot_track.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "kinematics/base/non_finite.h"
#include "kinematics/dynamics/dynamics.h"
#include "kinematics/dynamics/foot_contact.h"
#include "kinematics/spatial/rotation.h"
#include "kinematics/trajectory/fit_detour.h"
#include "planning/plan/sample_plan.h"
#include "workflows/exchange/median_internal.h"

namespace gaitwright {
namespace {

std::size_t At(int i) { return static_cast<std::size_t>(i); }

/// Current speed of the point of a body at p_WQ.
double SpeedOf(const DynamicsScratch& scratch, int body, const Vector3& p_WQ) {
  const Vector3 p_BQ = scratch.R_WB[At(body)].transpose() * (p_WQ - scratch.p_WB[At(body)]);
  return PointVelocity(scratch, body, p_BQ).head<3>().norm();
}

/// Whether a foot is low and slow, by row; contacts and gaps that are too short are removed.
std::vector<bool> LowAndSlow(const FootTrack& foot, double height_m, double speed_m_s, int least_rows) {
  std::vector<bool> stands;
  for (std::size_t k = 0; k < foot.height_m.size(); ++k)
    stands.push_back(foot.height_m[k] <= height_m && foot.speed_m_s[k] <= speed_m_s);
  for (const bool brief : {false, true}) {  // gaps first, then contacts
    for (std::size_t begin = 0; begin < stands.size();) {
      std::size_t end = begin;
      while (end < stands.size() && stands[end] == stands[begin]) ++end;
      const bool inner = begin > 0 && end < stands.size();
      if (inner && stands[begin] == brief && end - begin < static_cast<std::size_t>(least_rows))
        std::fill(stands.begin() + static_cast<std::ptrdiff_t>(begin),
                  stands.begin() + static_cast<std::ptrdiff_t>(end), !brief);
      begin = end;
    }
  }
  return stands;
}

/// The intervals of stance; a stance that begins in the last row is left out.
std::vector<ContactInterval> IntervalsOfRows(const std::vector<bool>& stands, const EvenMotion& motion) {
  std::vector<ContactInterval> intervals;
  const int last = motion.size() - 1;
  for (int begin = 0; begin < last;) {
    int end = begin;
    while (end < last && stands[At(end)] == stands[At(begin)]) ++end;
    if (stands[At(begin)]) intervals.push_back({motion.TimeOf(begin), motion.TimeOf(end)});
    begin = end;
  }
  return intervals;
}

/// Component-wise median of the position of a foot's contact frame over some rows, minus its rolling since the first
/// row.
Vector3 MedianPlace(const FootTrack& foot, int first, int last) {
  Vector3 place;
  for (int i = 0; i < 3; ++i) {
    std::vector<double> values;
    for (int k = first; k <= last; ++k)
      values.push_back((foot.X_WF[At(k)].translation() - foot.rolled_W[At(k)] + foot.rolled_W[At(first)])[i]);
    place[i] = MedianOf(std::move(values));
  }
  return place;
}

/// First and last row of a stance.
struct StanceRows {
  int first = 0, last = 0;
};

/// Leaves out rows at both ends of a stance in which the foot is not at its median height, because it moves up or down,
/// faster than a speed.
StanceRows TrimmedStance(const FootTrack& foot, double most_m, double slow_m_s, int last_row,
                         const StanceRows& stance) {
  const std::vector<double> heights(foot.height_m.begin() + stance.first, foot.height_m.begin() + stance.last + 1);
  const double usual_m = MedianOf(heights);
  const auto away = [&](int k) {
    return std::abs(foot.height_m[At(k)] - usual_m) > most_m && foot.speed_m_s[At(k)] >= slow_m_s;
  };
  StanceRows trimmed = stance;
  while (trimmed.first > 0 && trimmed.first < trimmed.last && away(trimmed.first)) ++trimmed.first;
  while (trimmed.last < last_row && trimmed.last > trimmed.first && away(trimmed.last)) --trimmed.last;
  return trimmed.last - trimmed.first < 2 ? stance : trimmed;
}

/// Median deviation of the heights of a stance from their median [m].
double UnrestOf(const FootTrack& foot, const StanceRows& stance) {
  std::vector<double> heights(foot.height_m.begin() + stance.first, foot.height_m.begin() + stance.last + 1);
  const double usual_m = MedianOf(heights);
  for (double& height_m : heights) height_m = std::abs(height_m - usual_m);
  return MedianOf(std::move(heights));
}

/// Trims stances as closely as their heights are constant, so that swings begin and end at rest. A stance keeps the
/// rows of an end in which no other foot would stand: its foot carries the robot then.
/// @param speed_m_s  root of g times the leg length.
std::vector<std::vector<StanceRows>> CloselyTrimmed(const std::vector<FootTrack>& feet,
                                                    const std::vector<std::vector<StanceRows>>& stances, double most_m,
                                                    double speed_m_s, int last_row) {
  constexpr double kLeastOfMost = 0.02, kDeviations = 4.0, kSlow = 0.01;
  std::vector<std::vector<StanceRows>> close = stances;
  for (std::size_t f = 0; f < feet.size(); ++f) {
    for (StanceRows& stance : close[f]) {
      const double deviation_m = std::clamp(kDeviations * UnrestOf(feet[f], stance), kLeastOfMost * most_m, most_m);
      stance = TrimmedStance(feet[f], deviation_m, kSlow * speed_m_s, last_row, stance);
    }
  }
  const auto others_stand = [&](std::size_t foot, int begin, int end) {
    for (int k = begin; k < end; ++k) {
      bool stands = false;
      for (std::size_t f = 0; f < feet.size(); ++f) {
        for (const StanceRows& stance : close[f]) stands |= f != foot && stance.first <= k && k <= stance.last;
      }
      if (!stands) return false;
    }
    return true;
  };
  std::vector<std::vector<StanceRows>> kept = close;
  for (std::size_t f = 0; f < feet.size(); ++f) {
    for (std::size_t i = 0; i < stances[f].size(); ++i) {
      if (!others_stand(f, stances[f][i].first, close[f][i].first)) kept[f][i].first = stances[f][i].first;
      if (!others_stand(f, close[f][i].last + 1, stances[f][i].last + 1)) kept[f][i].last = stances[f][i].last;
    }
  }
  return kept;
}

int RowOf(const EvenMotion& motion, double time_s) {
  return std::clamp(static_cast<int>(std::lround(time_s / motion.step_s)), 0, motion.size() - 1);
}

}  // namespace

std::vector<FootTrack> FeetOf(const RobotModel& model, const Terrain& terrain, const EvenMotion& motion) {
  std::vector<FootTrack> feet(model.feet.size());
  DynamicsScratch scratch(model);
  for (int k = 0; k < motion.size(); ++k) {
    ForwardVelocities(model, motion.q[At(k)], motion.v[At(k)], scratch);
    for (std::size_t f = 0; f < feet.size(); ++f) {
      const Foot& foot = model.feet[f];
      const Pose middle = FramePose(scratch, foot.body, foot.X_BF);
      const GroundPoint ground = GroundAt(terrain, middle.translation().head<2>());
      const Pose X_WF = ContactFrame(model, scratch, static_cast<int>(f), ground.normal_W);
      double height = kInfinity, speed = 0.0;
      for (const Vector3& p : ContactPoints(foot, X_WF)) {
        const GroundPoint under = GroundAt(terrain, p.head<2>());
        if (under.patch >= 0) height = std::min(height, p.z() - under.height_m);
        speed = std::max(speed, SpeedOf(scratch, foot.body, p));
      }
      Vector3 rolled = Vector3::Zero();
      if (k > 0) {
        const Vector3 turn = RotationLog(X_WF.linear() * feet[f].X_WF.back().linear().transpose());
        rolled = feet[f].rolled_W.back() + foot.radius * turn.cross(ground.normal_W);
      }
      feet[f].X_WF.push_back(X_WF);
      feet[f].height_m.push_back(height);
      feet[f].speed_m_s.push_back(speed);
      feet[f].rolled_W.push_back(rolled);
    }
  }
  return feet;
}

ContactSchedule ScheduleOf(const RobotModel& model, const EvenMotion& motion, const std::vector<FootTrack>& feet,
                           const ImportOptions& options, std::vector<DerivedPart>& derived) {
  constexpr double kStill = 1e-3;  // share of the leg length
  const double height_m = options.contact_height * model.leg_length_m();
  const double speed_m_s = options.contact_speed * std::sqrt(kGravity * model.leg_length_m());
  const int least_rows = static_cast<int>(std::ceil(options.contact_least_s / motion.step_s));
  std::vector<std::vector<ContactInterval>> by_foot;
  std::vector<std::vector<StanceRows>> rows(feet.size());
  for (std::size_t f = 0; f < feet.size(); ++f) {
    std::vector<bool> stands;
    for (const FootSet set : motion.contact) stands.push_back(Contains(set, static_cast<int>(f)));
    if (motion.contact.empty()) stands = LowAndSlow(feet[f], height_m, speed_m_s, least_rows);
    by_foot.push_back(IntervalsOfRows(stands, motion));
    for (const ContactInterval& interval : by_foot.back()) {
      const StanceRows stance{RowOf(motion, interval.start_s), RowOf(motion, interval.end_s)};
      rows[f].push_back(TrimmedStance(feet[f], kStill * model.leg_length_m(), 0.0, motion.size() - 1, stance));
    }
    if (!by_foot.back().empty()) continue;
    const double lowest = *std::min_element(feet[f].height_m.begin(), feet[f].height_m.end());
    const double slowest = *std::min_element(feet[f].speed_m_s.begin(), feet[f].speed_m_s.end());
    throw InvalidArgument(fmt::format(
        "foot '{}' is never in stance: {}its smallest height is {:.4f} m and its smallest speed {:.3f} m/s; a stance "
        "foot is at most {:.4f} m high (contact_height) and {:.3f} m/s fast (contact_speed)",
        model.feet[f].name, motion.contact.empty() ? "" : "by its column; ", lowest, slowest, height_m, speed_m_s));
  }
  if (motion.contact.empty()) {
    rows = CloselyTrimmed(feet, rows, kStill * model.leg_length_m(), std::sqrt(kGravity * model.leg_length_m()),
                          motion.size() - 1);
    for (std::size_t f = 0; f < feet.size(); ++f) {
      for (std::size_t i = 0; i < rows[f].size(); ++i)
        by_foot[f][i] = {motion.TimeOf(rows[f][i].first), motion.TimeOf(rows[f][i].last)};
    }
    derived.push_back({"contacts", fmt::format("feet up to {:.1f} mm above the ground and up to {:.3f} m/s fast count "
                                               "as stance, while their height stays within {:.1f} mm",
                                               1e3 * height_m, speed_m_s, 1e3 * kStill * model.leg_length_m())});
  }
  return ScheduleFromIntervals(by_foot, 0.0, motion.TimeOf(motion.size() - 1));
}

FootstepPlan FootholdsOf(const RobotModel& model, const Terrain& terrain, const ContactSchedule& schedule,
                         const EvenMotion& motion, const std::vector<FootTrack>& feet) {
  FootstepPlan plan;
  for (std::size_t f = 0; f < feet.size(); ++f) {
    for (const ContactInterval& interval : IntervalsOf(schedule, static_cast<int>(f))) {
      const int first = RowOf(motion, interval.start_s), last = RowOf(motion, interval.end_s);
      const Vector3& rolled = feet[f].rolled_W[At(first)];
      const Vector3 place = MedianPlace(feet[f], first, last);
      const GroundPoint ground = GroundAt(terrain, place.head<2>());
      if (ground.patch < 0) {
        throw InvalidArgument(
            fmt::format("foot '{}' stands at {:.3f} s at x = {:.3f} m, y = {:.3f} m, where there is "
                        "no ground",
                        model.feet[f].name, interval.start_s, place.x(), place.y()));
      }
      Foothold foothold;
      foothold.foot = static_cast<int>(f);
      const Matrix3& R = feet[f].X_WF[At((first + last) / 2)].linear();
      foothold.X_WF.linear() = RotationBetween(R.col(2), ground.normal_W).toRotationMatrix() * R;
      // Project along the normal onto the surface.
      const double above = (place.z() - ground.height_m) * ground.normal_W.z();
      foothold.X_WF.translation() = place - above * ground.normal_W;
      foothold.roll_W = feet[f].rolled_W[At(last)] - rolled;
      foothold.patch = ground.patch;
      foothold.touchdown_s = interval.start_s;
      foothold.liftoff_s = interval.end_s;
      plan.footholds.push_back(foothold);
    }
  }
  SortFootholds(plan);
  return plan;
}

SwingTrajectory SwingOf(const Foothold& from, const Foothold& to, const EvenMotion& motion, const FootTrack& foot,
                        double& farthest_m) {
  constexpr int kMostPoints = 20;
  SwingTrajectory swing;
  swing.foot = from.foot;
  swing.start_s = from.liftoff_s;
  swing.end_s = to.touchdown_s;
  swing.X_WF_start = from.X_WF;
  swing.X_WF_start.translation() += from.roll_W;
  swing.X_WF_end = to.X_WF;
  const int first = RowOf(motion, swing.start_s), last = RowOf(motion, swing.end_s), rows = last - first + 1;
  const int points = std::clamp(rows / 2, 1, kMostPoints);
  // The path without the rolling of the foot, minus the straight motion.
  SwingCurve straight = CurveOf(swing);  // gets the detour below
  straight.X_WF_end.translation() -= foot.rolled_W[At(last)] - foot.rolled_W[At(first)];
  std::vector<double> shares;
  std::vector<Vector3> path_W, off_W;
  for (int k = first; k <= last; ++k) {
    const double time_s = motion.TimeOf(k);
    shares.push_back((time_s - swing.start_s) / (swing.end_s - swing.start_s));
    path_W.emplace_back(foot.X_WF[At(k)].translation() - foot.rolled_W[At(k)] + foot.rolled_W[At(first)]);
    off_W.emplace_back(path_W.back() - Evaluate(straight, time_s).X_WF.translation());
  }
  straight.detour_W = swing.detour_W = FitDetour(shares, off_W, points);
  farthest_m = 0.0;
  for (int k = first; k <= last; ++k) {
    const Vector3 at_W = Evaluate(straight, motion.TimeOf(k)).X_WF.translation();
    farthest_m = std::max(farthest_m, (path_W[At(k - first)] - at_W).norm());
  }
  swing.lift_m = LiftAtHalfTime(CurveOf(swing));
  swing.clearance_m = kInfinity;
  for (int i = rows / 3; i <= 2 * rows / 3 && i < rows; ++i)
    swing.clearance_m = std::min(swing.clearance_m, foot.height_m[At(first + i)]);
  if (!std::isfinite(swing.clearance_m)) swing.clearance_m = 0.0;
  return swing;
}

}  // namespace gaitwright
