// SPDX-License-Identifier: BSD-3-Clause
#include "examples/standing_strategies.h"

#include <algorithm>

#include "kinematics/dynamics/foot_contact.h"
#include "kinematics/model/body_tree.h"
#include "kinematics/spatial/rotation.h"

namespace gaitwright::examples {

StandingStrategy::StandingStrategy(const RobotModel& model, const MotionPlan& plan, Strategy strategy)
    : model_(model), plan_(plan), strategy_(strategy), joints_(model, plan), scratch_(model), J_(3, model.nv()) {
  ForwardKinematics(model, plan.whole_body.q.front(), scratch_);
  home_W_ = CentreOfMass(model, scratch_);
  inertia_B_ = LockedInertia(model, scratch_).diagonal();
}

/// Moment that rotates the body back to its planned orientation, critically damped.
Vector3 StandingStrategy::Upright() const {
  constexpr double kRate = 10.0;  // [rad/s]
  const Matrix3 R_planned = BaseRotation(plan_.whole_body.q.front());
  const Vector3 turn = RotationLog(R_planned * scratch_.R_WB[0].transpose());
  const Vector3 rate = kRate * kRate * turn - 2.0 * kRate * scratch_.w_WB[0];
  return R_planned * inertia_B_.cwiseProduct(R_planned.transpose() * rate);
}

PointWrench StandingStrategy::Wanted(const Vector3& p_WC, const Vector3& v_WC, const Polygon& soles) const {
  constexpr double kTurned = 0.5, kLargestRate = 20.0;  // [rad], [rad/s^2]: limits of the body's rotation
  const double omega = plan_.centroidal.omega_rad_s, weight = model_.weight_n();
  const Vector2 c = (p_WC - home_W_).head<2>(), rate = v_WC.head<2>() / omega;
  const Vector2 wanted =
      home_W_.head<2>() + (strategy_ == Strategy::kAnkle ? Vector2(1.5 * c + 0.5 * rate) : Vector2(1.3 * (c + rate)));
  const Vector2 zmp = NearestPoint(soles, wanted), beyond = wanted - zmp;
  Vector3 moment = Upright();
  if (strategy_ == Strategy::kHip && beyond.norm() > 1e-3) {
    const Vector3 axis = Vector3(-beyond.y(), beyond.x(), 0.0).normalized();
    const double turned = scratch_.R_WB[0].col(2).cross(Vector3::UnitZ()).dot(-axis);
    const double inertia = axis.cwiseAbs().dot(inertia_B_);
    if (turned < kTurned) moment = std::min(weight * beyond.norm(), kLargestRate * inertia) * axis;
  }
  const double height = p_WC.z();
  const double lift =
      weight + model_.total_mass_kg * 100.0 * (home_W_.z() - height) - 20.0 * model_.total_mass_kg * v_WC.z();
  const double normal = std::clamp(lift, 0.3 * weight, 2.0 * weight);
  const Vector2 arm = p_WC.head<2>() - zmp;
  return {p_WC, {(arm.x() * normal - moment.y()) / height, (arm.y() * normal + moment.x()) / height, normal}, moment};
}

JointCommand StandingStrategy::Update(const ControlInput& input) {
  JointCommand command = joints_.Update(input);
  ForwardKinematics(model_, input.q, scratch_);
  ForwardVelocities(model_, input.q, input.v, scratch_);
  CentreOfMassJacobian(model_, scratch_, J_);
  std::vector<ContactPoint> contacts;
  std::vector<int> bodies;
  std::vector<Vector2> corners;
  for (std::size_t f = 0; f < model_.legs.size(); ++f) {
    for (const Vector3& p_W : ContactPoints(model_, scratch_, static_cast<int>(f))) {
      contacts.push_back({p_W, Vector3::UnitZ(), 0.7, 1.0});
      bodies.push_back(model_.feet[f].body);
      corners.push_back(p_W.head<2>());
    }
  }
  splitter_.Solve(contacts, Wanted(CentreOfMass(model_, scratch_), J_ * input.v, ConvexHull(corners)), split_);
  VectorX from_ground = VectorX::Zero(model_.nv());  // generalised forces of the contacts
  for (std::size_t k = 0; k < contacts.size(); ++k)
    AddPointForce(model_, scratch_, bodies[k], contacts[k].p_W, split_.force_W[k], from_ground);
  VectorX gravity(model_.nv());
  InverseDynamics(model_, input.q, VectorX::Zero(model_.nv()), VectorX::Zero(model_.nv()), scratch_, gravity);
  const std::vector<bool> of_leg = DofsOfLegs(model_);
  for (int d = 0; d < model_.num_dofs(); ++d) {
    if (!of_leg[static_cast<std::size_t>(d)]) continue;
    command.tau_ff[d] = gravity[6 + d] - from_ground[6 + d];
    command.stiffness[d] = 0.0;
    command.damping[d] *= 0.1;
  }
  return command;
}

}  // namespace gaitwright::examples
