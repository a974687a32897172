// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "playback/report/page_parts_internal.h"
#include "playback/report/svg_tools.h"
#include "workflows/compare/comparison_text.h"
#include "workflows/exchange/motion_plots.h"

namespace gaitwright {
namespace {

std::string Paragraph(const std::string& css, const std::string& words) {
  return fmt::format("<p class=\"{}\">{}</p>\n", css, EscapedXml(words));
}

std::string Figure(double value) { return fmt::format("{:.4g}", value == 0.0 ? 0.0 : value); }
std::string OrDash(const std::optional<double>& value) { return value ? Figure(*value) : "\u2013"; }

std::string Row(const std::vector<std::string>& cells) {
  std::string html = "<tr>";
  for (std::size_t i = 0; i < cells.size(); ++i)
    html += (i == 0 ? "<td>" : "<td class=\"n\">") + EscapedXml(cells[i]) + "</td>";
  return html + "</tr>\n";
}

std::string Table(const std::string& title, const std::vector<std::string>& head, const std::string& rows) {
  if (rows.empty()) return "";
  std::string html = "<h2>" + EscapedXml(title) + "</h2>\n<div class=\"scroll\"><table><thead><tr>";
  for (std::size_t i = 0; i < head.size(); ++i)
    html += (i == 0 ? "<th>" : "<th class=\"n\">") + EscapedXml(head[i]) + "</th>";
  return html + "</tr></thead><tbody>\n" + rows + "</tbody></table></div>\n";
}

std::string InOrder(const MotionComparison& c) {
  std::string rows;
  for (const FirstDifference& one : c.in_order) {
    rows += Row({one.quantity, fmt::format("{:.3f} s", one.time_s), Figure(one.a), Figure(one.b),
                 one.tolerance > 0.0 ? Figure(one.tolerance) : "", one.unit == "1" ? "" : one.unit});
  }
  return Table("Differences in order of time", {"quantity", "at", "A", "B", "tolerance", "unit"}, rows);
}

std::string SeriesRow(const SeriesDifference& one) {
  if (one.samples == 0) return "";
  return Row({one.quantity, Figure(one.rms), Figure(one.largest), fmt::format("{:.3f} s", one.at_s),
              Figure(one.tolerance), one.first_s ? fmt::format("{:.3f} s", *one.first_s) : "", one.unit});
}

std::string Differences(const MotionComparison& c) {
  std::string rows;
  for (const JointDifference& joint : c.joints)
    rows += SeriesRow(joint.position) + SeriesRow(joint.speed) + SeriesRow(joint.torque);
  for (const SeriesDifference& one : c.base) rows += SeriesRow(one);
  for (const SeriesDifference& one : c.balance) rows += SeriesRow(one);
  for (const FootDifference& foot : c.feet) rows += SeriesRow(foot.timing);
  return Table("All differences", {"quantity", "rms", "largest", "at", "tolerance", "first beyond", "unit"}, rows);
}

std::string Metrics(const std::vector<MetricPair>& metrics) {
  std::string rows;
  for (const MetricPair& m : metrics) {
    rows += Row({m.key, OrDash(m.a) + (m.pass_a ? "" : " FAIL"), OrDash(m.b) + (m.pass_b ? "" : " FAIL"),
                 m.a && m.b ? Figure(*m.b - *m.a) : "", OrDash(m.limit), m.unit == "1" ? "" : m.unit});
  }
  return Table("Metrics", {"metric", "A", "B", "change", "limit", "unit"}, rows);
}

std::string FiguresTable(const std::vector<FigurePair>& figures) {
  std::string rows;
  for (const FigurePair& f : figures) rows += Row({f.key, OrDash(f.a), OrDash(f.b), f.unit == "1" ? "" : f.unit});
  return Table("Values of each file", {"quantity", "A", "B", "unit"}, rows);
}

std::string Words(const std::vector<WordDifference>& words) {
  std::string rows;
  const FoldedWords folded = Folded(words);
  for (const WordDifference& word : folded.each) rows += Row({word.key, word.a, word.b});
  if (!folded.only_a.empty() || !folded.only_b.empty())
    rows += Row({"options on one side only", folded.only_a, folded.only_b});
  return Table("Differences in text values", {"key", "A", "B"}, rows);
}

/// Whether a motion has the data that the plot of this name draws, see MotionPlots.
bool HasFor(const std::string& plot, const MotionRows& rows) {
  if (plot == "contacts") return !rows.contact.empty();
  if (plot == "joint_torques") return !rows.tau.empty();
  if (plot == "base_attitude") return rows.q.front().segment<4>(3).allFinite();
  return (plot != "top_view" && plot != "base_position") || rows.q.front().head<3>().allFinite();
}

/// The caption of a plot; it says so if only one file has such data.
std::string CaptionOf(const Plot& plot, const MotionRows& a, const MotionRows& b) {
  const bool in_a = HasFor(plot.name, a), in_b = HasFor(plot.name, b);
  if (in_a == in_b) return plot.caption;
  return fmt::format("{} {} only; {} has no such data.", plot.caption, in_a ? "A" : "B", in_a ? "B" : "A");
}

}  // namespace

std::string ComparisonPage(const ComparedMotion& a, const ComparedMotion& b, const MotionComparison& c,
                           const std::vector<MetricPair>& metrics) {
  const std::string title = fmt::format("{} and {} of {}", c.kind_a, c.kind_b, c.robot_a);
  std::string html = "<h1>" + EscapedXml(title) + "</h1>\n";
  html += Paragraph("soft", fmt::format("A: {} of {}, {}; B: {} of {}, {}", c.kind_a, c.robot_a, c.name_a, c.kind_b,
                                        c.robot_b, c.name_b));
  html += Paragraph(c.same() ? "reason pass" : "reason", FirstDifferenceText(c));
  html += Paragraph(
      "soft", fmt::format("Compared from {:.3f} to {:.3f} s on A's clock; clocks aligned by {}; B's clock is {:+.4f} s "
                          "ahead. In the plots, lines of A are broad and pale, lines of B thin and dark.",
                          c.start_s, c.end_s, c.aligned_by, c.offset_s));
  for (const std::string& note : c.notes) html += Paragraph("soft", "Note: " + note + ".");
  const std::optional<double> mark = c.same() ? std::nullopt : std::optional(c.in_order.front().time_s);
  html += InOrder(c) + "<h2>Both motions</h2>\n";
  for (const Plot& plot :
       MotionPlots({{"A", &a.model, &a.rows}, {"B", &b.model, &b.rows, c.offset_s}}, mark, "differs first")) {
    html += FigurePart({plot.name, CaptionOf(plot, a.rows, b.rows), plot.svg});
  }
  html += Differences(c) + FiguresTable(c.figures) + Metrics(metrics) + Words(c.words);
  return WholePage(title, html);
}

std::string ComparisonPage(const ReportComparison& c) {
  std::string html = "<h1>Two reports</h1>\n";
  html += Paragraph("soft", fmt::format("A: {}; B: {}", c.name_a, c.name_b));
  html += Paragraph(c.same() ? "reason pass" : "reason",
                    fmt::format("Score {:.1f} (A) and {:.1f} (B); {}", c.score_a, c.score_b,
                                c.same() ? "all differences are within tolerance" : "they differ"));
  html += Metrics(c.metrics) + Words(c.words);
  return WholePage("Two reports", html);
}

}  // namespace gaitwright
