// SPDX-License-Identifier: BSD-3-Clause
#include "cli/terrain_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "kinematics/spatial/convex_hull.h"
#include "planning/plan/terrain_shapes.h"
#include "playback/report/svg_tools.h"

namespace gaitwright::cli {
namespace {

using PlanBox = Eigen::AlignedBox2d;

constexpr double kLeft = 60.0, kTop = 50.0;           // of the top view [px]
constexpr double kWidest = 1000.0, kHighest = 560.0;  // of the top view [px]
constexpr double kSection = 200.0, kBetween = 100.0;  // largest height of the section, and the gap above it [px]
constexpr double kCell = 4.0;                         // size of a cell of the shading [px]
constexpr int kShades = 32;
constexpr double kNear = 10.0;  // edges of wide ground farther off are not shown [m]

constexpr char kStyle[] =
    "text{font:12px sans-serif;fill:#222}.t{font-size:15px;font-weight:bold}.n{font-size:10px}.m{text-anchor:middle}"
    ".e{text-anchor:end}.o{fill:none;stroke:#5b4a2a;stroke-width:1}.w{fill:#38434f;stroke:#12181f;stroke-width:1}"
    ".b{fill:#38434f;fill-opacity:.25;stroke:#38434f}.r{fill:none;stroke:#0072b2;stroke-width:2;stroke-dasharray:5 3}"
    ".g{stroke:#d5b98a;fill:#ead7b4}.l{stroke:#5b4a2a;stroke-width:1.5;fill:none}.a{stroke:#888;stroke-width:1;fill:"
    "none}";

/// The window to show: small parts whole, the near edges of wide ground, and the robot, with a margin.
PlanBox ShownWindow(const Terrain& terrain, const TerrainScale& scale) {
  PlanBox window(Vector2(scale.front_m - scale.body_length_m, -0.5 * scale.body_width_m),
                 Vector2(scale.front_m, 0.5 * scale.body_width_m));
  for (const TerrainPatch& patch : terrain.patches) {
    const std::vector<Vector2> outline = PlanOutline(patch);
    PlanBox box;
    for (const Vector2& corner : outline) box.extend(corner);
    if (!box.isEmpty() && box.sizes().maxCoeff() <= kNear) window.extend(box);
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const Vector2 middle = 0.5 * (outline[i] + outline[(i + 1) % outline.size()]);
      if (middle.norm() < kNear) window.extend(middle);
    }
  }
  for (const HeightField& field : terrain.height_fields) {
    window.extend(field.origin_W);
    window.extend(Vector2(field.origin_W + field.resolution_m * Vector2(field.columns - 1, field.rows - 1)));
  }
  for (const Obstacle& obstacle : terrain.obstacles) {
    for (const Vector3& p : CornersOf(obstacle)) window.extend(Vector2(p.head<2>()));
  }
  const Vector2 room = Vector2::Constant(std::max(0.5 * scale.body_length_m, 0.04 * window.sizes().maxCoeff()));
  return {window.min() - room, window.max() + room};
}

/// Maps metres to pixels, and holds the range of heights.
struct PictureView {
  PlanBox window;
  double px_per_m = 1.0;
  double lowest = 0.0, highest = 0.0;

  double X(double x) const { return kLeft + px_per_m * (x - window.min().x()); }
  double Y(double y) const { return kTop + px_per_m * (window.max().y() - y); }
  double right() const { return X(window.max().x()); }
  double bottom() const { return Y(window.min().y()); }
};

std::string SvgPoints(const PictureView& view, const std::vector<Vector2>& outline) {
  std::string points;
  for (const Vector2& p : outline) points += fmt::format("{:.1f},{:.1f} ", view.X(p.x()), view.Y(p.y()));
  return points;
}

/// Low ground is light, high ground brown.
std::string Shade(int shade) {
  const double u = static_cast<double>(shade) / (kShades - 1);
  const auto mix = [&](double low, double high) { return static_cast<int>(std::lround(low + u * (high - low))); };
  return fmt::format("#{:02x}{:02x}{:02x}", mix(0xfb, 0xb0), mix(0xf7, 0x74), mix(0xec, 0x2c));
}

/// Number of the shade at a place; -1 where there is no ground.
int ShadeAt(const Terrain& terrain, const PictureView& view, const Vector2& p) {
  const GroundPoint ground = GroundAt(terrain, p);
  if (ground.patch < 0) return -1;
  const double span = view.highest - view.lowest;
  return span < 1e-9 ? 0 : static_cast<int>(std::lround((ground.height_m - view.lowest) / span * (kShades - 1)));
}

/// Runs of cells of one shade.
std::string Shading(const Terrain& terrain, const PictureView& view) {
  std::string svg = "<g shape-rendering=\"crispEdges\">";
  const int columns = static_cast<int>(std::ceil((view.right() - kLeft) / kCell));
  const int rows = static_cast<int>(std::ceil((view.bottom() - kTop) / kCell));
  const auto shade_of = [&](int column, int row) {
    const Vector2 by((column + 0.5) * kCell / view.px_per_m, -(row + 0.5) * kCell / view.px_per_m);
    return ShadeAt(terrain, view, Vector2(view.window.min().x(), view.window.max().y()) + by);
  };
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns;) {
      const int first = column, shade = shade_of(column, row);
      while (column < columns && shade_of(column, row) == shade) ++column;
      svg += fmt::format("<rect x=\"{:.0f}\" y=\"{:.0f}\" width=\"{:.0f}\" height=\"{:.0f}\" fill=\"{}\"/>",
                         kLeft + first * kCell, kTop + row * kCell, (column - first) * kCell, kCell,
                         shade < 0 ? "url(#none)" : Shade(shade));
    }
  }
  return svg + "</g>";
}

/// A name, if it has room (about 6 px per letter).
std::string NameLabel(const PictureView& view, const PlanBox& box, const std::string& name, const char* fill) {
  const double width = view.px_per_m * box.sizes().x(), height = view.px_per_m * box.sizes().y();
  if (width < 5.5 * static_cast<double>(name.size()) || height < 12.0) return "";
  return fmt::format("<text class=\"n m\" x=\"{:.1f}\" y=\"{:.1f}\" style=\"fill:{}\">{}</text>",
                     view.X(box.center().x()), view.Y(box.center().y()) + 4.0, fill, EscapedXml(name));
}

std::string OutlinesAndNames(const Terrain& terrain, const PictureView& view) {
  std::string svg;
  const auto add = [&](const std::vector<Vector2>& outline, const std::string& name, const char* css,
                       const char* fill) {
    PlanBox box;
    for (const Vector2& p : outline) box.extend(p);
    svg += fmt::format("<polygon class=\"{}\" points=\"{}\"/>", css, SvgPoints(view, outline));
    svg += NameLabel(view, box.intersection(view.window), name, fill);
  };
  for (const TerrainPatch& patch : terrain.patches) {
    if (!patch.outline_T.empty()) add(PlanOutline(patch), patch.name, "o", "#222");
  }
  for (const HeightField& field : terrain.height_fields) {
    const Vector2 a = field.origin_W, b = a + field.resolution_m * Vector2(field.columns - 1, field.rows - 1);
    add({a, {b.x(), a.y()}, b, {a.x(), b.y()}}, field.name, "o", "#222");
  }
  for (const Obstacle& obstacle : terrain.obstacles) {
    std::vector<Vector2> points;
    double clear = 1e9;  // height of the lowest point over the ground
    for (const Vector3& p : CornersOf(obstacle)) {
      points.emplace_back(p.head<2>());
      clear = std::min(clear, p.z() - GroundAt(terrain, p.head<2>()).height_m);
    }
    add(ConvexHull(points), obstacle.name, clear > 0.02 ? "b" : "w", "#fff");
  }
  return svg;
}

std::string PictureFrame(const PictureView& view, double top, double bottom) {
  std::string svg = fmt::format("<rect class=\"a\" x=\"{}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\"/>", kLeft,
                                top, view.right() - kLeft, bottom - top);
  for (const double x :
       RoundTicks(view.window.min().x(), view.window.max().x(), static_cast<int>((view.right() - kLeft) / 90.0))) {
    svg += SvgSegment({view.X(x), bottom}, {view.X(x), bottom + 5.0}, "a");
    svg += SvgText(view.X(x), bottom + 18.0, "m", fmt::format("{:.4g}", x + 0.0));
  }
  return svg + SvgText(0.5 * (kLeft + view.right()), bottom + 34.0, "m", "x [m]");
}

std::string SideTicks(const std::vector<double>& ticks, const std::function<double(double)>& to_px, const char* label) {
  std::string svg;
  for (const double tick : ticks) {
    svg += SvgSegment({kLeft - 5.0, to_px(tick)}, {kLeft, to_px(tick)}, "a");
    svg += SvgText(kLeft - 8.0, to_px(tick) + 4.0, "e", fmt::format("{:.4g}", tick + 0.0));
  }
  return svg + SvgText(kLeft - 8.0, to_px(ticks.empty() ? 0.0 : ticks.back()) - 12.0, "e", label);
}

std::string RobotOutline(const PictureView& view, const TerrainScale& scale) {
  const double back = scale.front_m - scale.body_length_m, half = 0.5 * scale.body_width_m;
  return fmt::format(
      "<polygon class=\"r\" points=\"{}\"/><polygon class=\"r\" points=\"{}\"/>",
      SvgPoints(view, {{back, -half}, {scale.front_m, -half}, {scale.front_m, half}, {back, half}}),
      SvgPoints(view, {{scale.front_m, -0.3 * half}, {scale.front_m, 0.3 * half}, {scale.front_m + 0.4 * half, 0.0}}));
}

/// The legend of the shades, to the right of the top view.
std::string ShadeLegend(const PictureView& view) {
  std::string svg;
  const double x = view.right() + 20.0, height = std::min(160.0, view.bottom() - kTop);
  for (int i = 0; i < kShades; ++i) {
    svg += fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"16\" height=\"{:.1f}\" fill=\"{}\"/>", x,
                       kTop + height * (kShades - 1 - i) / kShades, height / kShades + 0.5, Shade(i));
  }
  svg += SvgText(x + 22.0, kTop + 10.0, "", fmt::format("{:.3f} m", view.highest));
  return svg + SvgText(x + 22.0, kTop + height, "", fmt::format("{:.3f} m", view.lowest));
}

/// The range of heights that the section shows: from below the ground (by a tenth of the range) to above everything on
/// it.
struct SectionHeights {
  double low, high, px_per_m;

  double height_px() const { return px_per_m * (high - low); }
};

SectionHeights HeightsInSection(const Terrain& terrain, const TerrainScale& scale, const PictureView& view) {
  double low = std::min(view.lowest, 0.0), high = std::max(view.highest, 1.1 * scale.body_height_m);
  for (const Obstacle& obstacle : terrain.obstacles) {
    for (const Vector3& p : CornersOf(obstacle)) high = std::max(high, 1.02 * p.z());
  }
  low -= 0.1 * (high - low);
  return {low, high, std::min(view.px_per_m, kSection / (high - low))};
}

/// The section along x through the start.
std::string SectionPicture(const Terrain& terrain, const TerrainScale& scale, const PictureView& view, double top) {
  const auto [low, high, z_px_per_m] = HeightsInSection(terrain, scale, view);
  const double bottom = top + z_px_per_m * (high - low);
  const auto z_px = [base = bottom, scale_px = z_px_per_m, least = low](double z) {
    return base - scale_px * (z - least);
  };
  std::string svg;
  for (const Obstacle& obstacle : terrain.obstacles) {
    Eigen::AlignedBox3d box;
    for (const Vector3& p : CornersOf(obstacle)) box.extend(p);
    svg += fmt::format("<rect class=\"{}\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\"/>",
                       box.min().y() <= 0.0 && box.max().y() >= 0.0 ? "w" : "b", view.X(box.min().x()),
                       z_px(box.max().z()), view.px_per_m * box.sizes().x(), z_px_per_m * box.sizes().z());
  }
  std::string line;
  const auto close = [&] {
    if (!line.empty()) svg += "<polyline class=\"l\" points=\"" + line + "\"/>";
    line.clear();
  };
  for (double px = kLeft; px <= view.right(); px += 0.5) {
    const double x = view.window.min().x() + (px - kLeft) / view.px_per_m;
    const GroundPoint ground = GroundAt(terrain, {x, 0.0});
    if (ground.patch < 0) {
      close();
      continue;
    }
    svg += px == std::floor(px) ? SvgSegment({px, z_px(ground.height_m)}, {px, bottom}, "g") : "";
    line += fmt::format("{:.1f},{:.1f} ", px, z_px(ground.height_m));
  }
  close();
  const double back = scale.front_m - scale.body_length_m, floor = GroundAt(terrain, Vector2::Zero()).height_m;
  svg += fmt::format("<rect class=\"r\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\"/>", view.X(back),
                     z_px(floor + scale.body_height_m), view.px_per_m * scale.body_length_m,
                     z_px_per_m * scale.body_height_m);
  const double steeper = z_px_per_m / view.px_per_m;
  svg += SvgText(kLeft, top - 14.0, "",
                 steeper > 0.99 ? "section at y = 0, heights to scale"
                                : fmt::format("section at y = 0, heights times {:.2f}", steeper));
  return svg + PictureFrame(view, top, bottom) + SideTicks(RoundTicks(low, high, 4), z_px, "z [m]");
}

/// The view of a window, with the range of heights in it.
PictureView MakePictureView(const Terrain& terrain, const TerrainScale& scale) {
  PictureView view{ShownWindow(terrain, scale)};
  view.px_per_m = std::min(kWidest / view.window.sizes().x(), kHighest / view.window.sizes().y());
  bool first = true;
  const Vector2 step = view.window.sizes() / 300.0;
  for (int i = 0; i <= 300; ++i) {
    for (int j = 0; j <= 300; ++j) {
      const GroundPoint ground = GroundAt(terrain, view.window.min() + Vector2(i * step.x(), j * step.y()));
      if (ground.patch < 0) continue;
      view.lowest = first ? ground.height_m : std::min(view.lowest, ground.height_m);
      view.highest = first ? ground.height_m : std::max(view.highest, ground.height_m);
      first = false;
    }
  }
  return view;
}

}  // namespace

std::string TerrainPicture(const Terrain& terrain, const TerrainScale& scale) {
  const PictureView view = MakePictureView(terrain, scale);
  const double width = view.right() + 110.0, section = view.bottom() + kBetween;
  const double height = section + HeightsInSection(terrain, scale, view).height_px() + 50.0;
  std::string svg = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" "
      "height=\"{1:.0f}\" viewBox=\"0 0 {0:.0f} {1:.0f}\"><style>{2}</style><defs><pattern id=\"none\" width=\"6\" "
      "height=\"6\" patternUnits=\"userSpaceOnUse\"><path d=\"M0 6L6 0\" stroke=\"#bbb\"/></pattern><clipPath "
      "id=\"in\"><rect x=\"{3}\" y=\"{4}\" width=\"{5:.1f}\" height=\"{6:.1f}\"/></clipPath></defs><rect "
      "width=\"100%\" "
      "height=\"100%\" fill=\"#fff\"/>",
      width, height, kStyle, kLeft, kTop, view.right() - kLeft, view.bottom() - kTop);
  svg += SvgText(kLeft, 28.0, "t", terrain.name);
  svg += "<g clip-path=\"url(#in)\">" + Shading(terrain, view) + OutlinesAndNames(terrain, view) +
         RobotOutline(view, scale) + "</g>";
  const auto y_px = [&](double y) { return view.Y(y); };
  svg += PictureFrame(view, kTop, view.bottom());
  svg += SideTicks(RoundTicks(view.window.min().y(), view.window.max().y(), 6), y_px, "y [m]") + ShadeLegend(view);
  svg += SectionPicture(terrain, scale, view, section);
  return svg + "</svg>\n";
}

}  // namespace gaitwright::cli
