// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
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
/// Points and spheres are placed (three rows), soles placed and turned (six). A sole or line foot on a leg with fewer
/// freedoms keeps, after its position, as many rotations as are left: a sole pitch, roll, yaw in this order; a line
/// pitch, yaw, roll.
///
/// The method follows from the model's geometry alone; see FitThreeJointForm and FitSixJointForm for the two closed
/// forms. Any other leg, and one whose joints share coordinates among themselves, is solved by damped least squares.
/// Rounded angles in the file do not prevent a closed form: the remaining error is removed by least squares.
///
/// Coordinates are the dofs that move the leg: position of a joint = multiplier * dof + offset, and its limits hold
/// for every joint that the dof moves. A dof that moves another leg too (NAO's hip yaw-pitch) is solved for this leg
/// alone: `shared_dofs` lists it, and two such legs agree only if their targets do.
///
/// Among several solutions within the limits: first those whose knee bends as the guess's does (as the standing
/// posture's where the guess is straight), then the nearest to the guess.
///
/// Immutable, so one object can be used by several threads.
class LegIk {
 public:
  enum class Method {
    kThreeJoint,  ///< abduction, hip and knee in closed form
    kSixJoint,    ///< three axes that meet, a knee, two that meet, in closed form
    kDamped,      ///< least squares from the guess and from seeded places
  };
  /// Joint positions that bring the foot to its target.
  struct Solution {
    VectorX joints;      ///< by dofs(), within the limits
    int branches = 0;    ///< solutions within the limits, this one included; 1 when not in closed form
    int iterations = 0;  ///< of least squares; 0 where the closed form was exact
  };

  /// @throws InvalidArgument when the model has no such leg.
  LegIk(const RobotModel& model, int leg);
  /// As above, with a given method. @throws InvalidArgument when the leg's geometry does not fit it.
  LegIk(const RobotModel& model, int leg, Method method);

  /// @param X_BF_target  [m]; its rotation must be one (not checked).
  /// @param guess        by dofs() [rad] or [m]. A closed form finds all solutions. kDamped may miss one, chiefly where
  /// the leg is singular close to its limits, and then fails (from random guesses about one pose in ten thousand); a
  /// guess that is near helps. Failure kInfeasible: `out_of_reach` says by how much and to which side, `joint_limit`
  /// names the joint, its position and its limit. @throws InvalidArgument for a guess of wrong size and for values that
  /// are not finite.
  Result<Solution> Solve(const Pose& X_BF_target, const VectorX& guess) const;
  /// Solves from the standing posture.
  Result<Solution> Solve(const Pose& X_BF_target) const { return Solve(X_BF_target, chain_.standing); }

  /// X_BF at joint positions by dofs().
  Pose FootPose(const VectorX& joints) const { return chain_.FootPose(joints); }

  /// How far a target is from what the leg reaches, limits apart. Exact in closed form; with kDamped what the least
  /// squares leave at best, position and rotation weighed by the leg's length.
  ReachGap Gap(const Pose& X_BF_target) const;

  Method method() const { return method_; }
  /// Dofs of the model in the order of guess and solution, base first.
  const std::vector<int>& dofs() const { return chain_.dofs; }
  /// Those of them that move another leg too.
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
  Vector6 lower_ = Vector6::Zero(), upper_ = Vector6::Zero();  // of the positions, with a closed form
  double bend_ = 0.0;                                          // sign of the standing knee
};

}  // namespace gaitwright
