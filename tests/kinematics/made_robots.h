// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>

#include "tests/kinematics/ik/synthetic_legs.h"
#include "tests/kinematics/random_state.h"

namespace gaitwright {

/// Robots of the program, and made-up robots with kinds of joints and links that those do not have.
inline const char* const kAnyRobots[] = {"a1", "nao", "sliding", "continuous", "hollow", "mimic", "line"};

/// URDF of a made-up biped, by kind: a prismatic knee; a continuous hip; links without mass between the joints of the
/// hip; a thigh with two coupled joints and a shin whose length follows the knee; ankles without roll.
inline std::string MadeUrdf(const std::string& kind) {
  std::vector<SyntheticJoint> joints = SixJoints();
  if (kind == "sliding") joints[3] = {"0.01 0.005 -0.3", "0 0 1", "lower='-0.1' upper='0.1'", "", "prismatic"};
  if (kind == "continuous") joints[2] = {"0 0 0", "0 1 0", "", "", "continuous"};
  if (kind == "mimic") {
    joints.insert(joints.begin() + 4, {"0 0 -0.1", "0 0 1", "lower='-0.1' upper='0.1'",
                                       "<mimic joint='j_SIDE4' multiplier='0.02' offset='0.01'/>", "prismatic"});
    joints.insert(joints.begin() + 3,
                  {"0 0 -0.05", "0 1 0", "lower='-2' upper='2'", "<mimic joint='j_SIDE2' multiplier='-0.2'/>"});
  }
  if (kind == "line") joints.pop_back();
  std::string urdf = SyntheticUrdf(joints, kBoxFoot);
  if (kind != "hollow") return urdf;
  for (const std::string link : {"l0", "l1", "r0", "r1"}) {
    const std::size_t at = urdf.find("<link name='" + link + "'>"), end = urdf.find("</link>", at);
    urdf.replace(at, end - at, "<link name='" + link + "'>");
  }
  return urdf;
}

/// One of kAnyRobots. Each robot is loaded only once.
inline RobotModel AnyRobot(const std::string& name) {
  static std::map<std::string, RobotModel> loaded;
  if (const auto known = loaded.find(name); known != loaded.end()) return known->second;
  if (name == "a1" || name == "nao") return loaded[name] = Robot(name);
  Result<RobotModel> model = LoadRobotFromText(MadeUrdf(name), "");
  EXPECT_TRUE(model.ok()) << (model.ok() ? "" : model.failure().message);
  return loaded[name] = std::move(model).value();
}

}  // namespace gaitwright
