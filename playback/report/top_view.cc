// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "playback/report/plots.h"
#include "playback/report/svg_plot.h"

namespace gaitwright {
namespace {

/// Plan view of a foot at a pose of its contact frame: its sole, or one point.
std::vector<Vector2> Outline(const Foot& foot, const Pose& X_WF) {
  if (foot.sole_F.empty()) return {X_WF.translation().head<2>()};
  std::vector<Vector2> outline;
  for (const Vector2& corner : foot.sole_F)
    outline.emplace_back((X_WF * Vector3(corner.x(), corner.y(), 0.0)).head<2>());
  return outline;
}

/// Whether a phase only connects the phases before and after, with more feet on the ground than in one of them. Its
/// support would hide theirs.
bool OnlyJoins(const ContactSchedule& schedule, std::size_t i) {
  if (i == 0 || i + 1 == schedule.phases.size()) return false;
  const FootSet now = schedule.phases[i].stance, before = schedule.phases[i - 1].stance;
  const FootSet after = schedule.phases[i + 1].stance;
  const bool more_than_before = (now & before) == before && now != before;
  const bool more_than_after = (now & after) == after && now != after;
  return more_than_before || more_than_after;
}

void DrawFootholds(const PlotData& data, SvgPlot& plot) {
  for (const Foothold& foothold : data.plan.footsteps.footholds) {
    if (foothold.touchdown_s > data.end_s()) continue;
    const Foot& foot = data.model.feet[static_cast<std::size_t>(foothold.foot)];
    if (foot.sole_F.empty()) {
      plot.Dot(foothold.X_WF.translation().head<2>(), Ink::kFoot, 3.0, "footholds planned");
    } else {
      plot.Area(Outline(foot, foothold.X_WF), Ink::kFoot, true, "footholds planned");
    }
  }
}

/// Places of the feet at touch-down, as measured: their outline at the first sample in the stance.
void DrawLandings(const PlotData& data, SvgPlot& plot) {
  DynamicsScratch scratch(data.model);
  const auto& samples = data.series.measured;
  for (const StanceRecord& stance : data.log.stances) {
    const Foot& foot = data.model.feet[static_cast<std::size_t>(stance.foot)];
    if (stance.touchdown_s > data.end_s() || stance.liftoff_s - stance.touchdown_s < 0.02) continue;
    if (foot.sole_F.empty()) {
      plot.Cross(stance.p_touchdown_W.head<2>(), Ink::kFoot, "feet measured");
      continue;
    }
    const double middle = std::min(0.5 * (stance.touchdown_s + stance.liftoff_s), data.end_s());
    const double row = (middle - samples.front().time_s) * data.log.log_rate_hz;
    const std::size_t k =
        static_cast<std::size_t>(std::max(0.0, std::min(row, static_cast<double>(samples.size()) - 1.0)));
    ForwardKinematics(data.model, data.log.samples[k].q, scratch);
    const Pose X_WF = ContactFrame(data.model, scratch, data.plan.terrain, stance.foot);
    plot.Area(Outline(foot, X_WF), Ink::kFoot, false, "feet measured");
  }
}

/// The goal as an arrow with its heading.
void DrawGoal(const PlotData& data, SvgPlot& plot) {
  const Vector2 goal(data.plan.goal.x_m, data.plan.goal.y_m);
  const double size = 0.07 * std::max(data.model.leg_length_m(), 0.1);
  const Eigen::Rotation2Dd turn(data.plan.goal.yaw_rad);
  plot.Area({goal + turn * Vector2(size, 0.0), goal + turn * Vector2(-size, 0.6 * size),
             goal + turn * Vector2(-0.4 * size, 0.0), goal + turn * Vector2(-size, -0.6 * size)},
            Ink::kBad, true, "goal of the base");
}

}  // namespace

void DrawSupports(const ContactSchedule& schedule, const std::vector<MotionSample>& samples, SvgPlot& plot) {
  if (schedule.phases.empty()) return;  // a command plans no contacts
  std::size_t drawn = schedule.phases.size();
  for (const MotionSample& sample : samples) {
    const std::size_t phase = static_cast<std::size_t>(PhaseAt(schedule, sample.time_s));
    if (phase == drawn || sample.support.empty() || OnlyJoins(schedule, phase)) continue;
    if (sample.stance != schedule.phases[phase].stance) continue;
    drawn = phase;
    plot.Area(sample.support.polygon, Ink::kSupport, true, "support polygons");
  }
}

void DrawPaths(const MotionSeries& series, SvgPlot& plot) {
  const auto com = [](const MotionSample& s) { return Vector2(s.p_WC.head<2>()); };
  const auto zmp = [](const MotionSample& s) { return s.has_zmp ? s.p_WZ : Vector2::Constant(std::nan("")).eval(); };
  const auto draw = [&](const std::vector<MotionSample>& samples, const auto& point, Ink ink, Stroke stroke,
                        const std::string& label) {
    std::vector<Vector2> path;
    for (const MotionSample& s : samples) path.push_back(point(s));
    if (!path.empty()) plot.Line(path, ink, stroke, label);
  };
  draw(series.planned, com, Ink::kCom, Stroke::kPlanned, "CoM planned");
  draw(series.measured, com, Ink::kCom, Stroke::kMeasured, "CoM measured");
  draw(series.planned, zmp, Ink::kZmp, Stroke::kPlanned, "ZMP planned");
  draw(series.measured, zmp, Ink::kZmp, Stroke::kMeasured, "ZMP measured");
}

Plot TopView(const PlotData& data) {
  SvgPlot plot(SvgPlot::ToScale("From above", "x [m]", "y [m]"));
  DrawGround(data, plot);
  DrawSupports(data.plan.schedule, data.series.measured, plot);
  DrawFootholds(data, plot);
  DrawLandings(data, plot);
  DrawPaths(data.series, plot);
  DrawGoal(data, plot);
  return {
      "top_view",
      "Footholds, support polygons, centre of mass and zero-moment point, in metres and to scale. The measured ZMP is "
      "low-pass filtered with 10 ms; supports are those of the scheduled stance feet at their measured positions.",
      plot.Svg()};
}

}  // namespace gaitwright
