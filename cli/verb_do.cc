// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>

#include "cli/json_text_internal.h"
#include "cli/output.h"
#include "cli/paths.h"
#include "cli/robot_input.h"
#include "cli/walk_arguments.h"
#include "kinematics/base/file.h"
#include "planning/plan/terrain_scale.h"
#include "planning/tasks/task_plan_json.h"
#include "planning/terrain/load_terrain.h"
#include "workflows/words/interpret.h"
#include "workflows/words/places.h"
#include "workflows/words/plan_tasks.h"
#include "workflows/words/task_scores.h"

namespace gaitwright::cli {
namespace {

struct DoSettings {
  Common common;
  std::string text, task_file, terrain = "flat";
  RobotFlags robot;
  LanguageModel interpreter;
  TaskOptions tasks;
  PlayArguments play;
  Outputs outputs;
  bool yes = false, schema = false, only_tasks = false;

  bool asks_model() const { return !interpreter.url.empty(); }
};

void CheckDo(const DoSettings& a) {
  if (a.text.empty() == a.task_file.empty())
    throw InvalidArgument("give the task either as TEXT or by --task-plan FILE");
  if (a.asks_model() != !a.interpreter.model.empty())
    throw InvalidArgument("--interpreter (the endpoint) and --model (the model's name) must be given together");
  if (!(a.interpreter.longest_s >= 0.1 && a.interpreter.longest_s <= 3600.0))
    throw InvalidArgument(
        fmt::format("--interpreter-timeout {} is out of its range: 0.1 to 3600 s", a.interpreter.longest_s));
  if (a.asks_model() && a.text.empty()) throw InvalidArgument("--interpreter is for TEXT, not for --task-plan");
  Paths paths;
  paths.Read("--task-plan", a.task_file);
  a.outputs.AddPathsTo(paths);
  a.robot.AddTo(paths);
  paths.AddTerrain(a.terrain);
  CheckPaths(paths);
}

Result<Interpretation> TasksOf(const DoSettings& a, const TaskScope& scope) {
  if (a.task_file.empty()) {
    return Interpret(a.text, scope, a.asks_model() ? std::optional(a.interpreter) : std::nullopt);
  }
  const Result<std::string> text = ReadFile(a.task_file);
  if (!text) return text.failure();
  Result<TaskPlan> plan = TaskPlanFromJson(*text);
  if (!plan) return plan.failure();
  if (auto failure = ReasonNotPlanned(*plan, scope)) return *failure;
  return Interpretation{std::move(*plan), "file", {}};
}

/// Whether to ask on the terminal before carrying out the tasks.
bool AsksBeforeDoing(const DoSettings& a) { return !a.yes && ::isatty(STDIN_FILENO) != 0; }

/// Prints the task plan for people; on standard error if standard output is for JSON or a verdict. It is shown even
/// with --quiet if it needs confirmation.
void ShowTasks(const Interpretation& tasks, const DoSettings& a) {
  std::FILE* const to = a.common.json || a.common.quiet ? stderr : stdout;
  for (const std::string& note : tasks.notes) fmt::print(stderr, "note: {}\n", note);
  if (a.common.quiet && !AsksBeforeDoing(a)) return;
  fmt::print(to, "as understood by the {}:\n", tasks.by == "file" ? "file's writer" : tasks.by);
  for (std::size_t k = 0; k < tasks.plan.tasks.size(); ++k) {
    const Task& task = tasks.plan.tasks[k];
    fmt::print(to, "  {}. {}{}\n", k + 1, TaskText(task), task.words.empty() ? "" : fmt::format("   ({})", task.words));
  }
  std::fflush(to);
}

/// Whether to carry out the tasks. On a terminal it asks. Without a terminal, tasks understood by the grammar are
/// carried out, and tasks from a language model only with --yes.
bool GoesOn(const DoSettings& a, const Interpretation& tasks) {
  if (!AsksBeforeDoing(a)) {
    if (!a.yes && tasks.by == "language model")
      throw InvalidArgument("a plan from a language model needs your confirmation: give --yes");
    return true;
  }
  fmt::print(stderr, "Do this? [y/N] ");
  std::string answer;
  std::getline(std::cin, answer);
  return answer == "y" || answer == "Y" || answer == "yes";
}

void PrintDone(const Judged& judged, const Files& files, const Interpretation& tasks, const PlannedTasks& planned,
               const Common& common) {
  const TaskScores scores = ScoreTasks(planned, judged.played);
  if (!common.json && !common.quiet) {
    for (const std::string& note : planned.notes) fmt::print("note: {}\n", note);
    fmt::print("{}\n", TaskScoresText(scores));
  }
  PrintJudged(judged, files, common,
              {{"tasks", TaskPlanJson(tasks.plan)},
               {"understood_by", JsonText(tasks.by)},
               {"notes", JsonText(planned.notes)},
               {"scores", TaskScoresJson(scores)}});
}

int PlanAndPlay(DoSettings& a, const RobotModel& model, const Terrain& terrain, const Interpretation& tasks) {
  const Result<PlannedTasks> planned = PlanTasks(model, terrain, tasks.plan, a.tasks);
  if (!planned) return Report(planned.failure(), a.common);
  const Result<PlayedWalk> played = PlayWalk(planned->robot, planned->plan, a.play.request);
  if (!played) return Report(played.failure(), a.common);
  Judged judged{planned->robot, planned->plan, *played, planned->audit, planned->planning_cpu_s, true};
  if (a.robot.is_file()) judged.mesh_folder = a.robot.folder();
  const Result<Files> files = WriteOutputs(judged, a.outputs);
  if (!files) return Report(files.failure(), a.common);
  PrintDone(judged, *files, tasks, *planned, a.common);
  return judged.pass() ? kPass : kVerdictFail;
}

int RunDo(DoSettings& a) {
  if (a.schema) {
    fmt::print("{}", TaskPlanSchema());
    return kPass;
  }
  a.play.SetDefaults(a.common);
  ApplySets("--set", a.common.sets, Joined({a.tasks.motion.Fields(), a.play.Fields()}));
  a.tasks.seed = static_cast<std::uint64_t>(a.common.seed);
  CheckDo(a);
  const Result<RobotModel> model = ReadRobot(a.robot);
  if (!model) return Report(model.failure(), a.common);
  const Result<Terrain> terrain = LoadTerrain(a.terrain, ScaleOf(*model));
  if (!terrain) return Report(terrain.failure(), a.common);
  a.play.Finish();
  a.play.CheckActs(a.common.sets);
  TaskScope scope = ScopeOf(*model);
  scope.places = PlacesOf(*terrain);
  a.interpreter.key = ApiKeyFromEnvironment();
  const Result<Interpretation> tasks = TasksOf(a, scope);
  if (!tasks) return Report(tasks.failure(), a.common);
  if (a.only_tasks) {
    for (const std::string& note : tasks->notes) fmt::print(stderr, "note: {}\n", note);
    fmt::print("{}", TaskPlanJson(tasks->plan));
    return kPass;
  }
  ShowTasks(*tasks, a);
  if (!GoesOn(a, *tasks)) return kWrongInput;
  return PlanAndPlay(a, *model, *terrain, *tasks);
}

}  // namespace

void AddDo(Verb program, int& status) {
  auto a = std::make_shared<DoSettings>();
  const Verb verb = program.AddVerb("do", "Carry out an instruction in English or Chinese");
  a->outputs.folder = "out";
  verb.AddValue("TEXT", a->text, "The instruction, such as \"walk two steps, then raise the right arm\".")
      .SetType("TEXT");
  AddText(verb, "--task-plan", "FILE", a->task_file, "A task plan as JSON instead of TEXT, see --schema.");
  verb.SetGroup("Robot and ground");
  a->robot.AddTo(verb);
  AddText(verb, "--terrain", "NAME", a->terrain,
          "Ground by name or file; places with names can be destinations; default flat.");
  verb.SetGroup("Interpretation");
  AddText(verb, "--interpreter", "URL", a->interpreter.url,
          "OpenAI-compatible endpoint of a language model, with its key in GAITWRIGHT_API_KEY or OPENAI_API_KEY; "
          "default: the built-in grammar.");
  AddText(verb, "--model", "NAME", a->interpreter.model, "Name of the language model, with --interpreter.");
  AddNumber(verb, "--interpreter-timeout", "s", a->interpreter.longest_s,
            "Time limit for one answer of the language model, 0.1 to 3600; default 60.");
  verb.AddSwitch("--yes", a->yes, "Carry out the task plan without confirmation; default: ask on a terminal.");
  verb.AddSwitch("--tasks-only", a->only_tasks, "Print the task plan as JSON and exit.");
  verb.AddSwitch("--schema", a->schema, "Print the JSON schema of task plans and exit.");
  verb.SetGroup("Options");
  a->play.AddTo(verb);
  a->outputs.AddTo(verb);
  AddCommon(verb, a->common,
            {"do \"walk forward two steps, then raise the right arm\" --robot nao --yes",
             "do \"起来，小跑两米，然后坐下\" --robot a1 --out-dir trot", "do \"bow twice\" --robot nao --tasks-only"});
  AddOptionFlags(verb, Joined({a->tasks.motion.Fields(), a->play.Fields()}), a->common.sets, a->common.json);
  SetWork(verb, a->common, status, [a] { return RunDo(*a); });
}

}  // namespace gaitwright::cli
