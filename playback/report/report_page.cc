// SPDX-License-Identifier: BSD-3-Clause
#include "playback/report/report_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "planning/plan/parts_text.h"
#include "planning/plan/plans_contacts_internal.h"
#include "playback/report/engines_part.h"
#include "playback/report/page_parts_internal.h"
#include "playback/report/plots.h"
#include "playback/report/svg_tools.h"
#include "playback/score/gates.h"
#include "playback/score/report_text.h"

namespace gaitwright {
namespace {

/// A headline metric: its key and its title.
struct Headline {
  const char* key;
  const char* words;
};

constexpr Headline kHeadlines[] = {
    {"goal_error_m", "distance to the goal at the end"},
    {"zmp_margin_p05_m", "ZMP margin, 5th percentile"},
    {"dcm_capture_margin_min_m", "capture margin at touch-down"},
    {"zmp_error_mean_m", "ZMP error, mean"},
    {"slip_max_step_m", "largest slip of a step"},
    {"torque_use_max", "largest torque, share of the limit at that time"},
    {"contact_timing_error_max_s", "largest contact timing error"},
};

/// Heading of a group in the table, identified by its first key.
struct Group {
  const char* first_key;
  const char* title;
};

constexpr Group kGroups[] = {
    {"fell", "Progress"}, {"zmp_margin_min_m", "Balance"}, {"slip_total_m", "Contact"}, {"torque_use_max", "Joints"}};

/// The limit with typographic signs.
std::string PrintedLimit(const Metric& metric) {
  std::string text = LimitText(metric);
  if (text.rfind("<=", 0) == 0) text.replace(0, 2, "\u2264");
  if (text.rfind(">=", 0) == 0) text.replace(0, 2, "\u2265");
  return text == "-" ? "\u2013" : EscapedXml(text);
}

std::string Card(const Headline& headline, const Metric& metric) {
  const char* state = metric.pass ? "pass" : "fail";
  std::string use;
  if (metric.applied && metric.bound == Bound::kAtMost && *metric.limit > 0.0) {
    const double share = std::clamp(*metric.value / *metric.limit, 0.0, 1.0);
    use = fmt::format("<div class=\"use\"><i class=\"{}\" style=\"width:{:.1f}%\"></i></div>", state, 100.0 * share);
  }
  std::string beside;
  if (metric.applied) beside = "limit " + PrintedLimit(metric);
  if (metric.planned)
    beside += (beside.empty() ? "planned " : ", planned ") + EscapedXml(FigureText(metric, *metric.planned));
  return fmt::format(
      "<div class=\"card\"><div class=\"what\">{}</div><div class=\"figure {}\">{}</div>{}<div "
      "class=\"limit\">{}</div></div>\n",
      EscapedXml(headline.words), state, EscapedXml(FigureText(metric, *metric.value)), use, beside);
}

std::string Cards(const StabilityReport& report) {
  std::string html = "<div class=\"cards\">\n";
  for (const Headline& headline : kHeadlines) {
    const Metric& metric = report.At(headline.key);
    const bool beside_the_point = metric.bound != Bound::kNone && !metric.applied;
    if (metric.value && !beside_the_point) html += Card(headline, metric);
  }
  return html + "</div>\n";
}

/// Data of a page.
struct Subject {
  const RobotModel& model;
  const MotionPlan& plan;
  const PlaybackLog& log;
  const StabilityReport& report;
  const ReportWords& words;

  bool pass() const { return report.pass && (!words.second || words.second->report.pass) && words.objection.empty(); }
};

/// "in Bullet, REASON; in MuJoCo, REASON" if the reasons of two engines differ.
std::string PhysicsReason(const Subject& about) {
  const auto& second = about.words.second;
  if (!second || second->report.reason == about.report.reason) return about.report.reason;
  return fmt::format("in {}, {}; in {}, {}", EngineTitle(second->agreement.name_a), about.report.reason,
                     EngineTitle(second->agreement.name_b), second->report.reason);
}

std::string Head(const Subject& about) {
  const auto& [model, plan, log, report, words] = about;
  const std::string physics = PhysicsReason(about);
  const std::string reason = words.objection.empty()
                                 ? physics
                                 : words.objection + "; in physics, " + (report.pass ? "" : "it fails too: ") + physics;
  const std::string engines =
      words.second ? EngineTitle(words.second->agreement.name_a) + " and " + EngineTitle(words.second->agreement.name_b)
                   : EngineTitle(EngineOf(log));
  const double score = words.second ? std::min(report.score, words.second->report.score) : report.score;
  const double duration = log.samples.empty() ? 0.0 : log.samples.back().time_s - log.start_s;
  const std::string parts = PartsText(plan.parts);
  const std::string controller = log.controller.empty() ? "" : ", controller " + log.controller;
  return VerdictPart({about.pass(), about.pass() ? "PASS" : "FAIL", TitleOf(model, plan),
                      fmt::format("{:.2f} s played in {} at a {:.3g} ms step{}; {:.4g} kg, friction {:.3g}", duration,
                                  engines, 1e3 * log.step_s, controller, model.total_mass_kg, log.friction),
                      fmt::format("{:.1f}", score), "of 100", reason}) +
         (parts.empty() ? "" : fmt::format("<p class=\"soft\">{}</p>\n", EscapedXml(parts)));
}

std::string MarkOf(const Metric& metric) {
  if (!metric.applied) return "";
  return VerdictMark(metric.pass);
}

std::string OrDash(const Metric& metric, const std::optional<double>& value) {
  return value ? EscapedXml(FigureText(metric, *value)) : "\u2013";
}

/// @param second  of the other engine, or null.
std::string TableRow(const MetricRule& rule, const Metric& metric, const Metric* second) {
  const std::string why = metric.not_applied.empty() ? "" : "; not applied: " + metric.not_applied;
  std::string measured = OrDash(metric, metric.value), mark = MarkOf(metric);
  if (second != nullptr) {
    measured += "</td><td class=\"n\">" + OrDash(*second, second->value);
    if (second->pass != metric.pass || second->applied != metric.applied) mark += " / " + MarkOf(*second);
  }
  return fmt::format(
      "<tr><td><span class=\"key\">{}</span><span class=\"meaning\">{}{}</span></td><td class=\"n\">{}</td><td "
      "class=\"n\">{}"
      "</td><td class=\"n\">{}</td><td>{}</td><td class=\"n\">{}</td></tr>\n",
      rule.key, EscapedXml(rule.meaning), EscapedXml(why), measured, OrDash(metric, metric.planned),
      PrintedLimit(metric), mark, metric.at_s ? fmt::format("{:.2f} s", *metric.at_s) : "");
}

std::string MetricTable(const StabilityReport& report, const std::optional<SecondVerdict>& second) {
  std::string html = "<h2>All metrics</h2>\n<div class=\"scroll\"><table><thead><tr><th>metric</th><th class=\"n\">";
  html += second ? fmt::format("{}</th><th class=\"n\">{}", EscapedXml(EngineTitle(second->agreement.name_a)),
                               EscapedXml(EngineTitle(second->agreement.name_b)))
                 : "measured";
  html +=
      "</th><th class=\"n\">planned</th><th class=\"n\">limit</th><th>gate</th><th class=\"n\">worst "
      "at</th></tr></thead><tbody>\n";
  for (const MetricRule& rule : MetricRules()) {
    for (const Group& group : kGroups) {
      if (rule.key == group.first_key)
        html += fmt::format("<tr class=\"group\"><td colspan=\"{}\">{}</td></tr>\n", second ? 7 : 6, group.title);
    }
    html += TableRow(rule, report.At(rule.key), second ? &second->report.At(rule.key) : nullptr);
  }
  return html +
         "</tbody></table></div>\n<p class=\"soft\">The score has 50 points for passing every gate and up to 50 points "
         "for the quality of all metrics. After a fall it is at most 25, in proportion to the time before the fall. "
         "It never increases when a metric gets worse. Compare scores only for the same robot, terrain and "
         "command.</p>\n";
}

std::string Figures(const std::vector<Plot>& plots) {
  std::string html = "<h2>What happened</h2>\n";
  for (const Plot& plot : plots) html += FigurePart(plot);
  return html;
}

std::string ChangeTable(const std::vector<OptionChange>& changes) {
  if (changes.empty()) return "<p>Every option had its default value.</p>\n";
  std::string html =
      "<div class=\"scroll\"><table id=\"changed_options\"><thead><tr><th>option</th><th>value</th><th>default "
      "value</th></tr></thead><tbody>\n";
  for (const OptionChange& change : changes) {
    html +=
        fmt::format("<tr><td><span class=\"key\">{}</span></td><td>{}</td><td>{}</td></tr>\n", EscapedXml(change.key),
                    EscapedXml(change.value), change.usual.empty() ? "\u2013" : EscapedXml(change.usual));
  }
  return html + "</tbody></table></div>\n";
}

std::string Origin(const MotionPlan& plan, const PlaybackLog& log, const std::vector<OptionChange>& changes) {
  std::string html = "<h2>Provenance</h2>\n";
  html += fmt::format("<p class=\"soft\">Plan by {} {} with seed {}; played by {}; robot {}; plan {}.</p>\n",
                      EscapedXml(plan.provenance.made_by), EscapedXml(plan.provenance.program_version),
                      plan.provenance.seed, EscapedXml(log.program_version), EscapedXml(log.robot_hash),
                      EscapedXml(log.plan_hash));
  html += ChangeTable(changes) + OptionsPart("All options of the plan", plan.provenance.options);
  return html + OptionsPart("All options of the playback", log.options);
}

}  // namespace

std::string TitleOf(const RobotModel& model, const MotionPlan& plan) {
  const std::string names = GaitNames(plan.parts), motion = PlansContacts(plan) ? "a motion" : "a learned policy";
  const std::string gait = names.empty() ? motion : names;
  const std::string ground = plan.terrain.name.empty() ? "" : " on " + plan.terrain.name + " ground";
  return fmt::format("{}: {}{}", model.name, gait, ground);
}

std::string ReportPage(const RobotModel& model, const MotionPlan& plan, const PlaybackLog& log,
                       const StabilityReport& report, const ReportWords& words) {
  const Subject about{model, plan, log, report, words};
  const std::vector<Plot> plots = MakePlots(model, plan, log, report);
  std::string html = Head(about) + Cards(report);
  if (!words.viewer.empty()) html += "<h2 class=\"screen\">In motion</h2>\n" + words.viewer;
  if (words.second) html += EnginesPart(model, plan, log, report, *words.second);
  html += words.orbit + Figures(plots) + MetricTable(report, words.second);
  html += ListPart("Audit of the plan", words.audit_lines) + ListPart("Notes", report.notes);
  html += ListPart("Warnings of the plan", plan.warnings) + Origin(plan, log, words.changed_options);
  return WholePage(fmt::format("{} \u2013 {}", TitleOf(model, plan), about.pass() ? "pass" : "fail"), html);
}

}  // namespace gaitwright
