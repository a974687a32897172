// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>
#include <vector>

#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// The joints of one leg as lines in the base at joint positions zero, so that
///   X_BF = E_1 E_2 ... E_n X_BF(0),  E_i the motion about (or along) line i.
/// Coordinates are the dofs that move the leg: position of a joint = multiplier * coordinate + offset.
///
/// Murray, Li and Sastry 1994, section 3.2.2: product of exponentials.
struct LegChain {
  /// One joint of the chain, in the base frame.
  struct Link {
    std::string name;
    Vector3 axis_B = Vector3::UnitZ();  ///< unit, at positions zero
    Vector3 point_B = Vector3::Zero();  ///< on the axis [m], at positions zero
    bool turns = true;                  ///< false: prismatic
    int coordinate = 0;                 ///< index into dofs
    double multiplier = 1.0, offset = 0.0;
  };
  using Jacobian = Eigen::Matrix<double, 6, Eigen::Dynamic>;

  /// @throws InvalidArgument for a leg that does not exist.
  LegChain(const RobotModel& model, int leg);

  /// X_BF. @param coordinates  same size as dofs.
  Pose FootPose(const VectorX& coordinates) const;
  /// X_BF with its Jacobian J: [v_BF in B; w_BF in F] = J times the rates of the coordinates. `screws` (6 x links) is
  /// scratch memory.
  Pose FootPose(const VectorX& coordinates, Jacobian& screws, Jacobian& J) const;

  int num_coordinates() const { return static_cast<int>(dofs.size()); }
  /// Whether every joint is revolute and has its own coordinate.
  bool IsPlain() const;

  std::string foot_name;
  std::vector<Link> links;       ///< base first
  std::vector<int> dofs;         ///< dofs of the model, in the order of the joints
  std::vector<int> shared_dofs;  ///< dofs that also move another leg
  VectorX lower, upper;          ///< limits of the coordinates, from all joints that they move
  VectorX standing;              ///< coordinates of the standing posture
  Pose X_BF_zero = Pose::Identity();
  double length_m = 0.0;  ///< leg length, which scales positions

  /// Controlled rows: 0..2 position in B, 3..5 rotation about the axes of F.
  std::array<int, 6> rows{};
  int num_rows = 0;

 private:
  void AddLinks(const RobotModel& model, const Leg& leg);
  void ChooseRows(const Foot& foot);
};

}  // namespace gaitwright
