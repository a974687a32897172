// SPDX-License-Identifier: BSD-3-Clause
#include "playback/report/plot_grid.h"

#include <fmt/format.h>

#include <algorithm>

#include "playback/report/svg_tools.h"

namespace gaitwright {
namespace {

/// The first line of a picture of that size.
std::string Head(double width_px, double height_px, const std::string& title) {
  return fmt::format(
      "<svg class=\"gw\" width=\"{0:.0f}\" height=\"{1:.0f}\" viewBox=\"0 0 {0:.0f} {1:.0f}\" "
      "role=\"img\"><title>{2}</title>\n",
      width_px, height_px, EscapedXml(title));
}

}  // namespace

std::string GridOfPlots(const std::vector<SvgPlot>& plots, int columns, const std::string& title) {
  if (plots.empty()) return "";
  const double width = plots[0].options().width_px, height = plots[0].options().height_px;
  const std::size_t wide = static_cast<std::size_t>(std::max(columns, 1));
  const std::size_t rows = (plots.size() + wide - 1) / wide;
  const double whole_width = width * static_cast<double>(std::min(wide, plots.size()));
  const double above = title.empty() ? 0.0 : 26.0;
  const double whole_height = above + height * static_cast<double>(rows);
  std::string svg = Head(whole_width, whole_height, title);
  if (!title.empty()) svg += "<text x=\"13\" y=\"15\" class=\"heading\">" + EscapedXml(title) + "</text>";
  svg += plots[0].LegendEndingAt(whole_width - 12.0, 11.0);
  for (std::size_t i = 0; i < plots.size(); ++i) {
    const std::size_t row = i / wide, column = i % wide;
    svg += plots[i].Svg({width * static_cast<double>(column), above + height * static_cast<double>(row)}) + "\n";
  }
  return svg + "</svg>";
}

std::string StackOfPlots(const std::vector<SvgPlot>& plots, const std::string& title) {
  double width_px = 0.0, height_px = 0.0;
  std::string stacked;
  for (const SvgPlot& plot : plots) {
    stacked += plot.Svg({0.0, height_px}) + "\n";
    width_px = std::max(width_px, plot.options().width_px);
    height_px += plot.height_px();
  }
  return Head(width_px, height_px, title) + stacked + "</svg>";
}

}  // namespace gaitwright
