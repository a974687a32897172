// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/pipeline/mean_height.h"

#include <fmt/format.h>

#include "kinematics/base/result.h"
#include "planning/plan/support_plane.h"

namespace gaitwright {

double MeanHeightOverFeet(const CentroidalTrajectory& motion, const FootstepPlan& footsteps, int num_feet) {
  if (motion.p_WC.empty()) throw InvalidArgument("MeanHeightOverFeet: the motion has no samples");
  for (int f = 0; f < num_feet; ++f) {
    if (FootholdAt(footsteps, f, motion.start_s) < 0)
      throw InvalidArgument(fmt::format("MeanHeightOverFeet: foot {} has no foothold", f));
  }
  double sum = 0.0;
  for (std::size_t k = 0; k < motion.p_WC.size(); ++k) {
    const double time_s = motion.start_s + static_cast<double>(k) * motion.step_s;
    const Vector3& p_WC = motion.p_WC[k];
    sum += p_WC.z() - CarryingPlaneAt(footsteps, num_feet, time_s).HeightAt(p_WC.head<2>());
  }
  return sum / static_cast<double>(motion.p_WC.size());
}

}  // namespace gaitwright
