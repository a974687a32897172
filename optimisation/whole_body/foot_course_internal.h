// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/trajectory/swing_curve.h"
#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// Where one foot of a leg is to be over a plan: on its footholds and along its swings, as if spheres did not roll.
/// After heel-off a sole turns about its front edge, by a minimum-jerk move, into the pose from which it swings.
///
/// A sphere's contact point is on the course plus what it has rolled since the start of the plan, in stance and in
/// swing (RollsOf).
class FootCourse {
 public:
  /// The plan must have a swing between any two footholds of the foot, and outlive this.
  FootCourse(const RobotModel& model, const MotionPlan& plan, int foot);

  struct Place {
    Pose X_WF = Pose::Identity();  ///< contact frame
    bool swings = false;           ///< both ends of a swing belong to stances
    bool presses = false;          ///< it may bear load: not where it lands or leaves
    bool on_edge = false;          ///< a sole that stands on its front edge
    std::size_t foothold = 0;      ///< of the plan: that it stands on, or left last
  };
  Place At(double time_s) const;

  int foot() const { return foot_; }
  /// The plan's footholds of this foot, by index.
  const std::vector<std::size_t>& footholds() const { return footholds_; }
  /// Where the course passes each of them: the foothold less `roll_W`, what has been rolled at touch-down, by foothold
  /// of this foot.
  void SetRolls(const std::vector<Vector3>& roll_W);
  const Vector3& PathAt(std::size_t stance) const { return path_W_[stance]; }

 private:
  Pose OnEdge(std::size_t stance, double time_s) const;

  const MotionPlan& plan_;
  const Foot& shape_;
  int foot_;
  double start_s_, end_s_;
  std::vector<std::size_t> footholds_;
  std::vector<SwingCurve> swings_;
  std::vector<Vector3> path_W_;  // by foothold of this foot
};

/// Of all legs' feet.
std::vector<FootCourse> CoursesOf(const RobotModel& model, const MotionPlan& plan);

/// How far the foot of each leg has rolled since the start, and its rotation, by foot and row of a trajectory. A foot
/// that is no sphere does not roll.
struct FootRolls {
  std::vector<std::vector<Vector3>> roll_W;
  std::vector<std::vector<Matrix3>> R_WF;

  /// The roll of a foot with rotation R near a row: what is rolled until then, on ground of a normal.
  Vector3 At(const Foot& foot, std::size_t index, std::size_t row, const Matrix3& R_WF_now,
             const Vector3& normal_W) const;
};
FootRolls RollsOf(const RobotModel& model, const WholeBodyTrajectory& motion, const std::vector<FootCourse>& courses);

}  // namespace gaitwright
