// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/dynamics/dynamics.h"
#include "optimisation/centroidal/rigid_body_motion.h"
#include "optimisation/centroidal/rigid_body_problem.h"
#include "planning/audit/ground_watch.h"
#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// Finds where the body and the upper legs come too near to solids along a motion, and the constraints of a rigid body
/// that avoid this: half-spaces that contain the solid, for the nearest point of the part, assumed fixed in the body.
/// For legs this holds for small changes only, so it must be checked again. Links that end in a foot are handled by the
/// swings.
///
/// The required clearance is 0.07 leg lengths, the usual deviation of a playback from its plan, or the clearance of
/// the part in standing at the start or the end if that is less. A motion fails below a quarter of that.
class BodyClearance {
 public:
  BodyClearance(const RobotModel& model, const Terrain& terrain);

  /// Records where parts are too close: the worst places of each part within each 20 ms.
  /// @param samples  samples of the rigid body, one for each row of the whole-body motion.
  /// @return missing clearance of the motion [m]; 0 for none.
  double Look(const WholeBodyTrajectory& rows, const std::vector<RigidBodySample>& samples);

  /// All recorded places.
  std::vector<RigidClearance> Wanted() const;

  /// Halves the required clearance, but not below the failure limit. @return whether it was reduced.
  bool Ease();

 private:
  /// A place that must be clear, and its missing clearance.
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
  double share_ = 1.0;  // present share of the required clearance
};

}  // namespace gaitwright
