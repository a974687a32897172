// SPDX-License-Identifier: BSD-3-Clause
#include "planning/plan/support_plane.h"

#include <Eigen/Eigenvalues>
#include <algorithm>

#include "kinematics/trajectory/swing_curve.h"

namespace gaitwright {
namespace {

/// Sums over the contact points of a stance, for the least-squares fit.
struct Spread {
  int count = 0;
  Vector3 middle = Vector3::Zero();
  Eigen::Matrix2d places = Eigen::Matrix2d::Zero();  // sum of (p - middle)(p - middle)^T in plan view
  Vector2 rises = Vector2::Zero();                   // sum of (p - middle) (z - middle)
};

Spread SpreadOf(const ContactsByFoot& contacts, FootSet stance) {
  Spread spread;
  const auto each = [&](const auto& visit) {
    for (std::size_t f = 0; f < contacts.size(); ++f) {
      if (!Contains(stance, static_cast<int>(f))) continue;
      for (const Vector3& p : contacts[f]) visit(p);
    }
  };
  each([&](const Vector3& p) {
    ++spread.count;
    spread.middle += p;
  });
  if (spread.count == 0) return spread;
  spread.middle /= spread.count;
  each([&](const Vector3& p) {
    const Vector3 d = p - spread.middle;
    spread.places += d.head<2>() * d.head<2>().transpose();
    spread.rises += d.head<2>() * d.z();
  });
  return spread;
}

GroundPlane Blend(const GroundPlane& from, const GroundPlane& to, double u) {
  return {(1.0 - u) * from.height_m + u * to.height_m, (1.0 - u) * from.slope + u * to.slope};
}

/// The feet that stand on both sides of a boundary; if no foot does, all feet of the first stance.
FootSet Shared(FootSet here, FootSet there) { return (here & there) != 0 ? here & there : here; }

}  // namespace

GroundPlane PlaneThrough(const ContactsByFoot& contacts, FootSet stance) {
  const Spread spread = SpreadOf(contacts, stance);
  GroundPlane plane;
  if (spread.count == 0) return plane;
  // The plane gets no slope in a direction in which the points are not spread.
  constexpr double kLine = 1e-3;  // share of the largest spread, squared
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(spread.places);
  const double largest = axes.eigenvalues()[1];
  for (int i = 0; i < 2; ++i) {
    if (axes.eigenvalues()[i] <= kLine * largest || largest <= 0.0) continue;
    const Vector2 axis = axes.eigenvectors().col(i);
    plane.slope += axis * axis.dot(spread.rises) / axes.eigenvalues()[i];
  }
  plane.height_m = spread.middle.z() - plane.slope.dot(spread.middle.head<2>());
  return plane;
}

GroundPlane SupportPlaneAt(const ContactSchedule& schedule, double time_s, const ContactsByFoot& contacts) {
  if (schedule.phases.empty()) return PlaneThrough(contacts, AllFeet(static_cast<int>(contacts.size())));
  const auto i = static_cast<std::size_t>(PhaseAt(schedule, time_s));
  const ContactPhase& now = schedule.phases[i];
  const FootSet before = i > 0 ? Shared(now.stance, schedule.phases[i - 1].stance) : now.stance;
  const FootSet after = i + 1 < schedule.phases.size() ? Shared(now.stance, schedule.phases[i + 1].stance) : now.stance;
  if (before == after) return PlaneThrough(contacts, before);
  const double u = std::clamp((time_s - now.start_s) / (now.end_s - now.start_s), 0.0, 1.0);
  return Blend(PlaneThrough(contacts, before), PlaneThrough(contacts, after), SmoothStep(u).value);
}

GroundPlane CarryingPlaneAt(const FootstepPlan& footsteps, int num_feet, double time_s) {
  const std::vector<Foothold>& all = footsteps.footholds;
  ContactsByFoot places(static_cast<std::size_t>(num_feet));
  for (int f = 0; f < num_feet; ++f) {
    const int index = FootholdAt(footsteps, f, time_s);
    if (index < 0) continue;
    const auto last = all.begin() + index;
    Vector3 place = last->X_WF.translation();
    const auto next = std::find_if(last + 1, all.end(), [&](const Foothold& h) { return h.foot == f; });
    if (time_s > last->liftoff_s && next != all.end() && next->touchdown_s > last->liftoff_s) {
      const double u = std::min((time_s - last->liftoff_s) / (next->touchdown_s - last->liftoff_s), 1.0);
      place += u * (next->X_WF.translation() - place);
    }
    places[static_cast<std::size_t>(f)].push_back(place);
  }
  return PlaneThrough(places, AllFeet(num_feet));
}

Vector3 NormalUnder(const FootstepPlan& footsteps, int foot, double time_s) {
  const int index = FootholdAt(footsteps, foot, time_s);
  if (index < 0) return Vector3::UnitZ();
  return footsteps.footholds[static_cast<std::size_t>(index)].X_WF.linear().col(2);
}

double FrictionUnder(const Terrain& terrain, const FootstepPlan& footsteps, int foot, double time_s) {
  const int index = FootholdAt(footsteps, foot, time_s);
  return index < 0 ? 0.0 : FrictionOf(terrain, footsteps.footholds[static_cast<std::size_t>(index)].patch);
}

}  // namespace gaitwright
