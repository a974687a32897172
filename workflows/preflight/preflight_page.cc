// SPDX-License-Identifier: BSD-3-Clause
// The preflight as a page to print and sign.
#include <fmt/format.h>

#include <algorithm>

#include "playback/report/page_style.h"
#include "playback/report/svg_tools.h"
#include "workflows/preflight/preflight.h"
#include "workflows/preflight/preflight_joints.h"

namespace gaitwright {
namespace {

constexpr std::size_t kMostWorst = 6;

/// Style for A4 paper: dark on white.
std::string PaperStyle() {
  return R"(
.sign{display:grid;grid-template-columns:2fr 2fr 1fr;gap:34px 24px;margin:36px 0 0}
.sign div{border-top:1px solid var(--ink);padding-top:3px;color:var(--soft);font-size:12.5px}
.hash{font-family:ui-monospace,SFMono-Regular,Menlo,Consolas,monospace;font-size:12.5px;overflow-wrap:anywhere}
td.bar{width:16%}
td.bar .use{margin:6px 0 0}
pre{font-size:12px;line-height:1.35;background:var(--sheet);padding:8px 12px;border-radius:6px;overflow-x:auto;white-space:pre-wrap}
.close{color:var(--fail);font-weight:650}
@page{size:A4;margin:14mm 15mm}
@media print{:root{--paper:#fff;--sheet:#f5f7f9;--ink:#1f2730;--soft:#56616d;--rule:#dde2e7;--pass:#00785a;--fail:#b3164f;
--bar:#7a9ab0;color-scheme:light}
body{font-size:10pt;line-height:1.4;-webkit-print-color-adjust:exact;print-color-adjust:exact}
h1{font-size:16pt}h2{font-size:12pt;margin:16pt 0 4pt;break-after:avoid}table{font-size:8.5pt}
th,td{padding:2.5pt 8pt 2.5pt 0}tr,li{break-inside:avoid}thead{display:table-header-group}
pre{font-size:7.5pt}.scroll{overflow:visible}.signing{break-inside:avoid}.score{display:none}}
)";
}

std::string ListOf(const std::string& title, const std::vector<std::string>& lines) {
  if (lines.empty()) return "";
  std::string html = fmt::format("<h2>{}</h2>\n<ul>\n", title);
  for (const std::string& line : lines) html += "<li>" + EscapedXml(line) + "</li>\n";
  return html + "</ul>\n";
}

std::string Head(const Preflight& p) {
  const char* state = p.go() ? "pass" : "fail";
  std::string reason = p.go() ? "The audit passes" : p.reasons.front();
  if (p.go() && p.trials) reason += ", and " + SurvivalText(*p.trials);
  if (p.reasons.size() > 1) reason += fmt::format(" (first of {} reasons)", p.reasons.size());
  std::string html = fmt::format(
      "<div class=\"head\"><span class=\"verdict {0}\">{1}</span><div><h1>Preflight: {2}</h1><p "
      "class=\"soft\">{3}</p></div></div>\n<p class=\"reason {0}\">{4}.</p>\n",
      state, p.go() ? "GO" : "NO-GO", EscapedXml(p.robot), EscapedXml(p.motion), EscapedXml(reason));
  const auto row = [&](const char* what, const std::string& value, const char* css = "") {
    html += fmt::format("<tr><th>{}</th><td{}>{}</td></tr>\n", what, css, EscapedXml(value));
  };
  html += "<table id=\"what\"><tbody>\n";
  row("robot", fmt::format("{}, {:.4g} kg", p.robot, p.mass_kg));
  row("robot hash", p.robot_hash, " class=\"hash\"");
  row("plan", fmt::format("{:.2f} s, made by {}", p.duration_s, p.made_by));
  row("plan hash", p.whole_plan_hash, " class=\"hash\"");
  row("hash in its logs", p.plan_hash, " class=\"hash\"");
  row("checked by",
      fmt::format("gaitwright {}, {} samples at {:.0f} Hz", p.program_version, p.audit.samples, p.audit.rate_hz));
  return html + "</tbody></table>\n";
}

/// A bar that shows the used share of a limit, if the margin is a share.
std::string Bar(const AuditMargin& m) {
  if (!m.share) return "";
  const double used = std::clamp(1.0 - *m.share, 0.0, 1.0);
  return fmt::format("<div class=\"use\"><i class=\"{}\" style=\"width:{:.0f}%\"></i></div>",
                     *m.share < 0.0 ? "fail" : "pass", 100.0 * used);
}

std::string LimitRow(const AuditMargin& m, bool broken) {
  return fmt::format(
      "<tr><td>{}</td><td class=\"n\">{:.3f} s</td><td>{}</td><td class=\"n\">{}</td><td class=\"n\">{}</td><td "
      "class=\"n{}\">{}{}</td><td class=\"bar\">{}</td></tr>\n",
      LawWords(m.law), m.at_s, EscapedXml(m.where), AuditFigure(m.value, m.unit), AuditFigure(m.limit, m.unit),
      broken ? " close" : "", AuditFigure(m.margin, m.unit),
      m.share ? fmt::format(" ({:.0f} %)", 100.0 * *m.share) : "", Bar(m));
}

std::string Limits(const Preflight& p) {
  std::string html =
      "<h2>Limits and their margins</h2>\n<div class=\"scroll\"><table id=\"limits\"><thead><tr><th>check</th><th "
      "class=\"n\">worst at</th><th>where</th><th class=\"n\">value</th><th class=\"n\">limit</th><th "
      "class=\"n\">margin</th><th>used</th></tr></thead><tbody>\n";
  for (const AuditMargin& m : TightestOfEachLaw(p.audit.margins)) {
    const bool broken = std::any_of(p.audit.violations.begin(), p.audit.violations.end(),
                                    [&](const Violation& v) { return v.law == m.law; });
    html += LimitRow(m, broken);
  }
  return html + "</tbody></table></div>\n";
}

/// The margins of each joint, one row per joint.
std::string Joints(const Preflight& p) {
  const JointMargins table = JointMarginsOf(p.audit.margins);
  std::string html =
      "<h2>Margins of the joints</h2>\n<div class=\"scroll\"><table id=\"joints\"><thead><tr><th>joint</th>";
  for (const std::string& heading : table.headings) html += fmt::format("<th class=\"n\">{}</th>", heading);
  html += "</tr></thead><tbody>\n";
  for (const JointMargins::Row& row : table.rows) {
    html += fmt::format("<tr><td>{}</td>", EscapedXml(row.joint));
    for (std::size_t i = 0; i < row.cells.size(); ++i)
      html += fmt::format("<td class=\"n{}\">{}</td>", row.broken[i] ? " close" : "", row.cells[i]);
    html += "</tr>\n";
  }
  return html + "</tbody></table></div>\n<p class=\"soft\">Smallest margin of each joint to each limit.</p>\n";
}

/// The conditions of the trials, including disturbances.
std::string Conditions(const Preflight& p) {
  std::string html = "<p>Played under:</p>\n<ul id=\"conditions\">\n";
  for (const OptionChange& condition : p.trial_conditions)
    html += "<li>" + EscapedXml(ConditionText(condition)) + "</li>\n";
  html += "</ul>\n";
  return html + fmt::format("<p>Disturbances:</p>\n<pre>{}</pre>\n", EscapedXml(p.trials->disturbances));
}

std::string Trials(const Preflight& p) {
  if (!p.trials) {
    return fmt::format(
        "<h2>Trials</h2>\n<p><b>None.</b> How often this plan survives disturbances is unknown; {}.</p>\n",
        ThresholdText(p));
  }
  const std::string& controller = p.trials->controller;
  std::string html = fmt::format("<h2>Trials</h2>\n<p>{}; {}. {}{}.</p>\n", SurvivalText(*p.trials), ThresholdText(p),
                                 PassText(*p.trials),
                                 controller.empty() ? "" : fmt::format("; controller {}", EscapedXml(controller)));
  if (!p.trials->causes.empty()) {
    html += "<table id=\"causes\"><thead><tr><th>cause of falls</th><th class=\"n\">count</th></tr></thead><tbody>\n";
    for (const TrialsResult::Cause& cause : p.trials->causes)
      html += fmt::format("<tr><td>{}</td><td class=\"n\">{}</td></tr>\n", EscapedXml(cause.name), cause.count);
    html += "</tbody></table>\n";
  }
  html += Conditions(p);
  if (p.trials->worst.empty()) return html;
  html += p.trials->repeat.empty() ? "<p>Worst trials:</p>\n<ul>\n"
                                   : fmt::format(
                                         "<p>Worst trials; <span class=\"key\">{}</span> repeats one "
                                         "exactly:</p>\n<ul>\n",
                                         EscapedXml(p.trials->repeat));
  for (std::size_t i = 0; i < std::min(kMostWorst, p.trials->worst.size()); ++i) {
    const TrialsResult::Worst& worst = p.trials->worst[i];
    html += fmt::format("<li>seed {}{}</li>\n", worst.seed, worst.words.empty() ? "" : ": " + EscapedXml(worst.words));
  }
  return html + "</ul>\n";
}

}  // namespace

std::string PreflightPage(const Preflight& p) {
  std::string html = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"/><meta name=\"viewport\" "
      "content=\"width=device-width,initial-scale=1\"/><title>Preflight of {} \u2013 {}</title>\n<style>{}{}</style>"
      "</head>\n<body><main>\n",
      EscapedXml(p.robot), p.go() ? "go" : "no-go", PageStyle(), PaperStyle());
  html += Head(p) + ListOf("Reasons for no-go", p.reasons) + ListOf("Remarks", p.remarks) + Trials(p) + Limits(p);
  html += Joints(p) + ListOf("Assumptions", p.assumptions) + ListOf("Not checked", p.not_checked);
  html += "<div class=\"signing\"><h2>Signed</h2>\n<div class=\"sign\">";
  for (int line = 0; line < 2; ++line) html += "<div>name</div><div>signature</div><div>date</div>";
  return html + "</div></div>\n</main></body></html>\n";
}

}  // namespace gaitwright
