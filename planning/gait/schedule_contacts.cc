// SPDX-License-Identifier: BSD-3-Clause
#include "planning/gait/schedule_contacts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace gaitwright {
namespace {

struct Swing {
  double liftoff_s, touchdown_s;
  int foot;
};

double Fraction(double x) { return x - std::floor(x); }

/// Swings in order of lift-off, the first at time zero.
std::vector<Swing> Swings(const Gait& gait, const ScheduleRequest& request) {
  std::vector<double> liftoff(gait.phase.size());
  for (std::size_t i = 0; i < liftoff.size(); ++i) liftoff[i] = Fraction(gait.phase[i] + gait.duty_factor[i] + 1e-12);
  const double first = *std::min_element(liftoff.begin(), liftoff.end());
  std::vector<Swing> swings;
  const int cycles =
      request.footfalls > 0 ? request.footfalls : 1 + static_cast<int>(request.stepping_s / gait.cycle_s);
  for (int cycle = 0; cycle < cycles; ++cycle) {
    for (int foot = 0; foot < gait.num_feet(); ++foot) {
      const auto i = static_cast<std::size_t>(foot);
      const double start = (cycle + liftoff[i] - first) * gait.cycle_s;
      swings.push_back({start, start + (1.0 - gait.duty_factor[i]) * gait.cycle_s, foot});
    }
  }
  std::stable_sort(swings.begin(), swings.end(),
                   [](const Swing& a, const Swing& b) { return a.liftoff_s < b.liftoff_s - 1e-9; });
  if (request.footfalls > 0) {
    swings.resize(static_cast<std::size_t>(request.footfalls));
  } else {
    std::erase_if(swings, [&](const Swing& swing) { return swing.liftoff_s > request.stepping_s - 1e-6; });
  }
  return swings;
}

}  // namespace

Result<ContactSchedule> ScheduleContacts(const Gait& gait, const ScheduleRequest& request) {
  if (HasFlight(gait)) {
    return Failure{
        FailureKind::kInfeasible,
        "gait_with_flight",
        "ScheduleContacts",
        fmt::format("gait '{}' has phases without any foot on the ground; motions with flight are not planned yet",
                    gait.name),
        {"choose a gait without flight, such as trot or walk"}};
  }
  const auto on_grid = [&](double t) { return std::round(t / request.grid_s) * request.grid_s; };
  std::vector<std::vector<ContactInterval>> by_foot(gait.phase.size());
  std::vector<double> down(gait.phase.size(), 0.0);
  double last = request.initial_stand_s;
  for (const Swing& swing : Swings(gait, request)) {
    const auto i = static_cast<std::size_t>(swing.foot);
    by_foot[i].push_back({down[i], on_grid(request.initial_stand_s + swing.liftoff_s)});
    down[i] = on_grid(request.initial_stand_s + swing.touchdown_s);
    last = std::max(last, down[i]);
  }
  const double end = on_grid(last + request.final_stand_s);
  for (std::size_t i = 0; i < by_foot.size(); ++i) by_foot[i].push_back({down[i], end});
  return ScheduleFromIntervals(by_foot, 0.0, end);
}

}  // namespace gaitwright
