// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "cli/json_text_internal.h"
#include "cli/output.h"
#include "cli/paths.h"
#include "cli/walk_arguments.h"
#include "cli/word_list.h"
#include "kinematics/base/file.h"
#include "kinematics/model/dof_units.h"
#include "planning/audit/broken_time_internal.h"
#include "planning/plan/plan_json.h"
#include "planning/tasks/approach.h"
#include "workflows/preflight/preflight.h"

namespace gaitwright::cli {
namespace {

struct AuditSettings {
  Common common;
  std::string plan, derate, start, approach, trials, report;
  bool margins = false, preflight = false;
  AuditOptions options;
  ApproachOptions of_approach;
  PreflightOptions of_preflight;
  std::vector<Flag> only_with_preflight;

  OptionFields Fields() {
    return Joined(
        {options.Fields(), Prefixed("approach", of_approach.Fields()), Prefixed("preflight", of_preflight.Fields())});
  }
};

/// Reads --derate, such as torque=0.8,speed=0.9.
void Derate(const std::string& text, AuditOptions& options) {
  ApplySets("--derate", SplitAtCommas(text),
            {{"torque", &options.derate_torque, "1", 0.01, 1.0, ""},
             {"speed", &options.derate_speed, "1", 0.01, 1.0, ""},
             {"acceleration", &options.derate_acceleration, "1", 0.01, 1.0, ""},
             {"jerk", &options.derate_jerk, "1", 0.01, 1.0, ""},
             {"continuous", &options.derate_continuous, "1", 0.01, 1.0, ""}});
}

void CheckAuditFlags(const AuditSettings& a) {
  if (!a.approach.empty() && a.start.empty())
    throw InvalidArgument("--approach needs --start-posture FILE: the motion begins at the measured posture");
  for (const Flag& flag : a.only_with_preflight) {
    if (flag.given() && !a.preflight)
      throw InvalidArgument(fmt::format("{} is for --preflight only; add --preflight or leave it out", flag.name()));
  }
  Paths paths;
  paths.Read("the plan", a.plan);
  paths.Read("--start-posture", a.start);
  paths.Read("--trials-result", a.trials);
  paths.Write("--approach", a.approach, {".json"});
  paths.Write("--report", a.report, {".html"});
  CheckPaths(paths);
}

/// The reason why no approach is written although --approach is given.
std::string NoApproachText(const std::string& path) {
  return fmt::format(
      "every joint is within its tolerance of the first command: no approach is needed, and '{}' is not written", path);
}

/// A sentence about the approach to the plan's first posture.
std::string ApproachText(const RobotModel& model, const Approach& approach) {
  return fmt::format(
      "an approach of {:.2f} s to the first posture is planned{}, with the base held in the air; joint '{}' moves "
      "farthest, {:.3g} {}",
      approach.plan.duration_s(), approach.via_standing ? " via the standing posture" : "", approach.farthest,
      approach.farthest_by, PositionUnit(model, model.DofIndex(approach.farthest)));
}

nlohmann::ordered_json ApproachJson(const Approach& approach, const std::string& path) {
  return {{"duration_s", approach.plan.duration_s()},
          {"base", "hanging"},
          {"via_standing", approach.via_standing},
          {"farthest", approach.farthest},
          {"plan", path}};
}

/// The subject of the audit: the robot, its plan, and the approach, if requested.
struct AuditSubject {
  const RobotModel& model;
  const MotionPlan& plan;
  const std::optional<Approach>& approach;
};

int RunPreflight(AuditSettings& a, const AuditSubject& about) {
  PreflightInput input{a.options, a.of_preflight, {}, ""};
  if (!a.approach.empty())
    input.approach = about.approach ? ApproachText(about.model, *about.approach) : NoApproachText(a.approach);
  if (!a.trials.empty()) {
    const Result<TrialsResult> trials = LoadTrialsResult(a.trials);
    if (!trials) return Report(trials.failure(), a.common);
    input.trials = *trials;
  }
  const Result<Preflight> preflight = MakePreflight(about.model, about.plan, input);
  if (!preflight) return Report(preflight.failure(), a.common);
  std::vector<OutputFile> files;
  Files named;
  if (about.approach) {
    files.push_back({a.approach, PlanToJson(about.approach->plan)});
    named.emplace_back("approach", a.approach);
  }
  if (!a.report.empty()) {
    files.push_back({a.report, PreflightPage(*preflight)});
    named.emplace_back("report", a.report);
  }
  const auto written = WriteFilesTogether(files);
  if (!written) return Report(written.failure(), a.common);
  if (a.common.json) {
    fmt::print("{}\n", PreflightJson(*preflight, named));
  } else if (a.common.quiet) {
    fmt::print("{}\n", preflight->go() ? "go" : "no-go");
  } else {
    fmt::print("{}", PreflightText(*preflight));
  }
  return preflight->go() ? kPass : kVerdictFail;
}

/// Prints the verdict, for how long each check fails, the plan's own warnings and what the audit did not check.
void PrintAudit(const AuditReport& report, const std::vector<BrokenTime>& broken, const MotionPlan& plan) {
  fmt::print("{}{}", AuditText(report), BrokenText(broken));
  for (const std::string& warning : plan.warnings) fmt::print("warning: {}\n", warning);
  for (const std::string& note : report.notes) fmt::print("note: {}\n", note);
}

int AuditOnly(AuditSettings& a, const AuditSubject& about) {
  std::vector<BrokenTime> broken;
  const Result<AuditReport> report = AuditOverTime(about.model, about.plan, a.options, broken);
  if (!report) return Report(report.failure(), a.common);
  if (about.approach) {
    const Result<std::string> saved = SavePlan(about.approach->plan, a.approach);
    if (!saved) return Report(saved.failure(), a.common);
  }
  if (a.common.json) {
    auto json = ParsedJson(AuditJson(*report));
    json["broken"] = ParsedJson(BrokenJson(broken));
    json["warnings"] = about.plan.warnings;
    if (!a.approach.empty())
      json["approach"] = about.approach ? ApproachJson(*about.approach, a.approach) : nlohmann::ordered_json();
    PrintJson(json);
  } else if (a.common.quiet) {
    fmt::print("{}\n", report->pass() ? "pass" : "fail");
  } else {
    PrintAudit(*report, broken, about.plan);
    if (about.approach) fmt::print("{}: {}\n", ApproachText(about.model, *about.approach), a.approach);
    if (!a.approach.empty() && !about.approach) fmt::print("{}\n", NoApproachText(a.approach));
  }
  return report->pass() ? kPass : kVerdictFail;
}

int RunAudit(AuditSettings& a) {
  ApplySets("--set", a.common.sets, a.Fields());
  Derate(a.derate, a.options);
  a.options.margins = a.margins;
  CheckAuditFlags(a);
  const Result<MotionPlan> plan = LoadPlan(a.plan);
  if (!plan) return Report(plan.failure(), a.common);
  const Result<RobotModel> model = RobotOf(*plan);
  if (!model) return Report(model.failure(), a.common);
  if (!a.start.empty()) {
    const Result<StartPosture> start = LoadStartPosture(a.start, *model);
    if (!start) return Report(start.failure(), a.common);
    a.options.start = *start;
  }
  std::optional<Approach> approach;
  if (!a.approach.empty() && NeedsApproach(*model, *plan, *a.options.start, a.options)) {
    Result<Approach> planned = PlanApproach(*model, *plan, *a.options.start, a.of_approach, a.options);
    if (!planned) return Report(planned.failure(), a.common);
    approach = std::move(planned.value());
  }
  const AuditSubject about{*model, *plan, approach};
  return a.preflight ? RunPreflight(a, about) : AuditOnly(a, about);
}

void AddStartAndPreflight(Verb verb, AuditSettings& a) {
  verb.SetGroup("Before running on a robot");
  AddText(
      verb, "--start-posture", "FILE", a.start,
      "Measured joint positions (YAML, see docs/audit.md) that are compared with the first command; default: none.");
  AddText(verb, "--approach", "FILE", a.approach,
          "If a joint is beyond its tolerance, write a plan that moves safely from the measured posture to the first "
          "one; default: none.");
  verb.AddSwitch("--preflight", a.preflight,
                 "Make the sign-off page: margins, trials, assumptions and go or no-go; default: no.");
  a.only_with_preflight = {AddText(verb, "--trials-result", "FILE", a.trials,
                                   "Result file of 'trials' of this plan, for --preflight; default: none."),
                           AddText(verb, "--report", "FILE", a.report,
                                   "Write the page of --preflight to this HTML file (for A4 paper); default: none.")};
}

}  // namespace

void AddAudit(Verb program, int& status) {
  auto a = std::make_shared<AuditSettings>();
  const Verb verb =
      program.AddVerb("audit", "Check a plan densely against physics and the robot's limits, without a simulator");
  AddText(verb, "PLAN", "FILE", a->plan, "A plan file, as written by 'plan' and 'walk'.").Require();
  AddText(verb, "--derate", "KEY=SHARE", a->derate,
          "Check against these shares of the limits, such as torque=0.8,speed=0.9; also acceleration, jerk and "
          "continuous; from 0.01 to 1, default 1.");
  verb.AddSwitch("--margins", a->margins,
                 "Print the smallest margin of each check for each joint, foot or pair; default: no.");
  AddStartAndPreflight(verb, *a);
  AddCommon(verb, a->common,
            {"audit plan.json", "audit plan.json --derate torque=0.8,speed=0.9", "audit plan.json --margins",
             "audit plan.json --preflight --report preflight.html"});
  AddOptionFlags(verb, a->Fields(), a->common.sets, a->common.json);
  SetWork(verb, a->common, status, [a] { return RunAudit(*a); });
}

}  // namespace gaitwright::cli
