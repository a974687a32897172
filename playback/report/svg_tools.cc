// SPDX-License-Identifier: BSD-3-Clause
#include "playback/report/svg_tools.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace gaitwright {
namespace {

double DistanceToSegment(const Vector2& p, const Vector2& a, const Vector2& b) {
  const Vector2 ab = b - a;
  const double length2 = ab.squaredNorm();
  const double t = length2 > 0.0 ? std::clamp((p - a).dot(ab) / length2, 0.0, 1.0) : 0.0;
  return (p - (a + t * ab)).norm();
}

/// The points that the Douglas-Peucker algorithm keeps.
std::vector<bool> Kept(const std::vector<Vector2>& points, double tolerance) {
  std::vector<bool> kept(points.size(), false);
  kept.front() = kept.back() = true;
  std::vector<std::pair<std::size_t, std::size_t>> spans = {{0, points.size() - 1}};
  while (!spans.empty()) {
    const auto [first, last] = spans.back();
    spans.pop_back();
    double farthest = tolerance;
    std::size_t at = 0;
    for (std::size_t i = first + 1; i < last; ++i) {
      const double distance = DistanceToSegment(points[i], points[first], points[last]);
      if (distance > farthest) farthest = distance, at = i;
    }
    if (at == 0) continue;
    kept[at] = true;
    spans.emplace_back(first, at);
    spans.emplace_back(at, last);
  }
  return kept;
}

}  // namespace

std::vector<double> RoundTicks(double lowest, double highest, int count) {
  if (!std::isfinite(lowest) || !std::isfinite(highest) || !(lowest < highest)) return {};
  const double raw = (highest - lowest) / std::max(count, 1);
  constexpr double kRounding = 1e-12;  // smaller steps are only rounding
  if (!(raw > kRounding * std::max({std::abs(lowest), std::abs(highest), 1e-200})) || !std::isfinite(raw)) return {};
  const double power = std::pow(10.0, std::floor(std::log10(raw)));
  const double lead = raw / power;
  const double step = power * (lead <= 1.0 ? 1.0 : lead <= 2.0 ? 2.0 : lead <= 5.0 ? 5.0 : 10.0);
  std::vector<double> ticks;
  const double first = std::ceil(lowest / step - 1e-9), last = std::floor(highest / step + 1e-9);
  for (double i = first; i <= last; i += 1.0) ticks.push_back(i * step);
  constexpr int kMostTicks = 64;
  return ticks.size() < 2 && count < kMostTicks ? RoundTicks(lowest, highest, 2 * std::max(count, 1)) : ticks;
}

std::vector<Vector2> Simplified(const std::vector<Vector2>& points, double tolerance, std::size_t most) {
  if (points.size() < 3) return points;
  std::vector<Vector2> subset;
  do {
    const std::vector<bool> kept = Kept(points, tolerance);
    subset.clear();
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (kept[i]) subset.push_back(points[i]);
    }
    tolerance *= 2.0;
  } while (subset.size() > std::max<std::size_t>(most, 2));
  return subset;
}

std::string SvgText(double x, double y, const std::string& css, const std::string& words) {
  if (words.empty()) return "";
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" class=\"{}\">{}</text>", x, y, css, EscapedXml(words));
}

std::string SvgSegment(const Vector2& a, const Vector2& b, const std::string& css) {
  return fmt::format("<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" class=\"{}\"/>", a.x(), a.y(),
                     b.x(), b.y(), css);
}

}  // namespace gaitwright
