// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/model/robot_model.h"
#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// Errors that justify changing the forces of all feet by their full load; all > 0.
struct MomentumErrors {
  double position_m = 0.0;    ///< of the centre of mass
  double velocity_m_s = 0.0;  ///< of the centre of mass
  double turn_rad = 0.0;      ///< of the base
  double rate_rad_s = 0.0;    ///< of the base
  double step_m = 0.0;        ///< of a foothold relative to the body, at touch-down
};

/// Linear feedback of a robot's momentum along a whole plan.
///
/// The state x of a robot with n feet is its error against the plan, in W:
///   place and velocity of C; turn of the base (rotation vector); angular momentum about C over the locked inertia;
///   by foot x and y of its place on the ground, zero in the air.
/// Errors that feet in a line or a single foot cannot correct, or only at a high cost in other errors, are left to the
/// later stances and to their footholds.
struct MomentumGains {
  static constexpr Eigen::Index kFeet = 12;  ///< first row of x that belongs to a foot

  /// Gains in an interval of the plan's grid.
  struct Row {
    /// By foot, 6 x (12 + 2 n): change of its wrench about its contact, per newton of planned normal force.
    std::vector<MatrixX> wrench_per_n;
    /// 2 n x (12 + 2 n): by foot, shift of its next foothold from the plan if this feedback continues until then.
    MatrixX steps;
  };
  double start_s = 0.0, step_s = 0.0;
  std::vector<Row> rows;  ///< in order

  /// The row at a time; before the start the first, after the end the last. There must be at least one.
  const Row& At(double time_s) const;
};

/// The feedback of least cost, by the discrete Riccati equation backwards along the plan. With u_i the change of a
/// point's force as a share of its load (tangents also divided by friction), T = sqrt(leg length / g):
///   cost = integral of (sum of squared errors, each divided by its value in MomentumErrors, + |u|^2) dt / T
///          + at each touch-down |dr_i - dp|^2 / step^2,  dr_i chosen
///   dp' = dv,  m dv' = sum df_i,  turn' = w x turn + rate,  I rate' = sum (r_i - p) x df_i + (dr_i - dp) x f_i
/// Anderson and Moore, Optimal Control: Linear Quadratic Methods, 1990; the body as in Di Carlo et al., IROS 2018.
/// @param plan  with motion, forces and schedule; two rows or more.
MomentumGains DeriveMomentumGains(const RobotModel& model, const MotionPlan& plan, const MomentumErrors& errors);

}  // namespace gaitwright
