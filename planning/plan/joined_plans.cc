// SPDX-License-Identifier: BSD-3-Clause
#include "planning/plan/joined_plans.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>
#include <utility>

#include "kinematics/spatial/rotation.h"
#include "planning/plan/carried_plan.h"
#include "planning/plan/closed_seam_internal.h"

namespace gaitwright {
namespace {

constexpr double kTime = 1e-6;  // tolerance of the times of plans [s]

/// Index of the row at a time.
std::size_t RowAt(const WholeBodyTrajectory& w, double time_s) {
  const double row = std::round((time_s - w.start_s) / w.step_s);
  if (!(row >= 0.0 && row < w.size()) || std::abs(w.start_s + row * w.step_s - time_s) > kTime) {
    throw InvalidArgument(fmt::format("the plan has no row at {} s; its rows are from {} to {} s in steps of {} s",
                                      time_s, w.start_s, w.end_s(), w.step_s));
  }
  return static_cast<std::size_t>(row);
}

double TimeOf(const WholeBodyTrajectory& w, std::size_t row) { return w.start_s + static_cast<double>(row) * w.step_s; }

/// Joins the rows of one column up to an index and the rows of another column after an index.
template <class T>
void JoinColumn(std::vector<T>& column, std::size_t last, const std::vector<T>& then, std::size_t after) {
  if (column.empty() || then.empty()) return column.clear();
  column.resize(last + 1);
  column.insert(column.end(), then.begin() + static_cast<std::ptrdiff_t>(after) + 1, then.end());
}

template <class T>
void DropRows(std::vector<T>& column, std::size_t count) {
  if (!column.empty()) column.erase(column.begin(), column.begin() + static_cast<std::ptrdiff_t>(count));
}

/// Applies an action to each pair of columns of two plans.
template <class Action>
void ForColumns(MotionPlan& plan, const MotionPlan& other, Action act) {
  act(plan.whole_body.q, other.whole_body.q);
  act(plan.whole_body.v, other.whole_body.v);
  act(plan.whole_body.a, other.whole_body.a);
  act(plan.whole_body.tau, other.whole_body.tau);
  act(plan.whole_body.wrenches, other.whole_body.wrenches);
  act(plan.centroidal.p_WC, other.centroidal.p_WC);
  act(plan.centroidal.v_WC, other.centroidal.v_WC);
  act(plan.centroidal.a_WC, other.centroidal.a_WC);
  act(plan.centroidal.p_WZ, other.centroidal.p_WZ);
}

void AddPhases(const ContactSchedule& schedule, double from_s, double to_s, ContactSchedule& to) {
  for (ContactPhase phase : schedule.phases) {
    phase.start_s = std::max(phase.start_s, from_s);
    phase.end_s = std::min(phase.end_s, to_s);
    if (phase.end_s - phase.start_s < kTime) continue;
    if (to.phases.empty()) {
      to.phases.push_back(phase);
    } else if (to.phases.back().stance == phase.stance) {
      to.phases.back().end_s = phase.end_s;
    } else {
      phase.start_s = to.phases.back().end_s;
      to.phases.push_back(phase);
    }
  }
}

/// The part of `part` between two times; its extent becomes its duration.
MotionPart Clipped(MotionPart part, double from_s, double to_s) {
  if (part.start_s >= from_s - kTime && part.end_s <= to_s + kTime) return part;
  part.start_s = std::max(part.start_s, from_s);
  part.end_s = std::min(part.end_s, to_s);
  part.command.extent = WalkCommand::Extent::kDuration;
  part.command.duration_s = part.end_s - part.start_s;
  part.command.distance_m = 0.0;
  part.command.steps = 0;
  return part;
}

/// Whether two parts are the halves of one part that was cut in two.
bool GoesOn(const MotionPart& first, const MotionPart& second) {
  const WalkCommand &a = first.command, &b = second.command;
  const bool lasts = a.extent == WalkCommand::Extent::kDuration && b.extent == a.extent;
  return lasts && first.gait == second.gait && a.speed_m_s == b.speed_m_s &&
         a.lateral_speed_m_s == b.lateral_speed_m_s && a.yaw_rate_rad_s == b.yaw_rate_rad_s;
}

void JoinParts(MotionPlan& plan, double at_s, const MotionPlan& then) {
  std::vector<MotionPart> parts;
  for (const MotionPart& part : plan.parts) {
    if (part.start_s >= at_s - kTime) continue;
    parts.push_back(Clipped(part, part.start_s, at_s));
    if (part.end_s > at_s + kTime) parts.back().goal = BaseInPlan(plan.whole_body.q[RowAt(plan.whole_body, at_s)]);
  }
  for (const MotionPart& part : then.parts) {
    if (part.end_s <= at_s + kTime) continue;
    const MotionPart next = Clipped(part, at_s, part.end_s);
    if (!parts.empty() && GoesOn(parts.back(), next)) {
      parts.back().end_s = next.end_s;
      parts.back().goal = next.goal;
      parts.back().command.duration_s = next.end_s - parts.back().start_s;
    } else {
      parts.push_back(next);
    }
  }
  plan.parts = std::move(parts);
  for (const Adjustment& adjustment : then.adjustments) {
    if (std::find(plan.adjustments.begin(), plan.adjustments.end(), adjustment) == plan.adjustments.end())
      plan.adjustments.push_back(adjustment);
  }
  plan.goal = then.goal;
}

void JoinFootholds(FootstepPlan& plan, double at_s, const FootstepPlan& then) {
  std::erase_if(plan.footholds, [&](const Foothold& f) { return f.touchdown_s >= at_s - kTime; });
  for (const Foothold& next : then.footholds) {
    if (next.liftoff_s <= at_s + kTime) continue;
    const auto stands = std::find_if(plan.footholds.begin(), plan.footholds.end(), [&](const Foothold& f) {
      return f.foot == next.foot && f.liftoff_s >= at_s - kTime;
    });
    if (next.touchdown_s > at_s + kTime || stands == plan.footholds.end()) {
      plan.footholds.push_back(next);
      continue;
    }
    stands->liftoff_s = next.liftoff_s;
    stands->heel_off_s = next.heel_off_s;
    stands->roll_W = next.X_WF.translation() + next.roll_W - stands->X_WF.translation();
  }
  SortFootholds(plan);
}

void JoinSwings(std::vector<SwingTrajectory>& swings, double at_s, const std::vector<SwingTrajectory>& then) {
  std::erase_if(swings, [&](const SwingTrajectory& s) { return s.start_s >= at_s - kTime; });
  for (const SwingTrajectory& next : then) {
    if (next.end_s <= at_s + kTime) continue;
    const auto begun = std::find_if(swings.begin(), swings.end(), [&](const SwingTrajectory& s) {
      return s.foot == next.foot && s.end_s > at_s + kTime;
    });
    if (next.start_s >= at_s - kTime || begun == swings.end()) {
      swings.push_back(next);
      continue;
    }
    begun->end_s = next.end_s;
    begun->X_WF_end = next.X_WF_end;
  }
  std::stable_sort(swings.begin(), swings.end(), [](const SwingTrajectory& a, const SwingTrajectory& b) {
    return std::tie(a.start_s, a.foot) < std::tie(b.start_s, b.foot);
  });
}

FootSet StanceAt(const MotionPlan& plan, double time_s) {
  return plan.schedule.phases[static_cast<std::size_t>(PhaseAt(plan.schedule, time_s))].stance;
}

/// Pendulum frequency for the mean height of the two, weighted by their durations.
double MeanOmega(double one_rad_s, double one_s, double other_rad_s, double other_s) {
  if (one_rad_s == other_rad_s) return one_rad_s;
  const auto height = [](double omega_rad_s) { return 1.0 / (omega_rad_s * omega_rad_s); };
  return std::sqrt((one_s + other_s) / (one_s * height(one_rad_s) + other_s * height(other_rad_s)));
}

Failure Misfit(const std::string& why) {
  return {FailureKind::kBadInput, FailureCode::kMisfit, "JoinedPlans", why, {}};
}

std::optional<Failure> ReasonNotJoined(const MotionPlan& before, double before_s, const MotionPlan& after,
                                       double after_s) {
  if (before.robot_hash != after.robot_hash) return Misfit("the motions are of different robots");
  if (std::abs(before.whole_body.step_s - after.whole_body.step_s) > 1e-9)
    return Misfit(fmt::format("the motions have different time steps, {} and {} s", before.whole_body.step_s,
                              after.whole_body.step_s));
  if (!SameStance(before, before_s, after, after_s)) {
    return Misfit(fmt::format("at {} s of the first and {} s of the second motion, different feet are on the ground",
                              before_s, after_s));
  }
  return std::nullopt;
}

}  // namespace

Seam SeamBetween(const MotionPlan& before, double before_s, const MotionPlan& after, double after_s) {
  const WholeBodyTrajectory &a = before.whole_body, &b = after.whole_body;
  const std::size_t ka = RowAt(a, before_s), kb = RowAt(b, after_s);
  if (a.q[ka].size() != b.q[kb].size()) throw InvalidArgument("the plans are of different robots");
  const Pose X = PoseOf(BaseInPlan(a.q[ka])) * PoseOf(BaseInPlan(b.q[kb])).inverse();
  const VectorX q = CarriedState(X, b.q[kb]), v = CarriedRates(X, b.v[kb]);
  const Vector3 up_a = BaseRotation(a.q[ka]).col(2), up_b = BaseRotation(q).col(2);
  const auto largest = [](const VectorX& x) { return x.size() == 0 ? 0.0 : x.cwiseAbs().maxCoeff(); };
  Seam seam;
  seam.height_m = std::abs(q[2] - a.q[ka][2]);
  seam.tilt_rad = std::atan2(up_a.cross(up_b).norm(), up_a.dot(up_b));
  seam.joints = largest(q.tail(q.size() - 7) - a.q[ka].tail(q.size() - 7));
  seam.base_rates = largest(v.head<6>() - a.v[ka].head<6>());
  seam.joint_rates = largest(v.tail(v.size() - 6) - a.v[ka].tail(v.size() - 6));
  return seam;
}

bool SameStance(const MotionPlan& one, double one_s, const MotionPlan& other, double other_s) {
  const auto within = [](const MotionPlan& plan, double time_s) {
    return time_s >= plan.whole_body.start_s && time_s <= plan.whole_body.end_s();
  };
  for (const double side : {-kTime, kTime}) {
    if (!within(one, one_s + side) || !within(other, other_s + side)) continue;
    if (StanceAt(one, one_s + side) != StanceAt(other, other_s + side)) return false;
  }
  return true;
}

MotionPlan PlanFrom(MotionPlan plan, double from_s) {
  const std::size_t row = RowAt(plan.whole_body, from_s);
  const double start_s = TimeOf(plan.whole_body, row);
  ForColumns(plan, plan, [&](auto& column, const auto&) { DropRows(column, row); });
  plan.whole_body.start_s = plan.centroidal.start_s = start_s;
  ContactSchedule schedule;
  AddPhases(plan.schedule, start_s, plan.schedule.end_s(), schedule);
  plan.schedule = std::move(schedule);
  std::erase_if(plan.footsteps.footholds, [&](const Foothold& f) { return f.liftoff_s <= start_s + kTime; });
  for (Foothold& foothold : plan.footsteps.footholds) {
    foothold.touchdown_s = std::max(foothold.touchdown_s, start_s);
    if (foothold.heel_off_s) foothold.heel_off_s = std::max(*foothold.heel_off_s, start_s);
  }
  SortFootholds(plan.footsteps);
  std::erase_if(plan.swings, [&](const SwingTrajectory& s) { return s.end_s <= start_s + kTime; });
  std::erase_if(plan.gates, [&](const PlanGate& gate) { return gate.at_s <= start_s + kTime; });
  std::erase_if(plan.parts, [&](const MotionPart& part) { return part.end_s <= start_s + kTime; });
  for (MotionPart& part : plan.parts) part = Clipped(part, start_s, part.end_s);
  return plan;
}

Result<MotionPlan> JoinedPlans(const MotionPlan& before, double before_s, const MotionPlan& after, double after_s) {
  if (auto failure = ReasonNotJoined(before, before_s, after, after_s)) return *failure;
  const std::size_t ka = RowAt(before.whole_body, before_s), kb = RowAt(after.whole_body, after_s);
  const double at_s = TimeOf(before.whole_body, ka), later_s = at_s - TimeOf(after.whole_body, kb);
  const Pose X = PoseOf(BaseInPlan(before.whole_body.q[ka])) * PoseOf(BaseInPlan(after.whole_body.q[kb])).inverse();
  const MotionPlan then = CarriedPlan(X, later_s, after);
  MotionPlan joined = before;
  JoinParts(joined, at_s, then);
  CloseSeam(joined, ka, then, kb);
  ForColumns(joined, then, [&](auto& column, const auto& next) { JoinColumn(column, ka, next, kb); });
  joined.centroidal.omega_rad_s = MeanOmega(before.centroidal.omega_rad_s, at_s - before.whole_body.start_s,
                                            then.centroidal.omega_rad_s, then.whole_body.end_s() - at_s);
  ContactSchedule schedule;
  AddPhases(before.schedule, before.schedule.start_s(), at_s, schedule);
  AddPhases(then.schedule, at_s, then.schedule.end_s(), schedule);
  joined.schedule = std::move(schedule);
  JoinFootholds(joined.footsteps, at_s, then.footsteps);
  JoinSwings(joined.swings, at_s, then.swings);
  std::erase_if(joined.gates, [&](const PlanGate& gate) { return gate.at_s > at_s + kTime; });
  for (const PlanGate& gate : then.gates) {
    if (gate.at_s > at_s + kTime) joined.gates.push_back(gate);
  }
  return joined;
}

}  // namespace gaitwright
