// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/exchange/footstep_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "kinematics/base/strict_yaml_internal.h"
#include "kinematics/spatial/rotation.h"
#include "kinematics/trajectory/swing_curve.h"
#include "planning/footsteps/base_over_feet.h"
#include "planning/paths/standing_feet.h"
#include "workflows/exchange/contact_plan_internal.h"
#include "workflows/exchange/file_shapes.h"

namespace gaitwright {
namespace {

constexpr double kFar = 1000.0;  // [m]
constexpr double kStand = 0.8;   // [s] default before the first step and after the last
constexpr std::size_t kMostSteps = 10'000;

DataShape SecondsShape() { return shapes::Number(0.0, kLongestMotion); }

/// Structure of the position of a foot.
DataShape PlaceShape() {
  using namespace shapes;
  return Object({{"foot", Text(), "Name of a foot of the robot."},
                 {"x_m", Number(-kFar, kFar)},
                 {"y_m", Number(-kFar, kFar)},
                 Optional("z_m", Number(-kFar, kFar), "Height, checked against the ground within 1 cm."),
                 Optional("yaw_rad", Number(-10.0, 10.0), "Heading relative to the standing posture.")});
}

DataShape StepShape() {
  using namespace shapes;
  DataShape shape = PlaceShape();
  shape.members.push_back(Optional("lift_off_s", SecondsShape(), "Required if touch_down_s is given."));
  shape.members.push_back(Optional("touch_down_s", SecondsShape(), "Required if lift_off_s is given."));
  shape.members.push_back(
      Optional("swing_s", SecondsShape(), "Duration of the swing, instead of lift_off_s and touch_down_s."));
  shape.members.push_back(Optional("pause_s", SecondsShape(), "Pause before the next step."));
  return shape;
}

/// A step as in the file.
struct AskedStep {
  int foot = 0;
  Pose X_WF = Pose::Identity();
  int patch = 0;
  double liftoff_s = 0.0, touchdown_s = 0.0;
};

/// Gives the pose of a foot over time as it moves from step to step.
class SteppingFoot {
 public:
  SteppingFoot(const Pose& start, const std::vector<AskedStep>& steps) : from_(start), steps_(steps) {}

  /// Its pose at a time, which must not be earlier than in the previous call.
  Pose At(double time_s) {
    while (next_ < steps_.size() && time_s >= steps_[next_].touchdown_s) from_ = steps_[next_++].X_WF;
    if (next_ == steps_.size() || time_s <= steps_[next_].liftoff_s) return from_;
    const AskedStep& step = steps_[next_];
    const double share = SmoothStep((time_s - step.liftoff_s) / (step.touchdown_s - step.liftoff_s)).value;
    const Vector3 turn = RotationLog(step.X_WF.linear() * from_.linear().transpose());
    Pose X_WF = from_;
    X_WF.translation() += share * (step.X_WF.translation() - from_.translation());
    X_WF.linear() = RotationExp(share * turn) * from_.linear();
    return X_WF;
  }

 private:
  Pose from_;
  const std::vector<AskedStep>& steps_;
  std::size_t next_ = 0;
};

class FootstepReader {
 public:
  FootstepReader(const RobotModel& model, const Terrain& terrain, double grid_s)
      : model_(model),
        terrain_(terrain),
        grid_s_(grid_s),
        start_(StandingFeet(model)),
        patch_(start_.size(), 0),
        steps_(start_.size()) {}

  FootstepSkeleton Read(const YAML::Node& root) {
    const DataShape shape = FootstepFileShape();
    const YamlMap map(root, "the file", shape);
    swing_s_ = Seconds(map, "swing_s");
    pause_s_ = Seconds(map, "pause_s");
    now_s_ = Seconds(map, "initial_stand_s").value_or(kStand);
    final_stand_s_ = Seconds(map, "final_stand_s").value_or(kStand);
    for (std::size_t f = 0; f < start_.size(); ++f)
      start_[f] = OnGround(start_[f], static_cast<int>(f), patch_[f], root);
    if (const YAML::Node* start = map.Find("start")) TakeStart(*start);
    const std::vector<YAML::Node> steps = ListOf(*map.Find("footsteps"), "footsteps");
    if (steps.empty()) RefuseYaml(*map.Find("footsteps"), "footsteps is empty; one or more are needed");
    if (steps.size() > kMostSteps)
      RefuseYaml(*map.Find("footsteps"),
                 fmt::format("has {} footsteps; at most {} are read", steps.size(), kMostSteps));
    for (const YAML::Node& step : steps) TakeStep(step);
    return Skeleton(OnGrid(last_s_ + final_stand_s_));
  }

 private:
  double OnGrid(double time_s) const { return grid_s_ * std::round(time_s / grid_s_); }

  static std::optional<double> Seconds(const YamlMap& map, const std::string& key) {
    const YAML::Node* node = map.Find(key);
    if (node == nullptr) return std::nullopt;
    return NumberOf(*node, key, SecondsShape());
  }

  int FootOf(const YamlMap& map, const YAML::Node& node) const {
    const std::string name = map.Text("foot");
    std::vector<std::string> names;
    for (const Foot& foot : model_.feet) names.push_back(foot.name);
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) {
      RefuseYaml(node, fmt::format("robot '{}' has no foot '{}'; it has {}", model_.name, name, QuotedList(names)));
    }
    return static_cast<int>(found - names.begin());
  }

  /// Puts a pose in plan view on the ground; `patch` gets the index of the ground patch.
  Pose OnGround(const Pose& level, int foot, int& patch, const YAML::Node& node) const {
    const GroundPoint ground = GroundAt(terrain_, level.translation().head<2>());
    if (ground.patch < 0) {
      RefuseYaml(node, fmt::format("foot '{}' at x = {:.3f} m, y = {:.3f} m has no ground under it",
                                   model_.feet[static_cast<std::size_t>(foot)].name, level.translation().x(),
                                   level.translation().y()));
    }
    Pose X_WF = level;
    X_WF.translation().z() = ground.height_m;
    X_WF.linear() = RotationBetween(Vector3::UnitZ(), ground.normal_W) * level.linear();
    patch = ground.patch;
    return X_WF;
  }

  /// The pose of a foot; its heading is relative to the standing posture.
  Pose PlaceOf(const YamlMap& map, int foot, int& patch, const YAML::Node& node) const {
    constexpr double kOff = 0.01;  // [m]
    const DataShape shape = PlaceShape();
    const auto number = [&](const char* key) {
      return map.Find(key) == nullptr ? 0.0 : NumberOf(*map.Find(key), key, shape.At(key));
    };
    const double yaw = number("yaw_rad");
    Pose level = Pose::Identity();
    level.linear() = YawRotation(yaw) * StandingFeet(model_)[static_cast<std::size_t>(foot)].linear();
    level.translation() = Vector3(number("x_m"), number("y_m"), 0.0);
    Pose X_WF = OnGround(level, foot, patch, node);
    if (const YAML::Node* z = map.Find("z_m")) {
      const double height = number("z_m");
      if (std::abs(height - X_WF.translation().z()) > kOff) {
        RefuseYaml(*z, fmt::format(
                           "z_m = {:.4g} m is not on the ground, whose height is {:.4g} m there; accepted: within {} m",
                           height, X_WF.translation().z(), kOff));
      }
    }
    return X_WF;
  }

  void TakeStart(const YAML::Node& node) {
    std::vector<bool> said(start_.size(), false);
    for (const YAML::Node& entry : ListOf(node, "start")) {
      const DataShape shape = PlaceShape();
      const YamlMap map(entry, "a foot at the start", shape);
      const int foot = FootOf(map, entry);
      const auto f = static_cast<std::size_t>(foot);
      if (said[f]) RefuseYaml(entry, fmt::format("foot '{}' is in 'start' twice", model_.feet[f].name));
      said[f] = true;
      start_[f] = PlaceOf(map, foot, patch_[f], entry);
    }
    if (std::find(said.begin(), said.end(), false) != said.end())
      RefuseYaml(node, fmt::format("start has {} of {} feet; it needs all", std::count(said.begin(), said.end(), true),
                                   said.size()));
  }

  void TakeStep(const YAML::Node& node) {
    const DataShape shape = StepShape();
    const YamlMap map(node, "a footstep", shape);
    AskedStep step;
    step.foot = FootOf(map, node);
    step.X_WF = PlaceOf(map, step.foot, step.patch, node);
    const std::optional<double> lift = Seconds(map, "lift_off_s"), touch = Seconds(map, "touch_down_s");
    if (lift.has_value() != touch.has_value()) RefuseYaml(node, "lift_off_s and touch_down_s must be given together");
    const std::optional<double> swing = Seconds(map, "swing_s") ? Seconds(map, "swing_s") : swing_s_;
    if (!lift && !swing)
      RefuseYaml(node, "a footstep needs lift_off_s and touch_down_s, or a swing_s of its own or of all footsteps");
    step.liftoff_s = OnGrid(lift.value_or(now_s_));
    step.touchdown_s = OnGrid(touch.value_or(now_s_ + swing.value_or(0.0)));
    now_s_ = step.touchdown_s + Seconds(map, "pause_s").value_or(pause_s_.value_or(0.1));
    last_s_ = std::max(last_s_, step.touchdown_s);
    CheckTimes(step, node);
    steps_[static_cast<std::size_t>(step.foot)].push_back(step);
  }

  void CheckTimes(const AskedStep& step, const YAML::Node& node) const {
    const double least = 2.0 * grid_s_ - 1e-9;
    const std::string& name = model_.feet[static_cast<std::size_t>(step.foot)].name;
    if (step.touchdown_s - step.liftoff_s < least) {
      RefuseYaml(node, fmt::format("foot '{}' swings from {:.4g} to {:.4g} s; at least {} s are needed", name,
                                   step.liftoff_s, step.touchdown_s, 2.0 * grid_s_));
    }
    if (step.touchdown_s + final_stand_s_ > kLongestMotion) {
      RefuseYaml(
          node,
          fmt::format(
              "foot '{}' touches down at {:.6g} s and the motion ends {:.6g} s later; at most {:.0f} s are accepted",
              name, step.touchdown_s, final_stand_s_, kLongestMotion));
    }
    const std::vector<AskedStep>& before = steps_[static_cast<std::size_t>(step.foot)];
    const double stands_since = before.empty() ? 0.0 : before.back().touchdown_s;
    if (step.liftoff_s - stands_since < least) {
      RefuseYaml(node, fmt::format("foot '{}' lifts off at {:.4g} s but is on the ground only from {:.4g} s on; it "
                                   "must stand for at least {} s, and its steps must be in order of time",
                                   name, step.liftoff_s, stands_since, 2.0 * grid_s_));
    }
  }

  FootstepSkeleton Skeleton(double end_s) const {
    FootstepSkeleton skeleton;
    std::vector<std::vector<ContactInterval>> by_foot(start_.size());
    for (std::size_t f = 0; f < start_.size(); ++f) {
      Foothold stands{static_cast<int>(f), start_[f], Vector3::Zero(), patch_[f], 0.0, end_s};
      for (const AskedStep& step : steps_[f]) {
        stands.liftoff_s = step.liftoff_s;
        skeleton.footsteps.footholds.push_back(stands);
        by_foot[f].push_back({stands.touchdown_s, stands.liftoff_s});
        stands = {step.foot, step.X_WF, Vector3::Zero(), step.patch, step.touchdown_s, end_s};
      }
      skeleton.footsteps.footholds.push_back(stands);
      by_foot[f].push_back({stands.touchdown_s, end_s});
    }
    SortFootholds(skeleton.footsteps);
    skeleton.schedule = ScheduleFromIntervals(by_foot, 0.0, end_s);
    AddPath(end_s, skeleton);
    AddPart(end_s, skeleton);
    return skeleton;
  }

  /// Adds the base path: the base stays above the mean position of its feet, including those in swing.
  void AddPath(double end_s, FootstepSkeleton& skeleton) const {
    const std::vector<Pose> standing = StandingFeet(model_);
    const int rows = 1 + static_cast<int>(std::lround(end_s / grid_s_));
    std::vector<SteppingFoot> stepping;
    for (std::size_t f = 0; f < start_.size(); ++f) stepping.emplace_back(start_[f], steps_[f]);
    std::vector<Pose> feet = start_;
    double yaw_rad = MeanHeading(standing, feet);
    for (int k = 0; k < rows; ++k) {
      const double time_s = std::min(k * grid_s_, end_s);
      for (std::size_t f = 0; f < feet.size(); ++f) feet[f] = stepping[f].At(time_s);
      yaw_rad += WrapAngle(MeanHeading(standing, feet) - yaw_rad);  // without jumps of 2 pi
      skeleton.path.time_s.push_back(time_s);
      skeleton.path.pose.push_back(FitBase(standing, feet, yaw_rad).plan);
    }
  }

  void AddPart(double end_s, FootstepSkeleton& skeleton) const {
    const PlanarPose &from = skeleton.path.pose.front(), &to = skeleton.path.pose.back();
    const double c = std::cos(from.yaw_rad), s = std::sin(from.yaw_rad), x = to.x_m - from.x_m, y = to.y_m - from.y_m;
    MotionPart part;
    part.command.extent = WalkCommand::Extent::kGoal;
    part.command.goal_x_m = c * x + s * y;
    part.command.goal_y_m = c * y - s * x;
    part.command.goal_yaw_rad = WrapAngle(to.yaw_rad - from.yaw_rad);
    part.goal = skeleton.goal = to;
    part.end_s = end_s;
    part.gait = {"footsteps", "as the file has them", end_s, {}, {}};
    for (std::size_t f = 0; f < start_.size(); ++f) {
      double stands_s = 0.0;
      for (const ContactInterval& interval : IntervalsOf(skeleton.schedule, static_cast<int>(f)))
        stands_s += interval.end_s - interval.start_s;
      part.gait.phase.push_back(0.0);
      part.gait.duty_factor.push_back(stands_s / end_s);
    }
    skeleton.parts = {part};
  }

  const RobotModel& model_;
  const Terrain& terrain_;
  const double grid_s_;
  std::vector<Pose> start_;
  std::vector<int> patch_;
  std::optional<double> swing_s_, pause_s_;
  double now_s_ = 0.0, last_s_ = 0.0, final_stand_s_ = kStand;
  std::vector<std::vector<AskedStep>> steps_;  // by foot, in order of time
};

/// Time in which each foot makes one step; the tilt of the body is averaged over it.
double RoundOf(const FootstepSkeleton& skeleton, std::size_t feet) {
  constexpr double kShortest = 0.2;  // [s]
  const double steps = static_cast<double>(skeleton.footsteps.footholds.size() - feet);
  return std::max(kShortest, skeleton.schedule.end_s() * static_cast<double>(feet) / std::max(1.0, steps));
}

/// What `work` reads from a YAML text, or why it cannot be read.
template <class Read>
Result<Read> ReadSteps(const std::string& source, const std::function<Read()>& work) {
  const auto refused = [&](const std::string& why) {
    return Failure{
        FailureKind::kBadInput, FailureCode::kFootsteps, "ImportMotion", fmt::format("'{}': {}", source, why), {}};
  };
  try {
    return work();
  } catch (const InvalidArgument& error) {
    return refused(error.what());
  } catch (const YAML::Exception& error) {
    return refused(fmt::format("line {}: {}", error.mark.line + 1, error.msg));
  }
}

}  // namespace

DataShape FootstepFileShape() {
  using namespace shapes;
  return Object(
      {{"footsteps", List(StepShape(), 1, kMostSteps), "Footsteps, in order of time for each foot."},
       Optional("start", List(PlaceShape(), 1), "Start positions of all feet; default: the standing posture."),
       Optional("swing_s", SecondsShape(), "Swing duration of steps that do not set it."),
       Optional("pause_s", SecondsShape(), "Pause between steps that do not set their times."),
       Optional("initial_stand_s", SecondsShape(), "Standing time before the first step."),
       Optional("final_stand_s", SecondsShape(), "Standing time after the last step.")});
}

Result<FootstepSkeleton> ReadFootsteps(const RobotModel& model, const Terrain& terrain, const std::string& text,
                                       const std::string& source, double grid_s) {
  return ReadSteps<FootstepSkeleton>(source,
                                     [&] { return FootstepReader(model, terrain, grid_s).Read(LoadYaml(text)); });
}

std::optional<Failure> PlanFootstepFile(const RobotModel& model, const Terrain& terrain, const std::string& text,
                                        const ImportRequest& request, ImportedMotion& imported) {
  if (request.goal)
    return Failure{FailureKind::kBadInput,
                   FailureCode::kFootsteps,
                   "ImportMotion",
                   "the footsteps determine the goal: leave out --goal",
                   {}};
  const Result<std::string> steps = ReadSteps<std::string>(request.file, [&] {
    return HoldsContactPlan(text) ? FootstepsOfContactPlan(model, text, imported.unused_columns) : text;
  });
  if (!steps) return steps.failure();
  const Result<FootstepSkeleton> skeleton =
      ReadFootsteps(model, terrain, *steps, request.file, request.motion.pipeline.grid_step_s);
  if (!skeleton) return skeleton.failure();
  if (auto failure = ReasonOutOfReach(model, *skeleton, request.motion.footsteps.reach)) return failure;
  Result<PlannedMotion> planned =
      PlanMotion(model, terrain, *skeleton, RoundOf(*skeleton, model.feet.size()), request.motion);
  if (!planned) return planned.failure();
  imported.format = MotionFormat::kFootsteps;
  imported.rows = static_cast<int>(skeleton->footsteps.footholds.size() - model.feet.size());
  imported.plan = std::move(planned->plan);
  imported.notes.warnings = std::exchange(imported.plan.warnings, {});
  imported.notes.derived.push_back({"the whole motion", "planned over the footsteps: " + planned->summary});
  return std::nullopt;
}

}  // namespace gaitwright
