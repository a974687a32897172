// SPDX-License-Identifier: BSD-3-Clause
#include "playback/report/engines_part.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "playback/report/page_parts_internal.h"
#include "playback/report/plot_grid.h"
#include "playback/report/svg_plot.h"
#include "playback/report/svg_tools.h"
#include "playback/score/motion_series.h"

namespace gaitwright {
namespace {

/// The measured motions of both engines, with the engines' names.
struct BothMotions {
  std::vector<MotionSample> a, b;
  std::string name_a, name_b;
  double start_s, end_s;
};

BothMotions MotionsOf(const RobotModel& model, const MotionPlan& plan, const PlaybackLog& log,
                      const SecondVerdict& second) {
  BothMotions motions{MakeMeasuredSeries(model, plan, log, ScoreOptionsOf(log)),
                      MakeMeasuredSeries(model, plan, second.log, ScoreOptionsOf(second.log)),
                      EngineTitle(second.agreement.name_a),
                      EngineTitle(second.agreement.name_b),
                      0.0,
                      0.0};
  motions.start_s = log.start_s;
  motions.end_s = std::max(motions.a.back().time_s, motions.b.back().time_s);
  return motions;
}

SvgPlot::Options TimeAxis(const BothMotions& motions, const std::string& title, const std::string& y_label) {
  SvgPlot::Options options;
  options.title = title;
  options.y_label = y_label;
  options.x_label = "time [s]";
  options.x_lowest = motions.start_s;
  options.x_highest = motions.end_s;
  return options;
}

/// The first engine's curve is broad and pale; the second's is thin and dark, drawn on top.
template <class Figure>
void DrawBoth(const BothMotions& motions, Figure figure, Ink ink, SvgPlot& plot) {
  const auto line = [&](const std::vector<MotionSample>& samples) {
    std::vector<Vector2> points;
    points.reserve(samples.size());
    for (const MotionSample& sample : samples) points.emplace_back(sample.time_s, figure(sample));
    return points;
  };
  plot.Line(line(motions.a), ink, Stroke::kPlanned, motions.name_a);
  plot.Line(line(motions.b), ink, Stroke::kMeasured, motions.name_b);
}

std::string BalanceCurves(const BothMotions& motions) {
  std::vector<SvgPlot> plots;
  for (int axis = 0; axis < 2; ++axis) {
    const std::string name(1, "xy"[axis]);
    SvgPlot::Options options = TimeAxis(motions, "Zero-moment point, " + name, name + " [m]");
    options.height_px = 220.0;
    SvgPlot plot(options);
    DrawBoth(
        motions, [axis](const MotionSample& s) { return s.has_zmp ? s.p_WZ[axis] : std::nan(""); }, Ink::kZmp, plot);
    plots.push_back(std::move(plot));
  }
  SvgPlot::Options options = TimeAxis(motions, "Height of the base", "z [m]");
  options.height_px = 220.0;
  options.y_least_span = 0.02;
  SvgPlot plot(options);
  DrawBoth(
      motions, [](const MotionSample& s) { return s.X_WB.translation().z(); }, Ink::kCom, plot);
  plots.push_back(std::move(plot));
  return StackOfPlots(plots, "Balance in both engines");
}

std::string ForceCurves(const RobotModel& model, const BothMotions& motions) {
  constexpr int kColumns = 2;
  std::vector<SvgPlot> plots;
  for (std::size_t foot = 0; foot < model.feet.size(); ++foot) {
    SvgPlot::Options options = TimeAxis(motions, model.feet[foot].name, "N");
    options.width_px = 480.0;
    options.height_px = 170.0;
    options.x_label_room = true;
    if (foot + kColumns < model.feet.size()) options.x_label = "";
    options.most_points = 700;
    options.legend = false;
    SvgPlot plot(options);
    DrawBoth(
        motions, [foot](const MotionSample& s) { return s.feet[foot].force_W.z(); }, Ink::kFoot, plot);
    plots.push_back(std::move(plot));
  }
  return GridOfPlots(plots, kColumns, "Vertical force of the feet in both engines");
}

std::string VerdictRow(const std::string& engine, const StabilityReport& report) {
  return fmt::format("<tr><td>{}</td><td>{}</td><td class=\"n\">{:.1f}</td><td>{}</td></tr>\n", EscapedXml(engine),
                     VerdictMark(report.pass), report.score, EscapedXml(report.reason));
}

std::string InUnit(double value, const std::string& unit) {
  return unit == "m" ? fmt::format("{:.1f} mm", 1e3 * value) : fmt::format("{:.3g} {}", value, unit);
}

std::string DifferenceTable(const Agreement& agreement) {
  std::string html =
      "<details><summary>Differences by quantity</summary><table id=\"engine_differences\"><thead><tr><th>quantity</th>"
      "<th class=\"n\">rms</th><th class=\"n\">largest</th><th class=\"n\">at</th><th class=\"n\">tolerance</th><th "
      "class=\"n\">first differs at</th></tr></thead><tbody>\n";
  for (const QuantityAgreement& one : agreement.quantities) {
    html += fmt::format(
        "<tr><td>{}</td><td class=\"n\">{}</td><td class=\"n\">{}</td><td class=\"n\">{:.2f} s</td><td "
        "class=\"n\">{}</td><td class=\"n\">{}</td></tr>\n",
        EscapedXml(one.quantity), InUnit(one.rms, one.unit), InUnit(one.largest, one.unit), one.at_s,
        InUnit(one.tolerance, one.unit), one.parts_s ? fmt::format("{:.2f} s", *one.parts_s) : "\u2013");
  }
  return html + "</tbody></table></details>\n";
}

}  // namespace

std::string EngineVerdicts(const PlaybackLog& log, const StabilityReport& report,
                           const std::optional<SecondVerdict>& second) {
  std::string html = fmt::format(
      "<h2 id=\"engines\">{}</h2>\n<div class=\"scroll\"><table><thead><tr><th>engine</th><th>verdict</th><th "
      "class=\"n\">score</th><th>reason</th></tr></thead><tbody>\n",
      second ? "Two engines" : "Played in physics");
  html += VerdictRow(EngineTitle(second ? second->agreement.name_a : EngineOf(log)), report);
  if (second) html += VerdictRow(EngineTitle(second->agreement.name_b), second->report);
  html += "</tbody></table></div>\n";
  if (!second) return html;
  return html + fmt::format("<p>{}.</p>\n", EscapedXml(AgreementText(second->agreement))) +
         DifferenceTable(second->agreement);
}

std::string EnginesPart(const RobotModel& model, const MotionPlan& plan, const PlaybackLog& log,
                        const StabilityReport& report, const SecondVerdict& second) {
  std::string html = EngineVerdicts(log, report, second);
  const BothMotions motions = MotionsOf(model, plan, log, second);
  const std::string who = fmt::format("{} is broad and pale, {} thin and dark.", motions.name_a, motions.name_b);
  html += FigurePart({"engines_balance", "ZMP and height of the base as measured; " + who, BalanceCurves(motions)});
  return html + FigurePart({"engines_forces", "Vertical contact force by foot; " + who, ForceCurves(model, motions)});
}

}  // namespace gaitwright
