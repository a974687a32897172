// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/dynamics/contact_split.h"
#include "kinematics/dynamics/dynamics.h"
#include "kinematics/stability/polygon.h"
#include "planning/plan/motion_plan.h"
#include "playback/control/controller.h"
#include "playback/control/joint_pd.h"

namespace gaitwright::examples {

/// Balance strategy of a standing robot.
///   kAnkle     the ZMP follows the centre of mass, p = c0 + 1.5 (c - c0) + 0.5 c' / w, as with ankles that are
///              springs and dampers
///   kAnkleDcm  the ZMP follows the DCM, p = c0 + 1.3 (xi - c0), xi = c + c' / w: Englsberger et al., 2015,
///              T-RO 31(2)
///   kHip       as kAnkleDcm. If p is outside the soles, the hips also rotate the body, at the rate of angular momentum
///              m g (p - p_in_the_soles); Stephens, Humanoids 2007
enum class Strategy { kAnkle, kAnkleDcm, kHip };

/// The legs have no stiffness: their torques produce the forces on the soles that carry the robot and move the ZMP to
/// the position of the strategy. All other joints use joint PD.
class StandingStrategy : public Controller {
 public:
  /// The plan must be one in which the robot stands. Model and plan must outlive the controller.
  StandingStrategy(const RobotModel& model, const MotionPlan& plan, Strategy strategy);

  JointCommand Update(const ControlInput& input) override;
  std::string Name() const override { return "standing-strategy"; }

 private:
  PointWrench Wanted(const Vector3& p_WC, const Vector3& v_WC, const Polygon& soles) const;
  Vector3 Upright() const;

  const RobotModel& model_;
  const MotionPlan& plan_;
  Strategy strategy_;
  JointPd joints_;
  DynamicsScratch scratch_;
  MatrixX J_;
  Vector3 home_W_, inertia_B_;
  ContactSplitter splitter_;
  ContactSplit split_;
};

}  // namespace gaitwright::examples
