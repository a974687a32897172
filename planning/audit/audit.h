// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/base/options.h"
#include "kinematics/base/result.h"
#include "kinematics/model/robot_model.h"
#include "planning/audit/audit_report.h"
#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// How densely a plan is looked at, and with what reserve.
struct AuditOptions {
  double rate_hz = 1000.0;
  double derate_torque = 1.0, derate_speed = 1.0;

  OptionFields Fields() {
    return {
        {"rate_hz", &rate_hz, "Hz", 10.0, 10000.0, "Rate at which the plan is sampled.", {}},
        {"derate_torque",
         &derate_torque,
         "1",
         0.01,
         1.0,
         "Share of the joints' torque limits that a plan may use.",
         {}},
        {"derate_speed", &derate_speed, "1", 0.01, 1.0, "Share of the joints' speed limits that a plan may use.", {}}};
  }
};

/// Checks a plan against the laws, densely between its nodes, with the model's own dynamics; who made the plan is of no
/// account. Each law that is broken is reported once for each joint, foot or pair, where it is worst. Failure only when
/// the plan does not fit the robot at all.
///
///   dynamics       what the motion needs less what contacts and torques give: 0.02 m g of force, 0.02 m g h of moment
///   unilateral     no pulling force; centre of pressure inside the sole
///   friction_cone  tangential force at most friction times normal force
///   zmp_support    multibody ZMP inside the hull of the scheduled soles, or within 2 mm of it where it is a line; the
///                  reference that the plan has for it likewise, to 5 mm
///   consistency    q, v, a, footholds, schedule, swings and centroidal columns tell one story, to 1 mm and 1e-3 rad
Result<AuditReport> Audit(const RobotModel& model, const MotionPlan& plan, const AuditOptions& options);

}  // namespace gaitwright
