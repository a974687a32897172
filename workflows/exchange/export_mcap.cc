// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "kinematics/base/result.h"
#include "workflows/exchange/export_mcap_internal.h"
#include "workflows/exchange/mcap_file_internal.h"
#include "workflows/exchange/ros_messages_internal.h"

namespace gaitwright {
namespace {

std::int64_t NanosecondsOf(double time_s) { return std::llround(1e9 * time_s); }

std::vector<double> FiniteList(const char* what, const Eigen::Ref<const VectorX>& values) {
  if (!values.allFinite())
    throw InvalidArgument(fmt::format("a {} is not finite; only finite numbers are exported", what));
  return {values.data(), values.data() + values.size()};
}

/// Name of the URDF's root link.
std::string RootLink(const RobotModel& model) {
  const auto root = std::find_if(model.frames.begin(), model.frames.end(), [](const Frame& frame) {
    return frame.body == 0 && frame.X_BF.isApprox(Pose::Identity());
  });
  return root == model.frames.end() ? model.bodies.front().name : root->name;
}

OdometryMessage OdometryOf(const std::string& root, std::int64_t time_ns, const VectorX& q, const VectorX& v) {
  FiniteList("position of the base", q.head<7>());
  FiniteList("velocity of the base", v.head<6>());
  const Matrix3 R_WB = BaseRotation(q);
  return {time_ns,
          "odom",
          root,
          q.head<3>(),
          q.segment<4>(3),
          R_WB.transpose() * v.head<3>(),
          R_WB.transpose() * v.segment<3>(3)};
}

}  // namespace

std::string MotionMcap(const RobotModel& model, const MotionRows& rows) {
  McapWriter writer;
  const auto add = [&](const char* name, const char* type) {
    return writer.AddTopic({name, type, "cdr"}, RosSchema(type));
  };
  const int states = add("/joint_states", kJointStateType), odometry = add("/odom", kOdometryType),
            trajectories = add("/joint_trajectory", kJointTrajectoryType);
  const std::string root = RootLink(model);
  JointTrajectoryMessage trajectory{NanosecondsOf(rows.time_s.front()), model.dof_names, {}};
  const Eigen::Index n = model.num_dofs();
  for (std::size_t k = 0; k < rows.time_s.size(); ++k) {
    const std::int64_t time_ns = NanosecondsOf(rows.time_s[k]);
    JointStateMessage state{time_ns,
                            model.dof_names,
                            FiniteList("joint's position", rows.q[k].tail(n)),
                            FiniteList("joint's velocity", rows.v[k].tail(n)),
                            {}};
    if (!rows.tau.empty()) state.efforts = FiniteList("joint's torque", rows.tau[k]);
    writer.Add(states, time_ns, CdrOf(state));
    writer.Add(odometry, time_ns, CdrOf(OdometryOf(root, time_ns, rows.q[k], rows.v[k])));
    std::vector<double> a;
    if (!rows.a.empty()) a = FiniteList("joint's acceleration", rows.a[k].tail(n));
    trajectory.points.push_back({std::move(state.positions), std::move(state.velocities), std::move(a),
                                 std::move(state.efforts), time_ns - trajectory.stamp_ns});
  }
  writer.Add(trajectories, trajectory.stamp_ns, CdrOf(trajectory));
  return writer.Finish();
}

}  // namespace gaitwright
