// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "playback/report/orbit_part_internal.h"
#include "playback/report/page_parts_internal.h"
#include "playback/report/svg_plot.h"

namespace gaitwright {
namespace {

Plot MultiplierPlot(const FloquetMultipliers& multipliers) {
  constexpr int kSides = 120;
  SvgPlot::Options options = SvgPlot::ToScale("Floquet multipliers", "real part", "imaginary part");
  options.width_px = 420.0;
  options.x_lowest = options.y_lowest = -1.2;
  options.x_highest = options.y_highest = std::max(1.2, 1.1 * multipliers.largest());
  SvgPlot plot(options);
  std::vector<Vector2> circle;
  for (int i = 0; i <= kSides; ++i) {
    const double angle = 2.0 * M_PI * i / kSides;
    circle.emplace_back(std::cos(angle), std::sin(angle));
  }
  plot.Line(circle, Ink::kLimit, Stroke::kThin, "unit circle");
  for (const std::complex<double>& value : multipliers.values)
    plot.Dot({value.real(), value.imag()}, Ink::kDcm, 4.0, "multiplier");
  return {"floquet_multipliers",
          "Eigenvalues of the map from the deviations of one cycle to those of the next. Deviations decay if all lie "
          "inside the unit circle.",
          plot.Svg()};
}

std::string MultiplierTable(const FloquetMultipliers& multipliers) {
  constexpr std::size_t kRows = 6;
  std::string html =
      "<div class=\"scroll\"><table><thead><tr><th class=\"n\">magnitude</th><th class=\"n\">real part</th><th "
      "class=\"n\">imaginary part</th></tr></thead><tbody>\n";
  for (std::size_t i = 0; i < std::min(kRows, multipliers.values.size()); ++i) {
    const std::complex<double>& value = multipliers.values[i];
    html += fmt::format("<tr><td class=\"n\">{:.3f}</td><td class=\"n\">{:.3f}</td><td class=\"n\">{:.3f}</td></tr>\n",
                        std::abs(value), value.real(), value.imag());
  }
  return html + "</tbody></table></div>\n";
}

}  // namespace

std::string OrbitPart(const OrbitStability& orbit) {
  std::string html = fmt::format("<h2>Orbit stability</h2>\n<p>{}</p>\n", SentencePart(OrbitText(orbit)));
  if (orbit.verdict() == OrbitVerdict::kUnknown) return html;
  html += "<div class=\"narrow\">" + FigurePart(MultiplierPlot(orbit.multipliers)) +
          MultiplierTable(orbit.multipliers) + "</div>\n";
  html += fmt::format(
      "<p class=\"soft\">From {} playbacks, each with a push of {:.3g} N s in one of three directions and at one of "
      "four "
      "phases of a steady cycle.</p>\n",
      orbit.playbacks, orbit.impulse_n_s);
  return html;
}

}  // namespace gaitwright
