// SPDX-License-Identifier: BSD-3-Clause
#include "planning/gait/schedule_contacts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

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
  const double first = request.first_foot < 0 ? *std::min_element(liftoff.begin(), liftoff.end())
                                              : liftoff[static_cast<std::size_t>(request.first_foot)];
  std::vector<Swing> swings;
  const int cycles = request.footfalls > 0 ? 1 + request.footfalls / gait.num_feet()
                                           : 1 + static_cast<int>(request.stepping_s / gait.cycle_s);
  for (int cycle = 0; cycle < cycles; ++cycle) {
    for (int foot = 0; foot < gait.num_feet(); ++foot) {
      const auto i = static_cast<std::size_t>(foot);
      const double start = (cycle + (liftoff[i] < first - 1e-9 ? 1.0 : 0.0) + liftoff[i] - first) * gait.cycle_s;
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

/// Why the grid is too coarse for a gait.
std::optional<Failure> CheckGrid(const Gait& gait, double grid_s) {
  constexpr double kLeast = 2.0;  // steps of the grid in each swing and stance
  for (std::size_t i = 0; i < gait.phase.size(); ++i) {
    const double share = std::min(gait.duty_factor[i], 1.0 - gait.duty_factor[i]);
    if (share * gait.cycle_s >= kLeast * grid_s * (1.0 - 1e-9)) continue;
    const bool swing = gait.duty_factor[i] > 0.5;
    return Failure{
        FailureKind::kBadInput,
        "gait",
        "ScheduleContacts",
        fmt::format("in gait '{}' the {} of foot {} lasts {:.3g} s, less than two steps of the plan's grid of {:.3g} s",
                    gait.name, swing ? "swing" : "stance", i, share * gait.cycle_s, grid_s),
        {fmt::format("a cycle of {:.3g} s or more (gait.cycle_s)", kLeast * grid_s / share),
         fmt::format("a {} duty factor (gait.duty_factor)", swing ? "smaller" : "larger")}};
  }
  return std::nullopt;
}

}  // namespace

Result<ContactSchedule> ScheduleContacts(const Gait& gait, const ScheduleRequest& request) {
  if (const auto failure = CheckGrid(gait, request.grid_s)) return *failure;
  // Halves go up, whatever rounding errors they carry, so that what falls together stays together.
  const auto on_grid = [&](double t) { return std::floor(t / request.grid_s + 0.5 + 1e-6) * request.grid_s; };
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
