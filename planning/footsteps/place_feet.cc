// SPDX-License-Identifier: BSD-3-Clause
#include "planning/footsteps/place_feet.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "planning/paths/standing_feet.h"

namespace gaitwright {
namespace {

/// Components of a twist in which two feet are treated differently.
struct Sides {
  bool lateral = false, turn = false;
  bool any() const { return lateral || turn; }
};

/// Components in which a foot leads because it is on that side; none unless the robot has two feet.
Sides LedBy(const std::vector<Pose>& standing, std::size_t foot, const PlanarTwist& twist) {
  if (standing.size() != 2) return {};
  const double side = standing[foot].translation().y();
  return {side * twist.y_m > 0.0, side * twist.yaw_rad > 0.0};
}

/// `base` with the lateral position and the heading of `other`, if selected by `parts`.
PlanarPose WithParts(PlanarPose base, const PlanarPose& other, const Sides& parts) {
  if (parts.turn) base.yaw_rad = other.yaw_rad;
  if (parts.lateral) {
    const double s = std::sin(base.yaw_rad), c = std::cos(base.yaw_rad);
    const double lateral = -s * (other.x_m - base.x_m) + c * (other.y_m - base.y_m);
    base.x_m -= s * lateral;
    base.y_m += c * lateral;
  }
  return base;
}

void SortByTouchdown(FootstepPlan& plan) {
  std::stable_sort(plan.footholds.begin(), plan.footholds.end(),
                   [](const Foothold& a, const Foothold& b) { return a.touchdown_s < b.touchdown_s; });
}

/// A touchdown of a schedule and the stance that follows it.
struct Footfall {
  int foot = 0;
  ContactInterval stance;  // stance that begins with it
  double liftoff_s = 0.0;  // start of the swing before
  int count = 0;           // number from 1; feet that land together have the last number of them
  PlanarTwist base_steps;  // number of steps of the twist, by component
};

std::vector<Footfall> FootfallsOf(const ContactSchedule& schedule, int num_feet) {
  std::vector<Footfall> footfalls;
  for (int foot = 0; foot < num_feet; ++foot) {
    const auto intervals = IntervalsOf(schedule, foot);
    for (std::size_t i = 1; i < intervals.size(); ++i)
      footfalls.push_back({foot, intervals[i], intervals[i - 1].end_s, 0, {}});
  }
  std::stable_sort(footfalls.begin(), footfalls.end(),
                   [](const Footfall& a, const Footfall& b) { return a.liftoff_s < b.liftoff_s; });
  for (std::size_t k = footfalls.size(); k-- > 0;) {
    const bool together = k + 1 < footfalls.size() && footfalls[k].stance.start_s == footfalls[k + 1].stance.start_s;
    footfalls[k].count = together ? footfalls[k + 1].count : static_cast<int>(k) + 1;
  }
  return footfalls;
}

/// Number of steps that the last footfalls of all feet can reach.
int StepsToGoal(const std::vector<Footfall>& footfalls, int num_feet) {
  double goal = std::numeric_limits<double>::infinity();
  for (int foot = 0; foot < num_feet; ++foot) {
    double last = 0.0;
    for (const Footfall& footfall : footfalls) {
      const PlanarTwist& counts = footfall.base_steps;
      if (footfall.foot == foot) last = std::min({counts.x_m, counts.y_m, counts.yaw_rad});
    }
    goal = std::min(goal, last);
  }
  return static_cast<int>(goal);
}

/// The stretch at a time.
const PathStretch& StretchAt(const std::vector<PathStretch>& stretches, double time_s) {
  const auto at = std::find_if(stretches.begin(), stretches.end(),
                               [&](const PathStretch& stretch) { return time_s < stretch.end_s; });
  return at == stretches.end() ? stretches.back() : *at;
}

/// Time in the middle of the standing part of a stance; negative if the stance has no such part.
double RestWithin(const std::vector<PathStretch>& stretches, const ContactInterval& stance) {
  for (const PathStretch& stretch : stretches) {
    const double middle = 0.5 * (stretch.start_s + stretch.end_s);
    if (stretch.stands && stance.start_s < middle && middle < stance.end_s) return middle;
  }
  return -1.0;
}

}  // namespace

FootstepPlan PlaceAlongPath(const RobotModel& model, const Gait& gait, const ContactSchedule& schedule,
                            const BasePath& path, const PlanarTwist& twist) {
  return PlaceAlongPath(model, schedule, path, {{schedule.start_s(), schedule.end_s(), false, gait.cycle_s, twist}});
}

FootstepPlan PlaceAlongPath(const RobotModel& model, const ContactSchedule& schedule, const BasePath& path,
                            const std::vector<PathStretch>& stretches) {
  const std::vector<Pose> standing = StandingFeet(model);
  FootstepPlan plan;
  for (std::size_t f = 0; f < standing.size(); ++f) {
    const auto intervals = IntervalsOf(schedule, static_cast<int>(f));
    for (std::size_t i = 0; i < intervals.size(); ++i) {
      const double middle = 0.5 * (intervals[i].start_s + intervals[i].end_s);
      const PathStretch& stretch = StretchAt(stretches, middle);
      const Sides led = LedBy(standing, f, stretch.twist);
      PlanarPose base = WithParts(PoseAt(path, middle), PoseAt(path, middle + 0.5 * stretch.cycle_s), led);
      if (const double rest_s = RestWithin(stretches, intervals[i]); rest_s >= 0.0) base = PoseAt(path, rest_s);
      if (i + 1 == intervals.size()) base = path.pose.back();
      if (i == 0) base = path.pose.front();
      Foothold foothold;
      foothold.foot = static_cast<int>(f);
      foothold.touchdown_s = intervals[i].start_s;
      foothold.liftoff_s = intervals[i].end_s;
      foothold.X_WF = Carried(base, standing[f]);
      plan.footholds.push_back(foothold);
    }
  }
  SortByTouchdown(plan);
  return plan;
}

CountedFootsteps PlaceCounted(const RobotModel& model, const ContactSchedule& schedule, const PlanarTwist& step) {
  const std::vector<Pose> standing = StandingFeet(model);
  const int num_feet = static_cast<int>(standing.size());
  std::vector<Footfall> footfalls = FootfallsOf(schedule, num_feet);
  for (Footfall& footfall : footfalls) {
    // The foot on the side opposite to the motion lags.
    const Sides lags = LedBy(standing, static_cast<std::size_t>(footfall.foot), {0.0, -step.y_m, -step.yaw_rad});
    const double count = footfall.count;
    footfall.base_steps = {count, count - (lags.lateral ? 1.0 : 0.0), count - (lags.turn ? 1.0 : 0.0)};
  }
  CountedFootsteps counted;
  counted.steps_to_goal = StepsToGoal(footfalls, num_feet);
  const double goal = counted.steps_to_goal;
  for (int foot = 0; foot < num_feet; ++foot) {
    const ContactInterval first = IntervalsOf(schedule, foot).front();
    footfalls.push_back({foot, first, first.start_s, 0, {}});
  }
  for (const Footfall& footfall : footfalls) {
    const PlanarTwist& counts = footfall.base_steps;
    const auto at = [&](double steps) { return PoseAlong(step, std::min(steps, goal)); };
    PlanarPose base = WithParts(at(counts.x_m), at(counts.y_m), {true, false});
    base.yaw_rad = at(counts.yaw_rad).yaw_rad;
    const Pose X_WF = Carried(base, standing[static_cast<std::size_t>(footfall.foot)]);
    counted.footsteps.footholds.push_back(
        {footfall.foot, X_WF, Vector3::Zero(), 0, footfall.stance.start_s, footfall.stance.end_s});
  }
  std::stable_sort(counted.footsteps.footholds.begin(), counted.footsteps.footholds.end(),
                   [](const Foothold& a, const Foothold& b) { return a.foot < b.foot; });
  SortByTouchdown(counted.footsteps);
  return counted;
}

int LeadingFoot(const RobotModel& model, const PlanarTwist& twist) {
  const std::vector<Pose> standing = StandingFeet(model);
  for (std::size_t f = 0; f < standing.size(); ++f) {
    const Sides led = LedBy(standing, f, twist);
    if (led.lateral || (led.turn && twist.y_m == 0.0)) return static_cast<int>(f);
  }
  return -1;
}

}  // namespace gaitwright
