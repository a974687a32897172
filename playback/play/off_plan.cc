// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>

#include "kinematics/base/nearest_name.h"
#include "playback/play/off_plan_internal.h"

namespace gaitwright::playing {

std::vector<TimedPush> PushesOf(const PlayOptions& options) {
  std::vector<TimedPush> pushes = {{options.push_force_W, options.push_at_s, options.push_for_s, options.push_on}};
  pushes.insert(pushes.end(), options.more_pushes.begin(), options.more_pushes.end());
  std::erase_if(pushes, [](const TimedPush& push) { return push.force_W.isZero(0.0); });
  return pushes;
}

int PushedBody(const RobotModel& model, const std::string& on) {
  if (on == "base") return 0;
  if (on == "robot") return kWholeRobot;
  std::vector<std::string> names = {"base", "robot"};
  for (const Frame& frame : model.frames) {
    if (frame.name == on) return frame.body;
    names.push_back(frame.name);
  }
  throw InvalidArgument(fmt::format("option 'push_on' is '{}'; accepted: 'base', 'robot' or a link of '{}'{}", on,
                                    model.name, NearestHint(on, names)));
}

double ShareOfStep(const TimedPush& push, double time_s, double step_s) {
  constexpr double kRounding = 1e-6;
  const double begin_s = std::max(time_s, push.at_s), end_s = std::min(time_s + step_s, push.at_s + push.for_s);
  const double share = (end_s - begin_s) / step_s;
  if (share < kRounding) return 0.0;
  return share > 1.0 - kRounding ? 1.0 : share;
}

bool StartsOff(const PlayOptions& o) {
  return o.start_x_m != 0.0 || o.start_y_m != 0.0 || o.start_z_m != 0.0 || o.start_roll_rad != 0.0 ||
         o.start_pitch_rad != 0.0 || o.start_yaw_rad != 0.0 ||
         (o.start_joints.size() > 0 && !o.start_joints.isZero(0.0));
}

VectorX MovedOff(const RobotModel& model, const PlayOptions& o, VectorX q) {
  if (o.start_joints.size() > 0 && o.start_joints.size() != model.num_dofs()) {
    throw InvalidArgument(fmt::format("'start_joints' has {} numbers; '{}' needs {}", o.start_joints.size(), model.name,
                                      model.num_dofs()));
  }
  q.head<3>() += Vector3(o.start_x_m, o.start_y_m, o.start_z_m);
  const Quaternion turned = Eigen::AngleAxisd(o.start_yaw_rad, Vector3::UnitZ()) * Quaternion(BaseRotation(q)) *
                            Eigen::AngleAxisd(o.start_pitch_rad, Vector3::UnitY()) *
                            Eigen::AngleAxisd(o.start_roll_rad, Vector3::UnitX());
  q.segment<4>(3) = turned.normalized().coeffs();
  for (int dof = 0; dof < static_cast<int>(o.start_joints.size()); ++dof) {
    const double planned = q[7 + dof], wanted = planned + o.start_joints[dof];
    q[7 + dof] = std::clamp(wanted, std::min(planned, model.dof_lower(dof)), std::max(planned, model.dof_upper(dof)));
  }
  return q;
}

}  // namespace gaitwright::playing
