// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/spatial/pose.h"

namespace gaitwright {

/// A point through which the ground can push on the robot.
struct ContactPoint {
  Vector3 p_W = Vector3::Zero();        ///< [m]
  Vector3 normal_W = Vector3::UnitZ();  ///< unit, out of the ground
  double friction = 0.8;
  double reluctance =
      1.0;  ///< > 0: forces are shared in inverse proportion; large for a foot about to leave or just landed
};

/// A force and a moment about a point, in W.
struct PointWrench {
  Vector3 p_W = Vector3::Zero();
  Vector3 force_W = Vector3::Zero();
  Vector3 moment_W = Vector3::Zero();
};

/// Contact forces for a desired wrench, and the remaining part of the wrench.
struct ContactSplit {
  std::vector<Vector3> force_W;                 ///< by contact, each inside its friction cone
  Vector3 residual_force_W = Vector3::Zero();   ///< desired minus actual force [N]
  Vector3 residual_moment_W = Vector3::Zero();  ///< about the reference point of the desired wrench [N m]
  int iterations = 0;
};

/// The contact forces of least weighted square sum with a given wrench, each inside its second-order friction cone:
///   min sum_i reluctance_i |f_i|^2 / 2   s.t.  sum_i f_i = F,  sum_i (p_i - p) x f_i = M,  f_i in K_i.
/// Solved in the dual, six unknowns y: f_i = project_Ki(G_i^T y / reluctance_i), by a semi-smooth Newton method with
/// line search. A small penalty on y makes it a least-squares fit if the wrench is not possible (two point feet cannot
/// give a moment about the line between them). The result is a continuous function of its inputs. Projection onto the
/// second-order cone: Boyd and Vandenberghe, Convex Optimization, 2004, exercise 8.3(c).
class ContactSplitter {
 public:
  /// @throws InvalidArgument for no contact, and for a friction or reluctance that is not positive.
  void Solve(const std::vector<ContactPoint>& contacts, const PointWrench& wanted, ContactSplit& split);

 private:
  struct Map {
    Eigen::Matrix<double, 3, 6> Gt;      // force in the contact's axes (two tangents, normal) per unit of y
    Eigen::Matrix<double, 6, 6> inside;  // Hessian of a force inside of its cone
    double mu, weight;
  };
  double Dual(const Vector6& wanted, const Vector6& y, bool with_derivatives);
  bool Climb(const Vector6& wanted, double penalty, Vector6& y, int& iterations);

  std::vector<Map> maps_;
  std::vector<Vector3> forces_;
  double penalty_ = 0.0;
  Vector6 gradient_;
  Eigen::Matrix<double, 6, 6> hessian_;
};

}  // namespace gaitwright
