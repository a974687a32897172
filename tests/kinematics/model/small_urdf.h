// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "kinematics/model/load_robot.h"

namespace gaitwright {

inline std::string Replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
    text.replace(at, from.size(), to);
  return text;
}

/// Expects all parts in the message.
inline void ExpectSays(const std::string& message, const std::vector<std::string>& parts) {
  for (const std::string& part : parts) {
    EXPECT_NE(message.find(part), std::string::npos) << "'" << message << "' should say '" << part << "'";
  }
}

/// The message of a refused robot; "" if it is accepted.
inline std::string MessageOf(const std::string& urdf, const std::string& yaml = "", bool strict = false) {
  const Result<RobotModel> model = LoadRobotFromText(urdf, yaml, "robot", {}, strict);
  return model.ok() ? "" : model.failure().message;
}

/// A joint about y with the elements `extra`.
inline std::string PitchJoint(const std::string& name, const std::string& parent, const std::string& child,
                              const std::string& xyz, const std::string& extra = "") {
  return "<joint name='" + name + "' type='revolute'><parent link='" + parent + "'/><child link='" + child +
         "'/><origin xyz='" + xyz +
         "'/><axis xyz='0 1 0'/><limit lower='-2' upper='1' effort='30' velocity='20'/><dynamics damping='0.1'/>" +
         extra + "</joint>";
}

inline std::string SmallLink(const std::string& name, const std::string& geometry = "") {
  return "<link name='" + name +
         "'><inertial><mass value='1'/><inertia ixx='0.01' iyy='0.01' izz='0.01' ixy='0' ixz='0' iyz='0'/></inertial>" +
         (geometry.empty() ? "" : "<collision><geometry>" + geometry + "</geometry></collision>") + "</link>";
}

/// Four legs with hip, knee and links of 0.2 m: `A_hip`, `A_knee`, `A_shank`, `A_foot` and so on. A and B are in front
/// (A left), C and D behind. The knee of each leg contains the placeholder `A_extra`.
/// @param foot  geometry of each foot.
inline std::string FourLegs(const std::string& foot = "<sphere radius='0.02'/>") {
  std::string text = "<robot name='four'>" + SmallLink("trunk", "<box size='0.4 0.2 0.1'/>");
  for (const std::string leg : {"A", "B", "C", "D"}) {
    const std::string at = std::string(leg < "C" ? "0.2 " : "-0.2 ") + (leg == "A" || leg == "C" ? "0.1 0" : "-0.1 0");
    text += SmallLink(leg + "_thigh") + SmallLink(leg + "_shank") + SmallLink(leg + "_foot", foot);
    text += PitchJoint(leg + "_hip", "trunk", leg + "_thigh", at);
    text += PitchJoint(leg + "_knee", leg + "_thigh", leg + "_shank", "0 0 -0.2", "<!--" + leg + "_extra-->");
    text += "<joint name='" + leg + "_end' type='fixed'><parent link='" + leg + "_shank'/><child link='" + leg +
            "_foot'/><origin xyz='0 0 -0.2'/></joint>";
  }
  return text + "</robot>";
}

/// FourLegs with a text for the placeholder of one leg, for example a knee that mimics another joint.
inline std::string FourLegsWhere(const std::string& leg, const std::string& extra) {
  return Replaced(FourLegs(), "<!--" + leg + "_extra-->", extra);
}

}  // namespace gaitwright
