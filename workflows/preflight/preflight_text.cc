// SPDX-License-Identifier: BSD-3-Clause
// The preflight as text and as JSON.
#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "workflows/preflight/preflight.h"
#include "workflows/preflight/preflight_joints.h"

namespace gaitwright {
namespace {

using Json = nlohmann::ordered_json;

std::string Section(const std::string& title, const std::vector<std::string>& lines) {
  if (lines.empty()) return "";
  std::string text = "\n" + title + "\n";
  for (const std::string& line : lines) text += "  - " + line + "\n";
  return text;
}

std::string LimitsText(const Preflight& preflight) {
  std::string text = "\nLimits: the smallest margin of each check\n";
  for (const AuditMargin& m : TightestOfEachLaw(preflight.audit.margins)) {
    text += fmt::format("  {:<28} {}{} left at {:.3f} s: {}, {} of {}\n", LawWords(m.law),
                        AuditFigure(m.margin, m.unit), m.share ? fmt::format(" ({:.0f} %)", 100.0 * *m.share) : "",
                        m.at_s, m.where, AuditFigure(m.value, m.unit), AuditFigure(m.limit, m.unit));
  }
  return text;
}

/// The lines of a text, indented.
std::string SetIn(const std::string& text) {
  std::string lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines += "      " + line + "\n";
  return lines;
}

std::string TrialsText(const Preflight& preflight) {
  if (!preflight.trials) {
    return fmt::format("\nTrials\n  - none: the survival rate under disturbances is unknown; {}\n",
                       ThresholdText(preflight));
  }
  const TrialsResult& trials = *preflight.trials;
  std::vector<std::string> lines = {SurvivalText(trials), PassText(trials), ThresholdText(preflight)};
  for (const TrialsResult::Cause& cause : trials.causes)
    lines.push_back(fmt::format("{} of the falls: {}", cause.count, cause.name));
  for (const TrialsResult::Worst& worst : trials.worst)
    lines.push_back(fmt::format("worst: seed {}{}", worst.seed, worst.words.empty() ? "" : ", " + worst.words));
  if (!trials.controller.empty()) lines.push_back("controller: " + trials.controller);
  std::string text = Section("Trials", lines);
  text += "  - played under:\n";
  for (const OptionChange& condition : preflight.trial_conditions) text += SetIn(ConditionText(condition));
  return text + "  - disturbances:\n" + SetIn(trials.disturbances);
}

std::string JointsText(const Preflight& preflight) {
  const JointMargins table = JointMarginsOf(preflight.audit.margins);
  if (table.rows.empty()) return "";
  std::string text = "\nMargins of the joints: smallest margin to each limit\n";
  const auto line = [&](const std::string& name, const std::vector<std::string>& cells) {
    text += fmt::format("  {:<28}", name);
    for (const std::string& cell : cells) text += fmt::format("{:>17}", cell);
    text += "\n";
  };
  line("joint", table.headings);
  for (const JointMargins::Row& row : table.rows) line(row.joint, row.cells);
  return text;
}

Json MarginJson(const AuditMargin& m) {
  return {
      {"law", LawName(m.law)}, {"at_s", m.at_s}, {"where", m.where},   {"value", m.value},
      {"limit", m.limit},      {"unit", m.unit}, {"margin", m.margin}, {"share", m.share ? Json(*m.share) : Json()}};
}

Json DifferentJson(const TrialsResult& trials) {
  const ShareInterval survival = WilsonInterval(trials.different_survived, trials.different);
  return {{"n", trials.different},      {"survived", trials.different_survived}, {"passed", trials.different_passed},
          {"survival", survival.share}, {"survival_low", survival.low},          {"survival_high", survival.high}};
}

Json TrialsJson(const TrialsResult& trials, const std::vector<OptionChange>& conditions) {
  Json causes = Json::object(), worst = Json::array(), under = Json::array();
  for (const OptionChange& c : conditions) under.push_back({{"key", c.key}, {"value", c.value}, {"usual", c.usual}});
  const ShareInterval passed = trials.pass_share();
  for (const TrialsResult::Cause& cause : trials.causes) causes[cause.name] = cause.count;
  for (const TrialsResult::Worst& entry : trials.worst) worst.push_back({{"seed", entry.seed}, {"words", entry.words}});
  return {{"n", trials.n},
          {"survived", trials.survived},
          {"survival", trials.survival},
          {"survival_low", trials.survival_low},
          {"survival_high", trials.survival_high},
          {"passed", trials.passed},
          {"pass_share", passed.share},
          {"pass_low", passed.low},
          {"pass_high", passed.high},
          {"different", DifferentJson(trials)},
          {"controller", trials.controller},
          {"conditions", under},
          {"disturbances", trials.disturbances},
          {"causes", causes},
          {"worst", worst}};
}

}  // namespace

std::string PreflightText(const Preflight& p) {
  std::string text = fmt::format("PREFLIGHT: {}\n", p.go() ? "GO" : "NO-GO");
  text += fmt::format(
      "  robot    {}, {:.4g} kg, hash {}\n  plan     {}, {:.2f} s, made by {}, hash {}, hash in its logs {}\n"
      "  checked  by gaitwright {}, {} samples at {:.0f} Hz\n",
      p.robot, p.mass_kg, p.robot_hash, p.motion, p.duration_s, p.made_by, p.whole_plan_hash, p.plan_hash,
      p.program_version, p.audit.samples, p.audit.rate_hz);
  text += Section("Reasons for no-go", p.reasons) + Section("Remarks", p.remarks) + TrialsText(p) + LimitsText(p) +
          JointsText(p);
  text += Section("Assumptions", p.assumptions) + Section("Not checked", p.not_checked);
  return text +
         "\nName ______________________   Signature ______________________   Date ______________\n"
         "Name ______________________   Signature ______________________   Date ______________\n";
}

std::string PreflightJson(const Preflight& p, const std::vector<std::pair<std::string, std::string>>& files) {
  Json limits = Json::array(), written = Json::object();
  for (const AuditMargin& margin : TightestOfEachLaw(p.audit.margins)) limits.push_back(MarginJson(margin));
  for (const auto& [kind, path] : files) written[kind] = path;
  const Json json = {{"verdict", p.go() ? "go" : "no-go"},
                     {"reasons", p.reasons},
                     {"remarks", p.remarks},
                     {"robot", p.robot},
                     {"robot_hash", p.robot_hash},
                     {"plan_hash", p.plan_hash},
                     {"whole_plan_hash", p.whole_plan_hash},
                     {"least_survival", p.least_survival},
                     {"fewest_trials", p.fewest_trials},
                     {"program_version", p.program_version},
                     {"made_by", p.made_by},
                     {"motion", p.motion},
                     {"duration_s", p.duration_s},
                     {"limits", limits},
                     {"audit", Json::parse(AuditJson(p.audit))},
                     {"trials", p.trials ? TrialsJson(*p.trials, p.trial_conditions) : Json()},
                     {"assumptions", p.assumptions},
                     {"not_checked", p.not_checked},
                     {"files", written}};
  return json.dump(2);
}

}  // namespace gaitwright
