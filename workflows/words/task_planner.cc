// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "kinematics/dynamics/dynamics.h"
#include "kinematics/dynamics/foot_contact.h"
#include "optimisation/pipeline/plan_posture.h"
#include "planning/paths/standing_feet.h"
#include "planning/plan/carried_plan.h"
#include "planning/plan/joined_plans.h"
#include "workflows/words/task_planner_internal.h"

namespace gaitwright::tasks {
namespace {

Sides SidesOf(const Task& task) {
  const std::string side = task.Word("side");
  return {side != "right", side != "left"};
}

std::vector<double> Shares(double size, std::initializer_list<double> shares) {
  std::vector<double> sizes;
  for (const double share : shares) sizes.push_back(share * size);
  return sizes;
}

/// Puts the contacts of a motion with fixed feet on the surfaces on which the previous motion ends.
void StandOnSurfacesOf(const MotionPlan& before, MotionPlan& plan) {
  const auto stood = [&](int foot) { return FootholdAt(before.footsteps, foot, before.whole_body.end_s()); };
  for (Foothold& foothold : plan.footsteps.footholds) {
    const int at = stood(foothold.foot) >= 0 ? stood(foothold.foot) : stood(0);
    foothold.patch = before.footsteps.footholds[static_cast<std::size_t>(at)].patch;
  }
}

}  // namespace

TaskPlanner::TaskPlanner(const RobotModel& model, const RobotModel& whole_model, const Terrain& terrain,
                         const TaskOptions& options)
    : model_(model), whole_model_(whole_model), terrain_(terrain), options_(options) {
  stance_.key = StandingKey(model);
}

void TaskPlanner::BeginLow() {
  const Result<Lying> lying = FindLying(whole_model_, stance_.key.joints);
  if (lying) {
    stance_ = {lying->lying, Stance::Pose::kLying};
    lying_ = *lying;
    return;
  }
  stance_.pose = Stance::Pose::kCrouching;
  notes_.push_back(fmt::format("the robot gets up from a crouch: {}", lying.failure().message));
}

std::optional<Failure> TaskPlanner::Add(const Task& task) {
  if (auto failure = FindGround()) return failure;
  static const std::vector<std::string> kAnyhow = {"stand", "stand_up", "raise_arm", "lower_arm", "wave"};
  const bool anyhow = std::find(kAnyhow.begin(), kAnyhow.end(), task.action) != kAnyhow.end();
  const bool again = (task.action == "sit" && stance_.pose == Stance::Pose::kSitting) ||
                     (task.action == "lie_down" && stance_.pose == Stance::Pose::kLying);
  if (stance_.pose != Stance::Pose::kStanding && !anyhow && !again) {
    notes_.push_back(fmt::format("the robot stands up before '{}'", task.words.empty() ? TaskText(task) : task.words));
    if (auto failure = StandUp()) return failure;
  }
  task_ = &task;
  auto failure = DoTask(task, again);
  task_ = nullptr;
  ends_s_.push_back((whole_ ? whole_->whole_body.end_s() : 0.0) + ChainTime());
  return failure;
}

/// Finds the height of the ground for the next motions; all feet must be at one level.
std::optional<Failure> TaskPlanner::FindGround() {
  constexpr double kLevel = 2e-3;  // [m]
  if (!whole_ || !chain_.empty()) return std::nullopt;
  DynamicsScratch scratch(model_);
  ForwardKinematics(model_, whole_->whole_body.q.back(), scratch);
  std::vector<double> heights_m;
  for (int f = 0; f < static_cast<int>(model_.legs.size()); ++f)
    heights_m.push_back(ContactFrame(model_, scratch, f).translation().z());
  const auto [low, high] = std::minmax_element(heights_m.begin(), heights_m.end());
  const auto name = [&](auto foot) { return model_.feet[static_cast<std::size_t>(foot - heights_m.begin())].name; };
  if (*high - *low > kLevel) {
    return Failure{FailureKind::kInfeasible,
                   FailureCode::kNotLevel,
                   "PlanTasks",
                   fmt::format("the preceding walk ends with '{}' {:.2f} m above '{}', so no other task can follow it",
                               name(high), *high - *low, name(low)),
                   {"end with this walk", "walk to a place where all feet are at one level"}};
  }
  ground_m_ = 0.5 * (*low + *high);
  if (std::abs(ground_m_) < kLevel) ground_m_ = 0.0;
  return std::nullopt;
}

std::optional<Failure> TaskPlanner::DoTask(const Task& task, bool again) {
  if (task.action == "walk" && task.Has("to")) return WalkTo(task);
  if (task.action == "walk") return Walk(task, true);
  if (task.action == "turn") return Turn(task);
  if (task.action == "jump") return DoJump(task);
  if (task.action == "flip") return DoFlip(task);
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

/// Pose of the base in plan view, relative to the start of the whole motion.
PlanarPose TaskPlanner::Here() const { return whole_ ? BaseInPlan(whole_->whole_body.q.back()) : PlanarPose{}; }

/// Pose of the base, with the height of the ground there.
Pose TaskPlanner::Start() const {
  Pose X = PoseOf(Here());
  X.translation().z() = ground_m_;
  return X;
}

/// @param next  a motion that starts from standing on ground of height 0.
std::optional<Failure> TaskPlanner::Append(MotionPlan next) {
  if (ground_m_ != 0.0) next = CarriedPlan(Pose(Eigen::Translation3d(0.0, 0.0, ground_m_)), 0.0, std::move(next));
  if (!whole_) {
    whole_ = std::move(next);
    whole_->terrain = terrain_;
    return std::nullopt;
  }
  Result<MotionPlan> joined = JoinedPlans(*whole_, whole_->whole_body.end_s(), next, next.whole_body.start_s);
  if (!joined) return joined.failure();
  whole_ = std::move(*joined);
  return std::nullopt;
}

/// Plans the waiting postures as one continuous motion, with their simultaneous gestures.
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
  if (whole_) StandOnSurfacesOf(*whole_, *plan);
  return Append(std::move(*plan));
}

double TaskPlanner::ChainTime() const { return chain_.empty() ? 0.0 : Chained(chain_).duration_s(); }

std::optional<Failure> TaskPlanner::AddPosture(const MotionBySize& motion, const Sizes& sizes) {
  const Result<PostureMotion> passing = PostureWithin(whole_model_, motion, sizes, options_.motion);
  if (!passing) return passing.failure();
  const double from_s = ChainTime();
  const PostureKey from = stance_.key;
  chain_.push_back(*passing);
  stance_.key = passing->keys.back();
  return task_ == nullptr ? std::nullopt : AddGestures(from, from_s);
}

std::optional<Failure> TaskPlanner::AddPosture(const PostureMotion& motion) {
  return AddPosture([&](double) { return Result<PostureMotion>(motion); }, {{0.0}, false, ""});
}

/// Adds the gestures at the same time as the last posture of the chain, in sequence; waits for gestures that take
/// longer.
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
    from_s += motion.duration_s();
  }
  if (stance_.key.joints != chain_.back().keys.back().joints)
    return Flush();  // the next motion starts with these joints
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
  Result<PostureMotion> once = often(1);
  if (!once) return once;
  // As often as fits into the time, without the time to raise and lower the arm.
  constexpr double kMost = 1000.0;
  const double wished_s = gesture.Number("duration_s", duration_s);
  const double one_s = often(2)->duration_s() - once->duration_s();
  const double more = std::clamp((wished_s - once->duration_s()) / one_s, 0.0, kMost);
  return often(1 + static_cast<int>(more));
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
  } else if (stance_.pose == Stance::Pose::kCrouching) {
    constexpr double kDeep = 0.3;  // share of the leg length
    const auto rise = [&](double depth_m) -> Result<PostureMotion> {
      PostureKey low = up;
      low.shift.z() -= depth_m;
      return GoTo(model_, "stand_up", low, up);
    };
    failure = AddPosture(rise, {Shares(kDeep * model_.leg_length_m(), {1.0, 0.75, 0.5, 0.25}), false, ""});
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
  constexpr double kAngle = 0.5, kLower = 0.4;  // [rad]; share of the leg length per radian
  const PostureKey from = stance_.key;
  const auto motion = [&](double angle) -> Result<PostureMotion> {
    return GoTo(model_, "sit", from, SittingKey(model_, angle, kLower * angle * model_.leg_length_m()));
  };
  if (auto failure = AddPosture(motion, {Shares(kAngle, {1.0, 0.8, 0.6, 0.4}), false, ""})) return failure;
  stance_.pose = Stance::Pose::kSitting;
  if (!task.Has("duration_s")) return std::nullopt;
  return AddPosture(Hold(stance_.key, task.Number("duration_s", 0.0)));
}

/// Plans a task that begins and ends standing.
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
  const Sizes lower{{0.0, 0.05, 0.1, 0.15}, false, ""};  // the legs may have to bend
  const auto by = [&](double bow_rad) -> MotionBySize {
    return [&, bow_rad](double lowered) -> Result<PostureMotion> {
      return Bow(model_, from, bow_rad, lowered * model_.leg_length_m(), times);
    };
  };
  std::optional<Failure> failure;
  for (const double share : {1.0, 0.75, 0.5}) {
    if (asked && share < 1.0) break;
    failure = AddPosture(by(share * angle), lower);
    if (!failure) return failure;
  }
  if (!asked) return failure;
  const double largest = LargestBelow(
      [&](double bow_rad) { return PostureWithin(whole_model_, by(bow_rad), lower, options_.motion).ok(); }, angle);
  failure->suggestions.clear();
  if (largest >= kDegree)
    failure->suggestions = {
        fmt::format("a bow of 1 to {:.0f} degrees, which is about the largest that robot '{}' can do here",
                    std::floor(largest / kDegree), model_.name)};
  return failure;
}

/// Index of the foot of a side.
int TaskPlanner::FootOf(const std::string& side) const {
  const std::vector<Pose> feet = StandingFeet(model_);
  const bool first_is_left = feet[0].translation().y() > feet[1].translation().y();
  return (side == "left") == first_is_left ? 0 : 1;
}

}  // namespace gaitwright::tasks
