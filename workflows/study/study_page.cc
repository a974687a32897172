// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/study/study_page.h"

#include <fmt/format.h>

#include "playback/report/page_parts_internal.h"
#include "playback/report/svg_plot.h"
#include "playback/report/svg_tools.h"
#include "workflows/study/sweep_files.h"

namespace gaitwright {
namespace {

std::string GaitOf(const Study& study) { return study.walk.gait.empty() ? "its best gait" : study.walk.gait; }

std::string Head(const Study& study, const std::vector<PointOutcome>& outcomes) {
  const SweepSummary summary = SummaryOf(outcomes);
  std::string keys;
  for (const StudyAxis& axis : study.axes) keys += (keys.empty() ? "" : ", ") + axis.key;
  std::string html = fmt::format("<h1>{}: {} over {}</h1>\n<p class=\"soft\">{} points on {} ground{}</p>\n",
                                 EscapedXml(study.model.name), EscapedXml(GaitOf(study)), EscapedXml(keys),
                                 outcomes.size(), EscapedXml(study.walk.terrain),
                                 study.trials > 0 ? fmt::format(", {} trials each", study.trials) : "");
  html += "<div class=\"cards\">\n";
  for (const PointStatus status : kPointStatuses) {
    const double share = outcomes.empty() ? 0.0 : 100.0 * summary.Count(status) / static_cast<double>(outcomes.size());
    html += CardPart(EscapedXml(WordsOf(status)), std::to_string(summary.Count(status)),
                     fmt::format("{:.0f} % of the points", share));
  }
  return html + "</div>\n";
}

std::string Best(const Study& study, const std::vector<PointOutcome>& outcomes) {
  const SweepSummary summary = SummaryOf(outcomes);
  if (!summary.best) return "<p class=\"reason fail\">No point has a plan that passes its audit.</p>\n";
  const PointOutcome& best = outcomes[*summary.best];
  std::string words =
      fmt::format("Best: {}, score {:.1f}", PointText(study.axes, study.points[best.point]), best.score.value_or(0.0));
  if (best.survival) {
    words += fmt::format(", {} of {} trials survived (95 % interval {:.1f} % to {:.1f} %)", best.survival->survived,
                         best.survival->trials, 100.0 * best.survival->low, 100.0 * best.survival->high);
  }
  const std::string engines = EnginesText(outcomes);
  return fmt::format("<p class=\"reason pass\">{}. {}.</p>\n", EscapedXml(words), EscapedXml(best.reason)) +
         (engines.empty() ? "" : fmt::format("<p>{}</p>\n", EscapedXml("Engines: " + engines + ".")));
}

std::string Failures(const Study& study, const std::vector<PointOutcome>& outcomes) {
  std::vector<std::vector<std::string>> rows = {{"points", "status", "range", "reason at the first point"}};
  for (const FailureGroup& group : FailureGroups(study, outcomes)) {
    rows.push_back({std::to_string(group.points.size()),
                    WordsOf(group.status) + (group.code.empty() ? "" : " (" + group.code + ")"), group.where,
                    group.example});
  }
  return rows.size() == 1 ? "<p>Every point passes.</p>\n" : TableOf(rows);
}

std::string EveryPoint(const Study& study, const std::vector<PointOutcome>& outcomes) {
  std::vector<std::string> heads = {"point"};
  for (const StudyAxis& axis : study.axes) heads.push_back(axis.key);
  heads.insert(heads.end(), {"what", "score"});
  if (study.trials > 0) heads.emplace_back("survived");
  const bool in_two = CountEngines(outcomes).points() > 0;
  if (in_two) heads.emplace_back("engines");
  heads.emplace_back("why");
  std::vector<std::vector<std::string>> rows = {heads};
  for (const PointOutcome& o : outcomes) {
    std::vector<std::string> row = {std::to_string(o.point)};
    row.insert(row.end(), study.points[o.point].begin(), study.points[o.point].end());
    row.insert(row.end(), {WordsOf(o.status), o.score ? fmt::format("{:.1f}", *o.score) : "\u2013"});
    if (study.trials > 0)
      row.push_back(o.survival ? fmt::format("{} of {}", o.survival->survived, o.survival->trials) : "\u2013");
    if (in_two) row.push_back(o.engines.empty() ? "\u2013" : VerdictsText(o.engines));
    row.push_back(o.reason);
    rows.push_back(row);
  }
  return "<details><summary>Every point</summary>\n" + TableOf(rows) + "</details>\n";
}

Ink InkOf(PointStatus status) { return status == PointStatus::kPass ? Ink::kZmp : Ink::kBad; }

/// Plots the score of every point over one axis of numbers.
std::string ScoreOver(const Study& study, const std::vector<PointOutcome>& outcomes, std::size_t axis) {
  const StudyAxis& a = study.axes[axis];
  SvgPlot::Options options;
  options.title = "Score over " + a.key;
  options.x_label = a.unit.empty() || a.unit == "1" ? a.key : a.key + " [" + a.unit + "]";
  options.y_label = "score";
  options.y_lowest = 0.0;
  options.y_highest = 100.0;
  SvgPlot plot(options);
  for (const PointOutcome& o : outcomes) {
    const Vector2 at(NumberOfValue(study.points[o.point][axis]), o.score.value_or(0.0));
    if (o.score) {
      plot.Dot(at, InkOf(o.status), 3.5, o.status == PointStatus::kPass ? "pass" : "fail");
    } else {
      plot.Cross(at, Ink::kMuted, "refused, shown at 0");
    }
  }
  return FigureOf(
      {"score_over_" + a.key, "Each point's score over " + a.key + ", for all values of the other axes.", plot.Svg()});
}

}  // namespace

std::string StudyPage(const std::string& title, const std::string& body) { return WholePage(title, body); }

std::string FigureOf(const StudyPicture& picture) {
  return fmt::format("<figure>\n{}<figcaption>{}</figcaption></figure>\n", picture.svg, EscapedXml(picture.caption));
}

std::string TableOf(const std::vector<std::vector<std::string>>& rows) {
  std::string html = "<div class=\"scroll\"><table>\n";
  for (std::size_t i = 0; i < rows.size(); ++i) {
    html += "<tr>";
    for (const std::string& cell : rows[i])
      html += fmt::format("<{0}>{1}</{0}>", i == 0 ? "th" : "td", EscapedXml(cell));
    html += "</tr>\n";
  }
  return html + "</table></div>\n";
}

std::string SweepPage(const Study& study, const std::vector<PointOutcome>& outcomes) {
  std::string body = Head(study, outcomes) + Best(study, outcomes);
  body += "<h2>Map</h2>\n" + FigureOf(DrawStabilityMap(study, outcomes, MapQuantity::kScore));
  if (study.trials > 0) body += FigureOf(DrawStabilityMap(study, outcomes, MapQuantity::kSurvival));
  for (std::size_t k = 0; k < study.axes.size(); ++k) {
    if (study.axes[k].is_range() && study.axes[k].numbers) body += ScoreOver(study, outcomes, k);
  }
  body += "<h2>Failures and their reasons</h2>\n" + Failures(study, outcomes);
  body += "<h2>Points</h2>\n" + EveryPoint(study, outcomes);
  return StudyPage(fmt::format("{}: sweep", study.model.name), body);
}

}  // namespace gaitwright
