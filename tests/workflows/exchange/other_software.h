// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// A walk of a four-legged robot with legs of two equal links as other software would write it: nothing of it comes
/// from our planners, nor from our kinematics. The base goes straight ahead, up to speed and to rest again; feet go
/// from where they stood to half a step ahead of the hip; two links by the law of cosines.
struct OtherWalk {
  double height_m = 0.3, speed_m_s = 0.15, cycle_s = 0.6, lift_m = 0.05, stand_s = 0.5;
  double swing_share = 0.8;  ///< of a half cycle
  int half_cycles = 8;
  bool pairs = true;  ///< diagonal legs swing together, else one leg after the other
  double step_s = 0.005;
  double joint_scale = 1.0;   ///< of all that is written for joints
  double length_scale = 1.0;  ///< of the base's position
  double time_scale = 1.0;
  bool w_first = false;  ///< writes w, x, y, z into the columns of x, y, z, w
  bool with_base = true, with_contacts = false;
};

/// The text of its CSV, for the A1.
std::string CsvOf(const OtherWalk& walk);

/// A robot that stands, or is put anywhere in whatever posture.
struct OtherStance {
  double step_s = 0.02, base_z_m = 0.0;
  int rows = 50;
  std::string turn_columns = "base_qx,base_qy,base_qz,base_qw", turn = "0,0,0,1";
  std::map<std::string, double> joints = {};  ///< those that are not as in the standing posture
};

/// The text of its CSV.
std::string CsvOf(const RobotModel& model, const OtherStance& stance);

/// The same walk as a joint trajectory of ROS.
std::string TrajectoryOf(const OtherWalk& walk);

}  // namespace gaitwright
