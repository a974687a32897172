// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/search/refuse_walk.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

namespace gaitwright {
namespace {

bool IsLimit(const Violation& v) {
  static const std::set<Law> kLimits = {Law::kJointPosition,    Law::kJointVelocity, Law::kJointAcceleration,
                                        Law::kJointJerk,        Law::kJointTorque,   Law::kTorqueSpeed,
                                        Law::kContinuousTorque, Law::kReach,         Law::kSelfCollision};
  return kLimits.contains(v.law);
}

double Passed(const Violation& v) { return std::abs(v.value - v.limit) / std::max(std::abs(v.limit), 1e-9); }

}  // namespace

bool IsTooMuch(const Failure& failure) {
  static const std::set<FailureCode> kWhateverThePace = {
      FailureCode::kGait,        FailureCode::kPassiveJoint, FailureCode::kFreedoms,     FailureCode::kHeight,
      FailureCode::kNoSupport,   FailureCode::kNoFootholds,  FailureCode::kSearchBudget, FailureCode::kStartBlocked,
      FailureCode::kGoalBlocked, FailureCode::kWayBlocked,   FailureCode::kWayNotFound};
  return failure.kind == FailureKind::kInfeasible && !kWhateverThePace.contains(failure.code);
}

std::vector<Violation> BrokenLimits(const AuditReport& audit) {
  std::vector<Violation> broken;
  std::copy_if(audit.violations.begin(), audit.violations.end(), std::back_inserter(broken), IsLimit);
  std::stable_sort(broken.begin(), broken.end(),
                   [](const Violation& a, const Violation& b) { return Passed(a) > Passed(b); });
  const auto too_fast = [&](const std::string& where) {
    return std::any_of(broken.begin(), broken.end(),
                       [&](const Violation& v) { return v.law == Law::kJointVelocity && v.where == where; });
  };
  std::vector<Violation> causes,
      followers;  // a motor above its no-load speed has no torque, so its torque limit is only a consequence
  for (const Violation& v : broken) (v.law == Law::kTorqueSpeed && too_fast(v.where) ? followers : causes).push_back(v);
  causes.insert(causes.end(), followers.begin(), followers.end());
  return causes;
}

std::vector<Violation> Forbidding(const AuditReport& audit) {
  std::vector<Violation> forbidding = BrokenLimits(audit);
  std::copy_if(audit.violations.begin(), audit.violations.end(), std::back_inserter(forbidding),
               [](const Violation& v) { return !IsLimit(v); });
  return forbidding;
}

bool IsSound(const Result<PlannedWalk>& planned) {
  return planned && planned->motion.limit_violation < kSlightViolation && Forbidding(planned->audit).empty();
}

Failure ReasonForbidden(const PlannedWalk& planned) {
  const std::vector<Violation> forbidding = Forbidding(planned.audit);
  if (forbidding.empty()) {  // limits that are violated between the audit's samples
    std::string text;
    for (const std::string& warning : planned.motion.plan.warnings) text += (text.empty() ? "" : "; ") + warning;
    return {FailureKind::kInfeasible, FailureCode::kLimits, "PlanWalk", text, {AllowLimits()}};
  }
  const std::size_t limits = BrokenLimits(planned.audit).size();
  return {FailureKind::kInfeasible,
          limits > 0 ? FailureCode::kLimits : FailureCodeOf(forbidding.front().law),
          "PlanWalk",
          LimitText(forbidding.front()) + (limits > 1 ? fmt::format(" (worst of {} violated limits)", limits) : "") +
              (planned.motion.unfinished ? "; " + planned.motion.unfinished->message : ""),
          {AllowLimits()},
          forbidding.front()};
}

FailureCode ReasonRefused(const Result<PlannedWalk>& planned) {
  return planned ? ReasonForbidden(*planned).code : planned.failure().code;
}

std::string LimitText(const Violation& v) {
  if (v.law == Law::kSelfCollision) return fmt::format("{} collide at {:.2f} s", v.where, v.at_s);
  if (v.law == Law::kDynamics) {
    return fmt::format(
        "at {:.2f} s the contact forces cannot produce the motion: the residual is {:.3g} {}, the limit "
        "{:.2g}; the friction or the support area is too small",
        v.at_s, v.value, v.unit, v.limit);
  }
  if (v.law == Law::kFlight) {
    return fmt::format(
        "at {:.2f} s no foot is in contact, but the motion needs a {}: {:.3g} {} (limit {:.2g}); lower the speed or "
        "shorten the flight",
        v.at_s, v.where, v.value, v.unit, v.limit);
  }
  if (v.law == Law::kZmpSupport) {
    return fmt::format("the {} is {:.1f} mm outside the support polygon at {:.2f} s (limit {:.2g} mm)", v.where,
                       1e3 * v.value, v.at_s, 1e3 * v.limit);
  }
  if (v.law == Law::kBodyClearance)
    return fmt::format("'{}' is {:.1f} mm in the ground or an obstacle at {:.2f} s", v.where, -1e3 * v.value, v.at_s);
  if (!IsLimit(v)) {
    return fmt::format("the plan fails the check '{}': {}, {:.4g} {} at {:.2f} s (limit {:.4g})", LawName(v.law),
                       v.where, v.value, v.unit, v.at_s, v.limit);
  }
  const char* what = v.law == Law::kJointTorque         ? "needs"
                     : v.law == Law::kTorqueSpeed       ? "needs, at its present speed,"
                     : v.law == Law::kContinuousTorque  ? "needs a root mean square of"
                     : v.law == Law::kJointVelocity     ? "moves at"
                     : v.law == Law::kJointAcceleration ? "accelerates at"
                     : v.law == Law::kJointJerk         ? "changes its acceleration by"
                     : v.law == Law::kJointPosition     ? "is at"
                                                        : "must reach";
  return fmt::format("'{}' {} {:.4g} {} at {:.2f} s, {:.3g} {} past its limit of {:.4g}", v.where, what, v.value,
                     v.unit, v.at_s, std::abs(v.value - v.limit), v.unit, v.limit);
}

Suggestion AllowLimits() {
  return {"pipeline.allow_limits", "true", Certainty::kPlanned,
          "--set pipeline.allow_limits=true gives the plan in spite of violated limits"};
}

}  // namespace gaitwright
