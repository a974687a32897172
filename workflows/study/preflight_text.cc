// SPDX-License-Identifier: BSD-3-Clause
// The preflight as text and as JSON.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "workflows/study/preflight.h"

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
  std::string text = "\nLimits: the worst moment of each law\n";
  for (const AuditMargin& m : TightestOfEachLaw(preflight.audit.margins)) {
    text += fmt::format("  {:<28} {}{} left at {:.3f} s: {}, {} of {}\n", LawWords(m.law),
                        AuditFigure(m.margin, m.unit), m.share ? fmt::format(" ({:.0f} %)", 100.0 * *m.share) : "",
                        m.at_s, m.where, AuditFigure(m.value, m.unit), AuditFigure(m.limit, m.unit));
  }
  return text;
}

std::string TrialsText(const Preflight& preflight) {
  if (!preflight.trials) return "\nTrials\n  - none: how often it survives disturbances is not known\n";
  std::vector<std::string> lines = {SurvivalText(*preflight.trials)};
  for (const TrialsResult::Cause& cause : preflight.trials->causes)
    lines.push_back(fmt::format("{} of the falls: {}", cause.count, cause.name));
  for (const TrialsResult::Worst& worst : preflight.trials->worst)
    lines.push_back(fmt::format("worst: seed {}{}", worst.seed, worst.words.empty() ? "" : ", " + worst.words));
  if (!preflight.trials->controller.empty()) lines.push_back("controller: " + preflight.trials->controller);
  return Section("Trials", lines);
}

Json MarginJson(const AuditMargin& m) {
  return {{"law", m.law},     {"at_s", m.at_s}, {"where", m.where},   {"value", m.value},
          {"limit", m.limit}, {"unit", m.unit}, {"margin", m.margin}, {"share", m.share ? Json(*m.share) : Json()}};
}

Json TrialsJson(const TrialsResult& trials) {
  Json causes = Json::object(), worst = Json::array();
  for (const TrialsResult::Cause& cause : trials.causes) causes[cause.name] = cause.count;
  for (const TrialsResult::Worst& entry : trials.worst) worst.push_back({{"seed", entry.seed}, {"words", entry.words}});
  return {{"n", trials.n},
          {"survived", trials.survived},
          {"survival", trials.survival},
          {"survival_low", trials.survival_low},
          {"survival_high", trials.survival_high},
          {"controller", trials.controller},
          {"disturbances", trials.disturbances},
          {"causes", causes},
          {"worst", worst}};
}

}  // namespace

std::string PreflightText(const Preflight& p) {
  std::string text = fmt::format("PREFLIGHT: {}\n", p.go() ? "GO" : "NO-GO");
  text += fmt::format(
      "  robot    {}, {:.4g} kg, hash {}\n  plan     {}, {:.2f} s, made by {}, hash {}\n  checked  by gaitwright {}, "
      "{} samples at {:.0f} Hz\n",
      p.robot, p.mass_kg, p.robot_hash, p.motion, p.duration_s, p.made_by, p.plan_hash, p.program_version,
      p.audit.samples, p.audit.rate_hz);
  text += Section("Why it is no go", p.reasons) + Section("To mind", p.remarks) + LimitsText(p) + TrialsText(p);
  text += Section("Taken for granted", p.assumptions) + Section("Not checked", p.not_checked);
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
                     {"program_version", p.program_version},
                     {"made_by", p.made_by},
                     {"motion", p.motion},
                     {"duration_s", p.duration_s},
                     {"limits", limits},
                     {"audit", Json::parse(AuditJson(p.audit))},
                     {"trials", p.trials ? TrialsJson(*p.trials) : Json()},
                     {"assumptions", p.assumptions},
                     {"not_checked", p.not_checked},
                     {"files", written}};
  return json.dump(2);
}

}  // namespace gaitwright
