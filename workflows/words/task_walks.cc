// SPDX-License-Identifier: BSD-3-Clause
// Part of TaskPlanner: walks, turns, and walks to places.
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "kinematics/dynamics/foot_contact.h"
#include "kinematics/model/body_tree.h"
#include "kinematics/spatial/rotation.h"
#include "optimisation/pipeline/plan_posture.h"
#include "optimisation/pipeline/robot_body.h"
#include "optimisation/search/pace.h"
#include "planning/paths/standing_feet.h"
#include "planning/plan/carried_plan.h"
#include "planning/plan/moved_terrain.h"
#include "planning/plan/robot_of_plan.h"
#include "workflows/words/places.h"
#include "workflows/words/task_planner_internal.h"

namespace gaitwright::tasks {
namespace {

/// Converts a plan of the robot without support contacts of the body to one with them.
void AddRest(const RobotModel& model, MotionPlan& plan) {
  SetRobot(model, plan);
  for (auto& wrenches : plan.whole_body.wrenches) wrenches.resize(model.feet.size());
}

/// Centre of the support area in standing, relative to the base; soles extend forward of the ankles.
Vector2 MiddleOfFeet(const RobotModel& model) {
  const std::vector<Pose> feet = StandingFeet(model);
  Eigen::AlignedBox2d covered;
  for (std::size_t f = 0; f < model.legs.size(); ++f) {
    for (const Vector3& p : ContactPoints(model.feet[f], feet[f])) covered.extend(Vector2(p.head<2>()));
  }
  return covered.center();
}

}  // namespace

/// The robot with other standing positions of the joints outside the legs.
RobotModel Posed(RobotModel model, const VectorX& joints) {
  const std::vector<bool> of_leg = DofsOfLegs(model);
  for (int d = 0; d < model.num_dofs(); ++d) {
    if (!of_leg[static_cast<std::size_t>(d)]) model.standing_joints[d] = joints[d];
  }
  return model;
}

std::optional<Failure> TaskPlanner::AddWalk(WalkRequest request, bool gestures) {
  const RobotModel posed = Posed(model_, stance_.key.joints);
  const Result<Terrain> ground = MovedTerrain(Start().inverse(), terrain_);
  if (!ground) return ground.failure();
  Result<PlannedWalk> planned = PlanWalkOn(posed, *ground, request);
  if (!planned) return planned.failure();
  MotionPlan walk = std::move(planned->motion.plan);
  PostureKey end = stance_.key;
  if (gestures && task_ != nullptr && !task_->during.empty()) {
    Result<MotionPlan> with = WithGestures(walk, end);
    if (!with) with = WithGesturesEased(posed, *ground, std::move(request), end);
    if (!with) return with.failure();
    walk = std::move(*with);
  }
  // Postures before the walk must end in its first state.
  if (auto failure = GoToStartOf(walk)) return failure;
  stance_.key.joints = end.joints;
  if (whole_model_.hash != model_.hash) AddRest(whole_model_, walk);
  return Append(std::move(walk));
}

/// WithGestures of walks in which they have more room. The body leans against a raised arm, which moves leg joints
/// closer to their limits; a ZMP farther inward compensates this. A walk at the robot's own speed may also be slower.
/// @return the failure of the last walk that was tried.
Result<MotionPlan> TaskPlanner::WithGesturesEased(const RobotModel& posed, const Terrain& ground, WalkRequest request,
                                                  PostureKey& key) const {
  constexpr std::array kShares = {1.0, 0.5, 0.25};  // of the speed
  PipelineOptions& pipeline = request.motion.pipeline;
  pipeline.zmp_inward = std::min(2.0 * pipeline.zmp_inward, PipelineOptions::kMostInward);
  const WalkCommand command = request.command;
  const double pace = PaceValue(posed, command);
  std::optional<Failure> failure;
  for (const double share : kShares) {
    if (share < 1.0) request.command = AtPace(posed, command, share * pace);
    const Result<PlannedWalk> planned = PlanWalkOn(posed, ground, request);
    key = stance_.key;
    Result<MotionPlan> with = planned ? WithGestures(planned->motion.plan, key) : Result<MotionPlan>(planned.failure());
    if (with) return with;
    failure = with.failure();
    if (!request.own_pace) break;
  }
  return *failure;
}

/// Adds the simultaneous gestures to a walk, in sequence; `key` gets the posture at its end.
Result<MotionPlan> TaskPlanner::WithGestures(MotionPlan walk, PostureKey& key) const {
  double from_s = walk.whole_body.start_s;
  for (const Task& gesture : task_->during) {
    const double left_s = walk.whole_body.end_s() - from_s;
    const Result<PostureMotion> made = GestureMotion(gesture, key, left_s);
    if (!made) return made.failure();
    const PostureMotion motion = Stretched(*made, 1.0, walk.whole_body.step_s);
    if (motion.duration_s() > left_s) StayOn(motion.duration_s() - left_s, walk);
    Result<MotionPlan> with = WithGesture(Posed(model_, key.joints), walk, motion, from_s, options_.motion.whole_body);
    if (!with) return with.failure();
    walk = std::move(*with);
    key.joints = motion.keys.back().joints;
    from_s += motion.duration_s();
  }
  const Result<AuditReport> audit = Audit(model_, walk, {});
  if (!audit) return audit.failure();
  if (audit->pass()) return walk;
  Failure failure = ReasonBroken(task_->words, *audit);
  failure.suggestions = {"try the tasks in sequence: 'then' instead of 'while'"};
  return failure;
}

/// Moves the body to its position relative to the feet at the start of a walk.
std::optional<Failure> TaskPlanner::GoToStartOf(const MotionPlan& walk) {
  constexpr double kSame = 1e-5;  // [m]
  PostureKey at = stance_.key;
  at.shift = walk.centroidal.p_WC.front() - StandingCentreOfMass(model_);
  at.turn_rad.setZero();
  const bool there = (at.shift - stance_.key.shift).norm() < kSame || (!whole_ && chain_.empty());
  const Task* const task = task_;
  task_ = nullptr;
  std::optional<Failure> failure;
  if (!there) failure = AddPosture(GoTo(model_, "stand", stance_.key, at));
  task_ = task;
  stance_.key = at;
  return failure ? failure : Flush();
}

std::optional<Failure> TaskPlanner::Walk(const Task& task, bool gestures) {
  Result<WalkRequest> request = WalkRequestOf(model_, task, options_);
  if (!request) return request.failure();
  auto failure = AddWalk(*request, gestures);
  if (!failure && task.Has("steps") && task.Count("steps", kFewestSteps) < kFewestSteps) {
    notes_.push_back(fmt::format("'{}' takes {} steps, because the last step brings the feet together",
                                 task.words.empty() ? TaskText(task) : task.words, kFewestSteps));
  }
  if (!failure || task.Word("pace") != "fast" || failure->kind != FailureKind::kInfeasible) return failure;
  Task slower = task;
  slower.parameters.erase("pace");
  notes_.push_back(fmt::format("'{}' uses the default speed: {}", task.words, failure->message));
  return Walk(slower, gestures);
}

std::optional<Failure> TaskPlanner::Turn(const Task& task) {
  constexpr double kMost = 120.0;  // [degree] largest angle of one turn
  const double angle = task.Number("angle_deg", 90.0);
  const int goes = static_cast<int>(std::ceil(angle / kMost - 1e-9));
  Task part = task;
  part.parameters["angle_deg"] = angle / goes;
  for (int k = 0; k < goes; ++k) {
    if (auto failure = Walk(part, k == 0)) return failure;
  }
  return std::nullopt;
}

/// The displacement that brings the centre of the robot's feet to a place.
Vector2 TaskPlanner::DisplacementTo(const PlaceName& place) const {
  const Vector2 centre_W = CentreOf(terrain_, place);
  return (PoseOf(Here()).inverse() * Vector3(centre_W.x(), centre_W.y(), 0.0)).head<2>() - MiddleOfFeet(model_);
}

std::optional<Failure> TaskPlanner::AlreadyThere() {
  notes_.push_back(fmt::format("'{}': the robot is already there", task_->words));
  return AddPosture(Hold(stance_.key, kStay));
}

/// Turns until the task's direction points to a place, unless it already does.
std::optional<Failure> TaskPlanner::FaceTowards(const PlaceName& place) {
  constexpr double kTolerance = 0.2;  // [rad]
  const Vector2 displacement = DisplacementTo(place);
  const Task& task = *task_;
  const std::string direction = task.Word("direction");
  const double heading = direction == "backward" ? std::numbers::pi
                         : direction == "left"   ? 0.5 * std::numbers::pi
                         : direction == "right"  ? -0.5 * std::numbers::pi
                                                 : 0.0;
  const double turn = WrapAngle(std::atan2(displacement.y(), displacement.x()) - heading);
  if (std::abs(turn) <= kTolerance) return std::nullopt;
  Task first;
  first.action = "turn";
  first.parameters = {{"direction", std::string(turn > 0.0 ? "left" : "right")},
                      {"angle_deg", std::abs(turn) / kDegree}};
  notes_.push_back(fmt::format("the robot turns {} by {:.0f} degrees before '{}'", first.Word("direction"),
                               std::abs(turn) / kDegree, task.words));
  const Task* const kept = task_;
  task_ = nullptr;
  auto failure = Turn(first);
  task_ = kept;
  return failure;
}

std::optional<Failure> TaskPlanner::WalkTo(const Task& task) {
  if (auto failure = Flush()) return failure;
  const auto& place = std::get<PlaceName>(task.parameters.at("to"));
  if (DisplacementTo(place).norm() < kThere) return AlreadyThere();
  if (auto failure = FaceTowards(place)) return failure;
  Result<WalkRequest> request = WalkRequestOf(model_, task, options_);
  if (!request) return request.failure();
  const Vector2 goal = DisplacementTo(place);
  WalkCommand& c = request->command;
  c.extent = WalkCommand::Extent::kGoal;
  c.distance_m = 0.0;
  c.goal_x_m = goal.x();
  c.goal_y_m = goal.y();
  return AddWalk(*request, true);
}

}  // namespace gaitwright::tasks
