// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <limits>

#include "kinematics/spatial/convex_hull.h"
#include "planning/plan/terrain_shapes.h"
#include "playback/report/plots.h"
#include "playback/report/svg_plot.h"

namespace gaitwright {
namespace {

/// Window of the ground to show: footholds, path of the body and goal.
Eigen::AlignedBox2d ShownWindow(const PlotData& data) {
  Eigen::AlignedBox2d window(Vector2(data.plan.goal.x_m, data.plan.goal.y_m));
  for (const Foothold& foothold : data.plan.footsteps.footholds)
    window.extend(Vector2(foothold.X_WF.translation().head<2>()));
  for (const MotionSample& sample : data.series.planned) window.extend(Vector2(sample.p_WC.head<2>()));
  const Vector2 room = Vector2::Constant(data.model.leg_length_m());
  return {window.min() - room, window.max() + room};
}

Polygon Within(const Eigen::AlignedBox2d& window, Polygon polygon) {
  const std::array<Vector2, 4> normals{Vector2::UnitX(), -Vector2::UnitX(), Vector2::UnitY(), -Vector2::UnitY()};
  const std::array<double, 4> least{window.min().x(), -window.max().x(), window.min().y(), -window.max().y()};
  for (std::size_t i = 0; i < normals.size(); ++i) polygon = Clipped(polygon, normals[i], least[i]);
  return polygon;
}

std::vector<Vector2> AlongX(const std::vector<MotionSample>& samples, std::size_t foot) {
  std::vector<Vector2> line;
  for (const MotionSample& s : samples) line.emplace_back(s.feet[foot].p_WF.x(), s.feet[foot].p_WF.z());
  return line;
}

/// Ground height below a path in plan view; NaN without ground.
std::vector<Vector2> GroundBelow(const Terrain& terrain, const std::vector<Vector2>& path) {
  std::vector<Vector2> profile;
  for (const Vector2& p : path) {
    const GroundPoint ground = GroundAt(terrain, p);
    profile.emplace_back(p.x(), ground.patch < 0 ? std::numeric_limits<double>::quiet_NaN() : ground.height_m);
  }
  return profile;
}

/// A straight line along x through the middle of the path, with one point per centimetre.
std::vector<Vector2> ForwardLine(const Eigen::AlignedBox2d& window) {
  constexpr double kStep = 0.01;
  std::vector<Vector2> line;
  for (double x = window.min().x(); x <= window.max().x(); x += kStep) line.emplace_back(x, window.center().y());
  return line;
}

}  // namespace

void DrawGround(const PlotData& data, SvgPlot& plot) {
  const Eigen::AlignedBox2d window = ShownWindow(data);
  for (const TerrainPatch& patch : data.plan.terrain.patches) {
    const Polygon outline = Within(window, PlanOutline(patch));
    if (outline.size() >= 3) plot.Area(outline, Ink::kMuted, false, "edges of the ground");
  }
  for (const Obstacle& obstacle : data.plan.terrain.obstacles) {
    std::vector<Vector2> corners;
    for (const Vector3& corner : CornersOf(obstacle)) corners.emplace_back(corner.head<2>());
    const Polygon outline = Within(window, ConvexHull(std::move(corners)));
    if (outline.size() >= 3) plot.Area(outline, Ink::kLimit, true, "obstacles");
  }
}

Plot SideView(const PlotData& data) {
  SvgPlot plot(SvgPlot::ToScale("From the side", "x [m]", "z [m]"));
  plot.Line(GroundBelow(data.plan.terrain, ForwardLine(ShownWindow(data))), Ink::kLimit, Stroke::kMeasured, "ground");
  for (std::size_t f = 0; f < data.model.feet.size(); ++f) {
    plot.Line(AlongX(data.series.planned, f), Ink::kFoot, Stroke::kPlanned, "feet planned");
    plot.Line(AlongX(data.series.measured, f), Ink::kFoot, Stroke::kMeasured, "feet measured");
  }
  std::vector<Vector2> planned, measured;
  for (const MotionSample& s : data.series.planned) planned.emplace_back(s.p_WC.x(), s.p_WC.z());
  for (const MotionSample& s : data.series.measured) measured.emplace_back(s.p_WC.x(), s.p_WC.z());
  plot.Line(planned, Ink::kCom, Stroke::kPlanned, "CoM planned");
  plot.Line(measured, Ink::kCom, Stroke::kMeasured, "CoM measured");
  return {"side_view",
          "Side view, in metres and to scale: contact points of the feet and the centre of mass above the ground along "
          "the middle of the path.",
          plot.Svg()};
}

}  // namespace gaitwright
