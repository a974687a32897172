// SPDX-License-Identifier: BSD-3-Clause
#include "playback/report/plots.h"

#include <fmt/format.h>

#include <algorithm>

#include "kinematics/base/result.h"
#include "playback/report/svg_plot.h"

namespace gaitwright {
namespace {

constexpr double kAfterFall = 0.15;  // shown [s]

void Append(std::vector<Plot> more, std::vector<Plot>& plots) {
  for (Plot& plot : more) plots.push_back(std::move(plot));
}

}  // namespace

void MarkTimes(const PlotData& data, SvgPlot& plot, bool in_words) {
  for (std::size_t k = 1; k < data.plan.parts.size(); ++k) {
    const MotionPart& part = data.plan.parts[k];
    const double start_s = data.start_s() + part.start_s - data.plan.whole_body.start_s;
    plot.AcrossY(start_s, Ink::kMuted, in_words ? part.gait.name : "");
  }
  const Metric& fell = data.report.At("fell");
  if (fell.value.value_or(0.0) <= 0.0 || !fell.at_s) return;
  plot.AcrossY(*fell.at_s, Ink::kBad, in_words ? fmt::format("fell, {:.2f} s", *fell.at_s) : "");
}

std::vector<Plot> MakePlots(const RobotModel& model, const MotionPlan& plan, const PlaybackLog& log,
                            const StabilityReport& report) {
  PlotData data{model, plan, log, report, MakeMotionSeries(model, plan, log, ScoreOptionsOf(log))};
  if (data.series.measured.empty()) throw InvalidArgument("MakePlots: the log has no sample with finite values");
  const Metric& fell = report.At("fell");
  if (fell.value.value_or(0.0) > 0.0 && fell.at_s) {
    std::size_t count = data.series.measured.size();
    while (count > 2 && data.series.measured[count - 1].time_s > *fell.at_s + kAfterFall) --count;
    data.series.measured.resize(count);
    data.series.planned.resize(count);
    data.series.plan.resize(count);
  }
  std::vector<Plot> plots = {TopView(data)};
  if (KindOfGround(plan.terrain) == GroundKind::kUneven) plots.push_back(SideView(data));
  Append(BalancePlots(data), plots);
  Append(EstimatePlots(data), plots);
  Append(ContactPlots(data), plots);
  Append(JointPlots(data), plots);
  return plots;
}

}  // namespace gaitwright
