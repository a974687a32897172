// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "playback/report/svg_plot.h"
#include "playback/report/svg_tools.h"

namespace gaitwright {
namespace {

constexpr double kSwatch = 46.0;            // a sample symbol and the gaps around it [px]
constexpr double kLegendCharacter = 6.3;    // [px]
constexpr double kLegendLineHeight = 17.0;  // [px]

}  // namespace

double SvgPlot::WidthOf(const LegendEntry& entry) {
  return kSwatch + kLegendCharacter * static_cast<double>(entry.label.size());
}

double SvgPlot::LegendWidth() const {
  double width = 0.0;
  for (const LegendEntry& entry : legend_) width += WidthOf(entry);
  return width;
}

int SvgPlot::LegendLines(double available_px) const {
  if (!options_.legend || legend_.empty()) return 0;
  const double title = 20.0 + 7.6 * static_cast<double>(options_.title.size());
  if (title + LegendWidth() <= available_px && !options_.title.empty()) return 0;  // beside the title
  return static_cast<int>(std::ceil(LegendWidth() / available_px));
}

/// Draws a shape of the plot into a box of the legend.
std::string SvgPlot::DrawEntry(const LegendEntry& entry, double x, double y) const {
  Frame box{0.0, 0.0, x, y - 5.0, x + 24.0, y + 5.0, Vector2::Zero(), Vector2::Ones(), 0};
  Shape sample = entry.shape;
  const std::string words = SvgText(x + 30.0, y + 4.0, "legend", entry.label);
  switch (sample.kind) {
    case Shape::Kind::kArea:
      sample.points = {{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}};
      break;
    case Shape::Kind::kLine:
      sample.points = {{0.0, 0.5}, {1.0, 0.5}};
      break;
    case Shape::Kind::kBar: {
      const double height = sample.stroke == Stroke::kPlanned ? 10.0 : 4.0;
      return fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"24\" height=\"{:.1f}\" class=\"{} bar-{}\"/>", x,
                         y - 0.5 * height, height, CssClass(sample.ink), CssClass(sample.stroke)) +
             words;
    }
    default:
      sample.points = {{0.5, 0.5}};
      break;
  }
  return Draw(sample, box) + words;
}

std::string SvgPlot::LegendEndingAt(double right_px, double y_px) const {
  std::string svg;
  double x = right_px - LegendWidth() + 10.0;
  for (const LegendEntry& entry : legend_) {
    svg += DrawEntry(entry, x, y_px);
    x += WidthOf(entry);
  }
  return svg;
}

std::string SvgPlot::Legend(const Frame& f) const {
  if (f.legend_lines == 0) return LegendEndingAt(f.right, kLegendLineHeight - 4.0);
  std::string svg;
  double x = f.left, y = f.top - kLegendLineHeight * f.legend_lines + 5.0;
  for (const LegendEntry& entry : legend_) {
    if (x + WidthOf(entry) > f.right + 1.0 && x > f.left) {
      x = f.left;
      y += kLegendLineHeight;
    }
    svg += DrawEntry(entry, x, y);
    x += WidthOf(entry);
  }
  return svg;
}

}  // namespace gaitwright
