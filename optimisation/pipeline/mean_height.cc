// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/pipeline/mean_height.h"

#include <fmt/format.h>

#include <algorithm>

#include "kinematics/base/result.h"
#include "planning/plan/support_plane.h"

namespace gaitwright {
namespace {

/// Where a foot is at a time, on its foothold or evenly on its way to the next.
Vector3 PlaceOf(const FootstepPlan& footsteps, int foot, double time_s) {
  const auto& all = footsteps.footholds;
  const int index = FootholdAt(footsteps, foot, time_s);
  if (index < 0) throw InvalidArgument(fmt::format("MeanHeightOverFeet: foot {} has no foothold", foot));
  const auto last = all.begin() + index;
  Vector3 p = last->X_WF.translation();
  const auto next = std::find_if(last + 1, all.end(), [&](const Foothold& f) { return f.foot == foot; });
  if (time_s <= last->liftoff_s || next == all.end() || next->touchdown_s <= last->liftoff_s) return p;
  const double u = std::min((time_s - last->liftoff_s) / (next->touchdown_s - last->liftoff_s), 1.0);
  p += u * (next->X_WF.translation() - p);
  return p;
}

}  // namespace

double MeanHeightOverFeet(const CentroidalTrajectory& motion, const FootstepPlan& footsteps, int num_feet) {
  if (motion.p_WC.empty()) throw InvalidArgument("MeanHeightOverFeet: the motion has no samples");
  ContactsByFoot places(static_cast<std::size_t>(num_feet));
  double sum = 0.0;
  for (std::size_t k = 0; k < motion.p_WC.size(); ++k) {
    const double time_s = motion.start_s + static_cast<double>(k) * motion.step_s;
    for (int f = 0; f < num_feet; ++f) places[static_cast<std::size_t>(f)] = {PlaceOf(footsteps, f, time_s)};
    const Vector3& p_WC = motion.p_WC[k];
    sum += p_WC.z() - PlaneThrough(places, AllFeet(num_feet)).HeightAt(p_WC.head<2>());
  }
  return sum / static_cast<double>(motion.p_WC.size());
}

}  // namespace gaitwright
