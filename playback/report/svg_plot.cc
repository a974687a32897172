// SPDX-License-Identifier: BSD-3-Clause
#include "playback/report/svg_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "kinematics/base/result.h"
#include "playback/report/svg_tools.h"

namespace gaitwright {
namespace {

constexpr double kTolerance = 0.3;                           // of simplified lines [px]
constexpr double kCharacter = 6.0;                           // width of one at the size of the labels [px]
constexpr double kLineHeight = 17.0;                         // [px]
constexpr double kLeastHeight = 130.0, kMostHeight = 620.0;  // of equal axes [px]

std::string TickText(double value, double step) {
  const int decimals = std::clamp(static_cast<int>(std::ceil(-std::log10(step) - 1e-9)), 0, 6);
  const std::string text = fmt::format("{:.{}f}", std::abs(value) < 1e-9 * step ? 0.0 : value, decimals);
  return text.front() == '-' ? "\u2212" + text.substr(1) : text;
}

int YTickCount(double height_px) { return std::max(3, static_cast<int>(height_px / 38.0) + 1); }

std::string PathOf(const std::vector<Vector2>& pixels) {
  std::string path;
  for (const Vector2& p : pixels) path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L", p.x(), p.y());
  return path;
}

std::vector<std::string> TickTexts(const std::vector<double>& ticks) {
  std::vector<std::string> texts;
  for (const double tick : ticks) texts.push_back(TickText(tick, ticks.size() > 1 ? ticks[1] - ticks[0] : 1.0));
  return texts;
}

double WidestOf(const std::vector<std::string>& texts) {
  std::size_t widest = 1;
  for (const std::string& text : texts) widest = std::max(widest, text.size());
  return kCharacter * static_cast<double>(widest);
}

/// Widens a range: by a fixed amount if all data are equal up to rounding, otherwise by a share of the range.
void Widen(double& lowest, double& highest, double share) {
  if (!(lowest <= highest)) lowest = 0.0, highest = 1.0;
  const double span = highest - lowest;
  const double size = std::max(std::abs(lowest), std::abs(highest));
  const double room = span > 1e-9 * std::max(size, 1.0) ? share * span : std::max(0.02 * size, 1e-3);
  lowest -= room;
  highest += room;
}

/// Whether `length` finite points follow each other.
bool HasRun(const std::vector<Vector2>& points, int length) {
  int run = 0;
  return std::any_of(points.begin(), points.end(),
                     [&](const Vector2& p) { return (run = p.allFinite() ? run + 1 : 0) >= length; });
}

}  // namespace

Vector2 SvgPlot::Frame::Pixel(const Vector2& p) const {
  const Vector2 s = (p - lowest).cwiseQuotient(highest - lowest);
  return {left + s.x() * (right - left), bottom - s.y() * (bottom - top)};
}

SvgPlot::Options SvgPlot::ToScale(const std::string& title, const std::string& x_label, const std::string& y_label) {
  Options options;
  options.title = title;
  options.x_label = x_label;
  options.y_label = y_label;
  options.equal_axes = true;
  options.most_points = 2000;
  return options;
}

SvgPlot::SvgPlot(Options options)
    : options_(std::move(options)),
      lowest_(Vector2::Constant(std::numeric_limits<double>::infinity())),
      highest_(Vector2::Constant(-std::numeric_limits<double>::infinity())) {}

void SvgPlot::See(const Vector2& point) {
  if (!point.allFinite()) return;
  lowest_ = lowest_.cwiseMin(point);
  highest_ = highest_.cwiseMax(point);
}

void SvgPlot::Add(Shape shape, const std::string& label, bool in_scale) {
  if (in_scale) {
    for (const Vector2& point : shape.points) See(point);
  }
  const bool known =
      std::any_of(legend_.begin(), legend_.end(), [&](const LegendEntry& e) { return e.label == label; });
  if (!label.empty() && !known && HasRun(shape.points, shape.kind == Shape::Kind::kLine ? 2 : 1)) {
    legend_.push_back({label, shape});
    legend_.back().shape.points.clear();
  }
  shapes_.push_back(std::move(shape));
}

void SvgPlot::Line(const std::vector<Vector2>& points, Ink ink, Stroke stroke, const std::string& label) {
  Add({Shape::Kind::kLine, points, ink, stroke, false, 0.0, ""}, label, true);
}

void SvgPlot::Band(const std::vector<double>& x, const std::vector<double>& lower, const std::vector<double>& upper,
                   Ink ink, const std::string& label) {
  if (x.size() != lower.size() || x.size() != upper.size()) {
    throw InvalidArgument(
        fmt::format("SvgPlot::Band: {} values of x, but {} and {} of the bounds; equal numbers are needed", x.size(),
                    lower.size(), upper.size()));
  }
  std::vector<Vector2> there, back;
  const auto flush = [&] {
    there.insert(there.end(), back.rbegin(), back.rend());
    if (there.size() > 2) Add({Shape::Kind::kArea, there, ink, Stroke::kThin, true, 0.0, "band"}, label, true);
    there.clear();
    back.clear();
  };
  for (std::size_t k = 0; k < x.size(); ++k) {
    if (std::isfinite(lower[k]) && std::isfinite(upper[k])) {
      there.emplace_back(x[k], lower[k]);
      back.emplace_back(x[k], upper[k]);
    } else {
      flush();
    }
  }
  flush();
}

void SvgPlot::Area(const std::vector<Vector2>& corners, Ink ink, bool filled, const std::string& label) {
  if (corners.size() == 1) {
    Dot(corners[0], ink, 2.0, label);
  } else {
    Add({Shape::Kind::kArea, corners, ink, Stroke::kThin, filled, 0.0, ""}, label, true);
  }
}

void SvgPlot::Bar(int row, double x0, double x1, Ink ink, Stroke stroke, const std::string& label) {
  const double y = static_cast<double>(row);
  Add({Shape::Kind::kBar, {{x0, y}, {x1, y}}, ink, stroke, true, 0.0, ""}, label, true);
}

void SvgPlot::Dot(const Vector2& at, Ink ink, double radius_px, const std::string& label) {
  Add({Shape::Kind::kDot, {at}, ink, Stroke::kMeasured, true, radius_px, ""}, label, true);
}

void SvgPlot::Cross(const Vector2& at, Ink ink, const std::string& label) {
  Add({Shape::Kind::kCross, {at}, ink, Stroke::kMeasured, false, 4.0, ""}, label, true);
}

void SvgPlot::AcrossX(double y, Ink ink, const std::string& words, bool in_scale) {
  if (in_scale && std::isfinite(y)) {
    lowest_.y() = std::min(lowest_.y(), y);
    highest_.y() = std::max(highest_.y(), y);
  }
  Add({Shape::Kind::kAcrossX, {{0.0, y}}, ink, Stroke::kDashed, false, 0.0, words}, "", false);
}

void SvgPlot::AcrossY(double x, Ink ink, const std::string& words) {
  Add({Shape::Kind::kAcrossY, {{x, 0.0}}, ink, Stroke::kDashed, false, 0.0, words}, "", false);
}

SvgPlot::Frame SvgPlot::MakeFrame() const {
  Frame frame{options_.width_px, options_.height_px, 0, 0, 0, 0, lowest_, highest_, 0};
  const double missing = options_.y_least_span - (frame.highest.y() - frame.lowest.y());
  if (missing > 0.0 && std::isfinite(missing)) frame.lowest.y() -= 0.5 * missing, frame.highest.y() += 0.5 * missing;
  Widen(frame.lowest.x(), frame.highest.x(), options_.equal_axes ? 0.03 : 0.0);
  Widen(frame.lowest.y(), frame.highest.y(), options_.equal_axes ? 0.12 : 0.06);
  frame.lowest = {options_.x_lowest.value_or(frame.lowest.x()), options_.y_lowest.value_or(frame.lowest.y())};
  frame.highest = {options_.x_highest.value_or(frame.highest.x()), options_.y_highest.value_or(frame.highest.y())};
  if (!options_.rows.empty()) {
    frame.lowest.y() = static_cast<double>(options_.rows.size()) - 0.4;  // downward
    frame.highest.y() = -0.6;
  }
  const double title = options_.title.empty() ? 0.0 : kLineHeight + 3.0;
  const double below = 6.0 + kLineHeight + (options_.x_label.empty() && !options_.x_label_room ? 0.0 : kLineHeight);
  frame.bottom = frame.height - below;
  const auto ticks = TickTexts(RoundTicks(frame.lowest.y(), frame.highest.y(), YTickCount(frame.bottom - title - 6.0)));
  frame.left = 14.0 + std::max(30.0, WidestOf(options_.rows.empty() ? ticks : options_.rows)) +
               (options_.y_label.empty() ? 0.0 : kLineHeight);
  frame.right = frame.width - 12.0;
  frame.legend_lines = LegendLines(frame.right - frame.left);
  frame.top = 6.0 + title + kLineHeight * frame.legend_lines;
  if (!options_.equal_axes) return frame;
  const Vector2 span = frame.highest - frame.lowest;
  const double wanted = (frame.right - frame.left) * span.y() / span.x();
  const double inner = std::clamp(wanted, kLeastHeight, kMostHeight);
  frame.bottom = frame.top + inner;
  frame.height = frame.bottom + below;
  if (wanted < inner) {  // too flat: more room above and below
    const double extra = 0.5 * (span.y() * inner / wanted - span.y());
    frame.lowest.y() -= extra;
    frame.highest.y() += extra;
  } else if (wanted > inner) {  // too tall: more room left and right
    const double extra = 0.5 * (span.x() * wanted / inner - span.x());
    frame.lowest.x() -= extra;
    frame.highest.x() += extra;
  }
  return frame;
}

std::string SvgPlot::Axes(const Frame& f) const {
  std::string svg = fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" class=\"frame\"/>",
                                f.left, f.top, f.right - f.left, f.bottom - f.top);
  const int x_count = static_cast<int>((f.right - f.left) / 85.0) + 1;
  const auto x_ticks = RoundTicks(f.lowest.x(), f.highest.x(), x_count);
  const auto x_texts = TickTexts(x_ticks);
  for (std::size_t i = 0; i < x_ticks.size(); ++i) {
    const double x = f.Pixel({x_ticks[i], 0.0}).x();
    svg += SvgSegment({x, f.top}, {x, f.bottom}, "grid") + SvgText(x, f.bottom + 15.0, "tick mid", x_texts[i]);
  }
  const auto y_ticks = RoundTicks(f.lowest.y(), f.highest.y(), YTickCount(f.bottom - f.top));
  const auto y_texts = TickTexts(y_ticks);
  for (std::size_t i = 0; i < y_ticks.size() && options_.rows.empty(); ++i) {
    const double y = f.Pixel({0.0, y_ticks[i]}).y();
    svg += SvgSegment({f.left, y}, {f.right, y}, "grid") + SvgText(f.left - 6.0, y + 4.0, "tick end", y_texts[i]);
  }
  for (std::size_t i = 0; i < options_.rows.size(); ++i) {
    const double y = f.Pixel({0.0, static_cast<double>(i)}).y();
    svg += SvgText(f.left - 6.0, y + 4.0, "tick end", options_.rows[i]);
  }
  if (!options_.title.empty()) svg += SvgText(f.left, kLineHeight, "title", options_.title);
  if (!options_.x_label.empty()) {
    svg += SvgText(0.5 * (f.left + f.right), f.bottom + 16.0 + kLineHeight, "label mid", options_.x_label);
  }
  if (!options_.y_label.empty()) {
    const double y = 0.5 * (f.top + f.bottom);
    svg +=
        fmt::format("<text x=\"13\" y=\"{0:.1f}\" transform=\"rotate(-90 13 {0:.1f})\" class=\"label mid\">{1}</text>",
                    y, EscapedXml(options_.y_label));
  }
  return svg;
}

std::string SvgPlot::DrawAcross(const Shape& shape, const Frame& f) const {
  const Vector2 at = f.Pixel(shape.points[0]);
  const bool along_x = shape.kind == Shape::Kind::kAcrossX;
  const bool inside = along_x ? at.y() >= f.top && at.y() <= f.bottom : at.x() >= f.left && at.x() <= f.right;
  if (!inside) return "";
  const std::string css = fmt::format("{} dashed", CssClass(shape.ink));
  if (along_x) {
    const double above = at.y() - f.top > 16.0 ? at.y() - 4.0 : at.y() + 13.0;
    return SvgSegment({f.left, at.y()}, {f.right, at.y()}, css) +
           SvgText(f.right - 5.0, above, "note end", shape.words);
  }
  const bool at_right = at.x() > 0.5 * (f.left + f.right);
  return SvgSegment({at.x(), f.top}, {at.x(), f.bottom}, css) +
         SvgText(at.x() + (at_right ? -5.0 : 5.0), f.top + 13.0, at_right ? "note end" : "note", shape.words);
}

std::string SvgPlot::Draw(const Shape& shape, const Frame& f) const {
  using Kind = Shape::Kind;
  if (shape.kind == Kind::kAcrossX || shape.kind == Kind::kAcrossY) return DrawAcross(shape, f);
  const char* ink = CssClass(shape.ink);
  std::vector<Vector2> pixels;
  std::string path;
  const auto flush = [&] {
    if (pixels.size() > 1) path += PathOf(Simplified(pixels, kTolerance, options_.most_points));
    pixels.clear();
  };
  for (const Vector2& p : shape.points) {
    if (p.allFinite()) {
      pixels.push_back(f.Pixel(p));
    } else if (shape.kind == Kind::kLine) {
      flush();
    }
  }
  if (shape.kind == Kind::kLine) {
    flush();
    return path.empty() ? "" : fmt::format("<path d=\"{}\" class=\"{} {}\"/>", path, ink, CssClass(shape.stroke));
  }
  if (pixels.empty()) return "";
  const Vector2& at = pixels[0];
  if (shape.kind == Kind::kDot) {
    return fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\" class=\"{} dot\"/>", at.x(), at.y(),
                       shape.radius_px, ink);
  }
  if (shape.kind == Kind::kCross) {
    const double r = shape.radius_px;
    const std::string css = fmt::format("{} heavy", ink);
    return SvgSegment({at.x() - r, at.y() - r}, {at.x() + r, at.y() + r}, css) +
           SvgSegment({at.x() - r, at.y() + r}, {at.x() + r, at.y() - r}, css);
  }
  if (shape.kind == Kind::kBar) {
    const double tall = 0.5 * (f.bottom - f.top) / static_cast<double>(std::max<std::size_t>(options_.rows.size(), 1));
    const double height = shape.stroke == Stroke::kPlanned ? 1.5 * tall : 0.6 * tall;
    return fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" class=\"{} bar-{}\"/>",
                       at.x(), at.y() - 0.5 * height, std::max(pixels[1].x() - at.x(), 0.5), height, ink,
                       CssClass(shape.stroke));
  }
  const auto outline = Simplified(pixels, kTolerance, 2 * options_.most_points);
  const char* css = shape.words == "band" ? "band" : (shape.filled ? "filled" : "outline");
  return fmt::format("<path d=\"{}Z\" class=\"{} {}\"/>", PathOf(outline), ink, css);
}

/// Whether a mark at the edge of the axes is drawn whole: if its middle is within. Lines across end at the axes.
bool SvgPlot::IsUncut(const Shape& shape, const Frame& f) {
  using Kind = Shape::Kind;
  if (shape.kind == Kind::kAcrossX || shape.kind == Kind::kAcrossY) return true;
  if (shape.kind != Kind::kDot && shape.kind != Kind::kCross) return false;
  constexpr double kRounding = 0.05, kInk = 1.0;  // [px]
  const Vector2 at = f.Pixel(shape.points[0]);
  const double inside = std::min({at.x() - f.left, f.right - at.x(), at.y() - f.top, f.bottom - at.y()});
  return inside >= -kRounding && inside <= shape.radius_px + kInk;
}

std::string SvgPlot::Svg(const Vector2& at) const {
  const Frame frame = MakeFrame();
  std::string body, over;
  for (const Shape& shape : shapes_) (IsUncut(shape, frame) ? over : body) += Draw(shape, frame) + "\n";
  const double w = frame.right - frame.left, h = frame.bottom - frame.top;
  std::string svg = fmt::format(
      "<svg class=\"gw\" x=\"{2:.0f}\" y=\"{3:.0f}\" width=\"{0:.0f}\" height=\"{1:.0f}\" viewBox=\"0 0 {0:.0f} "
      "{1:.0f}\" "
      "role=\"img\">",
      frame.width, frame.height, at.x(), at.y());
  svg += fmt::format("<title>{}</title>{}", EscapedXml(options_.title), Axes(frame));
  // A nested svg clips what is outside the axes; its viewBox keeps the same coordinates.
  svg += fmt::format(
      "<svg x=\"{0:.1f}\" y=\"{1:.1f}\" width=\"{2:.1f}\" height=\"{3:.1f}\" viewBox=\"{0:.1f} {1:.1f} {2:.1f} "
      "{3:.1f}\">{4}</svg>",
      frame.left, frame.top, w, h, body);
  return svg + over + (options_.legend ? Legend(frame) : "") + "</svg>";
}

}  // namespace gaitwright
