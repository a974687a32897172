// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/pipeline/support_regions.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "kinematics/dynamics/dynamics.h"
#include "kinematics/stability/holdable_support.h"
#include "kinematics/stability/polygon.h"
#include "optimisation/pipeline/sole_width.h"

namespace gaitwright {
namespace {

/// Corners of a foot's contact with the ground in plan view, at a time since the start of the grid.
std::vector<Vector2> CornersAt(const Foot& foot, const Foothold& foothold, double since_start_s,
                               const SupportInputs& inputs, const Polygon& support_F) {
  const auto index = static_cast<std::size_t>(foothold.foot);
  if (foot.sole_F.empty()) {
    if (inputs.contact_W.empty()) return {foothold.X_WF.translation().head<2>()};
    return {inputs.contact_W[index][static_cast<std::size_t>(std::lround(since_start_s / inputs.step_s))].head<2>()};
  }
  std::vector<Vector2> corners;
  for (const Vector2& corner : support_F)
    corners.push_back((foothold.X_WF * Vector3(corner.x(), corner.y(), 0.0)).head<2>());
  return corners;
}

/// Inputs for the region of a phase.
struct Scene {
  const RobotModel& model;
  const FootstepPlan& footsteps;
  const SupportInputs& inputs;
  double start_s;

  /// Support polygon of a foot at its foothold, in F.
  const Polygon& SupportAt(int foothold) const {
    const auto i = static_cast<std::size_t>(foothold);
    if (!inputs.support_F.empty()) return inputs.support_F[i];
    return model.feet[static_cast<std::size_t>(footsteps.footholds[i].foot)].sole_F;
  }
};

std::vector<Vector2> StanceCorners(const Scene& scene, const ContactPhase& phase, double time_s) {
  std::vector<Vector2> corners;
  for (int f = 0; f < static_cast<int>(scene.model.feet.size()); ++f) {
    if (!Contains(phase.stance, f)) continue;
    const int index = FootholdAt(scene.footsteps, f, 0.5 * (phase.start_s + phase.end_s));
    const Foothold& foothold = scene.footsteps.footholds[static_cast<std::size_t>(index)];
    const auto own = CornersAt(scene.model.feet[static_cast<std::size_t>(f)], foothold, time_s - scene.start_s,
                               scene.inputs, scene.SupportAt(index));
    corners.insert(corners.end(), own.begin(), own.end());
  }
  return corners;
}

/// The hull at mid phase, and its corners at both ends of the phase.
ZmpPhase MovingHull(const Scene& scene, const ContactPhase& phase) {
  const auto middle = StanceCorners(scene, phase, 0.5 * (phase.start_s + phase.end_s));
  const auto start = StanceCorners(scene, phase, phase.start_s);
  const auto end = StanceCorners(scene, phase, phase.end_s);
  ZmpPhase region;
  region.start_s = phase.start_s;
  region.end_s = phase.end_s;
  for (const Vector2& corner : ConvexHull(middle)) {
    const auto at = static_cast<std::size_t>(std::find(middle.begin(), middle.end(), corner) - middle.begin());
    region.region_start.push_back(start[at]);
    region.region_end.push_back(end[at]);
  }
  return region;
}

/// Preferred ZMP of single support.
class PreferredZmp {
 public:
  explicit PreferredZmp(const RobotModel& model) : model_(model), scratch_(model) {
    ForwardKinematics(model, StandingConfiguration(model), scratch_);
    height_m_ = CentreOfMass(model, scratch_).z();
  }

  /// The middle, in F, of the part of the support polygon in which the ankle can hold the robot.
  Vector2 Of(int foot, const Polygon& support_F) const {
    constexpr double kUse = 1.0;
    const Foot& sole = model_.feet[static_cast<std::size_t>(foot)];
    if (support_F.size() < 3) return Vector2::Zero();
    const Pose X_WF = FramePose(scratch_, sole.body, sole.X_BF);
    std::vector<Vector2> corners;
    for (const Vector2& corner : support_F) corners.push_back((X_WF * Vector3(corner.x(), corner.y(), 0.0)).head<2>());
    const Vector3 above(X_WF.translation().x(), X_WF.translation().y(), height_m_);
    const Vector2 middle =
        Centroid(HoldableSupport(model_, scratch_, foot, ConvexHull(corners), {above, model_.weight_n()}, kUse));
    return (X_WF.inverse() * Vector3(middle.x(), middle.y(), X_WF.translation().z())).head<2>();
  }

 private:
  const RobotModel& model_;
  DynamicsScratch scratch_;
  double height_m_ = 0.0;
};

/// Preferred ZMP at an end of a phase: the middle of its region. Under a single sole it is the sole's preferred ZMP,
/// moved towards the other feet or their last footholds.
Vector2 Preferred(const Scene& scene, const ContactPhase& phase, const std::vector<Vector2>& region,
                  const PreferredZmp& preferred) {
  if (std::popcount(phase.stance) != 1) return Centroid(region);
  const int foot = std::countr_zero(phase.stance);
  const Foot& sole = scene.model.feet[static_cast<std::size_t>(foot)];
  if (sole.sole_F.empty()) return Centroid(region);
  const double time_s = 0.5 * (phase.start_s + phase.end_s);
  const auto place = [&](int f) -> const Pose& {
    return scene.footsteps.footholds[static_cast<std::size_t>(FootholdAt(scene.footsteps, f, time_s))].X_WF;
  };
  double side = 0.0;
  for (int f = 0; f < static_cast<int>(scene.model.feet.size()); ++f) {
    if (f != foot) side += (place(foot).inverse() * place(f).translation()).y();
  }
  const Vector2 home = preferred.Of(foot, scene.SupportAt(FootholdAt(scene.footsteps, foot, time_s)));
  const double inward = (side > 0.0 ? 1.0 : -1.0) * scene.inputs.inward * SoleWidth(sole);
  return (place(foot) * Vector3(home.x(), home.y() + inward, 0.0)).head<2>();
}

/// At a change to a larger or smaller stance, both phases get the preferred point of the smaller one.
void JoinPreferred(const std::vector<ContactPhase>& phases, std::vector<ZmpPhase>& regions) {
  const std::vector<ZmpPhase> own = regions;
  for (std::size_t i = 0; i + 1 < regions.size(); ++i) {
    const FootSet here = phases[i].stance, there = phases[i + 1].stance, both = here & there;
    if (here == there || (both != here && both != there)) continue;
    const Vector2 point = both == here ? own[i].preferred_end : own[i + 1].preferred_start;
    regions[i].preferred_end = point;
    regions[i + 1].preferred_start = point;
  }
}

/// Largest distance of the corners in a phase from their linear interpolation between its ends [m].
double Bend(const Scene& scene, const ContactPhase& phase, const ZmpPhase& region) {
  const double middle_s = 0.5 * (phase.start_s + phase.end_s);
  const std::vector<Vector2> corners = StanceCorners(scene, phase, middle_s);
  double bend = 0.0;
  for (const Vector2& taken : RegionAt(region, middle_s)) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Vector2& corner : corners) nearest = std::min(nearest, (corner - taken).norm());
    bend = std::max(bend, nearest);
  }
  return bend;
}

/// Divides a phase on a line into parts, such that the corners stay within 0.5 mm of straight lines between the ends of
/// a part. Feet roll back and forth under a swaying body, and off the line no force can act.
void AppendParts(const Scene& scene, const ContactPhase& phase, const ZmpPhase& region, std::vector<ZmpPhase>& parts) {
  constexpr double kStraight = 5e-4;  // [m]
  constexpr int kFewestSteps = 8;
  const int steps = static_cast<int>(std::lround((phase.end_s - phase.start_s) / scene.inputs.step_s));
  const bool rolls = region.region_start.size() == 2 && !scene.inputs.contact_W.empty();
  const double bend = rolls ? Bend(scene, phase, region) : 0.0;
  const int wanted = static_cast<int>(std::ceil(std::sqrt(bend / kStraight)));
  const int count = std::clamp(wanted, 1, std::max(1, steps / kFewestSteps));
  if (count == 1) return parts.push_back(region);
  const auto boundary = [&](int k) {
    const int step = steps * k / count;
    return phase.start_s + step * scene.inputs.step_s;
  };
  for (int k = 0; k < count; ++k) {
    const double end_s = k + 1 == count ? phase.end_s : boundary(k + 1);
    ZmpPhase part = MovingHull(scene, {boundary(k), end_s, phase.stance});
    part.preferred_start = NearestPoint(part.region_start, PreferredAt(region, part.start_s));
    part.preferred_end = NearestPoint(part.region_end, PreferredAt(region, part.end_s));
    parts.push_back(std::move(part));
  }
}

}  // namespace

std::vector<ZmpPhase> SupportRegions(const RobotModel& model, const ContactSchedule& schedule,
                                     const FootstepPlan& footsteps, const SupportInputs& inputs) {
  const auto& phases = schedule.phases;
  const Scene scene{model, footsteps, inputs, schedule.start_s()};
  const PreferredZmp preferred(model);
  std::vector<ZmpPhase> regions;
  for (const ContactPhase& phase : phases) {
    ZmpPhase region = MovingHull(scene, phase);
    region.preferred_start = Preferred(scene, phase, region.region_start, preferred);
    region.preferred_end = Preferred(scene, phase, region.region_end, preferred);
    regions.push_back(region);
  }
  JoinPreferred(phases, regions);
  if (!regions.empty()) {
    regions.front().preferred_start = inputs.start_W;
    regions.back().preferred_end = inputs.end_W;
  }
  std::vector<ZmpPhase> parts;
  for (std::size_t i = 0; i < regions.size(); ++i) AppendParts(scene, phases[i], regions[i], parts);
  return parts;
}

}  // namespace gaitwright
