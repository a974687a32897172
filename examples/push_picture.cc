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
  for (const PushesTaken& pushes : taken) {
    std::vector<Vector2> border;
    for (std::size_t k = 0; k <= pushes.largest_n.size() && !pushes.largest_n.empty(); ++k) {
      const std::size_t at = k % pushes.largest_n.size();
      const double angle = pushes.directions_deg[at] * std::numbers::pi / 180.0;
      border.emplace_back(-pushes.largest_n[at] * std::sin(angle), pushes.largest_n[at] * std::cos(angle));
    }
    plot.Line(border, kInks[next++ % std::size(kInks)], Stroke::kMeasured, pushes.strategy);
  }
  return StandaloneSvg(plot.Svg());
}

}  // namespace gaitwright::examples
