// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "playback/report/svg_plot.h"
#include "playback/report/svg_tools.h"
#include "playback/report/trials_page.h"

namespace gaitwright {
namespace {

using Fate = PushRecord::Outcome;

constexpr std::size_t kLeastOfGroup = 10, kMostGroups = 8;  // of trials whose survival rate is drawn

/// Place of a push in the plot: forward is up, left is left.
Vector2 PlaceOf(double direction_deg, double size_n) {
  const double angle = direction_deg * std::numbers::pi / 180.0;
  return {-size_n * std::sin(angle), size_n * std::cos(angle)};
}

/// A vertical push is in the middle.
Vector2 PlaceOf(const PushRecord& push) {
  const std::optional<double> direction = push.direction_deg();
  return direction ? PlaceOf(*direction, push.size_n()) : Vector2(0.0, 0.0);
}

std::vector<Vector2> Ring(double radius) {
  std::vector<Vector2> points;
  for (int deg = 0; deg <= 360; deg += 5) points.push_back(PlaceOf(deg, radius));
  return points;
}

/// The sizes of the bins as a closed path of arcs; with gaps at empty bins.
std::vector<Vector2> Border(const std::vector<PushBin>& bins, std::optional<double> PushBin::*size) {
  std::vector<Vector2> points;
  const double half = 180.0 / static_cast<double>(bins.size());
  for (const PushBin& bin : bins) {
    const std::optional<double> radius = bin.*size;
    for (int i = -4; i <= 4; ++i) {
      points.push_back(radius ? PlaceOf(bin.direction_deg + half * i / 4.0, *radius) : Vector2::Constant(std::nan("")));
    }
  }
  if (!points.empty()) points.push_back(points.front());
  return points;
}

Plot PolarPlot(const RobustnessReport& report) {
  SvgPlot plot(SvgPlot::ToScale("Pushes by direction", "to the right [N]", "forward [N]"));
  double largest = 0.0;
  for (const PushRecord& push : report.pushes) largest = std::max(largest, push.size_n());
  for (const double radius : RoundTicks(0.0, std::max(largest, 1e-3), 4)) {
    if (radius > 0.0) plot.Line(Ring(radius), Ink::kMuted, Stroke::kDashed);
  }
  for (const PushRecord& push : report.pushes) {
    if (push.outcome == Fate::kUnknown) plot.Dot(PlaceOf(push), Ink::kMuted, 1.5, "unknown");
  }
  for (const PushRecord& push : report.pushes) {
    if (push.outcome == Fate::kRecovered) plot.Dot(PlaceOf(push), Ink::kFoot, 2.2, "survived");
  }
  for (const PushRecord& push : report.pushes) {
    if (push.outcome == Fate::kFatal) plot.Cross(PlaceOf(push), Ink::kBad, "fell");
  }
  plot.Line(Border(report.push_bins, &PushBin::largest_survived_n), Ink::kFoot, Stroke::kMeasured, "largest survived");
  plot.Line(Border(report.push_bins, &PushBin::smallest_fatal_n), Ink::kBad, Stroke::kMeasured, "smallest fatal");
  return {
      "pushes",
      fmt::format("Every push of every trial, seen from above with the robot's heading up: direction and size, "
                  "including its upward part. A push is fatal if the robot fell within {:g} s, before another push; it "
                  "is survived if the robot stayed up for {:g} s. The push need not be the cause of the fall.",
                  kPushWindow, kPushWatched),
      plot.Svg()};
}

/// Values of a quantity in all trials and whether the robot survived, sorted by value.
using Outcomes = std::vector<std::pair<double, bool>>;

Outcomes SortedBy(const RobustnessReport& report, const std::string& name) {
  Outcomes outcomes;
  for (const TrialOutcome& outcome : report.outcomes) {
    for (const SampledValue& one : outcome.sampled) {
      if (one.name == name && one.word.empty()) outcomes.emplace_back(one.value, outcome.survived);
    }
  }
  std::stable_sort(outcomes.begin(), outcomes.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  return outcomes;
}

Plot SurvivalOver(const RobustnessReport& report, const Sensitivity& cause) {
  SvgPlot::Options options;
  options.title = "Survival against the strongest correlate of falling";
  options.x_label = fmt::format("{} [{}]", cause.name, cause.unit);
  options.y_label = "survival rate";
  options.y_lowest = 0.0;
  options.y_highest = 1.02;
  SvgPlot plot(options);
  const Outcomes outcomes = SortedBy(report, cause.name);
  const std::size_t bins = std::min(outcomes.size() / kLeastOfGroup, kMostGroups);
  std::vector<double> x, low, high;
  std::vector<Vector2> shares;
  for (std::size_t b = 0; b < bins; ++b) {
    const std::size_t begin = b * outcomes.size() / bins, end = (b + 1) * outcomes.size() / bins;
    int survived = 0;
    double sum = 0.0;
    for (std::size_t i = begin; i < end; ++i) {
      survived += outcomes[i].second ? 1 : 0;
      sum += outcomes[i].first;
    }
    const ShareInterval share = WilsonInterval(survived, static_cast<int>(end - begin));
    x.push_back(sum / static_cast<double>(end - begin));
    low.push_back(share.low);
    high.push_back(share.high);
    shares.emplace_back(x.back(), share.share);
  }
  const bool grouped = bins > 1;
  if (grouped) {
    plot.Band(x, low, high, Ink::kSupport, "95 % interval");
    plot.Line(shares, Ink::kCom, Stroke::kMeasured, "share in groups of equal size");
  }
  for (const auto& [value, survived] : outcomes) {
    survived ? plot.Dot({value, 1.0}, Ink::kFoot, 1.8, "survived") : plot.Cross({value, 0.0}, Ink::kBad, "fell");
  }
  return {"survival_by_cause",
          fmt::format("{} has the most significant association with falling (p {:.2g}). {}", cause.name, cause.p,
                      grouped ? "Trials are grouped by its value; the line is the share of each group that survived."
                              : fmt::format("Each mark is a trial: at the top if it survived, at the bottom if it "
                                            "fell. Group shares need {} trials.",
                                            2 * kLeastOfGroup)),
          plot.Svg()};
}

/// Only gates whose values can be shown as a share of the limit: upper limits above zero.
Plot GatesPlot(const RobustnessReport& report) {
  std::vector<const MetricSpread*> shown;
  SvgPlot::Options options;
  options.title = "Metrics over their limits";
  options.x_label = "share of the limit";
  options.x_lowest = 0.0;
  options.x_highest = 2.0;
  for (const MetricSpread& m : report.metrics) {
    if (!m.limit || *m.limit <= 0.0) continue;
    shown.push_back(&m);
    options.rows.push_back(m.key);
  }
  options.height_px = 70.0 + 26.0 * static_cast<double>(shown.size());
  SvgPlot plot(options);
  for (std::size_t i = 0; i < shown.size(); ++i) {
    const MetricSpread& m = *shown[i];
    const auto share = [&](double value) { return std::clamp(value / *m.limit, 0.0, 2.0); };
    const int row = static_cast<int>(i);
    plot.Bar(row, share(m.lowest), share(m.highest), Ink::kSupport, Stroke::kPlanned, "all trials");
    plot.Bar(row, share(m.p05), share(m.p95), Ink::kCom, Stroke::kMeasured, "5 % to 95 %");
    plot.Dot({share(m.median), static_cast<double>(row)}, Ink::kZmp, 4.0, "median");
  }
  plot.AcrossY(1.0, Ink::kLimit, "limit");
  return {"gates",
          "Distribution over the trials of the metrics that have a limit; values above twice the limit are clipped.",
          plot.Svg()};
}

Plot ScoresPlot(const RobustnessReport& report) {
  SvgPlot::Options options;
  options.title = "Scores, sorted";
  options.x_label = "trials";
  options.y_label = "score";
  options.y_lowest = 0.0;
  options.y_highest = 100.0;
  options.height_px = 220.0;
  std::vector<double> scores;
  for (const TrialOutcome& outcome : report.outcomes) scores.push_back(outcome.score);
  std::sort(scores.begin(), scores.end());
  std::vector<Vector2> line;
  for (std::size_t i = 0; i < scores.size(); ++i) line.emplace_back(static_cast<double>(i + 1), scores[i]);
  SvgPlot plot(options);
  plot.Line(line, Ink::kCom, Stroke::kMeasured);
  plot.AcrossX(50.0, Ink::kLimit, "every gate passes above", true);
  return {"scores", "Score of every trial, the worst first; trials with 50 and more pass every gate.", plot.Svg()};
}

}  // namespace

std::vector<Plot> TrialPlots(const RobustnessReport& report) {
  std::vector<Plot> plots;
  if (report.n == 0) return plots;
  if (!report.push_bins.empty()) plots.push_back(PolarPlot(report));
  const auto numeric = std::find_if(report.sensitivity.begin(), report.sensitivity.end(),
                                    [](const Sensitivity& s) { return !s.of_a_word; });
  if (numeric != report.sensitivity.end()) plots.push_back(SurvivalOver(report, *numeric));
  plots.push_back(GatesPlot(report));
  plots.push_back(ScoresPlot(report));
  return plots;
}

}  // namespace gaitwright
