// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/walk/plan_within.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "workflows/walk/refuse_walk.h"

namespace gaitwright {
namespace {

/// Which quicker gaits are tried: so many in even ratios, the first of them by its number (0: the gait as fitted).
/// A search for faster walks need not go back to slower steps than the last that served: it keeps their number here.
struct Stepping {
  int quicker = 6;
  std::size_t from = 0;
};

constexpr double kSlightExcess = 1e-5;  // which the audit may let pass

/// What a search for plans is about; `command` changes.
struct Search {
  const RobotModel& model;
  const Terrain& terrain;
  const WalkRequest& request;
  bool only_within = false;  // plans past limits are of no interest and not audited
  AuditOptions audit = {};
};

Result<PlannedWalk> PlanAndAudit(const Search& search, const Gait& gait, const WalkCommand& command) {
  Result<PlannedMotion> motion = PlanMotion(search.model, search.terrain, gait, command, search.request.motion);
  if (!motion) return motion.failure();
  PlannedWalk planned;
  planned.motion = std::move(*motion);
  if (planned.motion.limit_excess >= kSlightExcess && search.only_within) return planned;
  const Result<AuditReport> audit = Audit(search.model, planned.motion.plan, search.audit);
  if (!audit) return audit.failure();
  planned.audit = *audit;
  return planned;
}

bool KeepsLimits(const Result<PlannedWalk>& planned) {
  return planned && planned->motion.limit_excess < kSlightExcess && BrokenLimits(planned->audit).empty();
}

bool Passes(const Result<PlannedWalk>& planned) { return KeepsLimits(planned) && planned->audit.pass(); }

/// True for failures that a slower walk may not have.
bool IsTooMuch(const Failure& failure) {
  return failure.kind == FailureKind::kInfeasible && failure.stage != "ScheduleContacts";
}

/// The gait fitted to a command, and the same with quicker steps, down to the shortest time that it may have.
Result<std::vector<Gait>> GaitsFor(const Search& search, const WalkCommand& command, int quicker) {
  const WalkRequest& request = search.request;
  const double speed = CommandedSpeed(search.model, command);
  const Result<Gait> gait = FindGait(search.model, request.gait, speed, request.gait_options);
  if (!gait) return gait.failure();
  std::vector<Gait> gaits = {*gait};
  const Result<double> shortest = ShortestCycle(search.model, request.gait, request.gait_options);
  if (!shortest) return shortest.failure();
  if (PaceOf(command) == Pace::kStepLength || *shortest >= gait->cycle_s) return gaits;
  for (int i = 1; i <= quicker; ++i) {
    gaits.push_back(*gait);
    gaits.back().cycle_s *= std::pow(*shortest / gait->cycle_s, static_cast<double>(i) / quicker);
  }
  return gaits;
}

/// The plan at the gait's fitted time, or at a quicker one where only that keeps the limits; else the first's outcome.
/// Quicker ones are tried as long as they do not take joints ever farther past their limits.
Result<PlannedWalk> PlanQuicker(const Search& search, const WalkCommand& command, Stepping& stepping) {
  constexpr int kPatience = 2;
  const Result<std::vector<Gait>> gaits = GaitsFor(search, command, stepping.quicker);
  if (!gaits) return gaits.failure();
  const std::size_t from = std::min(stepping.from, gaits->size() - 1);
  Result<PlannedWalk> first = PlanAndAudit(search, (*gaits)[from], command);
  if (KeepsLimits(first) || (!first && !IsTooMuch(first.failure()))) return first;
  const Search within{search.model, search.terrain, search.request, true, search.audit};
  const auto excess = [](const Result<PlannedWalk>& planned) {
    return planned ? planned->motion.limit_excess : std::numeric_limits<double>::infinity();
  };
  double last = excess(first);
  int worse = 0;
  for (std::size_t i = from + 1; i < gaits->size() && worse < kPatience; ++i) {
    Result<PlannedWalk> planned = PlanAndAudit(within, (*gaits)[i], command);
    worse = excess(planned) > last ? worse + 1 : 0;
    last = excess(planned);
    if (!Passes(planned)) continue;
    stepping.from = i;
    planned->motion.summary +=
        fmt::format("; a cycle of {:.2f} s, since one of {:.2f} s would break limits of the robot", (*gaits)[i].cycle_s,
                    gaits->front().cycle_s);
    return planned;
  }
  return first;
}

const char* NameOf(Pace pace) {
  switch (pace) {
    case Pace::kSpeed:
      return "speed";
    case Pace::kLateralSpeed:
      return "lateral speed";
    case Pace::kYawRate:
      return "turning rate";
    case Pace::kStepLength:
      return "step length";
  }
  return "";
}

std::string ValueText(const WalkCommand& c) {
  switch (PaceOf(c)) {
    case Pace::kSpeed:
      return fmt::format("{:.2g} m/s", c.speed_m_s);
    case Pace::kLateralSpeed:
      return fmt::format("{:.2g} m/s", std::abs(c.lateral_speed_m_s));
    case Pace::kYawRate:
      return fmt::format("{:.2g} rad/s", std::abs(c.yaw_rate_rad_s));
    case Pace::kStepLength:
      return fmt::format("{:.2g} m", std::abs(c.step_length_m));
  }
  return "";
}

/// The request for plans that only tell whether there are any: on a grid twice as coarse where a cycle has steps
/// enough.
WalkRequest Coarse(const WalkRequest& request, double cycle_s) {
  constexpr double kStepsOfCycle = 100.0, kCoarsest = 0.01;
  WalkRequest coarse = request;
  double& grid = coarse.motion.pipeline.grid_step_s;
  if (cycle_s >= 2.0 * grid * kStepsOfCycle) grid = std::max(grid, std::min(2.0 * grid, kCoarsest));
  return coarse;
}

/// Largest pace of the command that has a plan which passes its audit: looked for on short and coarse plans, then tried
/// on the whole walk as it would be asked for. 0 when there is none.
double LargestThatPasses(const Search& search, const Gait& gait) {
  constexpr int kLowered = 4;
  AuditOptions seldom;
  seldom.rate_hz *= 0.5;
  const WalkRequest coarse = Coarse(search.request, gait.cycle_s);
  const Search rough{search.model, search.terrain, coarse, true, seldom};
  Stepping stepping;
  const auto in_short = [&](const WalkCommand& c) {
    return Passes(PlanQuicker(rough, Shortened(search.model, c, gait.cycle_s), stepping));
  };
  const Search whole{search.model, search.terrain, search.request, true};
  const WalkCommand& command = search.request.command;
  double largest = LargestPace(search.model, command, in_short);
  for (int i = 0; i < kLowered && largest > 0.0; ++i) {
    Stepping fresh;
    if (Passes(PlanQuicker(whole, AtPace(search.model, command, largest), fresh))) return largest;
    largest = NextLower(largest);
  }
  return 0.0;
}

/// The failure with what it would take instead.
Failure Refusal(const Search& search, Failure failure) {
  const WalkCommand& command = search.request.command;
  const Result<Gait> gait =
      FindGait(search.model, search.request.gait, CommandedSpeed(search.model, command), search.request.gait_options);
  if (!gait) return failure;
  const double largest = LargestThatPasses(search, *gait);
  const char* name = NameOf(PaceOf(command));
  failure.hints = {"--set pipeline.allow_limits=true gives the plan all the same"};
  if (largest == 0.0) {
    failure.message += fmt::format("; robot '{}' has no {} at which it keeps its limits with gait '{}'",
                                   search.model.name, name, gait->name);
    failure.hints.insert(failure.hints.begin(), "another gait");
    return failure;
  }
  const WalkCommand slower = AtPace(search.model, command, largest);
  failure.message += fmt::format("; the largest {} with gait '{}' is {}", name, gait->name, ValueText(slower));
  failure.hints.insert(failure.hints.begin(), PaceFlags(slower));
  return failure;
}

Failure LimitsBroken(const AuditReport& audit) {
  const std::vector<Violation> broken = BrokenLimits(audit);
  return {FailureKind::kInfeasible,
          "limits",
          "PlanWalk",
          fmt::format("{}{}", LimitText(broken.front()),
                      broken.size() > 1 ? fmt::format(" (worst of {} limits that are broken)", broken.size()) : ""),
          {}};
}

}  // namespace

Result<PlannedWalk> PlanWithin(const RobotModel& model, const Terrain& terrain, const WalkRequest& request) {
  const Search search{model, terrain, request};
  const bool allow = request.motion.pipeline.allow_limits;
  Stepping stepping;
  if (allow) stepping.quicker = 0;
  Result<PlannedWalk> planned = PlanQuicker(search, request.command, stepping);
  if (allow || KeepsLimits(planned)) return planned;
  if (planned && BrokenLimits(planned->audit).empty()) return planned;
  if (planned) return Refusal(search, LimitsBroken(planned->audit));
  return IsTooMuch(planned.failure()) ? Refusal(search, planned.failure()) : planned;
}

}  // namespace gaitwright
