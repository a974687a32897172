// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/render/robot_drawing.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "kinematics/dynamics/foot_contact.h"
#include "kinematics/stability/polygon.h"
#include "playback/report/svg_tools.h"
#include "workflows/render/drawing_tables_internal.h"
#include "workflows/render/drawn_view_internal.h"

namespace gaitwright {
namespace {

constexpr double kSheetWide = 1280.0;              // [px]
constexpr double kEdge = 20.0, kTitleHigh = 62.0;  // margin around the sheet; space above the views [px]
constexpr double kAround = 52.0,
                 kViewTitle = 24.0;                      // margin for arrows and numbers; space above a view [px]
constexpr double kAxisRoom = 40.0;                       // space left of and below a view for its axes [px]
constexpr double kHighest = 560.0, kHighestLow = 400.0;  // height of a view in one row, and in one of two rows [px]

constexpr char kDrawingStyle[] =
    "text{font:12px 'DejaVu Sans',Verdana,sans-serif;fill:#222}.t{font-size:18px;font-weight:bold}.h{font-weight:bold}"
    ".v{font-size:13px;font-weight:bold}.m{text-anchor:middle}.e{text-anchor:end}.small{font-size:11px;fill:#555}"
    ".frame{fill:#fff;stroke:#c8ccd1}.grid{stroke:#e6e9ec}.tick{stroke:#888}.ground{stroke:#5b4a2a;stroke-width:2}"
    ".solid{fill:#b8c4d0;fill-opacity:.45;stroke:#7d8c9b;stroke-width:.8}.bone{stroke:#44505c;stroke-width:1.2;"
    "stroke-opacity:.7}.support{fill:#2a9d5c;fill-opacity:.13;stroke:#2a9d5c;stroke-dasharray:4 3}"
    ".sole{fill:#f08c00;fill-opacity:.4;stroke:#b35c00;stroke-width:1.5}.corner{fill:#b35c00;stroke:#fff;"
    "stroke-width:.6}.rest{opacity:.5}.mass{fill:#fff;stroke:#000;stroke-width:1.5}.quarter{fill:#000}"
    ".plumb{stroke:#000;stroke-dasharray:5 3}.foot-of-plumb{stroke:#000;stroke-width:2}"
    ".line{stroke-width:2.4;fill:none}.dash{stroke-dasharray:4 3}.ring{fill:#fff;stroke-width:2}.lead{stroke-width:.7}"
    ".halo{fill:#222;paint-order:stroke;stroke:#fff;stroke-width:3px}.number{font-size:12px;font-weight:bold;text-"
    "anchor:middle;paint-order:stroke;stroke:#fff;stroke-width:3px}"
    ".number-of-table{font-weight:bold;text-anchor:end}.axis{font-weight:bold}"
    "line.jx,circle.jx.ring,path.jx{stroke:#c8281e}.jx.full,text.jx{fill:#c8281e}"
    "line.jy,circle.jy.ring,path.jy{stroke:#117a37}.jy.full,text.jy{fill:#117a37}"
    "line.jz,circle.jz.ring,path.jz{stroke:#1f55c4}.jz.full,text.jz{fill:#1f55c4}"
    "line.jo,circle.jo.ring,path.jo{stroke:#8a2fa8}.jo.full,text.jo{fill:#8a2fa8}";

/// Data that all views draw.
struct DrawnRobot {
  const RobotModel& model;
  const DynamicsScratch& scratch;
  std::vector<DrawnSolid> solids;
  Vector3 p_WC;
};

enum ViewIndex { kSide, kFront, kCorner, kAbove };

std::array<DrawnView, 4> ViewsOf(const DrawnRobot& robot) {
  constexpr double kTurned = -0.6,
                   kRaised = 0.35;  // corner view: angle about z, elevation [rad]
  std::array<DrawnView, 4> views;
  views[kSide] = {"from its right side", Vector3::UnitX(), Vector3::UnitZ(), -Vector3::UnitY(), "x [m]", "z [m]"};
  views[kFront] = {"from its front", Vector3::UnitY(), Vector3::UnitZ(), Vector3::UnitX(), "y [m]", "z [m]"};
  DrawnView& corner = views[kCorner];
  corner.title = "from its front right corner";
  corner.toward_W =
      Vector3(std::cos(kRaised) * std::cos(kTurned), std::cos(kRaised) * std::sin(kTurned), std::sin(kRaised));
  corner.right_W = Vector3::UnitZ().cross(corner.toward_W).normalized();
  corner.up_W = corner.toward_W.cross(corner.right_W);
  views[kAbove] = {"feet from above", Vector3::UnitX(), Vector3::UnitY(), Vector3::UnitZ(), "x [m]", "y [m]"};
  const auto extend = [](DrawnView& view, const Vector3& p_W, double radius) {
    const Vector2 p = view.InPlane(p_W), around = Vector2::Constant(radius);
    view.extent_D.extend(Vector2(p - around));
    view.extent_D.extend(Vector2(p + around));
  };
  for (std::size_t i = 0; i < views.size(); ++i) {
    DrawnView& view = views[i];
    for (std::size_t f = 0; f < robot.model.feet.size(); ++f) {
      const Foot& foot = robot.model.feet[f];
      extend(view, FramePose(robot.scratch, foot.body, foot.X_BF).translation(), foot.radius);
      for (const Vector3& p : ContactPoints(robot.model, robot.scratch, static_cast<int>(f))) extend(view, p, 0.0);
    }
    extend(view, Vector3(robot.p_WC.x(), robot.p_WC.y(), 0.0), 0.0);
    if (i == kAbove) continue;
    extend(view, robot.p_WC, 0.0);
    for (std::size_t b = 0; b < robot.model.bodies.size(); ++b) extend(view, robot.scratch.p_WB[b], 0.0);
    for (const DrawnSolid& solid : robot.solids) {
      for (const Vector3& p : solid.points_W) extend(view, p, solid.radius);
    }
  }
  return views;
}

/// Scale at which views fit side by side into a row [px/m].
double ScaleOf(const std::vector<const DrawnView*>& row, double highest_px) {
  double wide = 0.0, high = 0.0, room = kSheetWide - 2.0 * kEdge;
  for (const DrawnView* view : row) {
    wide += view->extent_D.sizes().x();
    high = std::max(high, view->extent_D.sizes().y());
    room -= 2.0 * kAround + kAxisRoom;
  }
  return std::min(room / std::max(wide, 1e-3), highest_px / std::max(high, 1e-3));
}

/// Gives each view of a row its scale and its part of the sheet. @return the height of the row [px].
double PlaceRow(const std::vector<DrawnView*>& row, double left_px, double width_px, double top_px, double px_per_m) {
  double high = 0.0, used = 0.0;
  for (DrawnView* view : row) {
    view->px_per_m = px_per_m;
    high = std::max(high, px_per_m * view->extent_D.sizes().y());
    used += px_per_m * view->extent_D.sizes().x() + 2.0 * kAround + kAxisRoom;
  }
  high += 2.0 * kAround + kAxisRoom + kViewTitle;
  const double extra_px = (width_px - used) / static_cast<double>(row.size());
  double x = left_px;
  for (DrawnView* view : row) {
    const Vector2 size_px = px_per_m * view->extent_D.sizes();
    const double wide = size_px.x() + 2.0 * kAround + kAxisRoom + extra_px;
    view->frame_px = {Vector2(x + kAxisRoom, top_px + kViewTitle), Vector2(x + wide, top_px + high - kAxisRoom)};
    const Vector2 middle_px = view->frame_px.center(), middle_D = view->extent_D.center();
    view->zero_px = middle_px - px_per_m * Vector2(middle_D.x(), -middle_D.y());
    x += wide;
  }
  return high;
}

/// Lines and numbers of a view's axes; for a view that is not along an axis, a scale bar.
std::string AxesOf(const DrawnView& view) {
  constexpr double kTickEvery = 60.0;  // [px]
  const Vector2 low = view.frame_px.min(), high = view.frame_px.max(), size = view.frame_px.sizes();
  std::string svg = SvgText(low.x(), low.y() - 8.0, "v", view.title);
  svg += fmt::format("<rect class=\"frame\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\"/>", low.x(),
                     low.y(), size.x(), size.y());
  const Vector2 least = (low - view.zero_px) / view.px_per_m, most = (high - view.zero_px) / view.px_per_m;
  const std::vector<double> across = RoundTicks(least.x(), most.x(), static_cast<int>(size.x() / kTickEvery));
  if (view.right_label.empty()) {
    const double metres = across.size() < 2 ? 0.1 : across[1] - across[0];
    const Vector2 a(low.x() + 12.0, high.y() - 12.0), b = a + Vector2(metres * view.px_per_m, 0.0);
    return svg + SvgSegment(a, b, "ground") + SvgText(a.x(), a.y() - 7.0, "small", fmt::format("{:.3g} m", metres));
  }
  for (const double tick : across) {
    const double x = view.zero_px.x() + view.px_per_m * tick;
    svg += SvgSegment({x, low.y()}, {x, high.y()}, "grid") + SvgSegment({x, high.y()}, {x, high.y() + 4.0}, "tick");
    svg += SvgText(x, high.y() + 16.0, "m small", fmt::format("{:.4g}", tick + 0.0));
  }
  svg += SvgText(0.5 * (low.x() + high.x()), high.y() + 31.0, "m small", view.right_label);
  for (const double tick : RoundTicks(-most.y(), -least.y(), static_cast<int>(size.y() / kTickEvery))) {
    const double y = view.zero_px.y() - view.px_per_m * tick;
    svg += SvgSegment({low.x(), y}, {high.x(), y}, "grid") + SvgSegment({low.x() - 4.0, y}, {low.x(), y}, "tick");
    if (y < low.y() + 14.0) continue;  // space for the name of the axis
    svg += SvgText(low.x() - 6.0, y + 4.0, "e small", fmt::format("{:.4g}", tick + 0.0));
  }
  svg += SvgText(low.x() - 6.0, low.y() + 10.0, "e small", view.up_label);
  if (view.up_W.z() > 0.5) svg += SvgSegment({low.x(), view.zero_px.y()}, {high.x(), view.zero_px.y()}, "ground");
  return svg;
}

std::string NamesOfFeet(const DrawnView& view, const DrawnRobot& robot) {
  std::string svg;
  for (const Foot& foot : robot.model.feet) {
    const Vector2 at = view.ToPx(FramePose(robot.scratch, foot.body, foot.X_BF).translation());
    svg += SvgText(at.x(), at.y() - (foot.has_sole() ? 8.0 : view.px_per_m * foot.radius + 8.0), "m small halo",
                   foot.name);
  }
  return svg;
}

std::string ViewSvg(const DrawnView& view, const DrawnRobot& robot, bool with_body) {
  std::string svg = AxesOf(view);
  if (with_body) svg += DrawnBody(view, robot.model, robot.scratch, robot.solids);
  svg += DrawnFeet(view, robot.model, robot.scratch);
  if (!with_body) svg += NamesOfFeet(view, robot);
  if (with_body) svg += DrawnJoints(view, robot.model, robot.scratch);
  return svg;
}

/// A length rounded to 1 mm, without "-0" [m].
double RoundedToMm(double metres) { return std::round(1e3 * metres) / 1e3 + 0.0; }

/// Data of the robot, and the position of its centre of mass relative to its feet.
std::string StandsText(const DrawnRobot& robot) {
  std::vector<Vector2> points;
  for (std::size_t i = 0; i < robot.model.legs.size(); ++i) {
    for (const Vector3& p : ContactPoints(robot.model, robot.scratch, static_cast<int>(i)))
      points.emplace_back(p.head<2>());
  }
  const Polygon support = ConvexHull(points);
  std::string text = fmt::format(
      "{:.2f} kg, {} driven joints, {} feet; centre of mass at x {:.3f}, y {:.3f}, z {:.3f} m above the ground",
      robot.model.total_mass_kg, robot.model.num_dofs(), robot.model.legs.size(), RoundedToMm(robot.p_WC.x()),
      RoundedToMm(robot.p_WC.y()), robot.p_WC.z());
  if (support.size() < 3)
    return text + "; its feet touch the ground in " + (support.size() == 2 ? "a line" : "a point");
  const double inside = SignedDistance(support, robot.p_WC.head<2>());
  return text + fmt::format(", {:.0f} mm {} the edge of its support", 1e3 * std::abs(inside),
                            inside > 0.0 ? "inside" : "from");
}

}  // namespace

SvgDrawing RobotDrawing(const RobotModel& model, const std::string& mesh_folder) {
  DynamicsScratch scratch(model);
  ForwardKinematics(model, StandingConfiguration(model), scratch);
  const DrawnRobot robot{model, scratch, SolidsOf(model, scratch, mesh_folder), CentreOfMass(model, scratch)};
  std::array<DrawnView, 4> views = ViewsOf(robot);
  auto& [side, front, corner, above] = views;
  const double width = kSheetWide - 2.0 * kEdge;
  const double in_one_row = ScaleOf({&side, &front, &corner}, kHighest);
  const double in_two_rows = std::min(ScaleOf({&side, &front}, kHighestLow), ScaleOf({&corner, &above}, kHighestLow));
  double y = kTitleHigh;
  DrawnTable tables;
  if (in_two_rows > 1.2 * in_one_row) {
    y += PlaceRow({&side, &front}, kEdge, width, y, in_two_rows);
    y += PlaceRow({&corner, &above}, kEdge, width, y, in_two_rows);
    tables = DrawnTables(model, scratch, {kEdge + kAxisRoom, y}, width - kAxisRoom);
    y += tables.height_px;
  } else {
    constexpr double kFeetWide = 0.4;  // share of the sheet
    y += PlaceRow({&side, &front, &corner}, kEdge, width, y, in_one_row);
    const double scale = std::min((kFeetWide * width - 2.0 * kAround - kAxisRoom) / above.extent_D.sizes().x(),
                                  kHighestLow / above.extent_D.sizes().y());
    const double feet_high = PlaceRow({&above}, kEdge, kFeetWide * width, y, scale);
    tables = DrawnTables(model, scratch, {kEdge + (kFeetWide + 0.02) * width, y + kViewTitle - 4.0},
                         (0.98 - kFeetWide) * width);
    y += std::max(feet_high, tables.height_px + kViewTitle);
  }
  const double height = std::ceil(y + kEdge);
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" viewBox=\"0 0 {0:.0f} {1:.0f}\">"
      "<style>{2}</style><rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>",
      kSheetWide, height, kDrawingStyle);
  svg += SvgText(kEdge, 28.0, "t", model.name) + SvgText(kEdge, 48.0, "", StandsText(robot));
  for (std::size_t i = 0; i < views.size(); ++i) svg += ViewSvg(views[i], robot, i != kAbove);
  return {svg + tables.svg + "</svg>", static_cast<int>(kSheetWide), static_cast<int>(height)};
}

}  // namespace gaitwright
