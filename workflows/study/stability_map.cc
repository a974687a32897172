// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/study/stability_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "playback/report/svg_tools.h"

namespace gaitwright {
namespace {

constexpr double kWidth = 960.0, kLeft = 74.0, kRight = 14.0, kTop = 30.0, kBottom = 46.0, kHead = 74.0;

std::string Words(double x, double y, const std::string& style, const std::string& words) {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" {}>{}</text>\n", x, y, style, EscapedXml(words));
}

std::string TitleOf(const StudyAxis& axis) {
  return axis.unit.empty() || axis.unit == "1" ? axis.key : axis.key + " [" + axis.unit + "]";
}

/// One set of axes: the values of all further axes are fixed.
struct Panel {
  StudyPoint further;
  double x = 0.0, y = 0.0, width = 0.0, height = 0.0;  ///< area of the cells [px]
};

/// Position of a value on an axis, and the size of a cell, both as shares of the axis length.
struct Place {
  double middle = 0.5, width = 1.0;
};

class MapDrawing {
 public:
  MapDrawing(const Study& study, const std::vector<PointOutcome>& outcomes, MapQuantity quantity)
      : study_(study), outcomes_(outcomes), quantity_(quantity), best_(SummaryOf(outcomes).best) {
    for (const StudyAxis& axis : study.axes) sampled_ = sampled_ || axis.is_range();
    LayOut();
  }

  std::string Svg() const {
    std::string svg = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.0f} {1:.0f}\" width=\"{0:.0f}\" "
        "height=\"{1:.0f}\" font-family=\"system-ui,'Segoe UI',Roboto,Arial,sans-serif\" font-size=\"12\">\n"
        "<rect width=\"{0:.0f}\" height=\"{1:.0f}\" fill=\"#ffffff\"/>\n",
        kWidth, height_);
    svg += MapPatterns() + Legend();
    for (const Panel& panel : panels_) svg += Draw(panel);
    return svg + "</svg>\n";
  }
  bool sliced() const { return sliced_; }
  bool sampled() const { return sampled_; }

 private:
  bool has_y() const { return study_.axes.size() > 1; }

  /// Combinations of values of the axes beyond the second, one panel each.
  std::vector<StudyPoint> Further() {
    if (sampled_) return {{}};
    std::vector<StudyAxis> further(study_.axes.begin() + std::min<std::ptrdiff_t>(2, std::ssize(study_.axes)),
                                   study_.axes.end());
    std::size_t count = 1;
    for (const StudyAxis& axis : further) count *= axis.values.size();
    sliced_ = count > kMostMapPanels;
    const std::size_t at = best_.value_or(0);
    for (std::size_t k = 1; sliced_ && k < further.size(); ++k) further[k].values = {study_.points[at][2 + k]};
    return GridPoints(further);
  }

  void LayOut() {
    const std::vector<StudyPoint> further = Further();
    const auto columns = static_cast<double>(std::min<std::size_t>(further.size(), further.size() > 4 ? 3 : 2));
    const double pitch = (kWidth - kRight) / columns;
    const double width = pitch - kLeft - kRight;
    const double least = has_y() ? 160.0 : 44.0, most = has_y() ? 420.0 : 44.0;
    const double height = std::clamp(0.62 * width, least, most);
    for (std::size_t i = 0; i < further.size(); ++i) {
      const double column = std::fmod(static_cast<double>(i), columns);
      const double row = std::floor(static_cast<double>(i) / columns);
      panels_.push_back(
          {further[i], kLeft + column * pitch, kHead + kTop + row * (kTop + height + kBottom), width, height});
    }
    height_ = panels_.back().y + height + kBottom + 8.0;
  }

  Place PlaceOf(const StudyAxis& axis, const std::string& value) const {
    if (sampled_ && axis.numbers && axis.low < axis.high) {
      return {0.02 + 0.96 * (NumberOfValue(value) - axis.low) / (axis.high - axis.low), 0.0};
    }
    const auto at = std::find(axis.values.begin(), axis.values.end(), value) - axis.values.begin();
    const auto count = static_cast<double>(axis.values.size());
    return {(static_cast<double>(at) + 0.5) / count, 1.0 / count};
  }

  bool IsIn(const Panel& panel, const StudyPoint& point) const {
    return std::equal(panel.further.begin(), panel.further.end(),
                      point.begin() + std::min<std::ptrdiff_t>(2, std::ssize(point)),
                      point.begin() + std::min<std::ptrdiff_t>(2, std::ssize(point)) + std::ssize(panel.further));
  }

  MapCell CellOf(const Panel& panel, const PointOutcome& outcome) const {
    const StudyPoint& point = study_.points[outcome.point];
    const Place x = PlaceOf(study_.axes[0], point[0]);
    const Place y = has_y() ? PlaceOf(study_.axes[1], point[1]) : Place{};
    MapCell cell;
    cell.round = sampled_;
    cell.framed = best_ == outcome.point;
    cell.width = sampled_ ? 15.0 : x.width * panel.width - 1.0;
    cell.height = sampled_ ? 15.0 : y.width * panel.height - 1.0;
    cell.x = panel.x + x.middle * panel.width - 0.5 * cell.width;
    cell.y = panel.y + (1.0 - y.middle) * panel.height - 0.5 * cell.height;
    cell.words = fmt::format("{}: {}{}. {}", PointText(study_.axes, point), WordsOf(outcome.status),
                             outcome.score ? fmt::format(", score {:.1f}", *outcome.score) : "", outcome.reason);
    return cell;
  }

  std::string Draw(const Panel& panel) const {
    std::string svg = fmt::format(
        "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" fill=\"#f5f7f9\" stroke=\"#c9d0d7\"/>\n",
        panel.x - 1.0, panel.y - 1.0, panel.width + 2.0, panel.height + 2.0);
    std::string best;
    for (const PointOutcome& outcome : outcomes_) {
      if (!sampled_ && !IsIn(panel, study_.points[outcome.point])) continue;
      const MapCell cell = CellOf(panel, outcome);
      (cell.framed ? best : svg) += DrawCell(cell, outcome.status, ShareOf(outcome, quantity_));
    }
    return svg + best + Labels(panel);  // the frame of the best cell is on top of its neighbours
  }

  /// Labels of an axis, with their positions.
  std::vector<std::pair<std::string, double>> Ticks(const StudyAxis& axis, double length_px, double room_px) const {
    std::vector<std::pair<std::string, double>> ticks;
    if (sampled_ && axis.numbers && axis.low < axis.high) {
      for (const double value : RoundTicks(axis.low, axis.high, static_cast<int>(length_px / 90.0) + 2))
        ticks.emplace_back(fmt::format("{:.6g}", value), PlaceOf(axis, fmt::format("{}", value)).middle);
      return ticks;
    }
    const auto count = static_cast<double>(axis.values.size());
    const auto every = static_cast<std::size_t>(std::max(1.0, std::ceil(count * room_px / length_px)));
    for (std::size_t i = 0; i < axis.values.size(); i += every) {
      const std::string& value = axis.values[i];
      ticks.emplace_back(axis.numbers ? fmt::format("{:.4g}", NumberOfValue(value)) : value,
                         PlaceOf(axis, value).middle);
    }
    return ticks;
  }

  std::string Labels(const Panel& panel) const {
    const double bottom = panel.y + panel.height;
    std::string svg;
    for (const auto& [words, at] : Ticks(study_.axes[0], panel.width, 46.0))
      svg += Words(panel.x + at * panel.width, bottom + 16.0, "text-anchor=\"middle\" fill=\"#3b4650\"", words);
    svg += Words(panel.x + 0.5 * panel.width, bottom + 34.0,
                 "text-anchor=\"middle\" fill=\"#1f2730\" font-weight=\"600\"", TitleOf(study_.axes[0]));
    if (!panel.further.empty()) {
      const std::vector<StudyAxis> further(study_.axes.begin() + 2, study_.axes.end());
      svg += Words(panel.x, panel.y - 8.0, "fill=\"#1f2730\" font-weight=\"600\"", PointText(further, panel.further));
    }
    if (!has_y()) return svg;
    for (const auto& [words, at] : Ticks(study_.axes[1], panel.height, 18.0))
      svg += Words(panel.x - 7.0, panel.y + (1.0 - at) * panel.height + 4.0, "text-anchor=\"end\" fill=\"#3b4650\"",
                   words);
    const double x = panel.x - 56.0, y = panel.y + 0.5 * panel.height;
    return svg + Words(x, y,
                       fmt::format("text-anchor=\"middle\" fill=\"#1f2730\" font-weight=\"600\" transform=\"rotate(-90 "
                                   "{:.1f} {:.1f})\"",
                                   x, y),
                       TitleOf(study_.axes[1]));
  }

  std::string Legend() const {
    const bool score = quantity_ == MapQuantity::kScore;
    std::string svg = Words(kLeft, 22.0, "font-size=\"15\" font-weight=\"650\" fill=\"#1f2730\"",
                            score ? "Score" : "Share of trials survived");
    constexpr double kBar = 220.0, kY = 34.0;
    for (int i = 0; i < 44; ++i) {
      svg += fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"5.4\" height=\"14\" fill=\"{}\"/>\n",
                         kLeft + i * kBar / 44.0, kY, MapColour(i / 43.0));
    }
    for (const int percent : {0, 25, 50, 75, 100}) {
      svg += Words(kLeft + kBar * percent / 100.0, kY + 28.0, "text-anchor=\"middle\" fill=\"#3b4650\"",
                   fmt::format("{}{}", percent, score ? "" : " %"));
    }
    double x = kLeft + kBar + 40.0;
    const SweepSummary summary = SummaryOf(outcomes_);
    for (const PointStatus status : kPointStatuses) {
      if (status == PointStatus::kPass || summary.Count(status) == 0) continue;
      const bool has_score = status != PointStatus::kRefused;
      svg +=
          DrawCell({x, kY - 2.0, 20.0, 18.0, sampled_, false, ""}, status,
                   has_score ? std::optional<double>(status == PointStatus::kGateMissed ? 0.45 : 0.1) : std::nullopt);
      svg += Words(x + 26.0, kY + 12.0, "fill=\"#1f2730\"", WordsOf(status));
      x += 42.0 + 6.6 * static_cast<double>(WordsOf(status).size());
    }
    if (!best_) return svg;
    svg += DrawCell({x, kY - 2.0, 20.0, 18.0, sampled_, true, ""}, PointStatus::kPass, 0.95);
    return svg + Words(x + 26.0, kY + 12.0, "fill=\"#1f2730\"", "best");
  }

  const Study& study_;
  const std::vector<PointOutcome>& outcomes_;
  MapQuantity quantity_;
  std::optional<std::size_t> best_;
  bool sampled_ = false, sliced_ = false;
  std::vector<Panel> panels_;
  double height_ = 0.0;
};

}  // namespace

StudyPicture DrawStabilityMap(const Study& study, const std::vector<PointOutcome>& outcomes, MapQuantity quantity) {
  const MapDrawing drawing(study, outcomes, quantity);
  const bool score = quantity == MapQuantity::kScore;
  std::string caption = score ? "Score of each point, 0 to 100; 50 or more is a pass."
                              : "Survival rate of each point's trials; points without a passing plan have none.";
  caption += " Letters mark failures: R refused, A plan fails its audit, F fell, G fails a gate.";
  if (drawing.sampled() && study.axes.size() > 2)
    caption += " Points are drawn over the first two axes, for all values of the others.";
  if (drawing.sliced()) caption += " Axes beyond the third are shown only at the best point's values.";
  return {score ? "score_map" : "survival_map", caption, drawing.Svg()};
}

}  // namespace gaitwright
