// SPDX-License-Identifier: BSD-3-Clause
#include "playback/sensing/sensing_controller.h"

#include <cmath>
#include <numbers>

#include "kinematics/base/result.h"

namespace gaitwright {
namespace {

SensingOptions Checked(const MotionPlan& plan, SensingOptions options) {
  CheckOptions(options.Fields());
  if (options.state == "estimated" && plan.whole_body.q.empty())
    throw InvalidArgument("the plan has no whole-body motion, which the state estimate needs for its start");
  return options;
}

}  // namespace

/// State that is rebuilt for each playback.
struct SensingController::Instruments {
  Instruments(const RobotModel& model, const MotionPlan& plan, const SensingOptions& o, double step_s)
      : encoders(model.num_dofs(), o.sensors, step_s),
        imu(o.sensors, step_s),
        contacts(model.feet.size(), model.weight_n(), o.sensors, step_s),
        odometry(model, plan.terrain, {o.odometry, o.sensors, step_s}),
        commands(DelaySteps(o.command_delay_s, step_s)) {
    if (!plan.whole_body.q.empty()) odometry.Start(plan.whole_body.q.front());
    const double cutoff_hz = o.sensors.gyroscope_cutoff_hz;
    if (cutoff_hz > 0.0) rate_share = 1.0 - std::exp(-2.0 * std::numbers::pi * cutoff_hz * step_s);
  }

  Encoders encoders;
  Imu imu;
  ContactSensors contacts;
  LegOdometry odometry;
  DelayLine<JointCommand> commands;
  double rate_share = 1.0;           // coefficient of the low-pass filter of the angular velocity
  Vector3 rate_B = Vector3::Zero();  // low-pass filtered
};

SensingController::SensingController(const RobotModel& model, const MotionPlan& plan, std::unique_ptr<Controller> inner,
                                     const SensingOptions& options)
    : model_(model),
      plan_(plan),
      inner_(std::move(inner)),
      options_(Checked(plan, options)),
      source_(StateSourceOf(options.state)),
      loop_(DriveLoopOf(options.drive_loop)) {}

SensingController::~SensingController() = default;

void SensingController::Reset() {
  instruments_.reset();
  inner_->Reset();
}

const BaseEstimate* SensingController::Estimate() const {
  return source_ == StateSource::kEstimated && instruments_ ? &estimate_ : nullptr;
}

JointCommand SensingController::Update(const ControlInput& input) {
  if (!instruments_) instruments_ = std::make_unique<Instruments>(model_, plan_, options_, input.step_s);
  sensed_ = input;
  if (source_ != StateSource::kTrue) Sense(input);
  JointCommand command = inner_->Update(sensed_);
  CloseLoop(command);
  return instruments_->commands.Push(command);
}

/// Closes the joint loops: in the drives, whose zeros may have an offset, or on the sensed state.
void SensingController::CloseLoop(JointCommand& command) const {
  if (loop_ == DriveLoop::kSensed) {
    const Eigen::Index n = model_.num_dofs();
    command.tau_ff += command.stiffness.cwiseProduct(command.q - sensed_.q.tail(n)) +
                      command.damping.cwiseProduct(command.v - sensed_.v.tail(n));
    command.stiffness.setZero();
    command.damping.setZero();
  } else if (source_ != StateSource::kTrue && options_.sensors.encoder_bias_rad > 0.0) {
    command.q -= instruments_->encoders.bias();
  }
}

void SensingController::Sense(const ControlInput& input) {
  Instruments& on = *instruments_;
  const Eigen::Index n = model_.num_dofs();
  const JointReading& joints = on.encoders.Read(input.q.tail(n));
  const ContactReading& feet = on.contacts.Read(input.contact, input.wrenches);
  sensed_.q.tail(n) = joints.q;
  sensed_.v.tail(n) = joints.v;
  sensed_.contact = feet.contact;
  for (std::size_t f = 0; f < feet.load_n.size(); ++f)
    sensed_.wrenches[f] = {Vector3(0.0, 0.0, feet.load_n[f]), Vector3::Zero()};
  if (source_ != StateSource::kEstimated) return;
  on.odometry.Update(on.imu.Read(input.q, input.v), joints, feet);
  SendBase();
}

void SensingController::SendBase() {
  Instruments& on = *instruments_;
  const Matrix3& R_WB = on.odometry.R_WB();
  on.rate_B += on.rate_share * (R_WB.transpose() * on.odometry.w_WB() - on.rate_B);
  estimate_.p_WB = on.odometry.p_WB();
  estimate_.R_WB = Quaternion(R_WB);
  estimate_.v_WB = on.odometry.v_WB();
  estimate_.w_WB = R_WB * on.rate_B;
  sensed_.q.head<3>() = estimate_.p_WB;
  sensed_.q.segment<4>(3) = estimate_.R_WB.coeffs();
  sensed_.v.head<3>() = estimate_.v_WB;
  sensed_.v.segment<3>(3) = estimate_.w_WB;
}

std::unique_ptr<Controller> BehindSensors(const RobotModel& model, const MotionPlan& plan,
                                          std::unique_ptr<Controller> controller, const SensingOptions& options) {
  if (options.is_transparent()) return controller;
  return std::make_unique<SensingController>(model, plan, std::move(controller), options);
}

}  // namespace gaitwright
