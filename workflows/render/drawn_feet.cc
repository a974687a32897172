// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>

#include "kinematics/dynamics/foot_contact.h"
#include "kinematics/spatial/convex_hull.h"
#include "playback/report/svg_tools.h"
#include "workflows/render/drawn_view_internal.h"

namespace gaitwright {
namespace {

std::string PointsOf(const DrawnView& view, const std::vector<Vector3>& points_W) {
  std::string points;
  for (const Vector3& p : points_W) {
    const Vector2 px = view.ToPx(p);
    points += fmt::format("{:.1f},{:.1f} ", px.x(), px.y());
  }
  return points;
}

std::string SupportOf(const DrawnView& view, const RobotModel& model, const DynamicsScratch& scratch) {
  std::vector<Vector2> points;
  for (std::size_t i = 0; i < model.legs.size(); ++i) {
    for (const Vector3& p : ContactPoints(model, scratch, static_cast<int>(i))) points.emplace_back(p.head<2>());
  }
  std::vector<Vector3> corners;
  for (const Vector2& p : ConvexHull(points)) corners.emplace_back(p.x(), p.y(), 0.0);
  return "<polygon class=\"support\" points=\"" + PointsOf(view, corners) + "\"/>";
}

/// The sphere or the sole of a foot, and its contact points.
std::string FootOf(const DrawnView& view, const RobotModel& model, const DynamicsScratch& scratch, int index) {
  const Foot& foot = model.feet[static_cast<std::size_t>(index)];
  const bool is_rest = index >= static_cast<int>(model.legs.size());
  std::string svg = fmt::format("<g data-foot=\"{}\"{}>", EscapedXml(foot.name), is_rest ? " class=\"rest\"" : "");
  if (foot.radius > 0.0) {
    const Vector2 at = view.ToPx(FramePose(scratch, foot.body, foot.X_BF).translation());
    svg += fmt::format("<circle class=\"sole\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\"/>", at.x(), at.y(),
                       view.px_per_m * foot.radius);
  }
  const std::vector<Vector3> contacts = ContactPoints(model, scratch, index);
  if (contacts.size() > 1) svg += "<polygon class=\"sole\" points=\"" + PointsOf(view, contacts) + "\"/>";
  for (const Vector3& p : contacts) {
    const Vector2 at = view.ToPx(p);
    svg += fmt::format("<circle class=\"corner\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\"/>", at.x(), at.y(),
                       contacts.size() > 1 ? 2.5 : 3.5);
  }
  return svg + "</g>";
}

/// The quartered disc that marks a centre of mass in drawings.
std::string CentreOfMassMark(const Vector2& at) {
  constexpr double kRadius = 8.0;
  return fmt::format(
      "<circle class=\"mass\" cx=\"{0:.1f}\" cy=\"{1:.1f}\" r=\"{2}\"/><path class=\"quarter\" d=\"M{0:.1f} {1:.1f}h{2}"
      "a{2} {2} 0 0 0 -{2} -{2}zM{0:.1f} {1:.1f}h-{2}a{2} {2} 0 0 0 {2} {2}z\"/>",
      at.x(), at.y(), kRadius);
}

}  // namespace

std::string DrawnFeet(const DrawnView& view, const RobotModel& model, const DynamicsScratch& scratch) {
  std::string svg = SupportOf(view, model, scratch);
  for (int i = 0; i < static_cast<int>(model.feet.size()); ++i) svg += FootOf(view, model, scratch, i);
  const Vector3 p_WC = CentreOfMass(model, scratch);
  const Vector2 at = view.ToPx(p_WC), below = view.ToPx({p_WC.x(), p_WC.y(), 0.0});
  svg += SvgSegment(at, below, "plumb");
  svg += SvgSegment(below + Vector2(-6.0, 0.0), below + Vector2(6.0, 0.0), "foot-of-plumb");
  svg += SvgSegment(below + Vector2(0.0, -6.0), below + Vector2(0.0, 6.0), "foot-of-plumb");
  return svg + CentreOfMassMark(at);
}

}  // namespace gaitwright
