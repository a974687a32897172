// SPDX-License-Identifier: BSD-3-Clause
#include "planning/footsteps/plan_sequence.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "planning/footsteps/place_feet.h"
#include "planning/footsteps/uneven_footsteps.h"
#include "planning/gait/schedule_contacts.h"
#include "planning/paths/base_path.h"

namespace gaitwright {
namespace {

using Extent = WalkCommand::Extent;

Failure BadPart(const std::string& message) {
  return {FailureKind::kBadInput, FailureCode::kCommand, "PlanSequence", message, {}};
}

/// A part with its path, and its transition from the part before.
struct PartCourse {
  WalkPart part;
  bool stands = false;
  PlanarTwist twist;    // of the whole part
  double full_s = 0.0;  // duration at full speed
  double start_ramp_s = 0.0, stop_ramp_s = 0.0;
  bool follows = false;     // a gait changes into this one without a stop
  bool goes_on = false;     // this gait changes into the next one without a stop
  double early_s = 0.0;     // from the start of the base's speed change until the feet begin
  double outlasts_s = 0.0;  // from the start of the next part's feet until the base's speed change ends

  bool counted() const { return part.command.extent == Extent::kSteps; }
  double duration_s() const { return full_s + 0.5 * (start_ramp_s + stop_ramp_s); }
  double speed_m_s() const { return std::hypot(twist.x_m, twist.y_m) / full_s; }
};

std::optional<Failure> ReasonNoStand(const WalkCommand& command) {
  constexpr double kShortest = 0.1, kLongest = 600.0;  // [s]
  const double duration = command.duration_s;
  if (command.extent == Extent::kDuration && duration >= kShortest && duration <= kLongest) return std::nullopt;
  return BadPart(
      fmt::format("the duration of standing still is {} s; accepted: {} to {} s", duration, kShortest, kLongest));
}

Result<PartCourse> CourseOf(const RobotModel& model, const WalkPart& part, const FootstepOptions& options) {
  PartCourse course;
  course.part = part;
  course.stands = StandsStill(part.gait);
  if (course.stands) {
    if (auto failure = ReasonNoStand(part.command)) return *failure;
    course.full_s = part.command.duration_s;
    return course;
  }
  if (auto failure = ReasonNotWalked(model, part.gait, part.command)) return *failure;
  if (part.command.extent == Extent::kGoal)
    return BadPart("a part of a sequence cannot have a goal; give a distance, a duration or a number of steps");
  const Result<Course> own = MakeCourse(model, part.gait, part.command, options.ramp);
  if (!own) return own.failure();
  course.twist = own->twist;
  course.full_s = own->duration_s - own->ramp_s;
  course.start_ramp_s = course.stop_ramp_s = own->ramp_s;
  if (!course.counted()) return course;
  const int steps = StepsOfBase(part.gait, part.command.steps);
  if (steps < 1) {
    return BadPart(fmt::format("{} footfalls only close the stance of {} feet; {} or more move the robot",
                               part.command.steps, part.gait.num_feet(), part.gait.num_feet()));
  }
  course.twist = {steps * course.twist.x_m, steps * course.twist.y_m, steps * course.twist.yaw_rad};
  course.full_s = steps * part.gait.cycle_s / part.gait.num_feet();
  course.start_ramp_s = course.stop_ramp_s = std::min(options.ramp.cycles * part.gait.cycle_s, course.full_s);
  return course;
}

/// Joins neighbouring gaits without standing in between. The speed changes while the feet of the faster gait step.
void Couple(std::vector<PartCourse>& courses) {
  for (std::size_t k = 1; k < courses.size(); ++k) {
    PartCourse &before = courses[k - 1], &after = courses[k];
    if (before.stands || after.stands) continue;
    const double ramp = std::min({std::max(before.stop_ramp_s, after.start_ramp_s), before.full_s, after.full_s});
    before.stop_ramp_s = after.start_ramp_s = ramp;
    before.goes_on = after.follows = true;
    const bool slower = after.speed_m_s() < before.speed_m_s();
    (slower ? after.early_s : before.outlasts_s) = ramp;
  }
}

/// Longest time between two lift-offs, as a share of the cycle.
double LongestPause(const Gait& gait) {
  std::vector<double> liftoff;
  for (std::size_t i = 0; i < gait.phase.size(); ++i)
    liftoff.push_back(std::fmod(gait.phase[i] + gait.duty_factor[i] + 1e-12, 1.0));
  std::sort(liftoff.begin(), liftoff.end());
  double longest = liftoff.front() + 1.0 - liftoff.back();
  for (std::size_t i = 1; i < liftoff.size(); ++i) longest = std::max(longest, liftoff[i] - liftoff[i - 1]);
  return longest;
}

GaitStint StintOf(const RobotModel& model, const PartCourse& course) {
  const Gait& gait = course.part.gait;
  if (course.stands) return {gait, course.full_s};
  GaitStint stint{gait};
  if (course.counted()) {
    stint.footfalls = course.part.command.steps;
    if (!course.follows) stint.first_foot = LeadingFoot(model, course.twist);
  }
  const double feet_s = course.duration_s() - course.early_s;  // from first lift-off to the base's arrival
  if (!course.goes_on) {
    stint.time_s = std::ceil(feet_s / gait.cycle_s - 1e-6) * gait.cycle_s;
    return stint;
  }
  // The last feet touch down at the transition, or up to one footfall later, so that the base need not exceed the
  // requested speed.
  const double duty = *std::max_element(gait.duty_factor.begin(), gait.duty_factor.end());
  const double last_s = feet_s - course.outlasts_s + (LongestPause(gait) - (1.0 - duty)) * gait.cycle_s;
  stint.time_s = std::max(last_s, gait.cycle_s);
  return stint;
}

/// Start time of the base's motion in a part: with the first lift-off, or earlier if the base has to slow down first.
double StartOf(const std::vector<PartCourse>& courses, const JoinedSchedule& joined, double first_s, std::size_t k) {
  return (k == 0 ? first_s : joined.start_s[k]) - courses[k].early_s;
}

/// A part with a duration that changes into the next gait lasts up to one footfall longer, until its last feet touch
/// down. It goes farther by that time at the requested speed.
void KeepSpeeds(const JoinedSchedule& joined, double first_s, std::vector<PartCourse>& courses) {
  for (std::size_t k = 0; k + 1 < courses.size(); ++k) {
    PartCourse& course = courses[k];
    if (!course.goes_on || course.part.command.extent != Extent::kDuration) continue;
    const double duration_s = joined.start_s[k + 1] + course.outlasts_s - StartOf(courses, joined, first_s, k);
    const double full_s = duration_s - 0.5 * (course.start_ramp_s + course.stop_ramp_s);
    const double more = full_s / course.full_s;
    course.twist = {more * course.twist.x_m, more * course.twist.y_m, more * course.twist.yaw_rad};
    course.full_s = full_s;
  }
}

/// The base's path over a schedule. The times of the feet are kept; a part with a distance that changes into the next
/// gait takes up to one footfall longer than at the requested speed.
BasePath PathOf(const std::vector<PartCourse>& courses, const JoinedSchedule& joined, double first_s) {
  const ContactSchedule& schedule = joined.schedule;
  std::vector<PathPiece> path;
  for (std::size_t k = 0; k < courses.size(); ++k) {
    const PartCourse& course = courses[k];
    if (course.stands) continue;
    PathPiece piece{course.twist, StartOf(courses, joined, first_s, k), course.duration_s(), course.start_ramp_s,
                    course.stop_ramp_s};
    if (course.goes_on) {
      piece.duration_s = joined.start_s[k + 1] + course.outlasts_s - piece.start_s;
    } else if (course.counted()) {
      const double down_s = k + 1 < courses.size() ? joined.start_s[k + 1] : schedule.phases.back().start_s;
      piece.duration_s = down_s - piece.start_s;
      const double ramps =
          2.0 * std::max(0.0, piece.duration_s - course.full_s);  // total ramp time at the requested speed
      if (!course.follows) piece.start_ramp_s = 0.5 * ramps;
      piece.stop_ramp_s = std::max(0.0, ramps - piece.start_ramp_s);
    }
    path.push_back(piece);
  }
  return MakeBasePath(path, schedule.end_s());
}

/// Appends the parts with their times, and returns their stretches of the path.
std::vector<PathStretch> AddParts(const std::vector<PartCourse>& courses, const JoinedSchedule& joined,
                                  FootstepSkeleton& skeleton) {
  std::vector<PathStretch> stretches;
  for (std::size_t k = 0; k < courses.size(); ++k) {
    const double end = k + 1 < courses.size() ? joined.start_s[k + 1] : joined.schedule.end_s();
    const PartCourse& course = courses[k];
    skeleton.goal = Carried(skeleton.goal, PoseAlong(course.twist, 1.0));
    skeleton.parts.push_back({course.part.gait, course.part.command, skeleton.goal, joined.start_s[k], end});
    stretches.push_back({joined.start_s[k], end, course.stands, course.part.gait.cycle_s, course.twist});
  }
  return stretches;
}

Result<FootstepSkeleton> AlongCourses(const RobotModel& model, const Terrain& terrain, std::vector<PartCourse> courses,
                                      const FootstepOptions& options) {
  std::vector<GaitStint> stints;
  for (const PartCourse& course : courses) stints.push_back(StintOf(model, course));
  if (courses.front().stands) stints.front().time_s += options.settling_s;
  if (courses.back().stands) stints.back().time_s += options.settling_s;
  const double first_s = options.initial_stand_s + options.settling_s;
  const Result<JoinedSchedule> joined =
      JoinSchedules(stints, {first_s, options.final_stand_s + options.settling_s, options.grid_s});
  if (!joined) return joined.failure();
  KeepSpeeds(*joined, first_s, courses);
  FootstepSkeleton skeleton;
  skeleton.schedule = joined->schedule;
  skeleton.path = PathOf(courses, *joined, first_s);
  skeleton.footsteps = PlaceAlongPath(model, skeleton.schedule, skeleton.path, AddParts(courses, *joined, skeleton));
  if (auto failure = ReasonOutOfReach(model, skeleton, options.reach)) return *failure;
  PutOnGround(terrain, skeleton.footsteps);
  return skeleton;
}

}  // namespace

Failure OfPart(std::size_t index, const std::string& gait, Failure failure) {
  failure.message = fmt::format("part {}, '{}': {}", index + 1, gait, failure.message);
  return failure;
}

Result<FootstepSkeleton> PlanSequence(const RobotModel& model, const Terrain& terrain,
                                      const std::vector<WalkPart>& parts, const FootstepOptions& options) {
  if (parts.size() == 1 && !StandsStill(parts.front().gait))
    return PlanFootsteps(model, terrain, parts.front().gait, parts.front().command, options);
  std::vector<PartCourse> courses;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    Result<PartCourse> course = CourseOf(model, parts[k], options);
    if (!course) return OfPart(k, parts[k].gait.name, course.failure());
    courses.push_back(std::move(*course));
  }
  if (KindOfGround(terrain) != GroundKind::kFlat)
    return BadPart("a sequence of gaits is supported on level ground only");
  Couple(courses);
  return AlongCourses(model, terrain, std::move(courses), options);
}

}  // namespace gaitwright
