// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "playback/report/svg_plot.h"
#include "playback/report/svg_tools.h"
#include "playback/score/agreement.h"
#include "playback/score/gates.h"
#include "workflows/study/study_page.h"
#include "workflows/study/tune_files.h"

namespace gaitwright {
namespace {

using Rows = std::vector<std::vector<std::string>>;

std::string Number(const std::optional<double>& value) { return value ? fmt::format("{:.4g}", *value) : "\u2013"; }

std::string Head(const Study& study, const TuneReport& report, const TuneOptions& options) {
  const TuneResult& result = report.result;
  return fmt::format(
      "<h1>{}: {} tuned</h1>\n<p class=\"soft\">{} candidates of {} trials each on {} ground; the value of a trial is "
      "its score, plus {:g} if the robot survives to the end</p>\n<p class=\"reason {}\">{}.</p>\n",
      EscapedXml(study.model.name), EscapedXml(study.walk.gait.empty() ? "its best gait" : study.walk.gait),
      result.candidates.size(), options.trials, EscapedXml(study.walk.terrain), options.survival_weight,
      result.better() ? "pass" : "fail", EscapedXml(VerdictOf(result)));
}

std::string Values(const Study& study, const TuneResult& result) {
  Rows rows = {{"option", "unit", "from", "to", "usual", "favourite", "chosen"}};
  for (std::size_t k = 0; k < study.axes.size(); ++k) {
    const StudyAxis& axis = study.axes[k];
    rows.push_back({axis.key, axis.unit, fmt::format("{:g}", axis.low), fmt::format("{:g}", axis.high),
                    result.candidates.front().values[k], result.candidates[result.favourite].values[k],
                    result.candidates[result.chosen].values[k]});
  }
  return TableOf(rows);
}

std::string Proof(const TuneResult& result) {
  if (!result.proof)
    return "<p>No candidate has a higher value than the present values, so there was no held-out test.</p>\n";
  const bool has_before = result.proof->no_before.empty();
  const auto row = [&](const char* what, const PairedDifference& d, double scale) -> std::vector<std::string> {
    if (!has_before) return {what, "\u2013", fmt::format("{:.2f}", scale * d.after), "\u2013", "\u2013"};
    return {what, fmt::format("{:.2f}", scale * d.before), fmt::format("{:.2f}", scale * d.after),
            fmt::format("{:+.2f}", scale * d.mean), fmt::format("{:+.2f} to {:+.2f}", scale * d.low, scale * d.high)};
  };
  return TableOf({{"mean over the held-out trials", "before", "after", "difference", "95 % interval"},
                  row("value", result.proof->value, 1.0),
                  row("score", result.proof->score, 1.0),
                  row("survival [%]", result.proof->survival, 100.0)}) +
         fmt::format("<p class=\"soft\">{} trials that no candidate was tried on before, {}.</p>\n",
                     result.proof->trials,
                     has_before ? "the same trials for both, compared in pairs"
                                : "of the best candidate only: " + EscapedXml(result.proof->no_before));
}

std::string Metrics(const TuneReport& report) {
  Rows rows = {{"metric", "unit", "before", "after", "better if"}};
  for (std::size_t k = 0; k < report.metrics.size(); ++k) {
    const MetricRule& rule = RuleOf(report.metrics[k]);
    const auto of = [&](const PointOutcome& o) { return k < o.metrics.size() ? o.metrics[k] : std::nullopt; };
    const std::optional<double> before = of(report.before), after = of(report.after);
    if (!before && !after) continue;
    const char* better = rule.better == Better::kLower ? "lower" : rule.better == Better::kHigher ? "higher" : "";
    rows.push_back({rule.key, rule.unit == "1" ? "" : rule.unit, Number(before), Number(after), better});
  }
  rows.push_back({"score", "", Number(report.before.score), Number(report.after.score), "higher"});
  for (std::size_t k = 0; k < std::min(report.before.engines.size(), report.after.engines.size()); ++k)
    rows.push_back({"verdict, score in " + EngineTitle(report.after.engines[k].engine), "",
                    VerdictText(report.before.engines[k]), VerdictText(report.after.engines[k]), "higher"});
  return TableOf(rows);
}

Ink InkOf(const std::string& found_by) {
  if (found_by == "usual") return Ink::kLimit;
  if (found_by == "sample") return Ink::kMuted;
  return found_by == "surface" ? Ink::kCom : Ink::kZmp;
}

std::string History(const TuneResult& result) {
  SvgPlot::Options options;
  options.title = "Value of each candidate, and the best so far";
  options.x_label = "candidate";
  options.y_label = "value";
  SvgPlot plot(options);
  std::vector<Vector2> best;
  double so_far = -1.0;
  for (std::size_t i = 0; i < result.candidates.size(); ++i) {
    const TuneCandidate& candidate = result.candidates[i];
    if (candidate.value) so_far = std::max(so_far, *candidate.value);
    if (so_far >= 0.0) best.emplace_back(static_cast<double>(i), so_far);
  }
  plot.Line(best, Ink::kFoot, Stroke::kThin, "best so far");
  for (std::size_t i = 0; i < result.candidates.size(); ++i) {
    const TuneCandidate& candidate = result.candidates[i];
    const Vector2 at(static_cast<double>(i), candidate.value.value_or(0.0));
    if (candidate.value) {
      plot.Dot(at, InkOf(candidate.found_by), 3.5, candidate.found_by);
    } else {
      plot.Cross(at, Ink::kBad, "refused, shown at 0");
    }
  }
  return FigureOf({"history", "Progress of the search. Crosses have no plan that passes its audit.", plot.Svg()});
}

/// The fitted surface along one option through the favourite, if the favourite is within the ranges.
std::vector<Vector2> Slice(const Study& study, const TuneResult& result, std::size_t axis) {
  std::vector<Vector2> line;
  VectorX at = SharesOf(study.axes, result.candidates[result.favourite].values).cwiseMax(0.0).cwiseMin(1.0);
  constexpr int kParts = 60;
  for (int i = 0; result.surface && i <= kParts; ++i) {
    at[static_cast<Eigen::Index>(axis)] = static_cast<double>(i) / kParts;
    const StudyAxis& a = study.axes[axis];
    line.emplace_back(a.low + (a.high - a.low) * i / kParts, result.surface->surface.At(at));
  }
  return line;
}

std::string Response(const Study& study, const TuneResult& result, std::size_t axis) {
  const StudyAxis& a = study.axes[axis];
  SvgPlot::Options options;
  options.title = "Response to " + a.key;
  options.x_label = a.unit.empty() || a.unit == "1" ? a.key : a.key + " [" + a.unit + "]";
  options.y_label = "value";
  options.x_lowest = a.low;
  options.x_highest = a.high;
  SvgPlot plot(options);
  plot.Line(Slice(study, result, axis), Ink::kSupport, Stroke::kPlanned, "surface through the best candidate");
  for (const TuneCandidate& candidate : result.candidates) {
    const double value = NumberOfValue(candidate.values[axis]);
    if (candidate.value && value >= a.low && value <= a.high)
      plot.Dot({value, *candidate.value}, InkOf(candidate.found_by), 3.5, candidate.found_by);
  }
  plot.AcrossY(NumberOfValue(result.candidates[result.favourite].values[axis]), Ink::kDcm, "favourite");
  std::string caption = "Each candidate's value over " + a.key + ", for all values of the other options.";
  if (result.surface)
    caption += result.surface->predicted > 0.0
                   ? fmt::format(" The surface predicts {:.0f} % of the variance of points that were not fitted.",
                                 100.0 * result.surface->predicted)
                   : std::string(" The surface predicts points that were not fitted worse than their mean does.");
  return FigureOf({"response", caption, plot.Svg()});
}

std::string EveryCandidate(const Study& study, const TuneResult& result) {
  std::vector<std::string> heads = {"candidate", "found by"};
  for (const StudyAxis& axis : study.axes) heads.push_back(axis.key);
  heads.insert(heads.end(), {"value", "refused because"});
  Rows rows = {heads};
  for (std::size_t i = 0; i < result.candidates.size(); ++i) {
    const TuneCandidate& candidate = result.candidates[i];
    std::vector<std::string> row = {std::to_string(i), candidate.found_by};
    row.insert(row.end(), candidate.values.begin(), candidate.values.end());
    row.insert(row.end(), {Number(candidate.value), candidate.worth.refusal});
    rows.push_back(row);
  }
  return "<details><summary>Every candidate</summary>\n" + TableOf(rows) + "</details>\n";
}

}  // namespace

std::string TunePage(const Study& study, const TuneReport& report, const TuneOptions& options) {
  const TuneResult& result = report.result;
  std::string body = Head(study, report, options) + "<h2>Values</h2>\n" + Values(study, result);
  body += "<h2>Test on held-out trials</h2>\n" + Proof(result);
  body += "<h2>Search</h2>\n" + History(result);
  for (std::size_t k = 0; k < study.axes.size(); ++k) body += Response(study, result, k);
  body += "<h2>The undisturbed walk</h2>\n" + Metrics(report);
  body += "<h2>Candidates</h2>\n" + EveryCandidate(study, result);
  return StudyPage(fmt::format("{}: tuning", study.model.name), body);
}

}  // namespace gaitwright
