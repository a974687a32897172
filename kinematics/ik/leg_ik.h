// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "kinematics/base/result.h"
#include "kinematics/ik/leg_chain.h"
#include "kinematics/ik/leg_closed_form.h"
#include "kinematics/ik/reach_gap.h"
#include "kinematics/model/robot_model.h"
#include "kinematics/spatial/pose.h"

namespace gaitwright {

struct DampedSearch;

/// Joint positions of one leg from the pose X_BF of its foot's controlled frame in the base: the middle of a sole, the
/// centre of a sphere.
///
/// For points and spheres, only the position is controlled (three rows); for soles, position and rotation (six rows).
/// If the leg has fewer degrees of freedom, the position of a sole or line has priority, then as many rotations as
/// possible: for a sole pitch, roll, yaw in this order; for a line pitch, yaw, roll.
///
/// The method depends only on the model's geometry; see FitThreeJointForm and FitSixJointForm for the two closed forms.
/// Other legs, and legs with several joints on one coordinate, are solved by damped least squares. Rounded angles in
/// the file do not prevent a closed form: least squares removes the remaining error.
///
/// Coordinates are the dofs that move the leg: position of a joint = multiplier * dof + offset. The limits of all
/// joints that the dof moves apply. A dof that also moves another leg (NAO's hip yaw-pitch) is solved for this leg
/// only. `shared_dofs` lists it, and the solutions of two such legs agree only if their targets do.
///
/// Among several solutions within the limits, a solution whose knee bends to the side of the guess has priority (of the
/// standing posture if the guess is straight), then the nearest to the guess.
///
/// Immutable, so one object can be used by several threads.
class LegIk {
 public:
  enum class Method {
    kThreeJoint,  ///< closed form for abduction, hip and knee
    kSixJoint,    ///< closed form for three axes that meet, a knee, and two axes that meet
    kDamped,      ///< least squares from the guess and from seeded random positions
  };
  /// Joint positions that bring the foot to its target.
  struct Solution {
    VectorX joints;      ///< by dofs(), within the limits
    int branches = 0;    ///< number of solutions within the limits, including this one; 1 without closed form
    int iterations = 0;  ///< iterations of least squares; 0 if the closed form was exact
  };

  /// @throws InvalidArgument if the model has no such leg.
  LegIk(const RobotModel& model, int leg);
  /// Uses a given method. @throws InvalidArgument if the leg's geometry does not fit the method.
  LegIk(const RobotModel& model, int leg, Method method);

  /// @param X_BF_target  [m]; its rotation matrix must be orthonormal (not checked).
  /// @param guess        by dofs() [rad] or [m]. A closed form finds all solutions. kDamped may fail although a
  /// solution exists, mainly if the leg is singular close to its limits (about one pose in ten thousand from random
  /// guesses); a near guess helps.
  /// @return Failure kInfeasible: `out_of_reach` with distance and direction, or `joint_limit` with the joint, its
  /// position and its limit. @throws InvalidArgument for a guess of wrong size and for values that are not finite.
  Result<Solution> Solve(const Pose& X_BF_target, const VectorX& guess) const;
  /// Solves from the standing posture.
  Result<Solution> Solve(const Pose& X_BF_target) const { return Solve(X_BF_target, chain_.standing); }

  /// The same for a target close to that of the guess: a leg without closed form is searched from the guess alone,
  /// which is a hundred times faster for targets that are not reached. Nothing if the target is not reached from there.
  std::optional<VectorX> SolveNear(const Pose& X_BF_target, const VectorX& guess) const;

  /// X_BF at joint positions by dofs().
  Pose FootPose(const VectorX& joints) const { return chain_.FootPose(joints); }

  /// Distance of a target from the reach of the leg without joint limits. Exact in closed form; with kDamped, it is the
  /// smallest remaining error of least squares, with rotation weighted by the leg's length.
  ReachGap Gap(const Pose& X_BF_target) const;

  Method method() const { return method_; }
  /// Dofs of the model in the order of guess and solution, base first.
  const std::vector<int>& dofs() const { return chain_.dofs; }
  /// The members of dofs() that also move another leg.
  const std::vector<int>& shared_dofs() const { return chain_.shared_dofs; }

 private:
  struct Choice {
    Vector6 positions = Vector6::Zero();
    double violation = 0.0, cost = 0.0;
    bool bends_back = false;
    int branches = 0;
  };

  void Check(const Pose& X_BF_target, const VectorX& guess) const;
  Choice Choose(const LegBranches& branches, const Vector6& guess) const;
  bool Reaches(const Pose& X_BF_target, const VectorX& joints) const;
  Result<Solution> SolveDamped(const Pose& X_BF_target, const VectorX& guess) const;
  ReachGap GapOf(const Pose& X_BF_target, const DampedSearch& best) const;
  VectorX Unlimited(bool upper) const;
  Failure OutOfReach(const ReachGap& gap) const;
  Failure JointLimit(const VectorX& joints) const;

  LegChain chain_;
  Method method_ = Method::kDamped;
  std::shared_ptr<const LegClosedForm> form_;                  // null with kDamped
  Vector6 lower_ = Vector6::Zero(), upper_ = Vector6::Zero();  // limits of the positions, with a closed form
  double bend_ = 0.0;                                          // sign of the standing knee
};

}  // namespace gaitwright
