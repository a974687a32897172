// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/pipeline/carried_base.h"

#include "kinematics/dynamics/dynamics.h"
#include "planning/plan/sample_plan.h"

namespace gaitwright {

BaseMotion CarriedBase(const RobotModel& model, const BodyPath& body, const CentroidalTrajectory& motion) {
  const VectorX standing = StandingConfiguration(model);
  DynamicsScratch scratch(model);
  ForwardKinematics(model, standing, scratch);
  const Matrix3 R_WB = BaseRotation(standing);
  const Vector3 p_BC = R_WB.transpose() * (CentreOfMass(model, scratch) - standing.head<3>());
  return [&body, &motion, R_WB, p_BC](double time_s) {
    Pose X_WB = Pose::Identity();
    X_WB.linear() = body.TurningAt(time_s).R_WB * R_WB;
    X_WB.translation() = SampleCentroidal(motion, time_s).p_WC - X_WB.linear() * p_BC;
    return X_WB;
  };
}

}  // namespace gaitwright
