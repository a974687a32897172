// SPDX-License-Identifier: BSD-3-Clause
#include "planning/plan/motion_plan.h"

namespace gaitwright {

int FootholdAt(const FootstepPlan& plan, int foot, double time_s) {
  constexpr double kTiny = 1e-9;
  int found = -1;
  for (std::size_t i = 0; i < plan.footholds.size(); ++i) {
    const Foothold& foothold = plan.footholds[i];
    if (foothold.foot != foot) continue;
    if (found >= 0 && foothold.touchdown_s > time_s + kTiny) break;
    found = static_cast<int>(i);
  }
  return found;
}

}  // namespace gaitwright
