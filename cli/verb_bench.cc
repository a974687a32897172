// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "cli/finish_json_internal.h"
#include "cli/flags.h"
#include "cli/json_text_internal.h"
#include "cli/program.h"
#include "cli/robot_input.h"
#include "workflows/study/centroidal_bench.h"
#include "workflows/study/whole_body_bench.h"

namespace gaitwright::cli {
namespace {

using Json = nlohmann::ordered_json;

/// Default factor by which a free total time may be shorter or longer.
constexpr double kFreeTotal = 1.5;

struct BenchSettings {
  Common common;
  std::string problems, filter;
  std::optional<double> distance_m, duration_s, friction;
  bool as_asked = false, audit = false;
  std::string timing_choice;
  RigidBodyOptions rigid_body;
  TimingOptions timing;

  OptionFields Fields() {
    return Joined({Prefixed("rigid_body", rigid_body.Fields()), Prefixed("timing", timing.Fields())});
  }
};

Json FaultsJson(const RigidBodyFaults& faults) {
  return {{"force_balance_mg", faults.force_balance},
          {"torque_balance_mg_m", faults.torque_balance},
          {"friction_mg", faults.friction},
          {"unilateral_mg", faults.unilateral},
          {"reach_m", faults.reach_m},
          {"foothold_m", faults.foothold_m},
          {"goal", faults.goal}};
}

Json TimingJson(const TimingOutcome& t) {
  return {{"refusal", t.refusal},
          {"keeps_all_laws", t.keeps},
          {"mended", t.mended},
          {"cost_before", t.cost_before},
          {"cost", t.cost},
          {"fall", t.Fall()},
          {"duration_s", t.duration_s},
          {"steps", t.steps},
          {"solves", t.solves},
          {"cpu_ms", t.cpu_ms},
          {"node_violation", t.node_violation},
          {"at_1_khz", FaultsJson(t.between)}};
}

Json TaskJson(const CentroidalTask& task) {
  return {{"distance_m", task.distance_m},
          {"goal_higher_m", task.higher_m},
          {"duration_s", task.duration_s},
          {"friction", task.friction}};
}

Json AuditOutcomeJson(const AuditOutcome& a) {
  return {{"pass", a.pass()},
          {"refusal", a.refusal},
          {"as_planned", ParsedJson(AuditJson(a.first))},
          {"in_the_end", ParsedJson(AuditJson(a.report))},
          {"rounds_swings_planned", a.swings_planned},
          {"rounds_breaks_halved", a.halvings},
          {"rounds_other_patches", a.changes},
          {"passes_when_eased", a.eased.has_value()},
          {"eased", a.eased ? TaskJson(*a.eased) : Json()},
          {"eased_in_the_end", a.eased ? ParsedJson(AuditJson(a.eased_report)) : Json()},
          {"cpu_ms", a.cpu_ms}};
}

Json OutcomeJson(const CentroidalOutcome& o) {
  return {{"robot", o.robot},
          {"schedule", o.schedule},
          {"ground", o.ground},
          {"solved", o.solved && !o.eased},
          {"reason", o.reason},
          {"solved_when_eased", o.eased},
          {"distance_m", o.task.distance_m},
          {"goal_higher_m", o.task.higher_m},
          {"duration_s", o.task.duration_s},
          {"friction", o.task.friction},
          {"variables", o.variables},
          {"constraints", o.constraints},
          {"iterations", o.iterations},
          {"patch_choices", o.choices},
          {"cpu_ms", o.cpu_ms},
          {"cost", o.cost},
          {"node_violation", o.node_violation},
          {"at_1_khz", FaultsJson(o.between)},
          {"timing", o.timing ? TimingJson(*o.timing) : Json()},
          {"audit", o.audit ? AuditOutcomeJson(*o.audit) : Json()},
          {"peak_memory_mb", o.peak_memory_mb}};
}

Failure NoSuchCase(const std::string& filter, const std::string& hint) {
  return {FailureKind::kBadInput,
          FailureCode::kNoSuchCase,
          "bench",
          fmt::format("no case name contains '{}'", filter),
          {hint}};
}

int RunBench(BenchSettings& a) {
  if (a.timing_choice == "free") {
    a.timing.least_total = 1.0 / kFreeTotal;
    a.timing.most_total = kFreeTotal;
  }
  ApplySets("--set", a.common.sets, a.Fields());
  const std::optional<TimingOptions> timing =
      a.timing_choice.empty() ? std::nullopt : std::optional<TimingOptions>(a.timing);
  const std::string path = a.problems.empty() ? CentroidalProblemsPath() : a.problems;
  const Result<CentroidalProblemSet> set = LoadCentroidalProblems(path);
  if (!set) return Report(set.failure(), a.common);
  const CentroidalTask task{a.distance_m.value_or(set->distance_m), a.duration_s.value_or(set->duration_s),
                            a.friction.value_or(set->friction)};
  const std::vector<CentroidalCase> cases = CasesOf(*set, a.filter);
  if (cases.empty()) {
    return Report(NoSuchCase(a.filter, "a case name is ROBOT-NUMBER-GROUND, such as hyq-1-gap"), a.common);
  }
  std::vector<CentroidalOutcome> outcomes;
  for (const CentroidalCase& one : cases)
    outcomes.push_back(RunCase(*set, one, task, a.rigid_body, {!a.as_asked, timing, a.audit}));
  if (a.common.json) {
    Json list = Json::array();
    for (const CentroidalOutcome& outcome : outcomes) list.push_back(OutcomeJson(outcome));
    PrintJson(Json{{"bench", "centroidal"}, {"cases", list}, {"files", {{"problems", path}}}});
  } else {
    fmt::print("{}", CentroidalTable(outcomes));
  }
  return kPass;
}

struct WholeBodySettings {
  Common common;
  RobotFlags robot = {.name = ""};
  std::string filter;
  MotionOptions motion;
};

Json OutcomeJson(const WholeBodyOutcome& o) {
  return {{"case", o.one.name},
          {"robot", o.one.robot},
          {"gait", o.one.gait},
          {"speed_m_s", o.one.speed_m_s},
          {"distance_m", o.one.distance_m},
          {"reason", o.reason},
          {"planning_cpu_s", o.planning_cpu_s},
          {"audit", o.passes_audit ? "pass" : "fail"},
          {"whole_body", FinishJson(o.finished)},
          {"ms_an_iteration", o.MsAnIteration()}};
}

/// The step tasks of the robot of the flags.
Result<std::vector<WholeBodyOutcome>> RunStepTasks(const WholeBodySettings& a) {
  const Result<RobotModel> model = ReadRobot(a.robot);
  if (!model) return model.failure();
  std::vector<WholeBodyOutcome> outcomes;
  for (const WholeBodyCase& task : StepTasks(model->name, static_cast<int>(model->legs.size()))) {
    if (task.name.find(a.filter) != std::string::npos) outcomes.push_back(RunWholeBodyCase(*model, task, a.motion));
  }
  if (outcomes.empty())
    return NoSuchCase(a.filter,
                      "robots of two legs have the task step-walk; those of four also "
                      "have step-trot, step-pace, step-bound and step-jump");
  return outcomes;
}

Result<std::vector<WholeBodyOutcome>> RunBuiltInCases(const WholeBodySettings& a) {
  const std::vector<WholeBodyCase> cases = WholeBodyCases(a.filter);
  if (cases.empty()) return NoSuchCase(a.filter, "a case name is ROBOT-GAIT-SPEED, such as a1-trot-3.5");
  std::vector<WholeBodyOutcome> outcomes;
  for (const WholeBodyCase& one : cases) outcomes.push_back(RunWholeBodyCase(one, a.motion));
  return outcomes;
}

int RunWholeBody(WholeBodySettings& a) {
  ApplySets("--set", a.common.sets, a.motion.Fields());
  const bool given = a.robot.is_file() || !a.robot.name.empty();
  const Result<std::vector<WholeBodyOutcome>> ran = given ? RunStepTasks(a) : RunBuiltInCases(a);
  if (!ran) return Report(ran.failure(), a.common);
  const std::vector<WholeBodyOutcome>& outcomes = *ran;
  if (!a.common.json) {
    fmt::print("{}", WholeBodyTable(outcomes));
    return kPass;
  }
  Json list = Json::array();
  for (const WholeBodyOutcome& outcome : outcomes) list.push_back(OutcomeJson(outcome));
  PrintJson(Json{{"bench", "whole-body"}, {"cases", list}});
  return kPass;
}

}  // namespace

void AddBench(Verb program, int& status) {
  auto a = std::make_shared<BenchSettings>();
  const Verb verb = program.AddVerb("bench", "Run a set of problems and print a table");
  const Verb centroidal =
      verb.AddVerb("centroidal", "Plan single rigid bodies with given contact schedules on uneven ground");
  AddText(centroidal, "--problems", "FILE", a->problems, "Your own set of cases; default: the built-in set.");
  AddText(centroidal, "--only", "TEXT", a->filter,
          "Run only cases whose name (ROBOT-NUMBER-GROUND, such as hyq-1-gap) contains this text.");
  AddNumber(centroidal, "--distance", "M", a->distance_m, "Distance to walk; default: as in the set.");
  AddNumber(centroidal, "--duration", "S", a->duration_s, "Duration of the motion; default: as in the set.");
  AddNumber(centroidal, "--friction", "MU", a->friction, "Friction coefficient of all ground; default: as in the set.");
  centroidal.AddSwitch("--as-asked", a->as_asked, "Do not make infeasible cases easier.");
  centroidal.AddSwitch("--audit", a->audit,
                       "Audit each motion at 1 kHz as a robot's plan, and plan it again until it passes.");
  AddText(centroidal, "--timing", "WHICH", a->timing_choice,
          "Then optimise the contact times: 'fixed' keeps the total time, 'free' changes it by a factor of up to 1.5.")
      .AcceptOnly({"fixed", "free"});
  AddCommon(centroidal, a->common,
            {"bench centroidal --only hyq-1-gap", "bench centroidal --only biped-0-flat --duration 3.6 --json",
             "bench centroidal --only hyq-1 --as-asked --timing fixed"});
  AddOptionFlags(centroidal, a->Fields(), a->common.sets, a->common.json);
  auto b = std::make_shared<WholeBodySettings>();
  const Verb whole_body = verb.AddVerb("whole-body", "Plan walks by whole-body trajectory optimisation");
  AddText(whole_body, "--only", "TEXT", b->filter,
          "Run only cases whose name (ROBOT-GAIT-SPEED, such as a1-trot-3.5) contains this text; default: all.");
  b->robot.AddTo(
      whole_body,
      "Robot by name, see 'gaitwright robots', for the tasks with steps of given length and duration; default "
      "none: the built-in cases.");
  AddCommon(whole_body, b->common,
            {"bench whole-body --only a1-pronk", "bench whole-body --only nao --json", "bench whole-body --robot go1"});
  AddOptionFlags(whole_body, b->motion.Fields(), b->common.sets, b->common.json);
  AddCommon(verb, a->common, {"bench centroidal --only hyq-1-gap"});
  verb.RequireVerbs(1, 1);
  SetWork(centroidal, a->common, status, [a] { return RunBench(*a); });
  SetWork(whole_body, b->common, status, [b] { return RunWholeBody(*b); });
}

}  // namespace gaitwright::cli
