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

/// How a standing robot keeps its balance.
///   kAnkle     the ZMP goes with the centre of mass, p = c0 + 1.5 (c - c0) + 0.5 c' / w, as ankles have it that are
///              springs and dampers
///   kAnkleDcm  the ZMP goes with the DCM, p = c0 + 1.3 (xi - c0), xi = c + c' / w: Englsberger et al., 2015,
///              T-RO 31(2)
///   kHip       the same, and what of it is out of the soles is made by turning the body about its hips:
///              m g (p - p_in_the_soles) is the rate of its angular momentum; Stephens, Humanoids 2007
enum class Strategy { kAnkle, kAnkleDcm, kHip };

/// Legs without stiffness: forces on the soles carry the robot, and put the ZMP where the strategy wants it. All else
/// is joint PD.
class StandingStrategy : public Controller {
 public:
  /// Model and plan, one that stands, must outlive it.
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
