// SPDX-License-Identifier: BSD-3-Clause
#include "planning/footsteps/uneven_footsteps.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "kinematics/ik/leg_workspace.h"
#include "kinematics/spatial/rotation.h"
#include "planning/footsteps/base_over_feet.h"
#include "planning/footsteps/search_beside_goal.h"
#include "planning/footsteps/stance_check.h"
#include "planning/gait/schedule_contacts.h"
#include "planning/paths/standing_feet.h"

namespace gaitwright {
namespace {

/// Mean distance of the standing feet from the base's axis: motion of the feet per radian of turning.
double TurnRadius(const RobotModel& model) {
  double sum = 0.0;
  const std::vector<Pose> standing = StandingFeet(model);
  for (const Pose& X_BF : standing) sum += X_BF.translation().head<2>().norm();
  return sum / static_cast<double>(standing.size());
}

/// Monotone cubic (PCHIP) through knots in time of heights or another quantity: at rest at both ends, without
/// overshoot. Fritsch and Butland, SIAM J. Sci. Stat. Comput. 5(2), 1984.
class SmoothRoute {
 public:
  SmoothRoute(std::vector<double> time_s, std::vector<double> value)
      : time_s_(std::move(time_s)), value_(std::move(value)), slope_(value_.size(), 0.0) {
    for (std::size_t k = 1; k + 1 < value_.size(); ++k) {
      const double before = Slope(k - 1), after = Slope(k);
      if (before * after <= 0.0) continue;
      const double h0 = time_s_[k] - time_s_[k - 1], h1 = time_s_[k + 1] - time_s_[k];
      slope_[k] = 3.0 * (h0 + h1) / ((2.0 * h1 + h0) / before + (h1 + 2.0 * h0) / after);
    }
  }

  double At(double t) const {
    if (t <= time_s_.front()) return value_.front();
    if (t >= time_s_.back()) return value_.back();
    const auto k = static_cast<std::size_t>(std::upper_bound(time_s_.begin(), time_s_.end(), t) - time_s_.begin()) - 1;
    const double h = time_s_[k + 1] - time_s_[k], u = (t - time_s_[k]) / h, w = 1.0 - u;
    return w * w * (1.0 + 2.0 * u) * value_[k] + u * u * (1.0 + 2.0 * w) * value_[k + 1] +
           h * u * w * (w * slope_[k] - u * slope_[k + 1]);
  }

 private:
  double Slope(std::size_t k) const { return (value_[k + 1] - value_[k]) / (time_s_[k + 1] - time_s_[k]); }

  std::vector<double> time_s_, value_, slope_;
};

/// Swings of a schedule, assigned to the groups of a sequence.
struct GroupTimes {
  std::vector<double> liftoff_s, touchdown_s;
};

/// Puts the footholds of a sequence into the intervals of the schedule. Returns the swing times of the groups.
GroupTimes PutFootholds(const FootstepSequence& sequence, const ContactSchedule& schedule, FootstepPlan& plan) {
  std::vector<std::vector<ContactInterval>> intervals;
  std::vector<std::size_t> next(sequence.start.size(), 1);
  const auto put = [&](const PlacedFoot& placed, const ContactInterval& stance) {
    plan.footholds.push_back({placed.foot, placed.X_WF, Vector3::Zero(), placed.surface, stance.start_s, stance.end_s});
  };
  for (const PlacedFoot& placed : sequence.start) {
    intervals.push_back(IntervalsOf(schedule, placed.foot));
    put(placed, intervals.back().front());
  }
  GroupTimes times;
  for (const Footfalls& step : sequence.steps) {
    double liftoff = schedule.end_s(), touchdown = schedule.start_s();
    for (const PlacedFoot& placed : step) {
      const auto foot = static_cast<std::size_t>(placed.foot);
      const std::size_t k = next[foot]++;
      put(placed, intervals[foot][k]);
      liftoff = std::min(liftoff, intervals[foot][k - 1].end_s);
      touchdown = std::max(touchdown, intervals[foot][k].start_s);
    }
    times.liftoff_s.push_back(liftoff);
    times.touchdown_s.push_back(touchdown);
  }
  SortFootholds(plan);
  return times;
}

BasePath PathOver(const RobotModel& model, const FootstepSequence& sequence, const GroupTimes& times, double end_s) {
  const std::vector<Pose> standing = StandingFeet(model);
  std::vector<Pose> feet;
  for (const PlacedFoot& placed : sequence.start) feet.push_back(placed.X_WF);
  std::vector<double> time, x, y, yaw;
  const auto knot = [&](double t) {
    const PlanarPose base = FitBase(standing, feet, MeanHeading(standing, feet)).plan;
    time.push_back(t);
    x.push_back(base.x_m);
    y.push_back(base.y_m);
    yaw.push_back(yaw.empty() ? base.yaw_rad : yaw.back() + WrapAngle(base.yaw_rad - yaw.back()));
  };
  knot(times.liftoff_s.front());
  for (std::size_t k = 0; k < sequence.steps.size(); ++k) {
    for (const PlacedFoot& placed : sequence.steps[k]) feet[static_cast<std::size_t>(placed.foot)] = placed.X_WF;
    const bool last = k + 1 == sequence.steps.size();
    knot(last ? times.touchdown_s[k] : 0.5 * (times.touchdown_s[k] + times.liftoff_s[k + 1]));
  }
  const SmoothRoute x_at(time, x), y_at(time, y), yaw_at(time, yaw);
  constexpr double kStep = 0.01;
  const int samples = 1 + static_cast<int>(std::ceil(end_s / kStep - 1e-9));
  BasePath path;
  for (int k = 0; k < samples; ++k) {
    const double t = std::min(k * kStep, end_s);
    path.time_s.push_back(t);
    path.pose.push_back({x_at.At(t), y_at.At(t), yaw_at.At(t)});
  }
  return path;
}

}  // namespace

int StepsOfBase(const Gait& gait, int footfalls) {
  const std::vector<std::vector<int>> groups = FootGroups(gait);
  int counted = 0, last = 0;
  for (std::size_t k = 0; counted < footfalls; ++k) {
    last = static_cast<int>(groups[k % groups.size()].size());
    counted += last;
  }
  return footfalls - gait.num_feet() + last;
}

int LeastStrides(double stride_m, const WalkCommand& command) {
  constexpr double kRounding = 1e-9, kMostStrides = 10000.0;
  using Extent = WalkCommand::Extent;
  const bool own_pace = command.speed_m_s == 0.0 && command.lateral_speed_m_s == 0.0 && command.yaw_rate_rad_s == 0.0;
  const bool goal = command.extent == Extent::kGoal && command.steps == 0;
  const double distance_m = goal ? std::hypot(command.goal_x_m, command.goal_y_m) : command.distance_m;
  const bool far =
      goal ? distance_m > 0.0 || command.goal_yaw_rad != 0.0 : command.extent == Extent::kDistance && distance_m > 0.0;
  if (!(stride_m > 0.0) || !own_pace || !far) return 0;
  return std::max(1, static_cast<int>(std::ceil(std::min(distance_m / stride_m, kMostStrides) - kRounding)));
}

WalkCommand CountedInStrides(const Gait& gait, int strides, const WalkCommand& command) {
  WalkCommand counted = command;
  counted.steps = gait.num_feet() * strides;
  const int steps = StepsOfBase(gait, counted.steps);
  if (steps < 1) return command;
  if (command.extent == WalkCommand::Extent::kGoal) return counted;
  counted.extent = WalkCommand::Extent::kSteps;
  counted.step_length_m = command.distance_m / steps;
  return counted;
}

Result<FootstepQuery> CourseQuery(const RobotModel& model, const Gait& gait, const WalkCommand& command,
                                  const FootstepOptions& options) {
  const Result<Course> course = MakeCourse(model, gait, command, options.ramp);
  if (!course) return course.failure();
  PlanarTwist twist = course->twist;
  double cycles = (course->duration_s - course->ramp_s) / gait.cycle_s;
  if (IsCounted(command)) {
    const int steps = StepsOfBase(gait, command.steps);
    if (steps < 1) {
      return Failure{FailureKind::kBadInput,
                     FailureCode::kCommand,
                     "PlanFootsteps",
                     fmt::format("the number of footfalls is {}; a robot with {} feet needs {} or more, because each "
                                 "foot ends with one that brings it to its standing place",
                                 command.steps, gait.num_feet(), gait.num_feet()),
                     {}};
    }
    twist = {steps * twist.x_m, steps * twist.y_m, steps * twist.yaw_rad};
    cycles = static_cast<double>(steps) / gait.num_feet();
  }
  FootstepQuery query{gait, RouteAlong(twist, TurnRadius(model)), 0.0};
  query.stride_m = query.route.length_m() / cycles;
  return query;
}

namespace {

/// Options of one search.
struct FootstepTry {
  FootstepSearchOptions search;
  FootholdOptions foothold;
};

/// In order: with `easy_sway`, so that ankles get more room; with `sway`; up to the limits of the joints, where ankles
/// of soles run out of range on steps down; and with heels that rise, first away from risers, which swings go around.
std::vector<FootstepTry> TriesOf(const RobotModel& model, const FootstepOptions& options) {
  constexpr double kFromRisers = 0.03;  // of the leg length
  FootstepSearchOptions asked = options.search;
  if (asked.workspaces == nullptr) asked.workspaces = std::make_shared<LegWorkspaces>();
  const double heel_off_rad = asked.heel_off_rad;
  asked.heel_off_rad = 0.0;
  FootstepSearchOptions easy = asked, full = asked, raised = asked;
  easy.sway = std::max(asked.sway, asked.easy_sway);
  full.reserve = 0.0;
  std::vector<FootstepTry> tries = {{easy, options.foothold}, {asked, options.foothold}, {full, options.foothold}};
  if (heel_off_rad == 0.0) return tries;
  raised.heel_off_rad = heel_off_rad;
  FootholdOptions away = options.foothold;
  away.margin_m = std::max(away.margin_m, kFromRisers * model.leg_length_m());
  tries.push_back({raised, away});
  tries.push_back({raised, options.foothold});
  return tries;
}

/// The first result of TriesOf. @param search  SearchFootsteps or SearchBesideGoal
template <class Search>
Result<FootstepSequence> SearchAtEase(const RobotModel& model, const Terrain& terrain, const FootstepQuery& query,
                                      const FootstepOptions& options, Search search) {
  if (LoneSoles(model, query.gait).empty()) return search(model, terrain, query, options.foothold, options.search);
  const std::vector<FootstepTry> tries = TriesOf(model, options);
  Result<FootstepSequence> sequence = search(model, terrain, query, tries[0].foothold, tries[0].search);
  for (std::size_t i = 1; i < tries.size() && !sequence; ++i)
    sequence = search(model, terrain, query, tries[i].foothold, tries[i].search);
  return sequence;
}

bool IsStraight(const FootstepRoute& route) {
  constexpr double kSame = 1e-6;  // [m], [rad]
  const PlanarPose &from = route.pose.front(), &to = route.pose.back();
  return std::abs(std::hypot(to.x_m - from.x_m, to.y_m - from.y_m) - route.length_m()) < kSame &&
         std::abs(WrapAngle(to.yaw_rad - from.yaw_rad)) < kSame;
}

/// Moves the goal to the end of the path, beside which it lies, and adds a warning.
void MoveGoal(const FootstepRoute& route, FootstepSkeleton& skeleton) {
  const PlanarPose &from = route.pose.front(), &asked = route.pose.back(), &end = skeleton.path.pose.back();
  const Vector2 along = Vector2(asked.x_m - from.x_m, asked.y_m - from.y_m).normalized();
  const double reached_m = along.dot(Vector2(end.x_m - from.x_m, end.y_m - from.y_m));
  skeleton.goal = {from.x_m + reached_m * along.x(), from.y_m + reached_m * along.y(), asked.yaw_rad};
  skeleton.warnings.push_back(
      fmt::format("the path ends after {:.3f} m instead of {:.3f} m, because the ground nearer to its end is too rough "
                  "for the feet",
                  reached_m, route.length_m()));
}

}  // namespace

Result<FootstepSkeleton> SearchSkeleton(const RobotModel& model, const Terrain& terrain, const FootstepQuery& query,
                                        const FootstepOptions& options) {
  Result<FootstepSequence> sequence = SearchAtEase(model, terrain, query, options, SearchFootsteps);
  const bool at_goal = sequence.ok();
  if (!at_goal && !terrain.height_fields.empty() && IsStraight(query.route)) {
    if (auto beside = SearchAtEase(model, terrain, query, options, SearchBesideGoal)) sequence = *beside;
  }
  if (!sequence) return sequence.failure();
  ScheduleRequest request;
  request.initial_stand_s = options.initial_stand_s + options.settling_s;
  request.final_stand_s = options.final_stand_s + options.settling_s;
  request.grid_s = options.grid_s;
  for (const Footfalls& step : sequence->steps) request.footfalls += static_cast<int>(step.size());
  request.first_foot = sequence->steps.front().front().foot;
  Result<ContactSchedule> schedule = ScheduleContacts(query.gait, request);
  if (!schedule) return schedule.failure();
  FootstepSkeleton skeleton;
  skeleton.schedule = std::move(*schedule);
  const GroupTimes times = PutFootholds(*sequence, skeleton.schedule, skeleton.footsteps);
  skeleton.path = PathOver(model, *sequence, times, skeleton.schedule.end_s());
  skeleton.goal = query.route.pose.back();
  if (!at_goal) MoveGoal(query.route, skeleton);
  skeleton.search = sequence->stats;
  return skeleton;
}

}  // namespace gaitwright
