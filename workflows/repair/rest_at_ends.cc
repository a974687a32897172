// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "planning/plan/sample_plan.h"
#include "workflows/repair/rest_at_ends_internal.h"

namespace gaitwright {
namespace {

/// Integral of SmoothStep from 0 to u.
double SmoothRise(double u) { return std::pow(u, 4.0) * (2.5 + u * (u - 3.0)); }

/// One end of a motion.
struct EndOfMotion {
  double ramp_s = 0.0, hold_s = 0.0;  ///< slowed; standing before or after it
};

EndOfMotion EndOf(const RobotModel& model, const EvenMotion& motion, FootSet stance, std::size_t row,
                  const RepairOptions& options) {
  constexpr double kSlow = 0.02, kSlowJoint = 0.1;  // of sqrt(g l), [rad/s]
  const VectorX& v = motion.v[row];
  const double slow = kSlow * std::sqrt(kGravity * model.leg_length_m());
  const bool moves = v.head<3>().norm() > slow || v.tail(v.size() - 3).lpNorm<Eigen::Infinity>() > kSlowJoint;
  const FootSet all = AllFeet(static_cast<int>(model.legs.size()));
  EndOfMotion end;
  const double length_s = motion.TimeOf(motion.size() - 1);
  if (moves) end.ramp_s = std::min(options.rest_s, 0.5 * length_s);
  if ((stance & all) != all) end.hold_s = 2.0 * options.rest_s;
  // Times are whole rows.
  const auto rounded = [&](double time_s) { return motion.step_s * 2.0 * std::round(0.5 * time_s / motion.step_s); };
  return {rounded(end.ramp_s), rounded(end.hold_s)};
}

}  // namespace

RestedMotion WithRestAtEnds(const RobotModel& model, const EvenMotion& motion, const std::vector<FootSet>& stance,
                            const RepairOptions& options) {
  constexpr double kStands = 0.5;  // of the time added, with all feet on the ground
  const std::size_t last = motion.q.size() - 1;
  const EndOfMotion start = EndOf(model, motion, stance.front(), 0, options),
                    end = EndOf(model, motion, stance[last], last, options);
  RestedMotion rested;
  rested.slowed_start_s = start.ramp_s;
  rested.slowed_end_s = end.ramp_s;
  rested.stood_start_s = start.hold_s;
  rested.stood_end_s = end.hold_s;
  const WholeBodyTrajectory of_file{0.0, motion.step_s, motion.q, motion.v, motion.a, {}, {}};
  const double length_s = motion.TimeOf(motion.size() - 1);
  const double end_s = start.hold_s + 0.5 * (start.ramp_s + end.ramp_s) + length_s + end.hold_s;
  const int rows = 1 + static_cast<int>(std::lround(end_s / motion.step_s));
  const FootSet all = AllFeet(static_cast<int>(model.legs.size()));
  rested.motion.step_s = motion.step_s;
  WholeBodySample sample;
  for (int k = 0; k < rows; ++k) {
    const double t = k * motion.step_s - start.hold_s, left = end_s - end.hold_s - k * motion.step_s;
    double file_s = t - 0.5 * start.ramp_s;
    if (t < start.ramp_s) file_s = start.ramp_s * SmoothRise(std::max(0.0, t) / start.ramp_s);
    if (left < end.ramp_s) file_s = length_s - end.ramp_s * SmoothRise(std::max(0.0, left) / end.ramp_s);
    if (t <= 0.0) file_s = 0.0;
    if (left <= 0.0) file_s = length_s;
    SampleWholeBody(of_file, file_s, sample);
    rested.motion.q.push_back(sample.q);
    rested.file_s.push_back(file_s);
    const auto row =
        static_cast<std::size_t>(std::clamp(std::lround(file_s / motion.step_s), 0L, static_cast<long>(last)));
    const bool stands = k * motion.step_s < kStands * start.hold_s || end_s - k * motion.step_s < kStands * end.hold_s;
    rested.stance.push_back(stands ? stance[row] | all : stance[row]);
  }
  return rested;
}

}  // namespace gaitwright
