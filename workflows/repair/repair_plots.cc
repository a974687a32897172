// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <cstddef>

#include "playback/report/plot_grid.h"
#include "playback/report/svg_plot.h"
#include "playback/score/agreement.h"
#include "workflows/repair/repair_page_internal.h"

namespace gaitwright {
namespace {

constexpr double kLeastGap = 1.0 / 900.0;     // of the time axis: nearer bars become one
constexpr std::size_t kPointsOfCurve = 1500;  // a long curve shows the largest value of each piece

bool Fails(const std::vector<BrokenTime>& broken, Law law) {
  return std::any_of(broken.begin(), broken.end(), [law](const BrokenTime& one) { return one.law == law; });
}

/// Checks that fail before or after, in their order.
std::vector<Law> FailingLaws(const RepairResult& result) {
  std::vector<Law> laws;
  for (const Law law : AllLaws()) {
    const bool after = result.repaired != nullptr && Fails(result.repaired->broken, law);
    if (after || Fails(result.findings.broken, law)) laws.push_back(law);
  }
  return laws;
}

/// Bars of one motion on a time axis.
SvgPlot BarsOf(const std::string& title, const std::vector<Law>& laws, const std::vector<BrokenTime>& broken,
               double until_s) {
  SvgPlot::Options options;
  options.title = title;
  options.x_label = "time [s]";
  options.x_lowest = 0.0;
  options.x_highest = until_s;
  for (const Law law : laws) options.rows.push_back(LawName(law));
  options.height_px = 66.0 + 22.0 * static_cast<double>(laws.size());
  SvgPlot plot(options);
  for (std::size_t row = 0; row < laws.size(); ++row) {
    for (const BrokenTime& one : broken) {
      if (one.law != laws[row]) continue;
      for (std::size_t i = 0; i < one.spans.size(); ++i) {
        BrokenSpan span = one.spans[i];
        while (i + 1 < one.spans.size() && one.spans[i + 1].start_s - span.end_s < kLeastGap * until_s)
          span.end_s = one.spans[++i].end_s;
        plot.Bar(static_cast<int>(row), span.start_s, span.end_s, Ink::kBad, Stroke::kMeasured);
      }
    }
  }
  return plot;
}

void MarkFalls(const PlayedWalk& played, SvgPlot& plot) {
  const auto mark = [&](const ScoredPlayback& one) {
    const Metric& fell = one.report.At("fell");
    if (fell.value.value_or(0.0) > 0.0 && fell.at_s)
      plot.AcrossY(*fell.at_s, Ink::kLimit, "fell in " + EngineTitle(EngineOf(one.log)));
  };
  mark(played);
  if (played.second != nullptr) mark(*played.second);
}

/// A curve over time; each point is the largest of its piece.
std::vector<Vector2> CurveOf(const std::vector<float>& values, double step_s, double scale) {
  std::vector<Vector2> points;
  const std::size_t piece = std::max<std::size_t>(1, values.size() / kPointsOfCurve);
  for (std::size_t k = 0; k < values.size(); k += piece) {
    const auto begin = values.begin() + static_cast<std::ptrdiff_t>(k);
    const auto end = values.begin() + static_cast<std::ptrdiff_t>(std::min(k + piece, values.size()));
    points.emplace_back(static_cast<double>(k) * step_s, scale * static_cast<double>(*std::max_element(begin, end)));
  }
  return points;
}

/// The curves of all groups in a unit.
SvgPlot CurvesOf(const MotionDistance& distance, double step_s, const std::string& unit) {
  constexpr Ink kInks[] = {Ink::kFoot, Ink::kCom, Ink::kDcm};
  const bool angles = unit == "rad";
  SvgPlot::Options options;
  options.title = angles ? "Joints, RMS" : "Places of base, hands and feet, RMS";
  options.x_label = "time [s]";
  options.y_label = angles ? "rad" : "mm";
  options.y_lowest = 0.0;
  options.y_least_span = angles ? 0.02 : 5.0;
  options.height_px = 220.0;
  SvgPlot plot(options);
  std::size_t ink = 0;
  for (const GroupDistance& group : distance.groups) {
    if (group.unit != unit) continue;
    plot.Line(CurveOf(group.over_time, step_s, angles ? 1.0 : 1e3), kInks[ink % std::size(kInks)], Stroke::kMeasured,
              WordsOfGroup(group.group));
    ++ink;
  }
  return plot;
}

}  // namespace

Plot BrokenPlot(const RepairResult& result) {
  const std::vector<Law> laws = FailingLaws(result);
  const RepairedMotion* repaired = result.repaired;
  const double until_s = std::max(result.findings.duration_s, repaired == nullptr ? 0.0 : repaired->plan.duration_s());
  std::vector<SvgPlot> plots;
  if (!laws.empty() && result.findings.before)
    plots.push_back(BarsOf("Original", laws, result.findings.broken, until_s));
  if (!laws.empty() && repaired != nullptr) {
    plots.push_back(
        BarsOf(repaired->broken.empty() ? "Repaired: no check fails" : "Repaired", laws, repaired->broken, until_s));
    if (result.played != nullptr) MarkFalls(*result.played, plots.back());
  }
  const std::string caption =
      repaired == nullptr
          ? "Bars: times at which a check of the audit fails at any place."
          : "Bars: times at which a check of the audit fails at any place. Both axes are equally long; the times of "
            "the repaired motion are later where parts were slowed or added.";
  return {"broken", caption, plots.empty() ? "" : StackOfPlots(plots, "Failing checks over time")};
}

Plot DistancePlot(const MotionDistance& distance, double step_s) {
  return {"distance",
          "Distance of the repaired motion from the original at the same moment of the motion, RMS over the joints or "
          "places of each part of the robot. Places are those in the world.",
          StackOfPlots({CurvesOf(distance, step_s, "rad"), CurvesOf(distance, step_s, "m")},
                       "Distance from the original over time")};
}

}  // namespace gaitwright
