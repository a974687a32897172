// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "kinematics/model/load_robot.h"

namespace gaitwright {

/// A joint of a made-up leg, for the left side; y is mirrored on the right.
struct SyntheticJoint {
  std::string xyz, axis;
  std::string limits = "lower='-1.2' upper='1.2'";
  std::string extra = "";  ///< more of the joint's elements; `SIDE` becomes l or r
  std::string type = "revolute";
};

inline std::string ForSide(std::string text, const std::string& side) {
  for (std::size_t at = 0; (at = text.find("SIDE", at)) != std::string::npos;) text.replace(at, 4, side);
  return text;
}

/// Two legs with the given joints below a base; the last link of each leg has a box as foot.
inline std::string SyntheticUrdf(const std::vector<SyntheticJoint>& joints, const std::string& foot) {
  const std::string inertial =
      "<inertial><mass value='1'/><inertia ixx='0.01' iyy='0.01' izz='0.01' ixy='0' ixz='0' iyz='0'/></inertial>";
  std::string urdf = "<robot name='made_up'><link name='base'>" + inertial + "</link>";
  for (const std::string side : {"l", "r"}) {
    const double mirror = side == "l" ? 1.0 : -1.0;
    std::string parent = "base";
    for (std::size_t i = 0; i < joints.size(); ++i) {
      const std::string name = side + std::to_string(i);
      std::string xyz = joints[i].xyz;
      if (i == 0) xyz = "0 " + std::to_string(mirror * 0.1) + " 0";
      urdf += "<link name='" + name + "'>" + inertial + (i + 1 == joints.size() ? foot : "") + "</link>";
      urdf += "<joint name='j_" + name + "' type='" + joints[i].type + "'><parent link='" + parent +
              "'/><child link='" + name + "'/><origin xyz='" + xyz + "'/><axis xyz='" + joints[i].axis + "'/><limit " +
              joints[i].limits + " effort='10' velocity='10'/>" + ForSide(joints[i].extra, side) + "</joint>";
      parent = name;
    }
  }
  return urdf + "</robot>";
}

inline const char kBoxFoot[] =
    "<collision><origin xyz='0.02 0 -0.04'/><geometry><box size='0.2 0.1 0.02'/></geometry></collision>";
inline const char kBallFoot[] =
    "<collision><origin xyz='0 0 -0.2'/><geometry><sphere radius='0.02'/></geometry></collision>";

inline RobotModel Made(const std::vector<SyntheticJoint>& joints, const std::string& foot = kBoxFoot) {
  Result<RobotModel> model = LoadRobotFromText(SyntheticUrdf(joints, foot), "");
  EXPECT_TRUE(model.ok()) << (model.ok() ? "" : model.failure().message);
  return std::move(model).value();
}

/// Yaw, roll, pitch through one point; a knee that bends in both directions; pitch and roll through the ankle.
inline std::vector<SyntheticJoint> SixJoints() {
  return {{"0 0 0", "0 0 1"},    {"0 0 0", "1 0 0"},
          {"0 0 0", "0 1 0"},    {"0.01 0.005 -0.3", "0 1 0", "lower='-2' upper='2'"},
          {"0 0 -0.3", "0 1 0"}, {"0 0 0", "1 0 0"}};
}

}  // namespace gaitwright
