// SPDX-License-Identifier: BSD-3-Clause
#include "playback/log/check_log.h"

#include <fmt/format.h>

#include <cmath>

#include "kinematics/base/result.h"
#include "playback/log/log_shape_internal.h"

namespace gaitwright {
namespace {

constexpr double kMost = 1e12;         // of any number, in its unit
constexpr double kUnit = 1e-3;         // how far from 1 a quaternion's length may be
constexpr std::size_t kMostFeet = 64;  // size of a FootSet

void CheckIn(const char* what, double value, double lowest, double highest) {
  if (value >= lowest && value <= highest) return;
  throw InvalidArgument(fmt::format("'{}' is {}; accepted: {} to {}", what, value, lowest, highest));
}

void CheckIn(const char* what, double value, const LogRange& range) {
  CheckIn(what, value, range.lowest, range.highest);
}

template <class Row>
void CheckRow(const char* what, std::size_t sample, const Row& row) {
  for (const double value : row) {
    if (!(std::abs(value) <= kMost))
      throw InvalidArgument(
          fmt::format("row {} of '{}' contains {}; at most +-{} is accepted", sample, what, value, kMost));
  }
}

void CheckHead(const PlaybackLog& log) {
  CheckIn("start_s", log.start_s, kLogStart);
  CheckIn("log_rate_hz", log.log_rate_hz, kLogRate);
  CheckIn("step_s", log.step_s, kLogStep);
  CheckIn("total_mass_kg", log.total_mass_kg, kLogMass);
  CheckIn("friction", log.friction, kLogFriction);
  for (const double time_s : log.saturated_s) CheckIn("saturated_s", time_s, 0.0, kMost);
  for (const BodyContact& contact : log.body_contacts) CheckIn("body_contacts, time_s", contact.time_s, -kMost, kMost);
}

void CheckPush(const TimedPush& push) {
  CheckIn("pushes, at_s", push.at_s, -kMost, kMost);
  CheckIn("pushes, for_s", push.for_s, 0.0, kMost);
  for (const double force : push.force_W) CheckIn("pushes, force_n", force, -kMost, kMost);
}

void CheckEstimate(const BaseEstimate& estimate, std::size_t k) {
  CheckRow("estimate", k, estimate.p_WB);
  CheckRow("estimate", k, estimate.R_WB.coeffs());
  CheckRow("estimate", k, estimate.v_WB);
  CheckRow("estimate", k, estimate.w_WB);
  const double length = estimate.R_WB.norm();
  if (!(std::abs(length - 1.0) <= kUnit))
    throw InvalidArgument(
        fmt::format("row {} of 'estimate' has a quaternion of length {:.6g}; it must be 1", k, length));
}

void CheckSample(const PlaybackLog& log, std::size_t k, std::size_t feet) {
  const LogSample& sample = log.samples[k];
  CheckIn("time_s", sample.time_s, -kMost, kMost);
  if (k > 0 && !(sample.time_s > log.samples[k - 1].time_s))
    throw InvalidArgument(fmt::format("row {} of 'time_s' is {:.9g}, which is not after the previous row, {:.9g}", k,
                                      sample.time_s, log.samples[k - 1].time_s));
  CheckRow("q", k, sample.q);
  CheckRow("v", k, sample.v);
  CheckRow("tau_nm", k, sample.tau);
  CheckRow("tau_peak_nm", k, sample.tau_peak);
  for (const double share : sample.effort_use) CheckIn("effort_use", share, 0.0, 1.0);
  for (const ContactWrench& wrench : sample.wrenches) {
    CheckRow("contact_wrenches", k, wrench.force_W);
    CheckRow("contact_wrenches", k, wrench.moment_W);
  }
  if (sample.estimate) CheckEstimate(*sample.estimate, k);
  const double length = sample.q.segment<4>(3).norm();
  if (!(std::abs(length - 1.0) <= kUnit))
    throw InvalidArgument(fmt::format("row {} of 'q' has a quaternion of length {:.6g}; it must be 1", k, length));
  if ((sample.contact & ~AllFeet(static_cast<int>(feet))) != 0)
    throw InvalidArgument(fmt::format("row {} of 'contact' is {}, which names a foot beyond the robot's {} feet", k,
                                      sample.contact, feet));
}

void CheckStance(const StanceRecord& stance, std::size_t feet) {
  if (feet > 0) CheckIn("stances, foot", stance.foot, 0, static_cast<double>(feet) - 1.0);
  CheckIn("stances, touchdown_s", stance.touchdown_s, -kMost, kMost);
  CheckIn("stances, liftoff_s", stance.liftoff_s, stance.touchdown_s, kMost);
  for (const double place : stance.p_touchdown_W) CheckIn("stances, touchdown_m", place, -kMost, kMost);
  for (const double value :
       {stance.touchdown_speed_m_s, stance.slip_m, stance.peak_normal_n, stance.penetration_m, stance.friction_use_max})
    CheckIn("stances", value, -kMost, kMost);
}

}  // namespace

void CheckLog(const PlaybackLog& log) {
  CheckHead(log);
  const std::size_t feet = log.samples.empty() ? 0 : log.samples.front().wrenches.size();
  if (feet > kMostFeet)
    throw InvalidArgument(fmt::format("'contact_wrenches' has {} feet; at most {} are accepted", feet, kMostFeet));
  for (std::size_t k = 0; k < log.samples.size(); ++k) CheckSample(log, k, feet);
  for (const StanceRecord& stance : log.stances) CheckStance(stance, feet);
  for (const TimedPush& push : log.pushes) CheckPush(push);
  if (log.start_penetration) CheckIn("start_penetration, depth_m", log.start_penetration->depth_m, 0.0, kMost);
}

}  // namespace gaitwright
