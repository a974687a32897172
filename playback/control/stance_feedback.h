// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/dynamics/contact_split.h"
#include "kinematics/stability/polygon.h"
#include "playback/control/footing.h"
#include "playback/control/situation.h"
#include "playback/control/stabilised.h"

namespace gaitwright {

class MomentumFeedback;

/// The part of `stabilised` that acts through the feet on the ground: base attitude, height and DCM.
class StanceFeedback {
 public:
  StanceFeedback(const RobotModel& model, const StabilisedOptions& options);

  /// Adds to tau (size n) the torques that turn the planned contact forces into the wanted ones.
  /// @param predictive  if given and active, it sets the wanted wrench.
  void Update(const Situation& now, const Footing& footing, VectorX& tau, const MomentumFeedback* predictive = nullptr);

  /// Commanded vertical acceleration of the centre of mass, in addition to the plan's [m/s^2]. Call Update first.
  double lifted_m_s2() const { return lifted_m_s2_; }

  /// Predicted deviation from the plan, if the present stance feet stay on the ground and the ZMP shift continues
  /// within their support.
  struct Drift {
    Vector2 dcm_W = Vector2::Zero(), com_W = Vector2::Zero();  ///< [m]
  };
  /// The drift `lookahead_s` >= 0 from now [s]; equals the current errors if no foot stands or the plan is in the air.
  /// Call Update first.
  Drift PredictedDrift(const Situation& now, double lookahead_s) const;

 private:
  void GatherContacts(const Situation& now, double total_normal_n);
  PointWrench PlannedWrench(const Situation& now) const;
  Vector3 WantedMoment(const Situation& now, const Vector3& planned_W) const;
  PointWrench WantedWrench(const Situation& now, const Footing& footing, const PointWrench& planned) const;
  void FindUsable(const Situation& now, const Footing& footing);
  Vector2 ZmpFor(const Vector2& dcm_error_W) const;
  void Split(const Situation& now, PointWrench wanted, double least_share);
  void AddTorques(const Situation& now, VectorX& tau) const;
  void BearLegs(const Situation& now, VectorX& tau);

  const RobotModel& model_;
  const StabilisedOptions& options_;
  const std::vector<int> leg_of_;  // by joint coordinate, or -1
  VectorX moved_weight_;           // result of BearLegs
  bool planar_ = false;  ///< a leg has fewer than three joints: it cannot push laterally, so no wrench is requested
  Vector3 inertia_B_ = Vector3::Ones();  // of the standing robot, about its centre of mass
  // Results of the last Update.
  double lifted_m_s2_ = 0.0;
  Vector2 dcm_error_W_ = Vector2::Zero();
  Vector2 planned_zmp_W_ = Vector2::Zero();  // only where usable_ has points
  Polygon usable_;                           // region in which the ZMP may be moved; empty if no foot stands
  std::vector<ContactPoint> contacts_;
  std::vector<int> contact_foot_;
  std::vector<Vector3> points_;  // of one foot
  Polygon support_;
  ContactSplitter splitter_;
  ContactSplit split_;
  std::vector<Vector3> kept_W_;  // by contact [N]
};

}  // namespace gaitwright
