// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "cli/walk_arguments.h"
#include "planning/plan/plan_json.h"

namespace gaitwright::cli {
namespace {

struct Arguments {
  Common common;
  std::string plan, derate;
  AuditOptions options;
};

/// --derate torque=0.8,speed=0.9
void Derate(const std::string& text, AuditOptions& options) {
  std::istringstream stream(text);
  for (std::string word; std::getline(stream, word, ',');) {
    OptionFields fields = {{"torque", &options.derate_torque, "1", 0.01, 1.0, "", {}},
                           {"speed", &options.derate_speed, "1", 0.01, 1.0, "", {}}};
    ApplySets("--derate", {word}, fields);
  }
}

int Run(Arguments& a) {
  ApplySets("--set", a.common.sets, a.options.Fields());
  Derate(a.derate, a.options);
  const Result<MotionPlan> plan = LoadPlan(a.plan);
  if (!plan) return Report(plan.failure(), a.common);
  const Result<RobotModel> model = RobotOf(*plan);
  if (!model) return Report(model.failure(), a.common);
  const Result<AuditReport> report = Audit(*model, *plan, a.options);
  if (!report) return Report(report.failure(), a.common);
  if (a.common.json) {
    fmt::print("{}\n", AuditJson(*report));
  } else if (a.common.quiet) {
    fmt::print("{}\n", report->pass() ? "pass" : "fail");
  } else {
    fmt::print("{}", AuditText(*report));
  }
  return report->pass() ? kPass : kVerdictFail;
}

}  // namespace

void AddAudit(CLI::App& app, int& status) {
  auto a = std::make_shared<Arguments>();
  CLI::App& verb = *app.add_subcommand("audit", "Check a plan densely against the laws, without a simulator");
  AddText(verb, "PLAN", "FILE", a->plan, "A plan file, as 'plan' and 'walk' write it.")->required();
  AddText(verb, "--derate", "KEY=SHARE", a->derate,
          "Hold the plan against these shares of the limits, as torque=0.8,speed=0.9; from 0.01 to 1, default 1.");
  AddCommon(verb, a->common, {"audit plan.json", "audit plan.json --derate torque=0.8,speed=0.9"});
  AddOptionList(verb, a->options.Fields(), a->common.json);
  verb.callback([a, &status] { status = Guarded(a->common, [&] { return Run(*a); }); });
}

}  // namespace gaitwright::cli
