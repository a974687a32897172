// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <iterator>
#include <numbers>

#include "examples/standing_control.h"
#include "playback/report/plot_style.h"
#include "playback/report/svg_plot.h"

namespace gaitwright::examples {

std::string PushPicture(const std::vector<PushesTaken>& taken) {
  SvgPlot plot(SvgPlot::ToScale("Largest push withstood", "to the right [N]", "forward [N]"));
  constexpr Ink kInks[] = {Ink::kMuted, Ink::kLimit, Ink::kCom, Ink::kZmp, Ink::kDcm, Ink::kJoint, Ink::kFoot};
  std::size_t next = 0;
  for (const PushesTaken& way : taken) {
    std::vector<Vector2> border;
    for (std::size_t k = 0; k <= way.largest_n.size() && !way.largest_n.empty(); ++k) {
      const std::size_t at = k % way.largest_n.size();
      const double angle = way.directions_deg[at] * std::numbers::pi / 180.0;
      border.emplace_back(-way.largest_n[at] * std::sin(angle), way.largest_n[at] * std::cos(angle));
    }
    plot.Line(border, kInks[next++ % std::size(kInks)], Stroke::kMeasured, way.way);
  }
  return StandaloneSvg(plot.Svg());
}

}  // namespace gaitwright::examples
