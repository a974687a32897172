// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "optimisation/pipeline/plan_posture.h"
#include "optimisation/search/refuse_walk.h"
#include "planning/audit/audit.h"
#include "workflows/words/plan_tasks_internal.h"

namespace gaitwright::tasks {
namespace {

/// Whether a check does not depend on speed, so that a slower motion does not help.
bool IsOfPlace(Law law) {
  constexpr std::array<Law, 5> kOfPlace = {Law::kJointPosition, Law::kReach, Law::kSelfCollision, Law::kFootClearance,
                                           Law::kBodyClearance};
  return std::find(kOfPlace.begin(), kOfPlace.end(), law) != kOfPlace.end();
}

/// Tries one size at decreasing speeds.
Result<PostureMotion> Try(const RobotModel& model, const PostureMotion& motion, const MotionOptions& options) {
  constexpr std::array<double, 5> kStretches = {1.0, 1.4, 2.0, 2.8, 4.0};
  Failure failure;
  for (const double stretch : kStretches) {
    const PostureMotion slower = Stretched(motion, stretch, options.pipeline.grid_step_s);
    const Result<MotionPlan> plan = PlanPosture(model, slower, options);
    if (!plan) return plan.failure();
    const Result<AuditReport> audit = Audit(model, *plan, {});
    if (!audit) return audit.failure();
    if (audit->pass()) return slower;
    failure = ReasonBroken(motion.name, *audit);
    if (IsOfPlace(failure.violation->law)) break;
  }
  return failure;
}

}  // namespace

double LargestBelow(const std::function<bool(double size)>& is_feasible, double size) {
  double largest = 0.0, too_large = size;
  for (int k = 0; k < 5; ++k) {
    const double middle = 0.5 * (largest + too_large);
    (is_feasible(middle) ? largest : too_large) = middle;
  }
  return largest;
}

Failure ReasonBroken(const std::string& what, const AuditReport& audit) {
  const std::vector<Violation> forbidding = Forbidding(audit);
  const Violation& worst = forbidding.empty() ? audit.violations.front() : forbidding.front();
  return {FailureKind::kInfeasible,
          FailureCodeOf(worst.law),
          "PlanTasks",
          fmt::format("'{}' fails the check '{}': {}", what, LawName(worst.law), LimitText(worst)),
          {},
          worst};
}

Result<PostureMotion> PostureWithin(const RobotModel& model, const MotionBySize& motion, const Sizes& sizes,
                                    const MotionOptions& options) {
  std::optional<Failure> first;
  for (const double size : sizes.tried) {
    const Result<PostureMotion> made = motion(size);
    if (!made) return made.failure();
    Result<PostureMotion> passing = Try(model, *made, options);
    if (passing) return passing;
    if (!first) first = passing.failure();
  }
  first->stage = "PlanTasks";
  if (!sizes.asked) return *first;
  const auto is_feasible = [&](double size) {
    const Result<PostureMotion> made = motion(size);
    return made && Try(model, *made, options);
  };
  const double largest = LargestBelow(is_feasible, sizes.tried.front());
  if (largest > 0.0) {
    first->suggestions = {
        fmt::format("the largest {} that robot '{}' can do here is about {:.2g}", sizes.name, model.name, largest)};
  }
  return *first;
}

void StayOn(double duration_s, MotionPlan& plan) {
  WholeBodyTrajectory& w = plan.whole_body;
  CentroidalTrajectory& c = plan.centroidal;
  const double from_s = w.end_s();
  const long rows = std::max(1L, std::lround(duration_s / w.step_s));
  const auto still = [](const VectorX& x) { return VectorX(VectorX::Zero(x.size())); };
  for (long k = 0; k < rows; ++k) {
    w.q.push_back(w.q.back());
    w.v.push_back(still(w.v.back()));
    w.a.push_back(still(w.a.back()));
    w.tau.push_back(w.tau.back());
    w.wrenches.push_back(w.wrenches.back());
    c.p_WC.push_back(c.p_WC.back());
    c.v_WC.emplace_back(Vector3::Zero());
    c.a_WC.emplace_back(Vector3::Zero());
    c.p_WZ.push_back(c.p_WZ.back());
  }
  for (Foothold& foothold : plan.footsteps.footholds) {
    if (foothold.liftoff_s == plan.schedule.phases.back().end_s) foothold.liftoff_s = w.end_s();
  }
  plan.schedule.phases.back().end_s = w.end_s();
  MotionPart part;
  part.gait = StandingGait(static_cast<int>(plan.parts.front().gait.num_feet()));
  part.command.extent = WalkCommand::Extent::kDuration;
  part.command.duration_s = w.end_s() - from_s;
  part.goal = plan.goal;
  part.start_s = from_s;
  part.end_s = w.end_s();
  plan.parts.push_back(part);
}

}  // namespace gaitwright::tasks
