// SPDX-License-Identifier: BSD-3-Clause
// Part of TaskPlanner: jumps and flips.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "kinematics/dynamics/dynamics.h"
#include "optimisation/pipeline/robot_body.h"
#include "planning/footsteps/ways_to_standing_internal.h"
#include "planning/gait/leap_gaits_internal.h"
#include "planning/paths/standing_feet.h"
#include "planning/plan/carried_plan.h"
#include "workflows/words/places.h"
#include "workflows/words/task_planner_internal.h"

namespace gaitwright::tasks {
namespace {

using Extent = WalkCommand::Extent;

/// Unit vector of a direction of the body, in plan view.
Vector2 DirectionOf(const std::string& direction) {
  if (direction == "backward") return {-1.0, 0.0};
  if (direction == "left") return {0.0, 1.0};
  if (direction == "right") return {0.0, -1.0};
  return {1.0, 0.0};
}

bool HasMarker(const Terrain& terrain, const std::string& name) {
  return std::any_of(terrain.markers.begin(), terrain.markers.end(),
                     [&](const TerrainMarker& marker) { return marker.name == name; });
}

/// Roll, pitch and yaw of R = Rz Ry Rx.
Vector3 RollPitchYawOf(const Matrix3& R) {
  return {std::atan2(R(2, 1), R(2, 2)), -std::asin(std::clamp(R(2, 0), -1.0, 1.0)), std::atan2(R(1, 0), R(0, 0))};
}

int FlightsOf(const MotionPlan& plan) {
  return static_cast<int>(std::count_if(plan.schedule.phases.begin(), plan.schedule.phases.end(),
                                        [](const ContactPhase& phase) { return phase.stance == 0; }));
}

/// Removes suggestions of options that a jump in words does not have.
Failure WithoutOptions(Failure failure) {
  std::erase_if(failure.suggestions, [](const Suggestion& said) {
    return said.what == "speed" || said.what == "lateral-speed" || said.what == "yaw-rate" ||
           said.what == "step-length" || said.what.starts_with("gait");
  });
  return failure;
}

}  // namespace

WalkRequest JumpRequestOf(const RobotModel& model, const Jump& jump, const TaskOptions& options) {
  WalkRequest request;
  request.motion = options.motion;
  request.motion.pipeline.end_as_standing = true;
  request.seed = options.seed;
  request.gait = LeapGait(static_cast<int>(model.feet.size()));
  request.own_pace = true;
  WalkCommand& c = request.command;
  c.distance_m = 0.0;
  if (jump.displacement_m.norm() == 0.0 && jump.turn_rad == 0.0) {
    c.extent = Extent::kSteps;
    c.steps = static_cast<int>(model.feet.size());
  } else if (jump.displacement_m.x() > 0.0 && jump.displacement_m.y() == 0.0 && jump.turn_rad == 0.0) {
    c.extent = Extent::kDistance;
    c.distance_m = jump.displacement_m.x();
  } else {
    c.extent = Extent::kGoal;
    c.goal_x_m = jump.displacement_m.x();
    c.goal_y_m = jump.displacement_m.y();
    c.goal_yaw_rad = jump.turn_rad;
  }
  return request;
}

std::optional<Failure> TaskPlanner::Leap(const Jump& jump, bool gestures) {
  const int before = whole_ ? FlightsOf(*whole_) : 0;
  if (auto failure = AddWalk(JumpRequestOf(model_, jump, options_), gestures)) return WithoutOptions(*failure);
  if (const int leaps = FlightsOf(*whole_) - before; leaps > 1)
    notes_.push_back(fmt::format("'{}' takes {} leaps", task_->words.empty() ? TaskText(*task_) : task_->words, leaps));
  return StandStraight();
}

/// Goes from the end of a leap, which is close to the standing posture, to that posture, with the feet where they are.
/// Does nothing if feet are beside their places in standing: they would slide.
std::optional<Failure> TaskPlanner::StandStraight() {
  constexpr double kInPlace = 5e-4;       // [m]
  if (FindGround()) return std::nullopt;  // feet at several levels: no task can follow, which the next one reports
  const VectorX& q = whole_->whole_body.q.back();
  const OffsetsToStanding offsets = FindOffsetsToStanding(whole_model_, q);
  if (offsets.largest_m() > kInPlace) return std::nullopt;
  DynamicsScratch scratch(whole_model_);
  ForwardKinematics(whole_model_, q, scratch);
  Pose X_WS = PoseOf(offsets.base.plan);
  X_WS.translation().z() = offsets.base.ground_m;
  PostureKey standing = stance_.key;
  standing.shift.setZero();
  standing.turn_rad.setZero();
  stance_.key = standing;
  stance_.key.shift = X_WS.inverse() * CentreOfMass(whole_model_, scratch) - StandingCentreOfMass(model_);
  stance_.key.turn_rad = RollPitchYawOf(X_WS.linear().transpose() * FramePose(scratch, 0, Pose::Identity()).linear());
  const Task* const task = task_;
  task_ = nullptr;
  auto failure = AddPosture(GoTo(model_, "stand", stance_.key, standing));
  task_ = task;
  return failure;
}

/// The ground under each foot after a jump; empty if a foot is over no ground.
std::vector<GroundPoint> TaskPlanner::GroundAfter(const Jump& jump) const {
  const Pose X_WB = PoseOf(Here()) * PoseOf({jump.displacement_m.x(), jump.displacement_m.y(), jump.turn_rad});
  const std::vector<Pose> feet = StandingFeet(model_);
  std::vector<GroundPoint> ground;
  for (std::size_t f = 0; f < model_.legs.size(); ++f) {
    const Vector3 p_W = X_WB * feet[f].translation();
    ground.push_back(GroundAt(terrain_, p_W.head<2>()));
    if (ground.back().patch < 0) return {};
  }
  return ground;
}

/// Height of the ground under the feet.
double TaskPlanner::HeightHere() const {
  const std::vector<GroundPoint> here = GroundAfter({});
  return here.empty() ? ground_m_ : here.front().height_m;
}

/// The shortest jump in a direction after which all feet are on one level and on ground that is accepted; nullopt if
/// there is none within reach.
std::optional<Jump> TaskPlanner::ShortestTo(const Vector2& direction, double turn_rad, double farthest_m,
                                            const std::function<bool(const GroundPoint&)>& is_it) const {
  constexpr double kStep = 0.01, kLevel = 2e-3;  // [m]
  for (int k = 1; k * kStep <= farthest_m; ++k) {
    const Jump jump{k * kStep * direction, turn_rad};
    const std::vector<GroundPoint> ground = GroundAfter(jump);
    const bool lands = !ground.empty() && std::all_of(ground.begin(), ground.end(), [&](const GroundPoint& point) {
      return is_it(point) && std::abs(point.height_m - ground.front().height_m) < kLevel;
    });
    if (lands) return jump;
  }
  return std::nullopt;
}

/// Jumps onto ground in a direction: as short as possible, with some distance of the feet from its edge. After a jump
/// down, legs need room beside the edge behind them, in proportion to the drop.
std::optional<Failure> TaskPlanner::LeapOnto(const Vector2& direction, double turn_rad, double farthest_m,
                                             const std::string& what,
                                             const std::function<bool(const GroundPoint&)>& is_it) {
  constexpr double kRise = 0.1, kShare = 0.5;  // margin upward / leg length; variation of the margin
  constexpr int kMargins = 3;
  const std::optional<Jump> shortest = ShortestTo(direction, turn_rad, farthest_m, is_it);
  if (!shortest) {
    return Failure{FailureKind::kInfeasible,
                   FailureCode::kPlace,
                   "PlanTasks",
                   fmt::format("within {:.2f} m in the direction of the jump, {} has no room for all feet at one level",
                               farthest_m, what),
                   {"walk nearer first"}};
  }
  const double drop_m = HeightHere() - GroundAfter(*shortest).front().height_m;
  const double margin_m = std::max(drop_m, kRise * model_.leg_length_m());
  std::optional<Failure> first;
  for (int k = 0; k < kMargins; ++k) {
    const double share = 1.0 + (k == 0 ? 0.0 : k == 1 ? -kShare : kShare);
    Jump jump = *shortest;
    jump.displacement_m += share * margin_m * direction;
    const std::vector<GroundPoint> ground = GroundAfter(jump);
    if (ground.empty() || !std::all_of(ground.begin(), ground.end(), is_it)) jump = *shortest;
    const auto failure = Leap(jump, true);
    if (!failure) return std::nullopt;
    if (!first) first = failure;
  }
  return first;
}

/// Jumps to a marker with the middle of the feet over it, or onto a patch as soon as all feet are on it.
std::optional<Failure> TaskPlanner::JumpTo(const Task& task, double turn_rad) {
  const auto& place = std::get<PlaceName>(task.parameters.at("to"));
  if (auto failure = Flush()) return failure;
  if (DisplacementTo(place).norm() < kThere) return AlreadyThere();
  if (auto failure = FaceTowards(place)) return failure;
  const Vector2 displacement = DisplacementTo(place);
  const bool marker = HasMarker(terrain_, place.name);
  const auto is_it = [&](const GroundPoint& point) {
    return static_cast<std::size_t>(point.patch) < terrain_.patches.size() &&
           IsPlace(terrain_.patches[static_cast<std::size_t>(point.patch)].name, place, terrain_);
  };
  const std::vector<GroundPoint> here = GroundAfter({});
  const bool on_it = !here.empty() && std::all_of(here.begin(), here.end(), is_it);
  if (marker || on_it) return Leap({displacement, turn_rad}, true);
  const std::string name =
      place.number > 0 ? fmt::format("'{} {}'", place.name, place.number) : fmt::format("'{}'", place.name);
  return LeapOnto(displacement.normalized(), turn_rad, displacement.norm(), name, is_it);
}

std::optional<Failure> TaskPlanner::JumpOnce(const Task& task, bool gestures) {
  constexpr double kForward = 1.0, kSideways = 0.5, kFarDown = 4.0;  // in leg lengths
  const double turn_deg = task.Has("turn") ? task.Number("angle_deg", 90.0) : 0.0;
  const double turn_rad = (task.Word("turn") == "right" ? -kDegree : kDegree) * turn_deg;
  if (task.Has("to")) return JumpTo(task, turn_rad);
  const std::string direction = task.Word("direction");
  const Vector2 unit = DirectionOf(direction);
  const double leg_m = model_.leg_length_m();
  if (task.Has("level")) {
    if (auto failure = Flush()) return failure;
    constexpr double kLower = 0.01;  // [m]
    const double here_m = HeightHere();
    return LeapOnto(unit, turn_rad, kFarDown * leg_m, "lower ground",
                    [&](const GroundPoint& point) { return point.height_m < here_m - kLower; });
  }
  const bool goes = !direction.empty() || task.Has("distance_m");
  const double own_m = goes ? (unit.y() != 0.0 ? kSideways : kForward) * leg_m : 0.0;
  return Leap({task.Number("distance_m", own_m) * unit, turn_rad}, gestures);
}

std::optional<Failure> TaskPlanner::DoJump(const Task& task) {
  for (int k = 0; k < task.Count("times", 1); ++k) {
    if (auto failure = FindGround()) return failure;
    if (auto failure = JumpOnce(task, k == 0)) return failure;
  }
  return std::nullopt;
}

std::optional<Failure> TaskPlanner::DoFlip(const Task& task) {
  WalkRequest request;
  request.motion = options_.motion;
  request.motion.pipeline.end_as_standing = true;
  request.seed = options_.seed;
  request.gait = GaitTurningOver(static_cast<int>(model_.feet.size()), task.Word("direction"));
  for (int k = 0; k < task.Count("times", 1); ++k) {
    if (auto failure = AddWalk(request, k == 0)) return WithoutOptions(*failure);
    if (auto failure = StandStraight()) return failure;
  }
  return std::nullopt;
}

}  // namespace gaitwright::tasks
