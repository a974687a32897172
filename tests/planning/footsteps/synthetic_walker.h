// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fmt/format.h>

#include <string>

#include "kinematics/model/load_robot.h"

namespace gaitwright {

inline std::string LinkXml(const std::string& name, double mass, double inertia, const std::string& more = "") {
  return fmt::format(
      "<link name='{0}'><inertial><mass value='{1}'/><inertia ixx='{2}' iyy='{2}' izz='{2}' ixy='0' ixz='0' iyz='0'/>"
      "</inertial>{3}</link>",
      name, mass, inertia, more);
}

inline std::string JointXml(const std::string& parent, const std::string& child, const std::string& at,
                            const std::string& axis) {
  return fmt::format(
      "<joint name='{1}_joint' type='revolute'><parent link='{0}'/><child link='{1}'/><origin xyz='{2}'/>"
      "<axis xyz='{3}'/><limit lower='-2.6' upper='2.6' velocity='30' effort='200'/></joint>",
      parent, child, at, axis);
}

/// A URDF with `rows` pairs of legs of three joints on spherical feet, left before right, front before rear.
inline std::string WalkerUrdf(int rows) {
  std::string text = "<robot name='walker'>" + LinkXml("trunk", 10.0, 0.3);
  for (int row = 0; row < rows; ++row) {
    for (const double side : {1.0, -1.0}) {
      const std::string leg = fmt::format("{}{}", side > 0.0 ? "L" : "R", row);
      text += LinkXml(leg + "_hip", 0.3, 0.001) + LinkXml(leg + "_thigh", 0.3, 0.001);
      text += LinkXml(leg + "_shank", 0.2, 0.001);
      text += LinkXml(leg + "_foot", 0.05, 1e-5, "<collision><geometry><sphere radius='0.02'/></geometry></collision>");
      text += JointXml("trunk", leg + "_hip", fmt::format("{} {} 0", 0.3 - 0.3 * row, 0.12 * side), "1 0 0");
      text += JointXml(leg + "_hip", leg + "_thigh", fmt::format("0 {} 0", 0.06 * side), "0 1 0");
      text += JointXml(leg + "_thigh", leg + "_shank", "0 0 -0.2", "0 1 0");
      text += fmt::format(
          "<joint name='{0}_foot_joint' type='fixed'><parent link='{0}_shank'/><child link='{0}_foot'/>"
          "<origin xyz='0 0 -0.2'/></joint>",
          leg);
    }
  }
  return text + "</robot>";
}

inline RobotModel Walker(int rows) { return *LoadRobotFromText(WalkerUrdf(rows), "", "walker"); }

}  // namespace gaitwright
