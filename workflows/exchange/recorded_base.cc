// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include "kinematics/base/result.h"
#include "kinematics/dynamics/dynamics.h"
#include "workflows/exchange/recorded_base_internal.h"

namespace gaitwright {
namespace {

/// A pose and rates between two messages.
struct OdometrySample {
  Pose X_WC = Pose::Identity();
  Vector3 v_WC = Vector3::Zero(), w_WC = Vector3::Zero();  ///< in the axes of C
};

Quaternion TurnOf(const Eigen::Vector4d& turn, bool w_first) {
  return (w_first ? Quaternion(turn[0], turn[1], turn[2], turn[3]) : Quaternion(turn[3], turn[0], turn[1], turn[2]))
      .normalized();
}

OdometrySample SampleBetween(const OdometryMessage& one, const OdometryMessage& two, double share, bool w_first) {
  OdometrySample sample;
  sample.X_WC.linear() = TurnOf(one.turn, w_first).slerp(share, TurnOf(two.turn, w_first)).toRotationMatrix();
  sample.X_WC.translation() = (1.0 - share) * one.p_WC + share * two.p_WC;
  sample.v_WC = (1.0 - share) * one.v_WC + share * two.v_WC;
  sample.w_WC = (1.0 - share) * one.w_WC + share * two.w_WC;
  return sample;
}

/// The link of this name, without the name of the robot before a slash; empty for one that the robot does not have.
std::optional<Frame> LinkOf(const RobotModel& model, const std::string& full) {
  const std::string name = full.substr(full.rfind('/') + 1);
  for (const Frame& frame : model.frames) {
    if (frame.name == name) return frame;
  }
  return {};
}

/// X_CB of the base in a link.
Pose RootInLink(const RobotModel& model, const Frame& link, const VectorX& joints, DynamicsScratch& scratch) {
  VectorX q(model.nq());
  q << Vector3::Zero(), Eigen::Vector4d(0.0, 0.0, 0.0, 1.0), joints;
  ForwardKinematics(model, q, scratch);
  Pose X_BC = Pose::Identity();
  X_BC.linear() = scratch.R_WB[static_cast<std::size_t>(link.body)];
  X_BC.translation() = scratch.p_WB[static_cast<std::size_t>(link.body)];
  return (X_BC * link.X_BF).inverse();
}

bool IsFinite(const OdometryMessage& message) {
  return message.p_WC.allFinite() && message.v_WC.allFinite() && message.w_WC.allFinite() &&
         std::abs(message.turn.norm() - 1.0) < 0.01;
}

}  // namespace

TimePlace PlaceAt(const std::vector<std::int64_t>& times, std::int64_t time) {
  const auto behind = std::upper_bound(times.begin(), times.end(), time);
  const auto before = static_cast<std::size_t>(behind - times.begin()) - 1;
  if (behind == times.end() || times[before] == time) return {before, 0.0};
  return {before, static_cast<double>(time - times[before]) / static_cast<double>(times[before + 1] - times[before])};
}

std::vector<std::size_t> OrderByTime(const std::vector<std::int64_t>& times) {
  std::vector<std::size_t> order(times.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return times[a] < times[b]; });
  return order;
}

RecordedBase::RecordedBase(const RecordedSeries<OdometryMessage>& series, const std::vector<std::int64_t>& times,
                           std::string topic)
    : topic_(std::move(topic)), child_frame_(series.messages.front().child_frame) {
  for (const std::size_t i : OrderByTime(times)) {
    const OdometryMessage& message = series.messages[i];
    if (!IsFinite(message)) {
      throw InvalidArgument(
          fmt::format("message {} of topic '{}' is not finite, or its quaternion is not of length 1", i + 1, topic_));
    }
    if (message.child_frame != child_frame_) {
      throw InvalidArgument(
          fmt::format("topic '{}' has poses of '{}' and of '{}'", topic_, child_frame_, message.child_frame));
    }
    if (!times_.empty() && times_.back() >= times[i]) {
      ++late_;
      continue;
    }
    times_.push_back(times[i]);
    poses_.push_back(message);
  }
}

void RecordedBase::AddTo(const RobotModel& model, const ImportOptions& options, const std::vector<std::int64_t>& rows,
                         MotionTable& table) const {
  const std::optional<Frame> link = LinkOf(model, child_frame_);
  const bool is_root = !link || (link->body == 0 && link->X_BF.isApprox(Pose::Identity()));
  const double unit = options.length_unit == "mm" ? 1e-3 : 1.0;
  // Many programs leave the rates at zero.
  const bool has_rates = is_root && std::any_of(poses_.begin(), poses_.end(), [](const OdometryMessage& m) {
                           return m.v_WC.squaredNorm() + m.w_WC.squaredNorm() > 0.0;
                         });
  DynamicsScratch scratch(model);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const TimePlace at = PlaceAt(times_, rows[k]);
    OdometrySample sample = SampleBetween(poses_[at.before], poses_[at.before + (at.share > 0.0 ? 1 : 0)], at.share,
                                          options.quaternion_order == "wxyz");
    sample.X_WC.translation() *= unit;
    if (has_rates) {
      Vector6 rate;
      rate << sample.X_WC.linear() * (unit * sample.v_WC), sample.X_WC.linear() * sample.w_WC;
      table.base_rate.push_back(rate);
    }
    if (!is_root) sample.X_WC = sample.X_WC * RootInLink(model, *link, table.q[k], scratch);
    table.base_m.push_back(sample.X_WC.translation());
    table.quaternion.push_back(Quaternion(sample.X_WC.linear()).coeffs());
  }
  table.derived.push_back({"base", fmt::format("poses of '{}' in topic '{}'{}", child_frame_, topic_,
                                               link ? "" : "; the robot has no such link: taken as its root link")});
}

}  // namespace gaitwright
