// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <string>

#include "tests/named_robot.h"
#include "workflows/exchange/even_motion.h"
#include "workflows/exchange/frame_motion_internal.h"

namespace gaitwright::synthetic {

/// A robot that stands still, in rows of 10 ms.
inline EvenMotion Standing(const RobotModel& model, int rows) {
  EvenMotion motion;
  motion.step_s = 0.01;
  motion.q.assign(static_cast<std::size_t>(rows), StandingConfiguration(model));
  motion.v.assign(motion.q.size(), VectorX::Zero(model.nv()));
  motion.a = motion.v;
  return motion;
}

/// Bends the knee of a leg in some rows, so that its foot is in the air there.
inline void BendKnee(const RobotModel& model, int leg, int first, int behind, EvenMotion& motion) {
  const int joint = model.legs[static_cast<std::size_t>(leg)].knee_joint;
  const int dof = model.joints[static_cast<std::size_t>(joint)].dof;
  for (int k = first; k < behind; ++k) motion.q[static_cast<std::size_t>(k)][7 + dof] -= 0.5;
}

/// Frames without names, at 100 Hz.
inline std::string FramesOf(const RobotModel& model, const EvenMotion& motion, const std::string& before = "",
                            const std::string& after = "\n") {
  const std::vector<std::string> order = DescribedJointOrder(model);
  std::string text;
  for (const VectorX& q : motion.q) {
    text += before;
    for (Eigen::Index i = 0; i < 7; ++i) text += (i == 0 ? "" : ",") + std::to_string(q[i]);
    for (const std::string& joint : order) text += "," + std::to_string(q[7 + model.DofIndex(joint)]);
    text += after;
  }
  return text;
}

}  // namespace gaitwright::synthetic
