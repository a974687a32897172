// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "kinematics/dynamics/dynamics.h"
#include "kinematics/model/load_robot.h"
#include "kinematics/spatial/rotation.h"
#include "planning/plan/gait.h"

namespace gaitwright::swaying {

/// A robot whose base sways and turns above feet that stand still exactly; joints by Newton's method.
class Robot {
 public:
  /// @param stands  feet that do not move.
  Robot(RobotModel robot, FootSet stands) : model(std::move(robot)), scratch_(model), jacobian_(6, model.nv()) {
    q = StandingConfiguration(model);
    v = VectorX::Zero(model.nv());
    ForwardKinematics(model, q, scratch_);
    for (std::size_t f = 0; f < model.feet.size(); ++f) {
      if (!Contains(stands, static_cast<int>(f))) continue;
      feet_.push_back(f);
      places_.push_back(FramePose(scratch_, model.feet[f].body, model.feet[f].X_BF));
    }
    home_ = q;
  }

  /// From a time on, all soles that stand turn about their middles, at a constant rate for `for_s`, and stay so.
  void RockSoles(const Vector3& turn_W, double from_s, double for_s) {
    rock_W_ = turn_W;
    rock_from_s_ = from_s;
    rock_for_s_ = for_s;
  }

  /// The state at a time; velocities are differences over the step, as in the simulator.
  void MoveTo(double t, double step_s) {
    const VectorX before = q;
    rocked_ = RotationExp(std::clamp((t - rock_from_s_) / rock_for_s_, 0.0, 1.0) * rock_W_);
    const double ramp = 1.0 - std::exp(-4.0 * t * t);
    const Vector3 sway(0.02 * std::sin(5.0 * t), 0.015 * std::sin(7.0 * t + 1.0) - 0.0126, 0.01 * std::sin(4.0 * t));
    const Vector3 turn(0.05 * std::sin(6.0 * t), 0.06 * std::sin(4.5 * t), 0.08 * std::sin(3.0 * t));
    q.head<3>() = home_.head<3>() + ramp * sway;
    const Matrix3 R_before = BaseRotation(before), R_WB = RotationExp(ramp * turn);
    q.segment<4>(3) = Quaternion(R_WB).coeffs();
    for (int i = 0; i < 6; ++i) PullFeetBack();
    v.head<3>() = (q.head<3>() - before.head<3>()) / step_s;
    v.segment<3>(3) = R_WB * RotationLog(R_before.transpose() * R_WB) / step_s;
    v.tail(model.num_dofs()) = (q - before).tail(model.num_dofs()) / step_s;
  }

  const RobotModel model;
  VectorX q, v;

 private:
  void PullFeetBack() {
    ForwardKinematics(model, q, scratch_);
    int rows = 0;
    for (const std::size_t f : feet_) rows += model.feet[f].has_sole() ? 6 : 3;
    MatrixX J(rows, model.num_dofs());
    VectorX off(rows);
    int row = 0;
    for (std::size_t i = 0; i < feet_.size(); ++i) {
      const Foot& foot = model.feet[feet_[i]];
      const int size = foot.has_sole() ? 6 : 3;
      const Pose X_WF = FramePose(scratch_, foot.body, foot.X_BF);
      PointJacobian(model, scratch_, foot.body, foot.X_BF.translation(), jacobian_);
      J.middleRows(row, size) = jacobian_.topRightCorner(size, model.num_dofs());
      Vector6 error;
      error << places_[i].translation() - X_WF.translation(),
          RotationLog(rocked_ * places_[i].linear() * X_WF.linear().transpose());
      off.segment(row, size) = error.head(size);
      row += size;
    }
    q.tail(model.num_dofs()) += J.completeOrthogonalDecomposition().solve(off);
  }

  DynamicsScratch scratch_;
  MatrixX jacobian_;
  std::vector<std::size_t> feet_;
  std::vector<Pose> places_;
  VectorX home_;
  Vector3 rock_W_ = Vector3::Zero();
  double rock_from_s_ = 0.0, rock_for_s_ = 1.0;
  Matrix3 rocked_ = Matrix3::Identity();
};

/// A quadruped on point feet.
inline Robot OnPoints() {
  RobotModel model = LoadNamedRobot("a1").value();
  for (Foot& foot : model.feet) {
    foot.type = FootType::kPoint;
    foot.radius = 0.0;
  }
  return {model, AllFeet(4)};
}

/// A biped on one sole.
inline Robot OnASole() { return {LoadNamedRobot("nao").value(), FootBit(0)}; }

}  // namespace gaitwright::swaying
