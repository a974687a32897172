// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/words/plan_tasks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <map>
#include <numbers>
#include <optional>

#include "kinematics/base/version.h"
#include "kinematics/spatial/rotation.h"
#include "optimisation/pipeline/plan_posture.h"
#include "planning/paths/standing_feet.h"
#include "planning/plan/carried_plan.h"
#include "planning/plan/joined_plans.h"
#include "planning/plan/moved_terrain.h"
#include "planning/tasks/task_plan_json.h"
#include "planning/terrain/load_terrain.h"
#include "workflows/walk/refuse_walk.h"
#include "workflows/words/places.h"
#include "workflows/words/plan_tasks_internal.h"

namespace gaitwright {
namespace {

using tasks::Stance;

constexpr double kDegree = std::numbers::pi / 180.0;

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

/// Puts one task after the other into one motion.
class TaskPlanner {
 public:
  TaskPlanner(const RobotModel& model, const Terrain& terrain, const TaskOptions& options)
      : model_(model), terrain_(terrain), options_(options) {
    stance_.key = StandingKey(model);
  }

  std::optional<Failure> Add(const Task& task) {
    if (NeedsStanding(task)) {
      if (auto failure = StandUp(true)) return failure;
    }
    task_ = &task;
    if (task.action == "walk" && task.Has("to")) return WalkTo(task);
    if (task.action == "walk") return Walk(task, true);
    if (task.action == "turn") return Turn(task);
    if (task.action == "stand") return Stay(task.Number("duration_s", kStay));
    if (task.action == "stand_up") return StandUp(false);
    if (task.action == "sit") return Sit(task);
    return Move(task);
  }

  MotionPlan TakePlan() { return std::move(*whole_); }
  std::vector<std::string>& notes() { return notes_; }

 private:
  static constexpr double kStay = 1.0;  // [s]

  bool NeedsStanding(const Task& task) const {
    static const std::vector<std::string> kAnyhow = {"stand",     "stand_up",  "sit", "lie_down",
                                                     "raise_arm", "lower_arm", "wave"};
    return stance_.pose != Stance::Pose::kStanding &&
           std::find(kAnyhow.begin(), kAnyhow.end(), task.action) == kAnyhow.end();
  }

  /// Where the base is in plan view, from the start of everything.
  PlanarPose Here() const { return whole_ ? BaseInPlan(whole_->whole_body.q.back()) : PlanarPose{}; }

  std::optional<Failure> Append(const MotionPlan& next) {
    if (!whole_) {
      whole_ = next;
      whole_->terrain = terrain_;
      return std::nullopt;
    }
    Result<MotionPlan> joined =
        JoinedPlans(*whole_, whole_->whole_body.end_s(), next, next.whole_body.start_s);
    if (!joined) return joined.failure();
    const double before = whole_->duration_s(), after = next.duration_s();
    const auto height = [](const MotionPlan& plan) { return 1.0 / std::pow(plan.centroidal.omega_rad_s, 2); };
    const double mean = (before * height(*whole_) + after * height(next)) / (before + after);
    whole_ = std::move(*joined);
    whole_->centroidal.omega_rad_s = std::sqrt(1.0 / mean);
    return std::nullopt;
  }

  /// A posture motion, with what is done meanwhile.
  std::optional<Failure> AddPosture(const tasks::MotionBySize& motion, const tasks::Sizes& sizes) {
    Result<tasks::PlannedPosture> planned = tasks::PlanPostureWithin(model_, motion, sizes, options_.motion);
    if (!planned) return planned.failure();
    const Result<MotionPlan> with = WithGestures(std::move(planned->plan));
    if (!with) return with.failure();
    stance_.key = planned->end;
    stance_.key.joints = joints_after_.value_or(stance_.key.joints);
    joints_after_.reset();
    size_ = planned->size;
    return Append(*with);
  }

  std::optional<Failure> AddPosture(const PostureMotion& motion) {
    return AddPosture([&](double) { return Result<PostureMotion>(motion); }, {{0.0}, false, ""});
  }

  Result<PostureMotion> GestureMotion(const Task& gesture, const PostureKey& from, double duration_s) const {
    if (gesture.action == "raise_arm") return RaiseArms(model_, from, SidesOf(gesture));
    if (gesture.action == "lower_arm") return LowerArms(model_, from, SidesOf(gesture));
    const Result<PostureMotion> once =
        gesture.action == "wave" ? WaveArms(model_, from, SidesOf(gesture), 1) : Nod(model_, from, 1);
    if (!once || gesture.Has("times")) {
      const int times = gesture.Count("times", 1);
      return gesture.action == "wave" ? WaveArms(model_, from, SidesOf(gesture), times) : Nod(model_, from, times);
    }
    const double wished = std::min(duration_s, gesture.Number("duration_s", duration_s));
    // As often as goes into the time, what raises and lowers the arm left out.
    const Result<PostureMotion> twice =
        gesture.action == "wave" ? WaveArms(model_, from, SidesOf(gesture), 2) : Nod(model_, from, 2);
    const double one_s = twice->duration_s() - once->duration_s();
    const int times = std::clamp(1 + static_cast<int>((wished - once->duration_s()) / one_s), 1, 1000);
    return gesture.action == "wave" ? WaveArms(model_, from, SidesOf(gesture), times) : Nod(model_, from, times);
  }

  /// A plan with the task's gestures over it; they begin with it. One that takes longer is waited for.
  Result<MotionPlan> WithGestures(MotionPlan plan) {
    if (task_ == nullptr) return plan;
    PostureKey from = stance_.key;
    for (const Task& gesture : task_->during) {
      const double step_s = plan.whole_body.step_s;
      Result<PostureMotion> motion = GestureMotion(gesture, from, plan.duration_s());
      if (!motion) return motion.failure();
      motion = Stretched(*motion, 1.0, step_s);
      if (motion->duration_s() > plan.duration_s())
        tasks::StayOn(motion->duration_s() - plan.duration_s() + step_s, plan);
      const RobotModel posed = Posed(model_, from.joints);
      Result<MotionPlan> moved =
          WithGesture(posed, plan, *motion, plan.whole_body.start_s, options_.motion.whole_body);
      if (!moved) return moved;
      plan = std::move(*moved);
      from.joints = motion->keys.back().joints;
      joints_after_ = from.joints;
    }
    return plan;
  }

  std::optional<Failure> AddWalk(const WalkRequest& request, bool gestures) {
    const RobotModel posed = Posed(model_, stance_.key.joints);
    const Result<Terrain> ground = MovedTerrain(PoseOf(Here()).inverse(), terrain_);
    if (!ground) return ground.failure();
    Result<PlannedWalk> planned = PlanWalkOn(posed, *ground, request);
    if (!planned) return planned.failure();
    MotionPlan walk = std::move(planned->motion.plan);
    if (auto failure = GoToHeightOf(walk)) return failure;
    if (gestures) {
      Result<MotionPlan> with = WithGestures(std::move(walk));
      if (!with) return with.failure();
      walk = std::move(*with);
      stance_.key.joints = joints_after_.value_or(stance_.key.joints);
      joints_after_.reset();
    }
    return Append(walk);
  }

  /// Walks carry the body at heights of their own: goes there first.
  std::optional<Failure> GoToHeightOf(const MotionPlan& walk) {
    constexpr double kSame = 1e-4;  // [m]
    DynamicsScratch scratch(model_);
    ForwardKinematics(model_, StandingConfiguration(model_), scratch);
    PostureKey at = stance_.key;
    at.shift = Vector3(0.0, 0.0, walk.centroidal.p_WC.front().z() - CentreOfMass(model_, scratch).z());
    at.turn_rad.setZero();
    const bool there = (at.shift - stance_.key.shift).norm() < kSame;
    if (there || (!whole_ && stance_.pose == Stance::Pose::kStanding)) {
      stance_.key = at;
      return std::nullopt;
    }
    const Task* const task = task_;
    task_ = nullptr;
    auto failure = AddPosture(GoTo(model_, "stand", stance_.key, at));
    task_ = task;
    return failure;
  }

  std::optional<Failure> Walk(const Task& task, bool gestures) {
    Result<WalkRequest> request = tasks::WalkRequestOf(model_, task, options_);
    if (!request) return request.failure();
    auto failure = AddWalk(*request, gestures);
    if (!failure || task.Word("pace") != "fast" || failure->kind != FailureKind::kInfeasible) return failure;
    Task slower = task;
    slower.parameters.erase("pace");
    notes_.push_back(fmt::format("'{}' goes at the usual speed: {}", task.words, failure->message));
    return Walk(slower, gestures);
  }

  std::optional<Failure> Turn(const Task& task) {
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

  std::optional<Failure> WalkTo(const Task& task) {
    constexpr double kAhead = 0.2, kThere = 0.02;  // [rad], [m]
    const Vector2 centre_W = CentreOf(terrain_, std::get<PlaceName>(task.parameters.at("to")));
    const Vector2 way = (PoseOf(Here()).inverse() * Vector3(centre_W.x(), centre_W.y(), 0.0)).head<2>();
    if (way.norm() < kThere) {
      notes_.push_back(fmt::format("'{}': it is there", task.words));
      return Stay(kStay);
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
      notes_.push_back(fmt::format("turns {} by {:.0f} degrees first, to where '{}' leads", first.Word("direction"),
                                   std::abs(turn) / kDegree, task.words));
      const Task* const kept = task_;
      task_ = nullptr;
      auto failure = Turn(first);
      task_ = kept;
      if (failure) return failure;
    }
    Result<WalkRequest> request = tasks::WalkRequestOf(model_, task, options_);
    if (!request) return request.failure();
    const Vector3 goal = PoseOf(Here()).inverse() * Vector3(centre_W.x(), centre_W.y(), 0.0);
    WalkCommand& c = request->command;
    c.extent = WalkCommand::Extent::kGoal;
    c.distance_m = 0.0;
    c.goal_x_m = goal.x();
    c.goal_y_m = goal.y();
    c.goal_yaw_rad = 0.0;
    return AddWalk(*request, true);
  }

  std::optional<Failure> Stay(double duration_s) {
    if (!whole_ || !task_->during.empty()) return AddPosture(Hold(stance_.key, duration_s));
    tasks::StayOn(duration_s, *whole_);
    return std::nullopt;
  }

  std::optional<Failure> StandUp(bool unasked) {
    PostureKey up = StandingKey(model_);
    up.joints = stance_.key.joints;
    if (unasked) notes_.emplace_back("it stands up first");
    const bool is_up = stance_.pose == Stance::Pose::kStanding && stance_.key.shift.norm() < 1e-4;
    stance_.pose = Stance::Pose::kStanding;
    const Task* const task = task_;
    task_ = nullptr;
    auto failure = is_up ? AddPosture(Hold(stance_.key, 0.5 * kStay)) : AddPosture(GoTo(model_, "stand_up", stance_.key, up));
    task_ = task;
    return failure;
  }

  std::optional<Failure> Sit(const Task& task) {
    constexpr double kAngle = 0.5, kLower = 0.4;  // [rad], of the leg's length to the radian
    const PostureKey from = stance_.key;
    const auto motion = [&](double angle) -> Result<PostureMotion> {
      return GoTo(model_, "sit", from, SittingKey(model_, angle, kLower * angle * model_.leg_length_m()));
    };
    if (auto failure = AddPosture(motion, {Shares(kAngle, {1.0, 0.8, 0.6, 0.4}), false, ""})) return failure;
    stance_.pose = Stance::Pose::kSitting;
    if (task.Has("duration_s")) tasks::StayOn(task.Number("duration_s", 0.0), *whole_);
    return std::nullopt;
  }

  /// What begins and ends standing.
  std::optional<Failure> Move(const Task& task) {
    const double leg = model_.leg_length_m();
    const PostureKey from = stance_.key;
    const int times = task.Count("times", 1);
    const double hold_s = task.Number("duration_s", 0.0);
    if (task.action == "squat" || task.action == "brace") {
      const bool brace = task.action == "brace";
      const tasks::Sizes sizes = task.Has("depth_m")
                                     ? tasks::Sizes{{task.Number("depth_m", 0.0)}, true, "depth_m"}
                                     : tasks::Sizes{Shares((brace ? 0.3 : 0.2) * leg, {1.0, 0.75, 0.5, 0.25}), false, ""};
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
      return AddPosture(
          [&](double lower) { return BalanceOn(model_, from, on, lower, task.Number("duration_s", 2.0)); },
          {Shares(leg, {0.0, 0.02, 0.05, 0.1}), false, ""});
    }
    Task gesture = task;
    if (task.action == "wave" && !task.Has("times") && !task.Has("duration_s")) gesture.parameters["times"] = 3;
    const Result<PostureMotion> motion = GestureMotion(gesture, from, hold_s);
    if (!motion) return motion.failure();
    return AddPosture(*motion);
  }

  std::optional<Failure> BowDown(const Task& task, int times) {
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
  int FootOf(const std::string& side) const {
    const std::vector<Pose> feet = StandingFeet(model_);
    const bool first_is_left = feet[0].translation().y() > feet[1].translation().y();
    return (side == "left") == first_is_left ? 0 : 1;
  }

  const RobotModel& model_;
  const Terrain& terrain_;
  const TaskOptions& options_;
  const Task* task_ = nullptr;
  Stance stance_;
  std::optional<VectorX> joints_after_;
  std::optional<MotionPlan> whole_;
  std::vector<std::string> notes_;
  double size_ = 0.0;
};

/// CPU time since it was made.
class Clock {
 public:
  double elapsed_s() const { return static_cast<double>(std::clock() - start_) / CLOCKS_PER_SEC; }

 private:
  std::clock_t start_ = std::clock();
};

Failure OfTask(std::size_t index, const Task& task, Failure failure) {
  const std::string words = task.words.empty() ? TaskText(task) : task.words;
  failure.message = fmt::format("task {}, '{}': {}", index + 1, words, failure.message);
  return failure;
}

Provenance ProvenanceOf(const TaskPlan& tasks, const TaskOptions& options) {
  MotionOptions motion = options.motion;
  Provenance provenance{Version(), "PlanTasks", {{"tasks", TaskPlanJson(tasks)}}, options.seed};
  for (const auto& [key, text] : TextsOf(motion.Fields())) provenance.options.emplace_back(key, text);
  return provenance;
}

}  // namespace

Result<PlannedTasks> PlanTasks(const RobotModel& model, const Terrain& terrain, const TaskPlan& tasks,
                               const TaskOptions& options) {
  const Clock clock;
  TaskScope scope = ScopeOf(model);
  scope.places = PlacesOf(terrain);
  if (auto failure = WhyNotPlanned(tasks, scope)) return *failure;
  TaskPlanner planner(model, terrain, options);
  for (std::size_t k = 0; k < tasks.tasks.size(); ++k) {
    if (auto failure = planner.Add(tasks.tasks[k])) return OfTask(k, tasks.tasks[k], *failure);
  }
  PlannedTasks planned;
  planned.plan = planner.TakePlan();
  planned.notes = std::move(planner.notes());
  planned.plan.provenance = ProvenanceOf(tasks, options);
  planned.planning_cpu_s = clock.elapsed_s();
  const Result<AuditReport> audit = Audit(model, planned.plan, {});
  if (!audit) return audit.failure();
  planned.audit = *audit;
  return planned;
}

}  // namespace gaitwright
