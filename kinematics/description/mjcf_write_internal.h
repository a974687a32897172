// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "kinematics/description/mjcf_equality_internal.h"
#include "kinematics/description/mjcf_inertia_internal.h"
#include "kinematics/description/mjcf_shapes_internal.h"

namespace gaitwright {

/// A robot as it is written: the tree with all that was found for its bodies and joints, by their indices.
struct MjcfRobot {
  std::string name;
  MjcfTree tree;
  std::vector<MjcfDrive> drives;
  std::vector<MjcfCoupling> couplings;
  std::vector<double> efforts;
  std::vector<MjcfInertia> inertias;
  std::vector<std::vector<MjcfUrdfShape>> collision, visual;
  std::vector<std::pair<std::string, double>> posture;
};

/// The URDF. Each body is a link of its name. A joint that moves has its anchor as the origin of its child link, so the
/// link's frame L differs from the body's frame B by the anchor: X_LB = translation(-pos) where one joint moves the
/// body. Several joints of a body are a chain of links without mass between them.
std::string WriteMjcfUrdf(const MjcfRobot& robot);

/// The robot.yaml: name, limits that a URDF cannot say, gains, motors and standing posture.
std::string WriteMjcfYaml(const MjcfRobot& robot);

}  // namespace gaitwright
