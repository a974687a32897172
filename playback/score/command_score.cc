// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <deque>

#include "planning/plan/plans_contacts_internal.h"
#include "playback/score/command_score_internal.h"

namespace gaitwright {
namespace {

constexpr char kVelocityError[] = "command_velocity_error_m_s", kYawRateError[] = "command_yaw_rate_error_rad_s";

/// Forward and lateral speed in the heading of the base, and yaw rate.
Vector3 PlanarVelocity(const VectorX& q, const VectorX& v) {
  const Vector2 level = Eigen::Rotation2Dd(-YawOf(BaseRotation(q))) * Vector2(v.head<2>());
  return {level.x(), level.y(), v[5]};
}

/// The mean error over the last kCommandWindow, and the means of its size over time.
class CommandErrors {
 public:
  explicit CommandErrors(std::size_t window) : window_(std::max<std::size_t>(window, 1)) {}

  void See(const Vector3& error, double time_s) {
    recent_.push_back(error);
    sum_ += error;
    if (recent_.size() > window_) {
      sum_ -= recent_.front();
      recent_.pop_front();
    }
    if (recent_.size() < window_) return;
    const Vector3 mean = sum_ / static_cast<double>(window_);
    velocity_ += mean.head<2>().norm();
    yaw_rate_ += std::abs(mean.z());
    ++count_;
    worst_velocity_.See(mean.head<2>().norm(), time_s);
    worst_yaw_rate_.See(std::abs(mean.z()), time_s);
  }

  std::vector<Measurement> Rows() const {
    if (count_ == 0) {
      const std::string missing = "the robot did not stand for the time over which velocities are averaged";
      return {{kVelocityError, {}, {}, {}, missing}, {kYawRateError, {}, {}, {}, missing}};
    }
    return {{kVelocityError, velocity_ / count_, {}, worst_velocity_.at_s, ""},
            {kYawRateError, yaw_rate_ / count_, {}, worst_yaw_rate_.at_s, ""}};
  }

 private:
  std::size_t window_;
  std::deque<Vector3> recent_;
  Vector3 sum_ = Vector3::Zero();
  double velocity_ = 0.0, yaw_rate_ = 0.0;
  int count_ = 0;
  Extreme worst_velocity_{Extreme::Kind::kLargest}, worst_yaw_rate_{Extreme::Kind::kLargest};
};

/// Reason for which a plan without contacts has no value for this metric; "" if it has one.
std::string NotOfCommands(const std::string& key) {
  const auto begins = [&](const char* prefix) { return key.starts_with(prefix); };
  if (begins("zmp_") || begins("dcm_") || key == "clearance_min_m" || key == "scuffs" ||
      key == "contact_timing_error_max_s" || key == "torque_step_use_max")
    return "the command plans no contacts";
  return begins("tracking_") ? "the command plans no posture" : "";
}

}  // namespace

std::vector<Measurement> CommandMeasurements(const ScoreInputs& in) {
  if (PlansContacts(in.plan)) {
    const std::string missing = "the plan is more than a velocity command";
    return {{kVelocityError, {}, {}, {}, missing}, {kYawRateError, {}, {}, {}, missing}};
  }
  CommandErrors errors(static_cast<std::size_t>(std::lround(kCommandWindow * in.log.log_rate_hz)));
  for (std::size_t k = 0; k < in.series.measured.size(); ++k) {
    const LogSample& sample = in.log.samples[k];
    const WholeBodySample& commanded = in.series.plan[k];
    if (sample.time_s > in.plan.whole_body.end_s()) break;  // the hold after the command's end
    errors.See(PlanarVelocity(sample.q, sample.v) - PlanarVelocity(commanded.q, commanded.v), sample.time_s);
  }
  return errors.Rows();
}

void KeepCommanded(std::vector<Measurement>& rows) {
  for (Measurement& row : rows) {
    if (row.key != "distance_m") row.planned.reset();
    const std::string missing = NotOfCommands(row.key);
    if (!missing.empty()) row = {row.key, {}, {}, {}, missing};
  }
}

std::string GateNotOfCommands(const std::string& key) {
  if (key == "goal_error_m") return "a command is a velocity, so command_velocity_error_m_s is the gate";
  return key == "heading_error_rad" ? "a command is a yaw rate, so command_yaw_rate_error_rad_s is the gate" : "";
}

bool IsOfCommands(const std::string& key) { return key == kVelocityError || key == kYawRateError; }

}  // namespace gaitwright
