// SPDX-License-Identifier: BSD-3-Clause
#include "playback/report/trials_page.h"

#include <fmt/format.h>

#include "playback/report/page_parts_internal.h"
#include "playback/report/svg_tools.h"
#include "playback/score/gates.h"

namespace gaitwright {
namespace {

std::string Percent(double share) { return fmt::format("{:.1f}&#160;%", 100.0 * share); }

std::string Interval(const ShareInterval& share) {
  return fmt::format("95 % interval {} to {}", Percent(share.low), Percent(share.high));
}

std::string Cards(const RobustnessReport& r) {
  std::string html = "<div class=\"cards\">\n";
  html += CardPart("survival to the plan's end", Percent(r.survival.share), Interval(r.survival));
  html += CardPart("trials that pass all gates", Percent(r.pass_share.share), Interval(r.pass_share));
  const GaitSensitivity& gait = r.gait_sensitivity;
  if (gait.norm) {
    html += CardPart("gait sensitivity norm", fmt::format("{:.3g}", *gait.norm),
                     fmt::format("standard error {:.2g}", gait.standard_error.value_or(0.0)));
  }
  html += CardPart("trials", fmt::format("{}", r.n), fmt::format("{} fell", r.n - r.survived));
  return html + "</div>\n";
}

std::string Cell(const std::string& text) { return "<td>" + EscapedXml(text) + "</td>"; }
std::string Number(double value) { return fmt::format("<td class=\"n\">{:.4g}</td>", value); }

std::string Table(const std::string& title, const std::string& heads, const std::string& rows) {
  if (rows.empty()) return "";
  return fmt::format(
      "<h2>{}</h2>\n<div class=\"scroll\"><table><thead><tr>{}</tr></thead><tbody>\n{}</tbody></table></div>\n", title,
      heads, rows);
}

std::string TallyTable(const std::string& title, const std::string& counted, const std::vector<Tally>& tallies) {
  std::string rows;
  for (const Tally& tally : tallies)
    rows += fmt::format("<tr>{}<td class=\"n\">{}</td></tr>\n", Cell(tally.what), tally.count);
  return Table(title, "<th>" + counted + "</th><th class=\"n\">trials</th>", rows);
}

std::string SensitivityTable(const RobustnessReport& report) {
  if (report.survived == 0 && report.n > 1)
    return "<p class=\"soft\">Correlates of falling are not available, because every trial fell.</p>\n";
  std::string rows;
  for (const Sensitivity& s : report.sensitivity) {
    const bool word = s.of_a_word;
    rows += fmt::format(
        "<tr><td><span class=\"key\">{}</span></td>{}<td class=\"n\">{:.2f}</td><td class=\"n\">{:.2g}</td>"
        "<td class=\"n\">{:.2f}</td>{}{}</tr>\n",
        EscapedXml(s.name), Cell(s.how), s.effect, s.p, s.weight, word ? Cell("") : Number(s.median_fell),
        word ? Cell("") : Number(s.median_survived));
  }
  return Table("Correlates of falling",
               "<th>quantity</th><th>falls if</th><th class=\"n\">effect</th><th class=\"n\">p</th><th class=\"n\">log "
               "odds</th><th class=\"n\">median, fell</th><th class=\"n\">median, survived</th>",
               rows) +
         (rows.empty() ? ""
                       : "<p class=\"soft\">Effect is the rank-biserial correlation, 1 if the quantity is larger (or "
                         "smaller) in every fall than in every survival; p is that of Mann and Whitney's test; log "
                         "odds are the change "
                         "per standard deviation, from a regression on all quantities together.</p>\n");
}

std::string WorstTable(const RobustnessReport& report) {
  std::string rows;
  for (const int number : report.worst) {
    const TrialOutcome& o = report.Outcome(number);
    rows += fmt::format("<tr><td class=\"n\">{}</td><td class=\"n\">{:.2f} s</td>{}{}</tr>\n", o.seed, o.ended_s,
                        Cell(o.survived ? "failed: " + o.cause : "fell: " + o.cause), Cell(o.reason));
  }
  return Table("The worst trials", "<th class=\"n\">seed</th><th class=\"n\">end</th><th>cause</th><th>reason</th>",
               rows) +
         (rows.empty() ? ""
                       : "<p class=\"soft\"><span class=\"key\">" + EscapedXml(report.subject.repeat) +
                             "</span> repeats one exactly, with its own report.</p>\n");
}

std::string MetricTable(const RobustnessReport& report) {
  std::string rows;
  for (const MetricSpread& m : report.metrics) {
    rows += fmt::format("<tr><td><span class=\"key\">{}</span><span class=\"meaning\">{}</span></td>", m.key,
                        EscapedXml(RuleOf(m.key).meaning));
    for (const double value : {m.lowest, m.p05, m.median, m.p95, m.highest}) rows += Number(value);
    rows += m.limit ? Number(*m.limit) + fmt::format("<td class=\"n\">{}</td></tr>\n", m.broken)
                    : "<td></td><td></td></tr>\n";
  }
  return Table("All metrics over the trials",
               "<th>metric</th><th class=\"n\">min</th><th class=\"n\">5 %</th><th class=\"n\">median</th><th "
               "class=\"n\">95 %</th><th class=\"n\">max</th><th class=\"n\">limit</th><th class=\"n\">broken</th>",
               rows);
}

/// The subject of the trials, in the words of a preflight.
std::string SubjectLine(const TrialSubject& subject) {
  return fmt::format(
      "<p class=\"soft\">Robot {}, robot hash {}; plan hash {}, that of its logs {}; controller {}; seed {}.</p>\n",
      EscapedXml(subject.robot), EscapedXml(subject.robot_hash), EscapedXml(subject.whole_plan_hash),
      EscapedXml(subject.plan_hash), EscapedXml(subject.controller), subject.seed);
}

std::string Conditions(const TrialSubject& subject) {
  std::string html = "<h2>Conditions</h2>\n<details open=\"open\"><summary>Disturbances</summary><pre>" +
                     EscapedXml(subject.disturbances) +
                     "</pre></details>\n<details><summary>All options of the playback</summary><table><tbody>\n";
  for (const auto& [key, value] : subject.options) html += "<tr>" + Cell(key) + Cell(value) + "</tr>\n";
  return html + "</tbody></table></details>\n";
}

}  // namespace

std::string TrialsPage(const RobustnessReport& report) {
  const std::string title = fmt::format("{}: {} trials", report.subject.robot, report.n);
  std::string html = fmt::format("<h1>{}</h1>\n", EscapedXml(title));
  html += SubjectLine(report.subject) + Cards(report);
  if (const std::string repeats = RepeatsText(report); !repeats.empty())
    html += "<p class=\"reason fail\">" + EscapedXml(repeats) + ".</p>\n";
  for (const Plot& plot : TrialPlots(report)) html += FigurePart(plot);
  html += TallyTable("Causes of falls", "cause", report.causes) +
          TallyTable("Gates failed without a fall", "gate", report.broken_gates) + SensitivityTable(report) +
          WorstTable(report) + MetricTable(report) + Conditions(report.subject);
  return WholePage(title, html);
}

}  // namespace gaitwright
