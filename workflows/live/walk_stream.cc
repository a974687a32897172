// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/live/walk_stream.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

#include "kinematics/spatial/rotation.h"
#include "planning/plan/carried_plan.h"
#include "planning/plan/sample_plan.h"

namespace gaitwright {
namespace {

constexpr double kTime = 1e-6;

/// Appends rows at rest after the last row of a motion, up to a time.
void Rest(MotionPlan& plan, double until_s) {
  WholeBodyTrajectory& w = plan.whole_body;
  CentroidalTrajectory& c = plan.centroidal;
  const auto repeat = [](auto& column) {
    if (!column.empty()) column.push_back(column.back());
  };
  while (w.end_s() < until_s - kTime) {
    repeat(w.q);
    repeat(w.v);
    repeat(w.a);
    repeat(w.tau);
    repeat(w.wrenches);
    repeat(c.p_WC);
    repeat(c.v_WC);
    repeat(c.a_WC);
    repeat(c.p_WZ);
  }
  const double end_s = w.end_s();
  for (Foothold& foothold : plan.footsteps.footholds) {
    if (foothold.liftoff_s >= plan.schedule.end_s() - kTime) foothold.liftoff_s = end_s;
  }
  plan.schedule.phases.back().end_s = end_s;
  plan.parts.back().end_s = end_s;
}

/// Largest posture difference that is blended at a seam, in 0.4 s; a change of body height causes such differences.
constexpr Seam kMostAtOnce = {
    .height_m = 0.03, .tilt_rad = 0.05, .joints = 0.6, .base_rates = 0.15, .joint_rates = 1.5};

Failure TooFarApart(const Seam& seam) {
  return {FailureKind::kInfeasible,
          FailureCode::kMisfit,
          "WalkStream",
          fmt::format("this speed needs another posture (base {:.3g} m higher or lower, joints moved by up to {:.3g} "
                      "rad or m), which cannot be reached while walking",
                      seam.height_m, seam.joints),
          {"stop first"}};
}

Failure NotFromHere() {
  return {FailureKind::kBadInput,
          FailureCode::kMisfit,
          "WalkStream",
          "the plan does not start from the robot's present motion",
          {}};
}

}  // namespace

WalkStream::WalkStream(const MotionPlan& stand) : plan_(stand) {
  const double start_s = plan_.whole_body.start_s;
  WholeBodyTrajectory& w = plan_.whole_body;
  CentroidalTrajectory& c = plan_.centroidal;
  const auto first = [](auto& column) {
    if (!column.empty()) column.resize(1);
  };
  first(w.q), first(w.v), first(w.a), first(w.tau), first(w.wrenches);
  first(c.p_WC), first(c.v_WC), first(c.a_WC), first(c.p_WZ);
  const int num_feet = plan_.parts.front().gait.num_feet();
  plan_.schedule.phases = {{start_s, start_s, AllFeet(num_feet)}};
  MotionPart part;
  part.gait = StandingGait(num_feet);
  part.goal = BaseInPlan(w.q[0]);
  part.start_s = part.end_s = start_s;
  part.command.extent = WalkCommand::Extent::kDuration;
  plan_.parts = {part};
  plan_.goal = part.goal;
  plan_.swings.clear();
  std::erase_if(plan_.footsteps.footholds, [&](const Foothold& f) { return f.touchdown_s > start_s + kTime; });
  for (Foothold& foothold : plan_.footsteps.footholds) {
    foothold.liftoff_s = start_s;
    foothold.heel_off_s.reset();
  }
  Rest(plan_, start_s + 2.0 * w.step_s);
}

double WalkStream::MomentFrom(double earliest_s) const {
  if (steady_.cycles == 0) return std::max(earliest_s, plan_.whole_body.end_s());
  const double cycles = std::ceil((earliest_s - steady_.start_s - kTime) / steady_.cycle_s);
  return steady_.start_s + std::clamp(cycles, 0.0, static_cast<double>(steady_.cycles)) * steady_.cycle_s;
}

double WalkStream::heading_rad() const {
  WholeBodySample sample;
  SampleWholeBody(plan_.whole_body, steady_.cycles == 0 ? plan_.whole_body.end_s() : steady_.start_s, sample);
  return YawOf(BaseRotation(sample.q));
}

/// Continues standing up to a time. Only the last part of a long stand is kept, since its duration does not matter.
void WalkStream::Stand(double until_s) {
  constexpr double kLong = 1.0;
  const double step_s = plan_.whole_body.step_s, end_s = plan_.whole_body.end_s();
  if (until_s - end_s > kLong) {
    const double steps = std::floor((until_s - kLong - end_s) / step_s);
    plan_ = CarriedPlan(Pose::Identity(), steps * step_s, PlanFrom(std::move(plan_), end_s - step_s));
  }
  Rest(plan_, until_s);
}

std::optional<Failure> WalkStream::GoOver(double earliest_s, const WalkPace& pace, const PacePlan& next) {
  if (next.before.has_value() == stops()) return NotFromHere();
  double from_s = next.plan.whole_body.start_s;
  if (stops()) {
    Stand(earliest_s);
  } else if (const auto same = SameMoment(plan_, MomentFrom(earliest_s), next.plan, *next.before)) {
    from_s = *same;
  } else {
    return NotFromHere();
  }
  const double at_s = MomentFrom(earliest_s);
  if (SameStance(plan_, at_s, next.plan, from_s)) {
    const Seam seam = SeamBetween(plan_, at_s, next.plan, from_s);
    if (!Within(seam, kMostAtOnce)) return TooFarApart(seam);
  }
  Result<MotionPlan> joined = JoinedPlans(plan_, at_s, next.plan, from_s);
  if (!joined) return joined.failure();
  plan_ = std::move(*joined);
  pace_ = pace;
  source_ = next;
  steady_ = next.stretch;
  steady_.start_s += at_s - from_s;
  return std::nullopt;
}

std::optional<Failure> WalkStream::Stop(double earliest_s) {
  if (stops()) return std::nullopt;
  const double at_s = MomentFrom(earliest_s);
  Result<MotionPlan> joined = JoinedPlans(plan_, at_s, source_->plan, LastLikeStart(source_->plan, source_->stretch));
  if (!joined) return joined.failure();
  plan_ = std::move(*joined);
  pace_ = {.gait = kStanding};
  source_.reset();
  steady_.cycles = 0;
  return std::nullopt;
}

bool WalkStream::GoOn(double until_s) {
  if (stops() || steady_.end_s() >= until_s - kTime) return false;
  while (steady_.end_s() < until_s - kTime) {
    Result<MotionPlan> joined = JoinedPlans(plan_, steady_.end_s(), source_->plan, source_->stretch.start_s);
    if (!joined) throw std::logic_error("a steady part is not periodic: " + joined.failure().message);
    plan_ = std::move(*joined);
    steady_.cycles += source_->stretch.cycles;
  }
  return true;
}

void WalkStream::Forget(double before_s) {
  const WholeBodyTrajectory& w = plan_.whole_body;
  const double rows = std::min(std::floor((before_s - w.start_s) / w.step_s), w.size() - 3.0);
  if (rows < 1.0) return;
  plan_ = PlanFrom(std::move(plan_), w.start_s + rows * w.step_s);
  if (steady_.cycles == 0) return;
  const double gone = std::floor((plan_.whole_body.start_s - steady_.start_s) / steady_.cycle_s);
  if (gone < 1.0) return;
  steady_.start_s += gone * steady_.cycle_s;
  steady_.cycles -= static_cast<int>(gone);
}

void WalkStream::Shift(const Vector3& by_W) {
  Pose X = Pose::Identity();
  X.translation() = by_W;
  plan_ = CarriedPlan(X, 0.0, std::move(plan_));
}

}  // namespace gaitwright
