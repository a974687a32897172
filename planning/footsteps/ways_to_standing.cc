// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "kinematics/dynamics/dynamics.h"
#include "kinematics/dynamics/foot_contact.h"
#include "kinematics/spatial/rotation.h"
#include "planning/footsteps/ways_to_standing_internal.h"
#include "planning/paths/standing_feet.h"

namespace gaitwright {

double OffsetsToStanding::largest_m() const {
  double largest = 0.0;
  for (const Vector3& offset : offset_W) largest = std::max(largest, offset.norm());
  return largest;
}

OffsetsToStanding FindOffsetsToStanding(const RobotModel& model, const VectorX& q, std::optional<double> yaw_rad) {
  const std::size_t legs = model.legs.size();
  std::vector<Pose> standing = StandingFeet(model);
  standing.resize(legs);
  DynamicsScratch upright(model), now(model);
  ForwardKinematics(model, StandingConfiguration(model), upright);
  ForwardKinematics(model, q, now);
  std::vector<Pose> X_WF;
  for (std::size_t f = 0; f < legs; ++f) X_WF.push_back(ContactFrame(model, now, static_cast<int>(f)));
  const double heading = yaw_rad ? *yaw_rad : FitBase(standing, X_WF).plan.yaw_rad;
  for (std::size_t f = 0; f < legs; ++f) {
    const Foot& foot = model.feet[f];
    const Matrix3 R_WF = FramePose(now, foot.body, foot.X_BF).linear();
    const Matrix3 R_WF_then = YawRotation(heading) * FramePose(upright, foot.body, foot.X_BF).linear();
    X_WF[f].translation() +=
        foot.radius * RotationLog(R_WF_then * R_WF.transpose()).cross(Vector3::UnitZ());  // rolls there
  }
  OffsetsToStanding offsets{yaw_rad ? FitBase(standing, X_WF, heading) : FitBase(standing, X_WF), {}};
  for (std::size_t f = 0; f < legs; ++f) {
    Vector3 offset_W = Carried(offsets.base.plan, standing[f]).translation() - X_WF[f].translation();
    offset_W.z() = 0.0;
    offsets.offset_W.push_back(offset_W);
  }
  return offsets;
}

}  // namespace gaitwright
