// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <set>
#include <utility>

#include "kinematics/base/options.h"
#include "workflows/exchange/read_motion_internal.h"
#include "workflows/exchange/recorded_base_internal.h"
#include "workflows/exchange/recorded_motion_internal.h"
#include "workflows/exchange/recorded_topics_internal.h"

namespace gaitwright {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

/// Values of a joint over time.
struct JointSeries {
  std::vector<std::int64_t> times;
  std::vector<double> q, v, tau;  ///< v and tau: NaN where a message lacks them

  static double At(const std::vector<double>& values, TimePlace at) {
    if (at.share == 0.0) return values[at.before];
    return (1.0 - at.share) * values[at.before] + at.share * values[at.before + 1];
  }
  static bool IsKnown(const std::vector<double>& values) {
    return std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
  }
};

class RecordingReader {
 public:
  RecordingReader(const RobotModel& model, const RecordedTopics& topics, const ImportOptions& options)
      : model_(model), topics_(topics), options_(options), joints_(static_cast<std::size_t>(model.num_dofs())) {}

  MotionTable Run() {
    chosen_ = ChooseTopics(model_, topics_, options_.topics);
    ChooseClock();
    if (chosen_.joint_states.empty()) {
      TakeTrajectory(topics_.trajectories.at(chosen_.trajectory));
    } else {
      TakeJointStates(topics_.joint_states.at(chosen_.joint_states));
    }
    CheckJoints();
    if (!chosen_.odometry.empty()) {
      const RecordedSeries<OdometryMessage>& series = topics_.odometry.at(chosen_.odometry);
      base_.emplace(series, TimesOf(series), chosen_.odometry);
      late_ += base_->late();
    }
    SetRows();
    ReportWhatWasRead();
    return std::move(table_);
  }

 private:
  template <class Message>
  static bool AllStamped(const RecordedSeries<Message>& series) {
    return std::all_of(series.messages.begin(), series.messages.end(), [](const auto& m) { return m.stamp_ns != 0; });
  }

  /// Stamps of the messages count only if all topics have them, so that there is one clock.
  void ChooseClock() {
    stamped_ = chosen_.joint_states.empty() ? AllStamped(topics_.trajectories.at(chosen_.trajectory))
                                            : AllStamped(topics_.joint_states.at(chosen_.joint_states));
    if (!chosen_.odometry.empty()) stamped_ = stamped_ && AllStamped(topics_.odometry.at(chosen_.odometry));
  }

  template <class Message>
  std::vector<std::int64_t> TimesOf(const RecordedSeries<Message>& series) const {
    if (!stamped_) return series.log_time_ns;
    std::vector<std::int64_t> times;
    for (const Message& message : series.messages) times.push_back(message.stamp_ns);
    return times;
  }

  double UnitOf(int dof) const {
    if (model_.LeaderOf(dof).is_prismatic()) return options_.length_unit == "mm" ? 1e-3 : 1.0;
    return options_.angle_unit == "deg" ? std::numbers::pi / 180.0 : 1.0;
  }

  /// Independent coordinates by the names of a message; -1 for others.
  std::vector<int> DofsOf(const std::vector<std::string>& names) {
    std::vector<int> dofs;
    for (const std::string& name : names) {
      const auto found = std::find(model_.dof_names.begin(), model_.dof_names.end(), name);
      dofs.push_back(found == model_.dof_names.end() ? -1 : static_cast<int>(found - model_.dof_names.begin()));
      if (dofs.back() < 0) unused_.insert(fmt::format("joint '{}'", name));
    }
    return dofs;
  }

  /// Adds the values of a message. @return the number of joints of the robot in it.
  int Add(const std::vector<int>& dofs, std::int64_t time, const JointStateMessage& values) {
    int count = 0;
    for (std::size_t i = 0; i < dofs.size() && !values.positions.empty(); ++i) {
      if (dofs[i] < 0) continue;
      JointSeries& joint = joints_[static_cast<std::size_t>(dofs[i])];
      if (!std::isfinite(values.positions[i])) {
        throw InvalidArgument(
            fmt::format("the position of joint '{}' is {} at {} ns", values.names[i], values.positions[i], time));
      }
      if (!joint.times.empty() && joint.times.back() >= time) {
        ++late_;
        continue;
      }
      const double unit = UnitOf(dofs[i]);
      joint.times.push_back(time);
      joint.q.push_back(unit * values.positions[i]);
      joint.v.push_back(values.velocities.empty() ? kUnknown : unit * values.velocities[i]);
      joint.tau.push_back(values.efforts.empty() ? kUnknown : values.efforts[i]);
      ++count;
    }
    return count;
  }

  void TakeJointStates(const RecordedSeries<JointStateMessage>& series) {
    table_.format = MotionFormat::kRosBag;
    const std::vector<std::int64_t> times = TimesOf(series);
    int most = 0;
    std::vector<std::string> names;
    std::vector<int> dofs;
    for (const std::size_t i : OrderByTime(times)) {
      const JointStateMessage& message = series.messages[i];
      if (message.names != names) dofs = DofsOf(names = message.names);
      const int count = Add(dofs, times[i], message);
      if (count > most) rows_.clear();
      most = std::max(most, count);
      if (count == most && count > 0) rows_.push_back(times[i]);
    }
  }

  void TakeTrajectory(const RecordedSeries<JointTrajectoryMessage>& series) {
    table_.format = MotionFormat::kRosBagTrajectory;
    if (series.messages.size() != 1) {
      throw InvalidArgument(
          fmt::format("topic '{}' has {} joint trajectories; a motion is one of them, or joint states",
                      chosen_.trajectory, series.messages.size()));
    }
    const JointTrajectoryMessage& message = series.messages.front();
    const std::vector<int> dofs = DofsOf(message.names);
    const std::int64_t start = TimesOf(series).front();
    for (const JointTrajectoryMessage::Point& point : message.points) {
      const std::int64_t time = start + point.from_start_ns;
      if (!rows_.empty() && time <= rows_.back()) {
        throw InvalidArgument(
            fmt::format("the time of point {} of topic '{}' does not rise", rows_.size() + 1, chosen_.trajectory));
      }
      Add(dofs, time, {0, message.names, point.positions, point.velocities, point.efforts});
      rows_.push_back(time);
    }
    CopyAccelerations(message, dofs);
  }

  void CopyAccelerations(const JointTrajectoryMessage& message, const std::vector<int>& dofs) {
    const bool all = std::all_of(message.points.begin(), message.points.end(),
                                 [](const auto& point) { return !point.accelerations.empty(); });
    for (std::size_t k = 0; all && k < message.points.size(); ++k) {
      VectorX a = VectorX::Constant(model_.num_dofs(), kUnknown);
      for (std::size_t i = 0; i < dofs.size(); ++i) {
        if (dofs[i] >= 0) a[dofs[i]] = UnitOf(dofs[i]) * message.points[k].accelerations[i];
      }
      accelerations_.push_back(std::move(a));
    }
  }

  void CheckJoints() {
    std::vector<std::string> missing;
    for (int d = 0; d < model_.num_dofs(); ++d) {
      const std::size_t count = joints_[static_cast<std::size_t>(d)].times.size();
      if (count == 0) missing.push_back(model_.dof_names[static_cast<std::size_t>(d)]);
    }
    if (static_cast<int>(missing.size()) == model_.num_dofs())
      throw InvalidArgument(fmt::format("topic '{}' has no positions of joints", JointTopic()));
    if (missing.empty()) return;
    if (options_.missing_joints == "refuse") {
      throw InvalidArgument(fmt::format("topic '{}' lacks {} of {} joints of robot '{}': {}", JointTopic(),
                                        missing.size(), model_.num_dofs(), model_.name, QuotedList(missing)));
    }
    table_.derived.push_back({"position of " + QuotedList(missing), "as in the standing posture"});
  }

  const std::string& JointTopic() const {
    return chosen_.joint_states.empty() ? chosen_.trajectory : chosen_.joint_states;
  }

  /// Keeps the rows at which everything is known.
  void CropRows() {
    std::int64_t first = rows_.front(), last = rows_.back();
    for (const JointSeries& joint : joints_) {
      if (joint.times.empty()) continue;
      first = std::max(first, joint.times.front());
      last = std::min(last, joint.times.back());
    }
    if (base_) {
      first = std::max(first, base_->times().front());
      last = std::min(last, base_->times().back());
    }
    const auto keep = [&](std::int64_t time) { return time >= first && time <= last; };
    const std::size_t before = rows_.size();
    std::vector<VectorX> accelerations;
    for (std::size_t k = 0; k < accelerations_.size(); ++k) {
      if (keep(rows_[k])) accelerations.push_back(accelerations_[k]);
    }
    accelerations_ = std::move(accelerations);
    std::erase_if(rows_, [&](std::int64_t time) { return !keep(time); });
    if (rows_.empty()) {
      throw InvalidArgument(fmt::format("topics '{}' and '{}' have no time in common", JointTopic(), chosen_.odometry));
    }
    if (rows_.size() < before)
      table_.derived.push_back({"rows", fmt::format("{} rows are left out, at which some topic or joint has no value",
                                                    before - rows_.size())});
  }

  void SetRows() {
    CropRows();
    std::vector<bool> fast, loaded;
    for (const JointSeries& joint : joints_) {
      fast.push_back(!joint.times.empty() && JointSeries::IsKnown(joint.v));
      loaded.push_back(!joint.times.empty() && JointSeries::IsKnown(joint.tau));
    }
    const bool any_v = std::find(fast.begin(), fast.end(), true) != fast.end(),
               any_tau = std::find(loaded.begin(), loaded.end(), true) != loaded.end();
    for (const std::int64_t time : rows_) {
      table_.time_s.push_back(1e-9 * static_cast<double>(time - rows_.front()));
      VectorX q = model_.standing_joints;
      VectorX v = VectorX::Constant(q.size(), kUnknown);
      VectorX tau = VectorX::Constant(q.size(), kUnknown);
      for (std::size_t d = 0; d < joints_.size(); ++d) {
        if (joints_[d].times.empty()) continue;
        const TimePlace at = PlaceAt(joints_[d].times, time);
        const auto i = static_cast<Eigen::Index>(d);
        q[i] = JointSeries::At(joints_[d].q, at);
        if (fast[d]) v[i] = JointSeries::At(joints_[d].v, at);
        if (loaded[d]) tau[i] = JointSeries::At(joints_[d].tau, at);
      }
      table_.q.push_back(std::move(q));
      if (any_v) table_.v.push_back(std::move(v));
      if (any_tau) table_.tau.push_back(std::move(tau));
    }
    if (any_v) table_.a = std::move(accelerations_);
    if (base_) base_->AddTo(model_, options_, rows_, table_);
  }

  void ReportWhatWasRead() {
    table_.derived.push_back({"joints", fmt::format("by their names in topic '{}'", JointTopic())});
    table_.derived.push_back(
        {"times", fmt::format("{}, counted from {} ns", stamped_ ? "stamps of the messages" : "times of recording",
                              rows_.front())});
    if (late_ > 0) {
      table_.derived.push_back(
          {"order", fmt::format("{} values are left out, since their times are not later than others", late_)});
    }
    if (!topics_.whole)
      table_.derived.push_back(
          {"end", "the recording was not ended properly; it was read up to its last complete record"});
    table_.unused_columns.assign(unused_.begin(), unused_.end());
    const auto add = [&](const auto& topics, const std::string& used) {
      for (const auto& [name, series] : topics) {
        if (name != used) table_.unused_columns.push_back(fmt::format("topic '{}'", name));
      }
    };
    add(topics_.joint_states, chosen_.joint_states), add(topics_.odometry, chosen_.odometry);
    add(topics_.trajectories, chosen_.trajectory), add(topics_.others, "");
  }

  const RobotModel& model_;
  const RecordedTopics& topics_;
  const ImportOptions& options_;
  ChosenTopics chosen_;
  bool stamped_ = false;
  std::vector<JointSeries> joints_;  ///< by dof
  std::vector<VectorX> accelerations_;
  std::vector<std::int64_t> rows_;
  std::optional<RecordedBase> base_;
  std::set<std::string> unused_;
  int late_ = 0;
  MotionTable table_;
};

}  // namespace

Result<MotionTable> ParseRecordedMotion(const RobotModel& model, const std::string& bytes,
                                        const std::vector<std::string>& further, const std::string& source,
                                        const ImportOptions& options) {
  try {
    RecordedTopics topics;
    ReadRecording(bytes, topics);
    for (const std::string& file : further) ReadRecording(file, topics);
    return RecordingReader(model, topics, options).Run();
  } catch (const InvalidArgument& error) {
    return RefusedMotion(source, error.what());
  }
}

}  // namespace gaitwright
