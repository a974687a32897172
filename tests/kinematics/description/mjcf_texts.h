// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <numbers>
#include <string>
#include <vector>

#include "kinematics/description/mjcf.h"
#include "kinematics/model/ball_joints.h"
#include "kinematics/model/build_model.h"
#include "tests/kinematics/model/small_urdf.h"

namespace gaitwright {

inline constexpr double kDegree = std::numbers::pi / 180.0;  // [rad]

/// A model of one free body 'base' of 1 kg. @param inside  its other elements. @param sections  sections after
/// <worldbody>.
inline std::string MjcfOf(const std::string& inside, const std::string& sections = "") {
  return "<mujoco model='made'>\n" + sections +
         "\n<worldbody>\n<body name='base'>\n<freejoint/>\n<inertial pos='0 0 0' mass='1' diaginertia='0.1 0.1 "
         "0.1'/>\n" +
         inside + "\n</body>\n</worldbody>\n</mujoco>\n";
}

/// A body of 1 kg. @param inside  its other elements.
inline std::string MjcfBodyOf(const std::string& name, const std::string& inside, const std::string& pose = "") {
  return "<body name='" + name + "' " + pose + ">\n<inertial pos='0 0 -0.1' mass='1' diaginertia='0.01 0.01 0.01'/>\n" +
         inside + "\n</body>\n";
}

/// The conversion of a model, or a failed test.
inline ConvertedMjcf Converted(const std::string& text, const MjcfFiles& files = {}) {
  Result<ConvertedMjcf> converted = ConvertMjcfText(text, files);
  EXPECT_TRUE(converted.ok()) << (converted.ok() ? "" : converted.failure().message) << "\n" << text;
  return converted.ok() ? *converted : ConvertedMjcf();
}

/// The message of a refused model; "" if it is accepted.
inline std::string MjcfMessage(const std::string& text, const MjcfFiles& files = {}) {
  const Result<ConvertedMjcf> converted = ConvertMjcfText(text, files);
  return converted.ok() ? "" : converted.failure().message;
}

/// Expects a note that contains all parts.
inline void ExpectNote(const ConvertedMjcf& converted, const std::vector<std::string>& parts) {
  std::string all;
  for (const std::string& note : converted.notes) {
    bool says = true;
    for (const std::string& part : parts) says = says && note.find(part) != std::string::npos;
    if (says) return;
    all += note + "\n";
  }
  ADD_FAILURE() << "no note says '" << parts.front() << "' and the rest; there are:\n" << all;
}

/// Bodies and joints of the URDF, without deriving legs.
inline RobotModel TreeOf(const ConvertedMjcf& converted) {
  const std::string urdf = WithoutBallJoints(converted.urdf);
  Result<RobotModel> model = BuildModel(SplitUrdf(urdf, 1.0), "made", 1.0);
  EXPECT_TRUE(model.ok()) << (model.ok() ? "" : model.failure().message) << "\n" << converted.urdf;
  return model.ok() ? *model : RobotModel();
}

/// The Failure that a call throws, or a failed test.
template <class Call>
Failure MjcfFailureOf(const Call& call) {
  try {
    call();
  } catch (const Failure& failure) {
    return failure;
  }
  ADD_FAILURE() << "the call throws no Failure";
  return {};
}

inline const Joint& JointNamed(const RobotModel& model, const std::string& name) {
  return model.joints[static_cast<std::size_t>(model.dof_joint[static_cast<std::size_t>(model.DofIndex(name))])];
}

}  // namespace gaitwright
