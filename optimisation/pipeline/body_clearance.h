// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/dynamics/dynamics.h"
#include "optimisation/centroidal/rigid_body_motion.h"
#include "optimisation/centroidal/rigid_body_problem.h"
#include "planning/audit/ground_watch.h"
#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// Finds where the body and the upper legs come too near to what is solid along a motion, and what a rigid body is to
/// keep to so that they do not: half-spaces that hold the solid, with the nearest point of the part taken to be fixed
/// in the body. Of the legs that is true for small changes only, so that it is to be looked at again. Links that end in
/// a foot are left to the swings.
///
/// Wanted is a clearance of 0.07 of the leg's length, as much as a robot that is played comes off its plan, or as much
/// as a part has when the robot stands at the start or the end. A motion lacks what is missing of a quarter of that.
class BodyClearance {
 public:
  BodyClearance(const RobotModel& model, const Terrain& terrain);

  /// Takes note of where parts are too near, the worst places of each within each 20 ms.
  /// @param samples  of the rigid body, one for each row of the whole body's motion.
  /// @return what the motion lacks [m]; 0 for nothing.
  double Look(const WholeBodyTrajectory& rows, const std::vector<RigidBodySample>& samples);

  /// All that was noted.
  std::vector<RigidClearance> Wanted() const;

  /// Wants half of the clearance from now on, no less than a motion may lack. @return whether that is less.
  bool Ease();

 private:
  /// A place that is to be clear, with a clearance of none, and how far.
  struct Place {
    RigidClearance touching;
    double kept_m;
  };

  void LimitBy(const VectorX& q);
  const std::vector<GroundHit>& NearAt(const VectorX& q);

  const RobotModel& model_;
  GroundWatch watch_;
  DynamicsScratch scratch_;
  GroundLimits limits_;
  std::vector<bool> ends_in_foot_;  // by body
  std::vector<double> kept_m_;      // by part of the watch
  std::vector<Place> places_;
  double share_ = 1.0;  // of the clearance that is wanted now
};

}  // namespace gaitwright
