// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "kinematics/base/options_file.h"
#include "kinematics/model/load_robot.h"
#include "planning/paths/base_path.h"
#include "planning/plan/carried_plan.h"
#include "planning/plan/plan_json.h"
#include "planning/plan/robot_of_plan.h"
#include "workflows/exchange/import_motion.h"
#include "workflows/grade/mark_motion_internal.h"
#include "workflows/render/temporary_folder_internal.h"
#include "workflows/study/run_point.h"

namespace gaitwright {
namespace {

constexpr double kCommandApart = 1e-6, kSlower = 1.25, kStandsFor = 4.0;

/// Whether two grounds are equal except for their names.
bool SameGround(const Terrain& a, const Terrain& b) {
  MotionPlan on_a, on_b;
  on_a.terrain = a;
  on_b.terrain = b;
  return MotionHash(on_a) == MotionHash(on_b);
}

/// The difference between a plan's command and the rubric's; "" if they are equal.
std::string OtherCommand(const WalkCommand& given, const WalkCommand& asked) {
  if (given.extent != asked.extent) return "it sets the distance in another way";
  const auto differs = [](double a, double b) { return !(std::abs(a - b) <= kCommandApart); };
  const auto words = [&](const char* key, double is, double should) {
    return differs(is, should) ? fmt::format("{} is {:g}, not {:g}", key, is, should) : "";
  };
  for (const std::string& word :
       {words("speed_m_s", given.speed_m_s, asked.speed_m_s),
        words("lateral_speed_m_s", given.lateral_speed_m_s, asked.lateral_speed_m_s),
        words("yaw_rate_rad_s", given.yaw_rate_rad_s, asked.yaw_rate_rad_s),
        words("distance_m", given.distance_m, asked.distance_m), words("goal_x_m", given.goal_x_m, asked.goal_x_m),
        words("goal_y_m", given.goal_y_m, asked.goal_y_m),
        words("goal_yaw_rad", given.goal_yaw_rad, asked.goal_yaw_rad)}) {
    if (!word.empty()) return word;
  }
  return "";
}

/// Longest accepted duration of a walk at the commanded speed, with standing; infinite without a commanded speed.
double LongestWalk(const RobotModel& model, const WalkCommand& command) {
  const double speed = std::hypot(command.speed_m_s, command.lateral_speed_m_s);
  if (speed == 0.0) return std::numeric_limits<double>::infinity();
  const PlanarPose goal = GoalOf(model, command);
  const double distance_m = std::max(command.distance_m, std::hypot(goal.x_m, goal.y_m));
  return kSlower * distance_m / speed + kStandsFor;
}

/// Checks that a submitted plan is for the given robot, ground and command. @throws InvalidArgument that names the
/// difference.
void CheckPlan(const RobotModel& model, const MotionRun& run, const MotionPlan& plan) {
  if (plan.robot != model.name || plan.robot_hash != model.hash)
    throw InvalidArgument(fmt::format("the plan is for robot '{}' ({}), but this part needs '{}' ({})", plan.robot,
                                      plan.robot_hash, model.name, model.hash));
  if (!SameGround(plan.terrain, run.terrain))
    throw InvalidArgument(
        fmt::format("the plan is for ground '{}', but this part needs '{}'", plan.terrain.name, run.terrain_text));
  if (plan.parts.size() != 1)
    throw InvalidArgument(fmt::format("the plan has {} parts; one walk is needed", plan.parts.size()));
  if (const std::string other = OtherCommand(plan.parts.front().command, run.walk.command); !other.empty())
    throw InvalidArgument("the plan is for another command: " + other);
  if (plan.duration_s() > LongestWalk(model, run.walk.command))
    throw InvalidArgument(fmt::format("the plan takes {:.1f} s; at the commanded speed, at most {:.1f} s are accepted",
                                      plan.duration_s(), LongestWalk(model, run.walk.command)));
}

/// Checks that a motion begins at the origin, because elsewhere it could avoid the obstacles of the ground. @throws
/// InvalidArgument that says where it begins.
void CheckStart(const MotionPlan& plan) {
  if (plan.whole_body.q.empty() || plan.whole_body.q.front().size() < 7) return;  // SetGoal refuses it
  constexpr double kNear = 0.1;                                                   // [m], [rad]
  const PlanarPose start = BaseInPlan(plan.whole_body.q.front());
  if (std::hypot(start.x_m, start.y_m) <= kNear && std::abs(start.yaw_rad) <= kNear) return;
  throw InvalidArgument(
      fmt::format("the motion begins at x {:.2f} m, y {:.2f} m, yaw {:.2f} rad; it must begin at the origin and face "
                  "x, each within {} m or rad",
                  start.x_m, start.y_m, start.yaw_rad, kNear));
}

/// Copies a file of the submission to a temporary file of the same name, for functions that read files. Their messages
/// have its path; the student sees only its name.
class Copied {
 public:
  explicit Copied(const HandedIn& in) : name_(in.part.file), path_(folder_.In(in.part.file)) {
    const Result<std::string> written = WriteFileAtomically(path_, in.text);
    if (!written) throw InvalidArgument("the submission cannot be copied: " + written.failure().message);
  }
  const std::string& path() const { return path_; }
  std::string Words(std::string message) const {
    for (std::size_t at = 0; (at = message.find(path_)) != std::string::npos;) message.replace(at, path_.size(), name_);
    return message;
  }

 private:
  TemporaryFolder folder_;
  std::string name_, path_;
};

/// The submitted options. @throws InvalidArgument for an option that must not be set.
OptionTexts OptionsOf(const HandedIn& in) {
  const Copied file(in);
  WalkRequest walk;
  PlayRequest play;
  const Result<OptionTexts> read = LoadOptionsFile(file.path(), StudyFields(walk, play));
  if (!read) throw InvalidArgument(file.Words(read.failure().message));
  WalkRequest planned;
  const OptionFields own = planned.Fields();
  for (const auto& [key, text] : *read) {
    const std::string& name = key;
    const bool of_plan =
        std::any_of(own.begin(), own.end(), [&](const OptionField& field) { return field.key == name; });
    if (!of_plan || (!in.part.motion.options.empty() && !MayBeSet(key, in.part.motion.options)))
      throw InvalidArgument(fmt::format("the option '{}' must not be set in this part", key));
  }
  return *read;
}

}  // namespace

RobotModel RobotOf(const RubricPart& part) {
  Result<RobotModel> model = LoadNamedRobot(part.motion.robot);
  if (!model) throw InvalidArgument(model.failure().message);
  return std::move(*model);
}

void SetGoal(const WalkCommand& command, const PlanarPose& goal, MotionPlan& plan) {
  if (plan.whole_body.q.empty() || plan.whole_body.q.front().size() < 7 || plan.parts.empty())
    throw InvalidArgument("the plan contains no motion");
  plan.goal = Carried(BaseInPlan(plan.whole_body.q.front()), goal);
  plan.parts.back().command = command;
  plan.parts.back().goal = plan.goal;
}

PartMark MarkPlan(const HandedIn& in) {
  const RobotModel model = RobotOf(in.part);
  Result<MotionPlan> plan = PlanFromJson(in.text, in.part.file);
  if (!plan) return NothingFor(in.part, ShownWords(plan.failure().message));
  std::vector<RunOutcome> outcomes;
  std::vector<MotionPage> pages;
  for (const MotionRun& run : DrawRuns(in.part, model, in.setup.seed)) {
    CheckPlan(model, run, *plan);
    CheckStart(*plan);
    SetRobot(model, *plan);
    plan->terrain = run.terrain;
    SetGoal(run.walk.command, GoalOf(model, run.walk.command), *plan);
    outcomes.push_back(JudgeRun({in.part, model}, run, *plan, pages));
  }
  return MarkOfRuns(in.part, outcomes, std::move(pages));
}

PartMark MarkMotionFile(const HandedIn& in) {
  const RobotModel model = RobotOf(in.part);
  const Copied file(in);
  std::vector<RunOutcome> outcomes;
  std::vector<MotionPage> pages;
  for (const MotionRun& run : DrawRuns(in.part, model, in.setup.seed)) {
    ImportRequest request;
    request.file = file.path();
    request.terrain = run.terrain_text;
    if (!in.part.motion.command.empty()) request.goal = GoalOf(model, run.walk.command);
    Result<ImportedMotion> imported = ImportMotion(model, request);
    if (!imported) return NothingFor(in.part, ShownWords(file.Words(imported.failure().message)));
    if (run.terrain_text != "flat") CheckStart(imported->plan);
    if (request.goal) SetGoal(run.walk.command, *request.goal, imported->plan);
    outcomes.push_back(JudgeRun({in.part, model}, run, imported->plan, pages));
  }
  return MarkOfRuns(in.part, outcomes, std::move(pages));
}

PartMark MarkParameters(const HandedIn& in) {
  const RobotModel model = RobotOf(in.part);
  const OptionTexts options = OptionsOf(in);
  std::vector<RunOutcome> outcomes;
  std::vector<MotionPage> pages;
  for (MotionRun& run : DrawRuns(in.part, model, in.setup.seed)) {
    OptionFields fields = run.walk.Fields();
    for (const auto& [key, text] : options) SetOption(fields, key, text);
    const Result<PlannedWalk> planned = PlanWalkOn(model, run.terrain, run.walk);
    if (planned) {
      outcomes.push_back(JudgeRun({in.part, model}, run, planned->motion.plan, pages));
    } else {
      outcomes.push_back({run.title, ShownWords(planned.failure().message), {}, false, "", in.part.motion.trials, 0});
    }
  }
  return MarkOfRuns(in.part, outcomes, std::move(pages));
}

}  // namespace gaitwright
