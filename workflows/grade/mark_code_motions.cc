// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "kinematics/base/nearest_name.h"
#include "planning/plan/plan_json.h"
#include "workflows/exchange/placed_steps.h"
#include "workflows/grade/mark_motion_internal.h"
#include "workflows/grade/student_answer.h"

namespace gaitwright {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMostSteps = 1000;

int FootOf(const RobotModel& model, const std::string& name) {
  std::vector<std::string> names;
  for (std::size_t foot = 0; foot < model.feet.size(); ++foot) {
    if (model.feet[foot].name == name) return static_cast<int>(foot);
    names.push_back(model.feet[foot].name);
  }
  throw InvalidArgument(
      fmt::format("the planner's answer names the unknown foot '{}'{}", name, NearestOrAll(name, names)));
}

std::vector<PlacedStep> StepsOf(const RubricPart& part, const RobotModel& model, const std::string& line) {
  const MotionSetup& motion = part.motion;
  std::vector<PlacedStep> steps;
  for (const AnsweredStep& step : ParseSteps(line, kMostSteps))
    steps.push_back({FootOf(model, step.foot), {step.x_m, step.y_m, step.yaw_rad}});
  const double lasts_s = static_cast<double>(steps.size()) * (motion.swing_s + motion.pause_s);
  if (lasts_s > motion.longest_motion_s)
    throw InvalidArgument(fmt::format("the planner gave {} steps, which last {:.1f} s; at most {:g} s are accepted",
                                      steps.size(), lasts_s, motion.longest_motion_s));
  return steps;
}

std::string StepsRequest(const RobotModel& model, const MotionRun& run, const PlanarPose& goal) {
  return Json{{"robot", model.name},
              {"terrain", run.terrain_text},
              {"goal", {goal.x_m, goal.y_m, goal.yaw_rad}},
              {"most", kMostSteps}}
      .dump();
}

/// Runs a planner on one ground. @throws BrokenCode
RunOutcome WalkOver(const HandedIn& in, const RobotModel& model, const MotionRun& run, StudentPython& code,
                    std::vector<MotionPage>& pages) {
  RunOutcome outcome;
  outcome.title = run.title;
  outcome.trials = in.part.motion.trials;
  const PlanarPose goal = GoalOf(model, run.walk.command);
  const Result<std::string> line = code.Ask(StepsRequest(model, run, goal), kLongestAnswer);
  if (!line && EndedIt(line.failure())) throw BrokenCode(ReasonOf(line.failure()));
  if (!line) {
    outcome.failure = ReasonOf(line.failure());
    return outcome;
  }
  try {
    const std::vector<PlacedStep> steps = StepsOf(in.part, model, *line);
    Result<MotionPlan> plan =
        PlanOverSteps(model, run.terrain, steps, {in.part.motion.swing_s, in.part.motion.pause_s});
    if (!plan) throw InvalidArgument(plan.failure().message);
    SetGoal(run.walk.command, goal, *plan);
    return JudgeRun({in.part, model}, run, *plan, pages);
  } catch (const InvalidArgument& error) {
    outcome.failure = ShownWords(error.what());
    return outcome;
  }
}

/// A controller whose commands come from a submission's code, over pipes. After a failure it sends no more requests,
/// and the motors are passive.
class AskedController final : public Controller {
 public:
  AskedController(StudentPython& code, int dofs, std::string& broken) : code_(code), dofs_(dofs), broken_(broken) {}

  JointCommand Update(const ControlInput& input) override {
    if (broken_.empty()) {
      try {
        return Asked(input);
      } catch (const InvalidArgument& error) {
        broken_ = fmt::format("the controller at {:.3f} s: {}", input.time_s, error.what());
      }
    }
    const VectorX nothing = VectorX::Zero(dofs_);
    return {nothing, nothing, nothing, nothing, nothing};
  }
  std::string Name() const override { return "submission"; }

 private:
  static std::string RequestOf(const ControlInput& input) {
    const auto list = [](const VectorX& v) { return std::vector<double>(v.data(), v.data() + v.size()); };
    Json forces = Json::array(), contact = Json::array();
    for (std::size_t foot = 0; foot < input.wrenches.size(); ++foot) {
      const Vector3& f = input.wrenches[foot].force_W;
      forces.push_back({f.x(), f.y(), f.z()});
      contact.push_back(Contains(input.contact, static_cast<int>(foot)));
    }
    return Json{{"update", {input.time_s, input.step_s, list(input.q), list(input.v), forces, contact}}}.dump();
  }

  JointCommand Asked(const ControlInput& input) {
    const Result<std::string> line = code_.Ask(RequestOf(input), kLongestAnswer);
    if (!line) throw InvalidArgument(ReasonOf(line.failure()));
    const std::vector<VectorX> rows = ParseRows(*line, 5, dofs_);
    if (rows[3].minCoeff() < 0.0 || rows[4].minCoeff() < 0.0)
      throw InvalidArgument("it gave a negative stiffness or damping; 0 or more is accepted");
    return {rows[0], rows[1], rows[2], rows[3], rows[4]};
  }

  StudentPython& code_;
  int dofs_;
  std::string& broken_;
};

/// Writes the plan for the code, which makes a controller for each playback.
ControllerMaker MakerOf(StudentPython& code, const RobotModel& model, const std::string& plan_path,
                        std::string& broken) {
  return [&code, &model, plan_path, &broken](const MotionPlan&) {
    const Result<std::string> made = code.Ask(Json{{"plan", plan_path}}.dump(), kLongestAnswer);
    if (!made && broken.empty()) broken = ReasonOf(made.failure());
    return std::make_unique<AskedController>(code, model.num_dofs(), broken);
  };
}

}  // namespace

PartMark MarkPlanner(const HandedIn& in) {
  const RobotModel model = RobotOf(in.part);
  const std::vector<MotionRun> runs = DrawRuns(in.part, model, in.setup.seed);
  Result<StudentPython> code = StartCode(in);
  if (!code) return NothingFor(in.part, ReasonOf(code.failure()));
  std::vector<RunOutcome> outcomes;
  std::vector<MotionPage> pages;
  for (const MotionRun& run : runs) outcomes.push_back(WalkOver(in, model, run, *code, pages));
  return MarkOfRuns(in.part, outcomes, std::move(pages));
}

PartMark MarkController(const HandedIn& in) {
  const RobotModel model = RobotOf(in.part);
  const std::vector<MotionRun> runs = DrawRuns(in.part, model, in.setup.seed);
  Result<StudentPython> code = StartCode(in);
  if (!code) return NothingFor(in.part, ReasonOf(code.failure()));
  std::string broken;
  std::vector<RunOutcome> outcomes;
  std::vector<MotionPage> pages;
  for (std::size_t number = 0; number < runs.size(); ++number) {
    const MotionPlan plan = GivenPlan(in.part, model, runs[number]);
    const Result<std::string> lent = code->Lend(fmt::format("plan{}.json", number + 1), PlanToJson(plan));
    if (!lent) return NothingFor(in.part, lent.failure().message);
    outcomes.push_back(JudgeRun({in.part, model, MakerOf(*code, model, *lent, broken), [&] { return broken; }},
                                runs[number], plan, pages));
  }
  return MarkOfRuns(in.part, outcomes, std::move(pages));
}

}  // namespace gaitwright
