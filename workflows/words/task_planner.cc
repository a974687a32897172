// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/words/task_planner_internal.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "kinematics/dynamics/dynamics.h"
#include "kinematics/spatial/rotation.h"
#include "optimisation/pipeline/plan_posture.h"
#include "planning/paths/standing_feet.h"
#include "planning/plan/carried_plan.h"
#include "planning/plan/joined_plans.h"
#include "planning/plan/moved_terrain.h"
#include "workflows/words/places.h"

namespace gaitwright::tasks {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kStay = 1.0;  // [s]

/// The robot with its joints outside the legs elsewhere in standing.
RobotModel Posed(RobotModel model, const VectorX& joints) {
  std::vector<bool> in_leg(static_cast<std::size_t>(model.num_dofs()), false);
  for (const Leg& leg : model.legs) {
    for (const int joint : leg.joints)
      in_leg[static_cast<std::size_t>(model.joints[static_cast<std::size_t>(joint)].dof)] = true;
  }
  for (int d = 0; d < model.num_dofs(); ++d) {
    if (!in_leg[static_cast<std::size_t>(d)]) model.standing_joints[d] = joints[d];
  }
  return model;
}

Sides SidesOf(const Task& task) {
  const std::string side = task.Word("side");
  return {side != "right", side != "left"};
}

std::vector<double> Shares(double size, std::initializer_list<double> shares) {
  std::vector<double> sizes;
  for (const double share : shares) sizes.push_back(share * size);
  return sizes;
}

/// The plan of the robot without what it lies on as one of the robot with it.
void AddRest(const RobotModel& model, MotionPlan& plan) {
  plan.robot_hash = model.hash;
  plan.yaml_text = model.yaml_text;
  for (auto& wrenches : plan.whole_body.wrenches) wrenches.resize(model.feet.size());
}

/// The centre of mass in standing.
Vector3 StandingCentre(const RobotModel& model) {
  DynamicsScratch scratch(model);
  ForwardKinematics(model, StandingConfiguration(model), scratch);
  return CentreOfMass(model, scratch);
}

}  // namespace

TaskPlanner::TaskPlanner(const RobotModel& model, const RobotModel& whole_model, const Terrain& terrain,
                         const TaskOptions& options)
    : model_(model), whole_model_(whole_model), terrain_(terrain), options_(options) {
  stance_.key = StandingKey(model);
}

std::optional<Failure> TaskPlanner::LieAtStart() {
  const Result<Lying> lying = FindLying(whole_model_, stance_.key.joints);
  if (!lying) return lying.failure();
  stance_ = {lying->lying, Stance::Pose::kLying};
  lying_ = *lying;
  return std::nullopt;
}

std::optional<Failure> TaskPlanner::Add(const Task& task) {
  static const std::vector<std::string> kAnyhow = {"stand", "stand_up", "raise_arm", "lower_arm", "wave"};
  const bool anyhow = std::find(kAnyhow.begin(), kAnyhow.end(), task.action) != kAnyhow.end();
  const bool again = (task.action == "sit" && stance_.pose == Stance::Pose::kSitting) ||
                     (task.action == "lie_down" && stance_.pose == Stance::Pose::kLying);
  if (stance_.pose != Stance::Pose::kStanding && !anyhow && !again) {
    notes_.push_back(fmt::format("it stands up before '{}'", task.words.empty() ? TaskText(task) : task.words));
    if (auto failure = StandUp()) return failure;
  }
  task_ = &task;
  auto failure = DoTask(task, again);
  task_ = nullptr;
  return failure;
}

std::optional<Failure> TaskPlanner::DoTask(const Task& task, bool again) {
  if (task.action == "walk" && task.Has("to")) return WalkTo(task);
  if (task.action == "walk") return Walk(task, true);
  if (task.action == "turn") return Turn(task);
  if (task.action == "stand" || again) return AddPosture(Hold(stance_.key, task.Number("duration_s", kStay)));
  if (task.action == "stand_up") return StandUp();
  if (task.action == "sit") return Sit(task);
  if (task.action == "lie_down") return Lie();
  return Move(task);
}

Result<MotionPlan> TaskPlanner::Finish() {
  if (auto failure = Flush()) return *failure;
  return std::move(*whole_);
}

/// Where the base is in plan view, from the start of everything.
PlanarPose TaskPlanner::Here() const { return whole_ ? BaseInPlan(whole_->whole_body.q.back()) : PlanarPose{}; }

std::optional<Failure> TaskPlanner::Append(MotionPlan next) {
  if (!whole_) {
    whole_ = std::move(next);
    whole_->terrain = terrain_;
    return std::nullopt;
  }
  Result<MotionPlan> joined = JoinedPlans(*whole_, whole_->whole_body.end_s(), next, next.whole_body.start_s);
  if (!joined) return joined.failure();
  const double before = whole_->duration_s(), after = next.duration_s();
  const auto height = [](const MotionPlan& plan) { return 1.0 / std::pow(plan.centroidal.omega_rad_s, 2); };
  const double mean = (before * height(*whole_) + after * height(next)) / (before + after);
  whole_ = std::move(*joined);
  whole_->centroidal.omega_rad_s = std::sqrt(1.0 / mean);
  return std::nullopt;
}

/// Plans the postures that wait for it, in one motion without seams, with what is done meanwhile.
std::optional<Failure> TaskPlanner::Flush() {
  if (chain_.empty()) return std::nullopt;
  Result<MotionPlan> plan = PlanPosture(whole_model_, Chained(chain_), options_.motion);
  if (!plan) return plan.failure();
  for (const auto& [gesture, from_s] : gestures_) {
    Result<MotionPlan> with = WithGesture(Posed(whole_model_, gesture.keys.front().joints), *plan, gesture, from_s,
                                          options_.motion.whole_body);
    if (!with) return with.failure();
    plan = std::move(*with);
  }
  chain_.clear();
  gestures_.clear();
  return Append(std::move(*plan));
}

double TaskPlanner::ChainTime() const { return chain_.empty() ? 0.0 : Chained(chain_).duration_s(); }

std::optional<Failure> TaskPlanner::AddPosture(const MotionBySize& motion, const Sizes& sizes) {
  Result<PlannedPosture> planned = PlanPostureWithin(whole_model_, motion, sizes, options_.motion);
  if (!planned) return planned.failure();
  const double from_s = ChainTime();
  const PostureKey from = stance_.key;
  chain_.push_back(planned->motion);
  stance_.key = planned->motion.keys.back();
  return task_ == nullptr ? std::nullopt : AddGestures(from, from_s);
}

std::optional<Failure> TaskPlanner::AddPosture(const PostureMotion& motion) {
  return AddPosture([&](double) { return Result<PostureMotion>(motion); }, {{0.0}, false, ""});
}

/// What is done while the last posture of the chain is; what takes longer is waited for.
std::optional<Failure> TaskPlanner::AddGestures(PostureKey from, double from_s) {
  for (const Task& gesture : task_->during) {
    const double step_s = options_.motion.pipeline.grid_step_s;
    const Result<PostureMotion> made = GestureMotion(gesture, from, ChainTime() - from_s);
    if (!made) return made.failure();
    const PostureMotion motion = Stretched(*made, 1.0, step_s);
    const double lacking_s = from_s + motion.duration_s() - ChainTime();
    if (lacking_s > 0.0) chain_.push_back(Hold(chain_.back().keys.back(), lacking_s + step_s));
    gestures_.emplace_back(motion, from_s);
    from.joints = stance_.key.joints = motion.keys.back().joints;
  }
  if (stance_.key.joints != chain_.back().keys.back().joints) return Flush();  // what comes next begins with them
  return std::nullopt;
}

Result<PostureMotion> TaskPlanner::GestureMotion(const Task& gesture, const PostureKey& from, double duration_s) const {
  if (gesture.action == "raise_arm") return RaiseArms(model_, from, SidesOf(gesture));
  if (gesture.action == "lower_arm") return LowerArms(model_, from, SidesOf(gesture));
  const auto often = [&](int times) -> Result<PostureMotion> {
    if (gesture.action == "nod") return Nod(model_, from, times);
    return WaveArms(model_, from, SidesOf(gesture), times);
  };
  if (gesture.Has("times")) return often(gesture.Count("times", 1));
  const Result<PostureMotion> once = often(1);
  if (!once) return once;
  // As often as goes into the time, what raises and lowers the arm left out.
  constexpr double kMost = 1000.0;
  const double wished_s = gesture.Number("duration_s", duration_s);
  const double one_s = often(2)->duration_s() - once->duration_s();
  const double more = std::clamp((wished_s - once->duration_s()) / one_s, 0.0, kMost);
  return often(1 + static_cast<int>(more));
}

std::optional<Failure> TaskPlanner::AddWalk(const WalkRequest& request, bool gestures) {
  // Postures before it end where the walk begins: they are planned with it in mind.
  const RobotModel posed = Posed(model_, stance_.key.joints);
  PlanarPose here = Here();
  if (!chain_.empty() && !whole_) here = {};
  const Result<Terrain> ground = MovedTerrain(PoseOf(here).inverse(), terrain_);
  if (!ground) return ground.failure();
  Result<PlannedWalk> planned = PlanWalkOn(posed, *ground, request);
  if (!planned) return planned.failure();
  MotionPlan walk = std::move(planned->motion.plan);
  if (auto failure = GoToStartOf(walk)) return failure;
  if (gestures && task_ != nullptr) {
    double last_s = walk.whole_body.start_s;
    for (const Task& gesture : task_->during) {
      const Result<PostureMotion> made = GestureMotion(gesture, stance_.key, walk.duration_s());
      if (!made) return made.failure();
      const PostureMotion motion = Stretched(*made, 1.0, walk.whole_body.step_s);
      if (motion.duration_s() > walk.duration_s()) StayOn(motion.duration_s() - walk.duration_s(), walk);
      Result<MotionPlan> with = WithGesture(Posed(model_, stance_.key.joints), walk, motion, last_s,
                                            options_.motion.whole_body);
      if (!with) return with.failure();
      walk = std::move(*with);
      stance_.key.joints = motion.keys.back().joints;
    }
  }
  if (whole_model_.hash != model_.hash) AddRest(whole_model_, walk);
  return Append(std::move(walk));
}

/// Walks carry the body at places of their own over the feet: goes there first.
std::optional<Failure> TaskPlanner::GoToStartOf(const MotionPlan& walk) {
  constexpr double kSame = 1e-5;  // [m]
  PostureKey at = stance_.key;
  at.shift = walk.centroidal.p_WC.front() - StandingCentre(model_);
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
  if (!failure || task.Word("pace") != "fast" || failure->kind != FailureKind::kInfeasible) return failure;
  Task slower = task;
  slower.parameters.erase("pace");
  notes_.push_back(fmt::format("'{}' goes at the usual speed: {}", task.words, failure->message));
  return Walk(slower, gestures);
}

std::optional<Failure> TaskPlanner::Turn(const Task& task) {
  constexpr double kMost = 120.0;  // [degree] in one go
  const double angle = task.Number("angle_deg", 90.0);
  const int goes = static_cast<int>(std::ceil(angle / kMost - 1e-9));
  Task part = task;
  part.parameters["angle_deg"] = angle / goes;
  for (int k = 0; k < goes; ++k) {
    if (auto failure = Walk(part, k == 0)) return failure;
  }
  return std::nullopt;
}

/// The way to a place from where the robot is.
Vector2 TaskPlanner::WayTo(const PlaceName& place) const {
  const Vector2 centre_W = CentreOf(terrain_, place);
  return (PoseOf(Here()).inverse() * Vector3(centre_W.x(), centre_W.y(), 0.0)).head<2>();
}

std::optional<Failure> TaskPlanner::WalkTo(const Task& task) {
  constexpr double kAhead = 0.2, kThere = 0.02;  // [rad], [m]
  if (auto failure = Flush()) return failure;
  const auto& place = std::get<PlaceName>(task.parameters.at("to"));
  const Vector2 way = WayTo(place);
  if (way.norm() < kThere) {
    notes_.push_back(fmt::format("'{}': it is there", task.words));
    return AddPosture(Hold(stance_.key, kStay));
  }
  const std::string direction = task.Word("direction");
  const double ahead = direction == "backward" ? std::numbers::pi
                       : direction == "left"   ? 0.5 * std::numbers::pi
                       : direction == "right"  ? -0.5 * std::numbers::pi
                                               : 0.0;
  const double turn = WrapAngle(std::atan2(way.y(), way.x()) - ahead);
  if (std::abs(turn) > kAhead) {
    Task first;
    first.action = "turn";
    first.parameters = {{"direction", std::string(turn > 0.0 ? "left" : "right")},
                        {"angle_deg", std::abs(turn) / kDegree}};
    notes_.push_back(fmt::format("it turns {} by {:.0f} degrees before '{}'", first.Word("direction"),
                                 std::abs(turn) / kDegree, task.words));
    const Task* const kept = task_;
    task_ = nullptr;
    auto failure = Turn(first);
    task_ = kept;
    if (failure) return failure;
  }
  Result<WalkRequest> request = WalkRequestOf(model_, task, options_);
  if (!request) return request.failure();
  const Vector2 goal = WayTo(place);
  WalkCommand& c = request->command;
  c.extent = WalkCommand::Extent::kGoal;
  c.distance_m = 0.0;
  c.goal_x_m = goal.x();
  c.goal_y_m = goal.y();
  return AddWalk(*request, true);
}

std::optional<Failure> TaskPlanner::StandUp() {
  const Task* const task = task_;
  task_ = nullptr;
  PostureKey up = StandingKey(model_);
  up.joints = stance_.key.joints;
  std::optional<Failure> failure;
  if (stance_.pose == Stance::Pose::kLying) {
    const double natural = 0.35;  // [rad]
    failure = AddPosture([&](double tip) -> Result<PostureMotion> { return GetUp(whole_model_, up, *lying_, tip); },
                         {Shares(natural, {1.0, 0.7, 0.4, 0.0}), false, ""});
  } else {
    const bool is_up = stance_.pose == Stance::Pose::kStanding && stance_.key.shift.norm() < 1e-4;
    failure = AddPosture(is_up ? Hold(stance_.key, 0.5 * kStay) : GoTo(model_, "stand_up", stance_.key, up));
  }
  stance_.pose = Stance::Pose::kStanding;
  task_ = task;
  return failure;
}

std::optional<Failure> TaskPlanner::Lie() {
  const Result<Lying> lying = FindLying(whole_model_, stance_.key.joints);
  if (!lying) return lying.failure();
  lying_ = *lying;
  if (auto failure = AddPosture(LieDown(whole_model_, stance_.key, *lying))) return failure;
  stance_.pose = Stance::Pose::kLying;
  return std::nullopt;
}

std::optional<Failure> TaskPlanner::Sit(const Task& task) {
  constexpr double kAngle = 0.5, kLower = 0.4;  // [rad], of the leg's length to the radian
  const PostureKey from = stance_.key;
  const auto motion = [&](double angle) -> Result<PostureMotion> {
    return GoTo(model_, "sit", from, SittingKey(model_, angle, kLower * angle * model_.leg_length_m()));
  };
  if (auto failure = AddPosture(motion, {Shares(kAngle, {1.0, 0.8, 0.6, 0.4}), false, ""})) return failure;
  stance_.pose = Stance::Pose::kSitting;
  if (!task.Has("duration_s")) return std::nullopt;
  return AddPosture(Hold(stance_.key, task.Number("duration_s", 0.0)));
}

/// What begins and ends standing.
std::optional<Failure> TaskPlanner::Move(const Task& task) {
  const double leg = model_.leg_length_m(), hold_s = task.Number("duration_s", 0.0);
  const PostureKey from = stance_.key;
  const int times = task.Count("times", 1);
  if (task.action == "squat" || task.action == "brace") {
    const bool brace = task.action == "brace";
    const Sizes sizes = task.Has("depth_m")
                            ? Sizes{{task.Number("depth_m", 0.0)}, true, "depth_m"}
                            : Sizes{Shares((brace ? 0.3 : 0.2) * leg, {1.0, 0.75, 0.5, 0.25}), false, ""};
    return AddPosture(
        [&](double depth) -> Result<PostureMotion> {
          return brace ? Brace(model_, from, depth, kStay) : Squat(model_, from, depth, times, hold_s);
        },
        sizes);
  }
  if (task.action == "bow") return BowDown(task, times);
  if (task.action == "nod") return AddPosture(Nod(model_, from, times));
  if (task.action == "balance") {
    const int on = FootOf(task.Word("side"));
    const double balance_s = task.Number("duration_s", 2.0);
    return AddPosture([&](double inward) { return BalanceOn(model_, from, on, inward, balance_s); },
                      {{0.0, 0.05, 0.1, 0.15, 0.2}, false, ""});
  }
  Task gesture = task;
  if (task.action == "wave" && !task.Has("times") && !task.Has("duration_s")) gesture.parameters["times"] = 3;
  const Result<PostureMotion> motion = GestureMotion(gesture, from, hold_s);
  if (!motion) return motion.failure();
  return AddPosture(*motion);
}

std::optional<Failure> TaskPlanner::BowDown(const Task& task, int times) {
  const double natural = (model_.feet.size() == 2 ? 35.0 : 18.0) * kDegree;
  const PostureKey from = stance_.key;
  const bool asked = task.Has("angle_deg");
  const double angle = asked ? task.Number("angle_deg", 0.0) * kDegree : natural;
  // Legs may have to bend for it.
  std::optional<Failure> failure;
  for (const double share : {1.0, 0.75, 0.5}) {
    if (asked && share < 1.0) break;
    failure = AddPosture(
        [&](double lower) -> Result<PostureMotion> {
          return Bow(model_, from, share * angle, lower * model_.leg_length_m(), times);
        },
        {{0.0, 0.05, 0.1, 0.15}, false, ""});
    if (!failure) return failure;
  }
  return failure;
}

/// The foot of a side.
int TaskPlanner::FootOf(const std::string& side) const {
  const std::vector<Pose> feet = StandingFeet(model_);
  const bool first_is_left = feet[0].translation().y() > feet[1].translation().y();
  return (side == "left") == first_is_left ? 0 : 1;
}

}  // namespace gaitwright::tasks
