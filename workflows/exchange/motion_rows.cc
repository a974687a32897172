// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/exchange/motion_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "kinematics/base/result.h"
#include "planning/plan/check_motion.h"
#include "planning/plan/sample_plan.h"
#include "planning/plan/steady_stretch.h"

namespace gaitwright {
namespace {

constexpr double kStepRounding = 1e-6;      // share of a step
constexpr double kUsualLowestRate = 200.0;  // [Hz]

void CheckRate(double rate_hz) {
  if (rate_hz >= kLowestRate && rate_hz <= kHighestRate) return;
  throw InvalidArgument(fmt::format("the rate is {} Hz; accepted: {} to {} Hz", rate_hz, kLowestRate, kHighestRate));
}

double Rounded(double rate_hz) {
  const double whole = std::round(rate_hz);
  return std::abs(rate_hz - whole) < 1e-9 * rate_hz ? whole : rate_hz;
}

FootSet ScheduledAt(const ContactSchedule& schedule, double time_s) {
  constexpr double kSame = 1e-9;  // [s]
  if (schedule.phases.empty()) return 0;
  return schedule.phases[static_cast<std::size_t>(PhaseAt(schedule, time_s + kSame))].stance;
}

void CheckLogFits(const RobotModel& model, const PlaybackLog& log) {
  if (log.samples.empty()) throw InvalidArgument("the log has no sample");
  const LogSample* before = nullptr;
  for (const LogSample& s : log.samples) {
    if (s.q.size() != model.nq() || s.v.size() != model.nv() || s.tau.size() != model.num_dofs()) {
      throw InvalidArgument(
          fmt::format("the log has {} joints; robot '{}' has {}", s.q.size() - 7, model.name, model.num_dofs()));
    }
    if (s.wrenches.size() > model.feet.size()) {
      throw InvalidArgument(
          fmt::format("the log has {} feet; robot '{}' has {}", s.wrenches.size(), model.name, model.feet.size()));
    }
    if (before != nullptr && !(s.time_s > before->time_s)) {
      throw InvalidArgument(
          fmt::format("the log has a sample at {} s after one at {} s; times must increase", s.time_s, before->time_s));
    }
    before = &s;
  }
}

MotionRows AllSamples(const PlaybackLog& log) {
  MotionRows rows;
  for (const LogSample& s : log.samples) {
    rows.time_s.push_back(s.time_s);
    rows.q.push_back(s.q);
    rows.v.push_back(s.v);
    rows.tau.push_back(s.tau);
    rows.contact.push_back(s.contact);
    rows.wrenches.push_back(s.wrenches);
  }
  return rows;
}

/// The row before a time and the fraction of the step to the next row.
struct Place {
  std::size_t row = 0;
  double share = 0.0;
  bool beyond = false;
};

Place PlaceOf(const std::vector<double>& times, double time_s) {
  const auto after = std::upper_bound(times.begin(), times.end(), time_s);
  const std::size_t last = times.size() - 1;
  constexpr double kSame = 1e-9;  // [s]
  if (after == times.begin()) return {0, 0.0, time_s < times.front() - kSame};
  const std::size_t row = static_cast<std::size_t>(after - times.begin()) - 1;
  if (row == last) return {last, 0.0, time_s > times.back() + kSame};
  const double step = times[row + 1] - times[row], share = (time_s - times[row]) / step;
  if (share > 1.0 - kStepRounding) return {row + 1, 0.0, false};
  return {row, share < kStepRounding ? 0.0 : share, false};
}

MotionRows RowsAt(const MotionPlan& plan, std::vector<double> times_s) {
  const WholeBodyTrajectory& motion = plan.whole_body;
  MotionRows rows;
  rows.time_s = std::move(times_s);
  WholeBodySample sample;
  for (const double time_s : rows.time_s) {
    SampleWholeBody(motion, time_s, sample);
    rows.q.push_back(sample.q);
    rows.v.push_back(sample.v);
    rows.a.push_back(sample.a);
    if (!motion.tau.empty()) rows.tau.push_back(sample.tau);
    if (!motion.wrenches.empty()) rows.wrenches.push_back(sample.wrenches);
    rows.contact.push_back(ScheduledAt(plan.schedule, time_s));
  }
  return rows;
}

}  // namespace

void BlendPosture(const VectorX& q0, const VectorX& q1, double u, VectorX& q) {
  q = (1.0 - u) * q0 + u * q1;
  const Quaternion R0(q0[6], q0[3], q0[4], q0[5]), R1(q1[6], q1[3], q1[4], q1[5]);
  q.segment<4>(3) = R0.slerp(u, R1).coeffs();
}

std::vector<double> TimesAtRate(double start_s, double end_s, double rate_hz, LastTime last) {
  CheckRate(rate_hz);
  const double rate = Rounded(rate_hz), steps = (end_s - start_s) * rate;
  const auto most = static_cast<long>(last == LastTime::kBeforeEnd ? std::floor(steps + kStepRounding)
                                                                   : std::ceil(steps - kStepRounding));
  std::vector<double> times;
  for (long k = 0; k <= most; ++k) times.push_back(start_s + static_cast<double>(k) / rate);
  return times;
}

double UsualRate(const MotionPlan& plan) {
  const double own = plan.whole_body.step_s > 0.0 ? 1.0 / plan.whole_body.step_s : kUsualLowestRate;
  const double rate = own < kUsualLowestRate ? own * std::ceil(kUsualLowestRate / own - 1e-9) : own;
  return Rounded(std::min(rate, kHighestRate));
}

MotionRows RowsOfPlan(const RobotModel& model, const MotionPlan& plan, double rate_hz) {
  CheckMotion(model, plan.whole_body);
  const WholeBodyTrajectory& motion = plan.whole_body;
  return RowsAt(plan, TimesAtRate(motion.start_s, motion.end_s(), rate_hz, LastTime::kBehindEnd));
}

CycleRows RowsOfCycle(const RobotModel& model, const MotionPlan& plan, double rate_hz) {
  CheckMotion(model, plan.whole_body);
  CheckRate(rate_hz);
  SteadyStretch longest;
  for (std::size_t part = 0; part < plan.parts.size(); ++part) {
    if (const auto stretch = SteadyStretchOf(plan, part); stretch && stretch->cycles > longest.cycles)
      longest = *stretch;
  }
  if (longest.cycles == 0) {
    throw InvalidArgument(
        "no cycle of this plan repeats itself: walk farther, or plan with --set trajectory.cycles=periodic");
  }
  CycleRows best;
  double start_s = 0.0;
  for (int i = 0; i < longest.cycles; ++i) {
    const double at_s = longest.start_s + i * longest.cycle_s;
    const Seam seam = SeamBetween(plan, at_s, plan, at_s + longest.cycle_s);
    if (i > 0 && seam.joints >= best.joints) continue;
    best.joints = seam.joints;
    best.joint_rates = seam.joint_rates;
    start_s = at_s;
  }
  const double frames = std::max(1.0, std::round(rate_hz * longest.cycle_s));
  std::vector<double> times_s;
  for (int k = 0; k <= static_cast<int>(frames); ++k) times_s.push_back(start_s + longest.cycle_s * k / frames);
  best.rows = RowsAt(plan, std::move(times_s));
  best.rate_hz = frames / longest.cycle_s;
  return best;
}

MotionRows RowsOfLog(const RobotModel& model, const PlaybackLog& log, double rate_hz) {
  CheckLogFits(model, log);
  CheckRate(rate_hz);
  MotionRows all = AllSamples(log);
  if (std::abs(rate_hz - log.log_rate_hz) <= 1e-9 * log.log_rate_hz) return all;
  if (rate_hz > log.log_rate_hz) {
    throw InvalidArgument(
        fmt::format("the rate of {} Hz is above the log's rate of {} Hz; use {} Hz or less, or play again with a "
                    "higher --log-rate-hz",
                    rate_hz, log.log_rate_hz, log.log_rate_hz));
  }
  MotionRows rows;
  rows.time_s = TimesAtRate(all.time_s.front(), all.time_s.back(), rate_hz);
  RowSample sample;
  for (const double time_s : rows.time_s) {
    SampleRows(all, time_s, sample);
    rows.q.push_back(sample.q);
    rows.v.push_back(sample.v);
    rows.tau.push_back(sample.tau);
    rows.contact.push_back(sample.contact);
    rows.wrenches.push_back(sample.wrenches);
  }
  return rows;
}

void SampleRows(const MotionRows& rows, double time_s, RowSample& sample) {
  const Place at = PlaceOf(rows.time_s, time_s);
  const std::size_t left = at.row, right = at.share > 0.0 ? at.row + 1 : at.row;
  const auto linear = [&](const auto& left_value, const auto& right_value) {
    return (1.0 - at.share) * left_value + at.share * right_value;
  };
  sample.q = rows.q[left];
  sample.v = rows.v[left];
  if (right != left) {
    BlendPosture(rows.q[left], rows.q[right], at.share, sample.q);
    sample.v = linear(rows.v[left], rows.v[right]);
  }
  if (at.beyond) sample.v *= 0.0;  // NaN stays NaN
  sample.tau.resize(0);
  if (!rows.tau.empty()) sample.tau = linear(rows.tau[left], rows.tau[right]);
  sample.contact = rows.contact.empty() ? 0 : rows.contact[left];
  sample.wrenches.resize(rows.wrenches.empty() ? 0 : rows.wrenches[left].size());
  for (std::size_t f = 0; f < sample.wrenches.size(); ++f) {
    const ContactWrench &w0 = rows.wrenches[left][f], &w1 = rows.wrenches[right][f];
    sample.wrenches[f] = {linear(w0.force_W, w1.force_W), linear(w0.moment_W, w1.moment_W)};
  }
}

}  // namespace gaitwright
