// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/dynamics/dynamics.h"
#include "kinematics/model/robot_model.h"
#include "kinematics/spatial/pose.h"

namespace gaitwright {

/// Desired motion of a foot's controlled frame (Foot::X_BF on Foot::body) in W.
struct FootMotion {
  Pose X_WF = Pose::Identity();
  Vector6 v_WF = Vector6::Zero();        ///< linear, then angular
  Vector3 a_extra_WF = Vector3::Zero();  ///< acceleration beyond the plan's, for the feed-forward [m/s^2]
};

/// Joint targets of single legs in the world frame, for the measured base pose instead of the planned one.
///
/// A leg is moved by the motors that it does not share. If they are fewer than the foot's conditions, position has
/// priority, then roll and pitch of a sole; its yaw is dropped.
class LegTargets {
 public:
  explicit LegTargets(const RobotModel& model);

  /// The leg's own independent joints; empty if they are fewer than three.
  const std::vector<int>& dofs(int leg) const { return dofs_[static_cast<std::size_t>(leg)]; }

  /// Moves the leg's entries of q (size nq; holds base pose and initial guess) and v (size nv; holds base velocity) to
  /// the desired motion. A foot that cannot reach its target comes as near as the iterations allow. The joints keep a
  /// small distance from their limits, or the planned distance if that is smaller.
  void Solve(int leg, const FootMotion& wanted, const VectorX& q_planned, VectorX& q, VectorX& v);

  /// Sets the leg's entries of v so that its contact point keeps its measured velocity, but not faster than creep_m_s
  /// (0: it stands still), on ground with the given normal, at the state q, v. The measured speed of a foot at rest is
  /// mostly noise.
  void Hold(int leg, const Vector3& normal_W, double creep_m_s, const VectorX& q, VectorX& v);

  /// Factors on the damping of a standing leg's joints, by dof of the leg; 1 for a foot without a sole. The joints'
  /// gains hold a foot at the end of the whole leg, m l^2 w. A joint at the distance r from the sole's middle moves the
  /// foot by r only, so it gets m r^2 w; r is at least the radius of the sole. A stiffer ankle would keep a sole on its
  /// edge. Joints that turn a sole about its normal have the factor 1. Call Hold first.
  VectorX SettlingShares(int leg, const Vector3& normal_W) const;

  /// Torques of the leg's joints for the extra acceleration: M_ll J_l^+ a. Call Solve first.
  /// @param M  mass matrix of the robot, nv x nv.
  VectorX ExtraTorque(int leg, const FootMotion& wanted, const MatrixX& M) const;

 private:
  static constexpr int kMost = 12;
  using Jacobian = Eigen::Matrix<double, 6, Eigen::Dynamic, 0, 6, kMost>;
  using Joints = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMost, 1>;

  void UpdateJacobian(int leg, const Vector3& p_BQ);
  void SetRates(int leg, const Vector6& wanted, VectorX& v) const;
  void KeepMotorSpeeds(const std::vector<int>& dofs, VectorX& v) const;
  Joints LeastSquares(const Vector6& rows) const;

  const RobotModel& model_;
  DynamicsScratch scratch_;
  std::vector<std::vector<int>> dofs_;
  std::vector<std::vector<int>> chains_;  ///< by foot: joints between the foot and the base
  std::vector<double>
      fastest_;  ///< by dof [rad/s or m/s]; near a straight knee a slow foot may require any joint speed
  MatrixX whole_;
  Jacobian jacobian_;
  Vector6 weight_ = Vector6::Ones();
};

}  // namespace gaitwright
