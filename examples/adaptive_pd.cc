// SPDX-License-Identifier: BSD-3-Clause
#include "examples/adaptive_pd.h"

#include <fmt/format.h>

#include <algorithm>

#include "kinematics/dynamics/foot_contact.h"

namespace gaitwright::examples {

VectorX TorquePerKilogram(const RobotModel& model, const VectorX& q, const std::vector<ContactWrench>& wrenches,
                          DynamicsScratch& scratch) {
  ForwardKinematics(model, q, scratch);
  VectorX from_ground = VectorX::Zero(model.nv());
  for (std::size_t f = 0; f < wrenches.size(); ++f) {
    Vector6 wrench;
    wrench << wrenches[f].force_W, wrenches[f].moment_W;
    const Vector3 p_WF = ContactFrame(model, scratch, static_cast<int>(f)).translation();
    AddPointWrench(model, scratch, model.feet[f].body, p_WF, wrench, from_ground);
  }
  return -from_ground.tail(model.num_dofs()) / model.total_mass_kg;
}

AdaptivePd::AdaptivePd(const RobotModel& model, const MotionPlan& plan, double rate_per_s)
    : model_(model),
      plan_(plan),
      gains_(DeriveGains(model, {.stiffness_scale = 0.3, .damping_scale = 0.3})),  // soft, like real joints
      scratch_(model) {
  if (!(rate_per_s >= 0.0)) throw InvalidArgument(fmt::format("rate_per_s is {}; it must be 0 or more", rate_per_s));
  SampleWholeBody(plan.whole_body, plan.whole_body.start_s, wanted_);
  const VectorX Y = TorquePerKilogram(model, wanted_.q, wanted_.wrenches, scratch_);
  // With this constant gain, an estimate that is one kilogram too low grows by rate_per_s kilograms per second: the
  // joints move by Y p = Kd e', and the estimate changes at the rate -gain Y^T e'.
  const double movement = Y.dot(Y.cwiseQuotient(gains_.damping));
  if (!(movement > 0.0)) throw InvalidArgument("no foot carries the robot at the start of the plan");
  gain_ = rate_per_s / movement;
}

JointCommand AdaptivePd::Update(const ControlInput& input) {
  SampleWholeBody(plan_.whole_body, input.time_s, wanted_);
  const Eigen::Index n = gains_.stiffness.size();
  const VectorX Y = TorquePerKilogram(model_, input.q, wanted_.wrenches, scratch_);
  const VectorX e = input.q.tail(n) - wanted_.q.tail(n), e_rate = input.v.tail(n) - wanted_.v.tail(n);
  const VectorX s = e_rate + gains_.stiffness.cwiseQuotient(gains_.damping).cwiseProduct(e);
  const double before_kg = payloads_kg_.empty() ? 0.0 : payloads_kg_.back();
  payloads_kg_.push_back(std::max(0.0, before_kg - input.step_s * gain_ * Y.dot(s)));
  const VectorX tau_ff = wanted_.tau + payloads_kg_.back() * Y;
  return {wanted_.q.tail(n), wanted_.v.tail(n), tau_ff, gains_.stiffness, gains_.damping};
}

}  // namespace gaitwright::examples
