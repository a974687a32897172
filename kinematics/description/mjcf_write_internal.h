// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "kinematics/description/mjcf_equality_internal.h"
#include "kinematics/description/mjcf_inertia_internal.h"
#include "kinematics/description/mjcf_shapes_internal.h"

namespace gaitwright {

/// A robot for the writers: the tree, with the data found for its bodies and joints by index.
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

/// The URDF. Each body becomes a link of the same name. The origin of a moving joint's child link is the anchor of the
/// joint. So the link's frame L differs from the body's frame B by the anchor: X_LB = translation(-pos) if one joint
/// moves the body. Several joints of a body become a chain with links without mass.
std::string WriteMjcfUrdf(const MjcfRobot& robot);

/// The robot.yaml: name, limits that a URDF cannot contain, gains, motors and standing posture.
std::string WriteMjcfYaml(const MjcfRobot& robot);

}  // namespace gaitwright
