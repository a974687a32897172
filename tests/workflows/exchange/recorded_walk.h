// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "tests/named_robot.h"
#include "workflows/exchange/mcap_file_internal.h"
#include "workflows/exchange/motion_rows.h"
#include "workflows/exchange/ros_messages_internal.h"

namespace gaitwright::synthetic {

/// Rows in which the base and all joints move, each by another amount, at 100 Hz.
inline MotionRows MovingRows(const RobotModel& model, int count) {
  MotionRows rows;
  for (int k = 0; k < count; ++k) {
    const double t = 0.01 * k;
    rows.time_s.push_back(t);
    VectorX q = StandingConfiguration(model), v = VectorX::Zero(model.nv());
    q[0] += 0.2 * t;
    v[0] = 0.2;
    q.segment<4>(3) = Quaternion(Eigen::AngleAxisd(0.5 * t, Vector3::UnitZ())).coeffs();
    v[5] = 0.5;
    for (int d = 0; d < model.num_dofs(); ++d) {
      q[7 + d] += 0.02 * (d + 1) * t;
      v[6 + d] = 0.02 * (d + 1);
    }
    rows.q.push_back(q);
    rows.v.push_back(v);
    rows.tau.push_back(VectorX::LinSpaced(model.num_dofs(), -1.0, 1.0));
  }
  return rows;
}

/// A recording that is written message by message.
class Recorder {
 public:
  template <class Message>
  void Add(const std::string& topic, const char* type, std::int64_t time_ns, const Message& message) {
    auto found = topics_.find(topic);
    if (found == topics_.end())
      found = topics_.emplace(topic, writer_.AddTopic({topic, type, "cdr"}, RosSchema(type))).first;
    writer_.Add(found->second, time_ns, CdrOf(message));
  }
  std::string Finish() { return writer_.Finish(); }

 private:
  McapWriter writer_;
  std::map<std::string, int> topics_;
};

/// The joints of a row with these names.
inline JointStateMessage StateOf(const RobotModel& model, const VectorX& q, const std::vector<std::string>& names) {
  JointStateMessage state;
  state.names = names;
  for (const std::string& name : names) state.positions.push_back(q[7 + model.DofIndex(name)]);
  return state;
}

}  // namespace gaitwright::synthetic
