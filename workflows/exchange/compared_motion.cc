// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/exchange/compared_motion.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "kinematics/base/non_finite.h"
#include "kinematics/base/options.h"
#include "kinematics/base/result.h"
#include "planning/plan/sample_plan.h"
#include "playback/score/contact_timing.h"
#include "workflows/exchange/check_motion_table.h"

namespace gaitwright {
namespace {

/// Intervals in which a foot is on the ground; contacts change halfway between two rows.
std::vector<ContactInterval> IntervalsOfRows(const MotionRows& rows, int foot) {
  std::vector<ContactInterval> intervals;
  const std::size_t n = rows.contact.size();
  const auto edge = [&](std::size_t k) { return 0.5 * (rows.time_s[k - 1] + rows.time_s[k]); };
  for (std::size_t k = 0; k < n; ++k) {
    const bool stands = Contains(rows.contact[k], foot), stood = k > 0 && Contains(rows.contact[k - 1], foot);
    if (stands && !stood) intervals.push_back({k == 0 ? rows.time_s[0] : edge(k), rows.time_s[n - 1]});
    if (!stands && stood) intervals.back().end_s = edge(k);
  }
  return intervals;
}

/// Weights of the differences before and after a row, whose weighted sum is the rate there [1/s].
struct RateWeights {
  double before = 0.0, after = 0.0;
};

/// Weights of the parabola through three rows, or of the line through two rows at an end and beside missing rows.
RateWeights WeightsAt(const std::vector<double>& t, double longest_step_s, std::size_t k) {
  const double before = k > 0 ? t[k] - t[k - 1] : INFINITY, after = k + 1 < t.size() ? t[k + 1] - t[k] : INFINITY;
  const bool has_before = std::isfinite(before) && before <= longest_step_s,
             has_after = std::isfinite(after) && after <= longest_step_s;
  if (has_before && has_after) return {after / before / (before + after), before / after / (before + after)};
  return {has_before ? 1.0 / before : 0.0, has_after ? 1.0 / after : 0.0};
}

/// Rate of q at a row; NaN for a row without a neighbour.
VectorX RateAt(const std::vector<double>& t, double longest_step_s, const std::vector<VectorX>& q, std::size_t k) {
  const RateWeights weights = WeightsAt(t, longest_step_s, k);
  const bool alone = weights.before == 0.0 && weights.after == 0.0;
  VectorX rate = VectorX::Constant(q[k].size(), alone ? kNaN : 0.0);
  if (weights.before != 0.0) rate += weights.before * (q[k] - q[k - 1]);
  if (weights.after != 0.0) rate += weights.after * (q[k + 1] - q[k]);
  return rate;
}

double GainAt(const std::vector<double>& t, double longest_step_s, std::size_t k) {
  const RateWeights weights = WeightsAt(t, longest_step_s, k);
  return std::hypot(weights.before, weights.before - weights.after, weights.after);
}

void CheckTable(const RobotModel& model, const MotionTable& table) {
  if (table.time_s.empty()) throw InvalidArgument("has no row");
  for (std::size_t k = 1; k < table.time_s.size(); ++k) {
    if (table.time_s[k] > table.time_s[k - 1]) continue;
    throw InvalidArgument(fmt::format("the time {} s of row {} does not come after {} s; times must rise",
                                      table.time_s[k], k + 1, table.time_s[k - 1]));
  }
  if (table.q.size() != table.time_s.size() || table.q.front().size() != model.num_dofs())
    throw InvalidArgument(fmt::format("does not have a position of each joint of robot '{}'", model.name));
}

/// The joint speeds in a row: those in the file; missing ones from the positions, if these are known.
VectorX SpeedsAt(const RobotModel& model, const MotionTable& table, double longest_step_s, std::size_t k) {
  VectorX v = table.v.empty() ? VectorX::Constant(model.num_dofs(), kNaN) : table.v[k];
  if (v.allFinite()) return v;
  const VectorX derived = RateAt(table.time_s, longest_step_s, table.q, k);
  for (Eigen::Index d = 0; d < v.size(); ++d) {
    if (std::isfinite(v[d])) continue;
    v[d] = derived[d];
    if (!(std::abs(v[d]) > kLargestDerived)) continue;
    throw InvalidArgument(
        fmt::format("the computed speed of joint '{}' is {:.3g} in row {} ({:.9g} s), which is not plausible: its "
                    "position jumps there",
                    model.dof_names[static_cast<std::size_t>(d)], v[d], k + 1, table.time_s[k]));
  }
  return v;
}

/// Notes missing rows of a motion that is measured at uniform steps.
void WatchGaps(ComparedMotion& motion) {
  motion.longest_step_s = LongestStep(motion.rows.time_s);
  motion.gaps = GapsOf(motion.rows.time_s, motion.longest_step_s);
  if (!motion.gaps.empty())
    motion.notes.push_back(
        fmt::format("'{}', {}; nothing is compared in that gap", motion.name, MissingRowsText(motion.rows.time_s)));
}

/// Notes on computed data, unused columns and missing data.
std::vector<std::string> NotesOf(const RobotModel& model, const MotionTable& table, const std::string& name) {
  std::vector<std::string> notes, lacking;
  for (int d = 0; d < model.num_dofs(); ++d) {
    if (!std::isfinite(table.q.front()[d])) lacking.push_back(model.dof_names[static_cast<std::size_t>(d)]);
  }
  if (!lacking.empty()) {
    notes.push_back(
        fmt::format("'{}' lacks {} of {} joints: {}; the other joints are compared, but not the centre of mass", name,
                    lacking.size(), model.num_dofs(), QuotedList(lacking)));
  }
  for (const DerivedPart& part : table.derived) notes.push_back(fmt::format("'{}', {}: {}", name, part.what, part.how));
  if (!table.unused_columns.empty())
    notes.push_back(fmt::format("'{}', columns that are not used: {}", name, QuotedList(table.unused_columns)));
  return notes;
}

}  // namespace

const char* ComparedKindName(ComparedKind kind) {
  switch (kind) {
    case ComparedKind::kPlan:
      return "plan";
    case ComparedKind::kLog:
      return "log";
    case ComparedKind::kCsv:
      return "csv";
    case ComparedKind::kTrajectory:
      return "trajectory";
  }
  return "";
}

ComparedMotion ComparedPlan(const RobotModel& model, const MotionPlan& plan, const std::string& name) {
  ComparedMotion motion{.name = name, .kind = ComparedKind::kPlan, .model = model, .plan = plan};
  motion.rows = RowsOfPlan(model, plan, UsualRate(plan));
  for (int foot = 0; foot < static_cast<int>(model.feet.size()); ++foot)
    motion.stances.push_back(IntervalsOf(plan.schedule, foot));
  return motion;
}

ComparedMotion ComparedLog(const RobotModel& model, const PlaybackLog& log, const std::string& name) {
  ComparedMotion motion{.name = name, .kind = ComparedKind::kLog, .model = model, .log = log};
  motion.rows = RowsOfLog(model, log, log.log_rate_hz);
  for (int foot = 0; foot < static_cast<int>(model.feet.size()); ++foot)
    motion.stances.push_back(MeasuredIntervals(log, foot, TimingGate()));
  motion.torque_age_s = 0.5 / log.log_rate_hz;
  WatchGaps(motion);
  return motion;
}

ComparedMotion ComparedTable(const RobotModel& model, const MotionTable& table, const std::string& name) {
  CheckTable(model, table);
  const ComparedKind kind = HasWaypoints(table.format) ? ComparedKind::kTrajectory : ComparedKind::kCsv;
  ComparedMotion motion{.name = name, .kind = kind, .model = model, .notes = NotesOf(model, table, name)};
  MotionRows& rows = motion.rows;
  rows.time_s = table.time_s;
  // Points of a joint trajectory may be far apart, because a controller interpolates between them.
  if (kind == ComparedKind::kCsv) WatchGaps(motion);
  for (std::size_t k = 0; k < table.time_s.size(); ++k) {
    VectorX q = VectorX::Constant(model.nq(), kNaN), v = VectorX::Constant(model.nv(), kNaN);
    if (!table.base_m.empty()) q.head<3>() = table.base_m[k];
    if (!table.quaternion.empty()) q.segment<4>(3) = table.quaternion[k].normalized();
    q.tail(model.num_dofs()) = table.q[k];
    v.tail(model.num_dofs()) = SpeedsAt(model, table, motion.longest_step_s, k);
    rows.q.push_back(std::move(q));
    rows.v.push_back(std::move(v));
  }
  for (int d = 0; d < model.num_dofs(); ++d)
    motion.derived_speeds.push_back(motion.HasJoint(d) && (table.v.empty() || !std::isfinite(table.v.front()[d])));
  motion.resolution = VectorX::Zero(model.num_dofs());
  for (Eigen::Index d = 0; d < motion.resolution.size(); ++d) {
    std::vector<double> positions;
    for (const VectorX& q : table.q) positions.push_back(q[d]);
    motion.resolution[d] = ResolutionOf(positions);
  }
  rows.tau = table.tau;
  rows.contact = table.contact;
  if (rows.contact.empty()) return motion;
  for (int foot = 0; foot < static_cast<int>(model.feet.size()); ++foot)
    motion.stances.push_back(IntervalsOfRows(rows, foot));
  return motion;
}

double ResolutionOf(const std::vector<double>& positions) {
  constexpr std::size_t kFewest = 16;
  constexpr double kAligned = 1e-3;  // share of a step
  std::vector<double> steps;
  double lowest = INFINITY, highest = -INFINITY;
  for (std::size_t k = 1; k < positions.size(); ++k) {
    const double step = std::abs(positions[k] - positions[k - 1]);
    if (!std::isfinite(step) || step == 0.0) continue;
    steps.push_back(step);
    lowest = std::min(lowest, positions[k]);
    highest = std::max(highest, positions[k]);
  }
  if (steps.size() < kFewest) return 0.0;
  const double least = *std::min_element(steps.begin(), steps.end());
  for (const double step : steps) {
    if (std::abs(step / least - std::round(step / least)) > kAligned) return 0.0;
  }
  return highest - lowest > kFewest * least ? least : 0.0;
}

Result<ComparedMotion> CheckedTable(const RobotModel& model, const ImportOptions& options, const MotionTable& table,
                                    const std::string& name) {
  try {
    CheckComparedTable(model, options, table);
    return ComparedTable(model, table, name);
  } catch (const InvalidArgument& error) {
    return Failure{FailureKind::kBadInput,
                   FailureCode::kMotion,
                   "ReadCompareInput",
                   fmt::format("'{}': {}", name, error.what()),
                   {}};
  }
}

double NoiseGain(const std::vector<double>& time_s, double at_s, double longest_step_s) {
  const auto after = std::upper_bound(time_s.begin(), time_s.end(), at_s);
  const auto right = std::min(static_cast<std::size_t>(after - time_s.begin()), time_s.size() - 1);
  return std::max(GainAt(time_s, longest_step_s, right > 0 ? right - 1 : 0), GainAt(time_s, longest_step_s, right));
}

void SampleCompared(const ComparedMotion& motion, double time_s, RowSample& sample) {
  if (!motion.plan) {
    SampleRows(motion.rows, time_s, sample);
    if (!InGap(motion.gaps, time_s)) return;
    for (VectorX* const part : {&sample.q, &sample.v, &sample.tau}) part->setConstant(kNaN);
    return;
  }
  WholeBodySample whole;
  SampleWholeBody(motion.plan->whole_body, time_s, whole);
  sample.q = whole.q;
  sample.v = whole.v;
  sample.tau = whole.tau;
  sample.wrenches = whole.wrenches;
}

}  // namespace gaitwright
