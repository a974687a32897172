// SPDX-License-Identifier: BSD-3-Clause
#include "planning/plan/motion_plan.h"

#include <algorithm>
#include <iterator>
#include <tuple>

namespace gaitwright {

void SortFootholds(FootstepPlan& plan) {
  std::stable_sort(plan.footholds.begin(), plan.footholds.end(), [](const Foothold& a, const Foothold& b) {
    return std::tie(a.touchdown_s, a.foot) < std::tie(b.touchdown_s, b.foot);
  });
}

int FootholdAt(const FootstepPlan& plan, int foot, double time_s) {
  constexpr double kTiny = 1e-9;
  const auto& all = plan.footholds;
  const auto later = std::upper_bound(all.begin(), all.end(), time_s + kTiny,
                                      [](double t, const Foothold& foothold) { return t < foothold.touchdown_s; });
  const auto is_its = [&](const Foothold& foothold) { return foothold.foot == foot; };
  const auto before = std::find_if(std::make_reverse_iterator(later), all.rend(), is_its);
  if (before != all.rend()) return static_cast<int>(all.rend() - before) - 1;
  const auto first = std::find_if(later, all.end(), is_its);
  return first == all.end() ? -1 : static_cast<int>(first - all.begin());
}

const MotionPart* PartAt(const std::vector<MotionPart>& parts, double time_s) {
  constexpr double kTiny = 1e-9;
  const auto ended = [&](const MotionPart& part) { return part.end_s <= time_s + kTiny; };
  if (parts.empty()) return nullptr;
  const auto at = std::find_if_not(parts.begin(), parts.end(), ended);
  return at == parts.end() ? &parts.back() : &*at;
}

std::string GaitNames(const std::vector<MotionPart>& parts) {
  std::string names;
  for (const MotionPart& part : parts) names += (names.empty() ? "" : ", ") + part.gait.name;
  return names;
}

}  // namespace gaitwright
