// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "playback/report/plots.h"
#include "playback/report/svg_plot.h"

namespace gaitwright {
namespace {

constexpr double kMillimetres = 1e3;
const double kGap = std::nan("");

SvgPlot TimePlot(const PlotData& data, const std::string& title, const std::string& y_label,
                 double y_least_span = 0.0) {
  SvgPlot::Options options;
  options.title = title;
  options.x_label = "time [s]";
  options.y_label = y_label;
  options.y_least_span = y_least_span;
  options.x_lowest = data.start_s();
  options.x_highest = data.end_s();
  return SvgPlot(options);
}

/// (time, value) over the samples; a value that is not finite leaves a gap.
template <class Figure>
std::vector<Vector2> Over(const std::vector<MotionSample>& samples, Figure figure) {
  std::vector<Vector2> line;
  line.reserve(samples.size());
  for (const MotionSample& sample : samples) line.emplace_back(sample.time_s, figure(sample));
  return line;
}

Plot ZmpAndCom(const PlotData& data, int axis) {
  const std::string name = axis == 0 ? "x" : "y";
  SvgPlot plot = TimePlot(data, "Zero-moment point and centre of mass, " + name, name + " [m]");
  DrawBalance(data.series, axis, plot);
  MarkTimes(data, plot);
  return {"zmp_com_" + name,
          "World " + name +
              " of the ZMP and the centre of mass over time; the shaded band is the extent of the scheduled support.",
          plot.Svg()};
}

Plot Margins(const PlotData& data) {
  SvgPlot plot = TimePlot(data, "Margin of the zero-moment point", "margin [mm]");
  const auto margin = [](const MotionSample& s) { return s.has_zmp ? kMillimetres * s.zmp_margin_m() : kGap; };
  plot.Line(Over(data.series.planned, margin), Ink::kZmp, Stroke::kPlanned, "planned");
  plot.Line(Over(data.series.measured, margin), Ink::kZmp, Stroke::kMeasured, "measured");
  plot.AcrossX(0.0, Ink::kLimit, "edge of the support", true);
  MarkTimes(data, plot);
  return {"margins",
          "Signed distance of the ZMP to the edge of the support; positive is inside. On two point feet, the support "
          "is a line and the margin is minus the distance to it.",
          plot.Svg()};
}

Plot Errors(const PlotData& data) {
  SvgPlot plot = TimePlot(data, "Error of zero-moment point and divergent component", "error [mm]");
  std::vector<Vector2> zmp, dcm;
  for (std::size_t k = 0; k < data.series.measured.size(); ++k) {
    const MotionSample &actual = data.series.measured[k], &wanted = data.series.planned[k];
    const SupportMotion motion = MotionBetween(wanted.support, actual.support);
    const bool both = actual.has_zmp && wanted.has_zmp;
    zmp.emplace_back(actual.time_s, both ? kMillimetres * (motion.Back(actual.p_WZ) - wanted.p_WZ).norm() : kGap);
    const bool stands = !actual.support.empty();
    dcm.emplace_back(actual.time_s, stands ? kMillimetres * (motion.Back(actual.dcm_W) - wanted.dcm_W).norm() : kGap);
  }
  plot.Line(zmp, Ink::kZmp, Stroke::kMeasured, "ZMP");
  plot.Line(dcm, Ink::kDcm, Stroke::kMeasured, "DCM");
  MarkTimes(data, plot);
  return {"errors",
          "Distance between the measured and the planned point, each in the frame of its own support, so that drift of "
          "the base is not counted.",
          plot.Svg()};
}

struct Attitude {
  double roll, pitch, yaw;
};

Attitude AttitudeOf(const MotionSample& sample) {
  const Matrix3 R = sample.X_WB.linear();
  return {std::atan2(R(2, 1), R(2, 2)), std::asin(std::clamp(-R(2, 0), -1.0, 1.0)), std::atan2(R(1, 0), R(0, 0))};
}

Plot Base(const PlotData& data) {
  SvgPlot plot = TimePlot(data, "Attitude of the base", "angle [rad]", 0.05);
  const auto& [planned, measured, plan] = data.series;
  const auto roll = [](const MotionSample& s) { return AttitudeOf(s).roll; };
  const auto pitch = [](const MotionSample& s) { return AttitudeOf(s).pitch; };
  double before = 0.0;
  const auto yaw = [&before](const MotionSample& s) {
    return before += std::remainder(AttitudeOf(s).yaw - before, 2.0 * M_PI);
  };
  plot.Line(Over(planned, roll), Ink::kZmp, Stroke::kPlanned, "roll planned");
  plot.Line(Over(measured, roll), Ink::kZmp, Stroke::kMeasured, "roll");
  plot.Line(Over(planned, pitch), Ink::kCom, Stroke::kPlanned, "pitch planned");
  plot.Line(Over(measured, pitch), Ink::kCom, Stroke::kMeasured, "pitch");
  plot.Line(Over(planned, yaw), Ink::kFoot, Stroke::kPlanned, "yaw planned");
  before = 0.0;
  plot.Line(Over(measured, yaw), Ink::kFoot, Stroke::kMeasured, "yaw");
  MarkTimes(data, plot);
  return {"base_attitude", "Roll, pitch and yaw of the base.", plot.Svg()};
}

Plot BaseHeight(const PlotData& data) {
  SvgPlot plot = TimePlot(data, "Height of the base", "z [m]", 0.02);
  const auto height = [](const MotionSample& s) { return s.X_WB.translation().z(); };
  plot.Line(Over(data.series.planned, height), Ink::kCom, Stroke::kPlanned, "planned");
  plot.Line(Over(data.series.measured, height), Ink::kCom, Stroke::kMeasured, "measured");
  MarkTimes(data, plot);
  return {"base_height", "World z of the base's origin.", plot.Svg()};
}

void DrawExtent(const std::vector<MotionSample>& samples, int axis, SvgPlot& plot) {
  std::vector<double> time, lower, upper;
  FootSet before = 0;
  for (const MotionSample& sample : samples) {
    double least = kGap, most = kGap;
    for (const Vector2& corner : sample.support.polygon) {
      least = std::fmin(least, corner[axis]);
      most = std::fmax(most, corner[axis]);
    }
    if (!time.empty() && sample.stance != before) {  // as a step, not as a slope
      time.push_back(sample.time_s);
      lower.push_back(lower.back());
      upper.push_back(upper.back());
    }
    before = sample.stance;
    time.push_back(sample.time_s);
    lower.push_back(least);
    upper.push_back(most);
  }
  plot.Band(time, lower, upper, Ink::kSupport, "extent of the support");
}

}  // namespace

void DrawBalance(const MotionSeries& series, int axis, SvgPlot& plot) {
  DrawExtent(series.measured.empty() ? series.planned : series.measured, axis, plot);
  const auto com = [axis](const MotionSample& s) { return s.p_WC[axis]; };
  const auto zmp = [axis](const MotionSample& s) { return s.has_zmp ? s.p_WZ[axis] : kGap; };
  plot.Line(Over(series.planned, com), Ink::kCom, Stroke::kPlanned, "CoM planned");
  if (!series.measured.empty()) plot.Line(Over(series.measured, com), Ink::kCom, Stroke::kMeasured, "CoM measured");
  plot.Line(Over(series.planned, zmp), Ink::kZmp, Stroke::kPlanned, "ZMP planned");
  if (!series.measured.empty()) plot.Line(Over(series.measured, zmp), Ink::kZmp, Stroke::kMeasured, "ZMP measured");
}

std::vector<Plot> BalancePlots(const PlotData& data) {
  return {ZmpAndCom(data, 0), ZmpAndCom(data, 1), Margins(data), Errors(data), Base(data), BaseHeight(data)};
}

}  // namespace gaitwright
