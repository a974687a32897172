// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fmt/format.h>

#include <string>
#include <vector>

#include "kinematics/dynamics/dynamics.h"
#include "tests/named_robot.h"
#include "workflows/exchange/joint_run_internal.h"

namespace gaitwright::synthetic {

/// A skeleton made from a robot, and its motion as BVH. Each joint of the skeleton moves a run of the robot's joints.
struct BvhWriter {
  const RobotModel& model;
  Matrix3 R_SB = Matrix3::Identity();  ///< axes of the file from those of the base
  double unit_m = 1.0;
  std::vector<std::vector<int>> runs = {};   ///< coordinates, parents before children
  std::vector<std::string> names = {};       ///< of the skeleton's joints, by run
  std::string order = "ZXY";                 ///< of the rotation channels
  std::string after_hierarchy = "MOTION\n";  ///< the line after the skeleton

  /// The run that carries the body from which a run starts; -1 for the base.
  int ParentOf(std::size_t run) const {
    int body = model.LeaderOf(runs[run].front()).parent_body;
    while (body > 0) {
      for (std::size_t other = 0; other < runs.size(); ++other) {
        for (const int dof : runs[other]) {
          if (model.dof_joint[static_cast<std::size_t>(dof)] + 1 == body) return static_cast<int>(other);
        }
      }
      body = model.joints[static_cast<std::size_t>(body) - 1].parent_body;
    }
    return -1;
  }

  std::string Triple(const Vector3& v) const { return fmt::format("{:.9g} {:.9g} {:.9g}", v[0], v[1], v[2]); }

  std::string Channels() const {
    std::string text;
    for (const char axis : order) text += fmt::format(" {}rotation", axis);
    return text;
  }

  std::string Skeleton(int parent, const Vector3& p_parent, int depth) const {
    const std::string space(static_cast<std::size_t>(2 * depth), ' ');
    std::string text;
    bool leaf = true;
    for (std::size_t run = 0; run < runs.size(); ++run) {
      if (ParentOf(run) != parent) continue;
      leaf = false;
      const Vector3 p = RunOf(model, runs[run]).p;
      text += space + "JOINT " + names[run] + "\n" + space + "{\n" + space + "  OFFSET " +
              Triple(R_SB * (p - p_parent) / unit_m) + "\n" + space + "  CHANNELS 3" + Channels() + "\n" +
              Skeleton(static_cast<int>(run), p, depth + 1) + space + "}\n";
    }
    if (leaf) text += space + "End Site\n" + space + "{\n" + space + "  OFFSET 0 0 0\n" + space + "}\n";
    return text;
  }

  /// Angles in degrees of a rotation, given in the axes of the base.
  std::string Angles(const Matrix3& R_B) const {
    const Matrix3 R = R_SB * R_B * R_SB.transpose();
    const auto axis = [&](std::size_t i) { return static_cast<Eigen::Index>(order[i] - 'X'); };
    const Vector3 angles = R.eulerAngles(axis(0), axis(1), axis(2)) * 180.0 / M_PI;
    return fmt::format(" {:.12g} {:.12g} {:.12g}", angles[0], angles[1], angles[2]);
  }

  /// In the order of Skeleton.
  std::string AnglesOfChildren(int parent, const VectorX& q) const {
    std::string text;
    for (std::size_t run = 0; run < runs.size(); ++run) {
      if (ParentOf(run) != parent) continue;
      const JointRun joints = RunOf(model, runs[run]);
      Matrix3 R_B = Matrix3::Identity();
      for (std::size_t i = 0; i < joints.dofs.size(); ++i)
        R_B = R_B * Eigen::AngleAxisd(q[7 + joints.dofs[i]], joints.axes[i]).toRotationMatrix();
      text += Angles(R_B) + AnglesOfChildren(static_cast<int>(run), q);
    }
    return text;
  }

  std::string Text(const std::vector<VectorX>& motion, double step_s) const {
    std::string text = "HIERARCHY\nROOT Hips\n{\n  OFFSET 0 0 0\n  CHANNELS 6 Xposition Yposition Zposition" +
                       Channels() + "\n" + Skeleton(-1, Vector3::Zero(), 1) + "}\n" + after_hierarchy +
                       fmt::format("Frames: {}\nFrame Time: {:.9g}\n", motion.size(), step_s);
    for (const VectorX& q : motion) {
      text += Triple(R_SB * q.head<3>() / unit_m) + Angles(BaseRotation(q)) + AnglesOfChildren(-1, q) + "\n";
    }
    return text;
  }
};

/// A skeleton with the robot's own joints, or with ball joints for its runs of one stem.
inline BvhWriter SkeletonOf(const RobotModel& model, bool balls) {
  BvhWriter writer{model};
  for (const std::vector<int>& run : StemRuns(model)) {
    if (balls && run.size() > 1) {
      writer.runs.push_back(run);
      writer.names.push_back(StemOf(model.dof_names[static_cast<std::size_t>(run.front())]));
      continue;
    }
    for (const int dof : run) {
      writer.runs.push_back({dof});
      writer.names.push_back(model.dof_names[static_cast<std::size_t>(dof)]);
    }
  }
  return writer;
}

/// The axes of files in which y is upward and z forward, as is usual.
inline Matrix3 YUpward() {
  Matrix3 R_SB;
  R_SB << 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0;
  return R_SB;
}

}  // namespace gaitwright::synthetic
