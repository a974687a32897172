// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// A walk of a four-legged robot with legs of two equal links, as other software would write it, independent of our
/// planners and kinematics. The base moves straight forward, from rest to rest; each foot swings to half a step in
/// front of its hip; the leg angles follow from the law of cosines.
struct OtherWalk {
  double height_m = 0.3, speed_m_s = 0.15, cycle_s = 0.6, lift_m = 0.05, stand_s = 0.5;
  double swing_share = 0.8;  ///< share of a half cycle
  int half_cycles = 8;
  bool pairs = true;  ///< true: diagonal legs swing together; false: one leg after the other
  double step_s = 0.005;
  double joint_scale = 1.0;   ///< scale of all joint columns
  double length_scale = 1.0;  ///< scale of the base's position
  double time_scale = 1.0;
  bool w_first = false;  ///< writes w, x, y, z into the columns x, y, z, w
  bool with_base = true, with_contacts = false;
};

/// Its CSV text, for the A1.
std::string CsvOf(const OtherWalk& walk);

/// A standing robot, or a robot at any place in any posture.
struct OtherStance {
  double step_s = 0.02, base_z_m = 0.0;
  int rows = 50;
  std::string turn_columns = "base_qx,base_qy,base_qz,base_qw", turn = "0,0,0,1";
  std::map<std::string, double> joints = {};  ///< joints that differ from the standing posture
};

/// Its CSV text.
std::string CsvOf(const RobotModel& model, const OtherStance& stance);

/// The walk as a joint trajectory of ROS.
std::string TrajectoryOf(const OtherWalk& walk);

}  // namespace gaitwright
