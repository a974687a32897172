// SPDX-License-Identifier: BSD-3-Clause
#include "playback/control/recovering.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "kinematics/base/result.h"
#include "kinematics/dynamics/dynamics.h"
#include "kinematics/dynamics/foot_contact.h"
#include "kinematics/spatial/rotation.h"
#include "kinematics/stability/polygon.h"
#include "kinematics/stability/zero_moment_point.h"
#include "planning/plan/carried_plan.h"

namespace gaitwright {
namespace {

/// First lift of each foot in a plan, by foot; infinite for a foot that is never lifted.
std::vector<double> FirstLifts(const std::optional<MotionPlan>& plan, std::size_t feet) {
  std::vector<double> lifts(feet, HUGE_VAL);
  if (!plan) return lifts;
  for (const SwingTrajectory& swing : plan->swings) {
    double& lift_s = lifts[static_cast<std::size_t>(swing.foot)];
    lift_s = std::min(lift_s, swing.start_s);
  }
  return lifts;
}

class Recovering final : public Controller {
 public:
  Recovering(const RobotModel& model, const MotionPlan& plan, RecoveryPlans recovery, const RecoveringOptions& options,
             const StabilisedOptions& stabilised, const GainOptions& gains)
      : model_(model),
        plan_(plan),
        recovery_(std::move(recovery)),
        options_(options),
        stabilised_(stabilised),
        gains_(gains),
        joint_gains_(DeriveGains(model, gains)),
        scratch_(model),
        J_(3, model.nv()),
        lifts_(FirstLifts(recovery_.steps, model.legs.size())),
        leg_m_(model.leg_length_m()) {
    CheckOptions(options_.Fields());
    const bool stands = plan.schedule.phases.size() == 1 &&
                        plan.schedule.phases.front().stance == AllFeet(static_cast<int>(model.legs.size()));
    if (!stands) throw InvalidArgument("'recovering' needs a plan that stands on all feet from its start to its end");
    const bool other = recovery_.steps && recovery_.steps->robot_hash != plan.robot_hash;
    if (other || recovery_.low.size() != model.num_dofs())
      throw InvalidArgument("the recovery steps of 'recovering' belong to another robot");
    Reset();
  }

  void Reset() override {
    inner_ = MakeStabilised(model_, plan_, stabilised_, gains_);
    state_ = State::kStanding;
    later_s_ = 0.0;
  }

  std::string Name() const override { return "recovering"; }

  JointCommand Update(const ControlInput& input) override {
    Observe(input);
    if (state_ != State::kBracing && FallIsCertain()) state_ = State::kBracing;
    if (state_ == State::kBracing) return GetDown();
    const bool begun = input.time_s > plan_.whole_body.start_s;
    const bool free = state_ == State::kStanding || input.time_s + later_s_ > moved_.whole_body.end_s();
    if (recovery_.steps && begun && free && out_m_ > -options_.step_margin * leg_m_) Step(input.time_s);
    ControlInput seen = input;
    seen.time_s += later_s_;
    return inner_->Update(seen);
  }

 private:
  enum class State { kStanding, kStepping, kBracing };

  void Observe(const ControlInput& input) {
    ForwardKinematics(model_, input.q, scratch_);
    ForwardVelocities(model_, input.q, input.v, scratch_);
    CentreOfMassJacobian(model_, scratch_, J_);
    const Vector3 v_WC = J_ * input.v;
    dcm_W_ = DivergentComponent(CentreOfMass(model_, scratch_), v_WC, plan_.centroidal.omega_rad_s);
    corners_.clear();
    middle_W_.setZero();
    for (int f = 0; f < static_cast<int>(model_.legs.size()); ++f)
      for (const Vector3& p_W : ContactPoints(model_, scratch_, f)) corners_.push_back(p_W.head<2>());
    for (const Vector2& corner : corners_) middle_W_ += corner / static_cast<double>(corners_.size());
    out_m_ = -SignedDistance(ConvexHull(corners_), dcm_W_);
    const VectorX& q = plan_.whole_body.q.front();
    const Vector3 up_planned = BaseRotation(q).transpose().col(2);  // world's up direction, in the base
    tilt_rad_ = std::acos(std::clamp((scratch_.R_WB[0] * up_planned).z(), -1.0, 1.0));
  }

  bool FallIsCertain() const { return out_m_ > options_.brace_margin * leg_m_ || tilt_rad_ > options_.brace_tilt_rad; }

  /// The robot's place on the ground: the place of the base relative to its standing feet.
  PlanarPose Here() const {
    const Vector2 middle_F = StandingMiddle();
    PlanarPose here;
    here.yaw_rad = YawOf(scratch_.R_WB[0] * BaseRotation(StandingConfiguration(model_)).transpose());
    const double c = std::cos(here.yaw_rad), s = std::sin(here.yaw_rad);
    Vector2 feet_W = Vector2::Zero();
    for (std::size_t f = 0; f < model_.legs.size(); ++f)
      feet_W += ContactFrame(model_, scratch_, static_cast<int>(f)).translation().head<2>() /
                static_cast<double>(model_.legs.size());
    here.x_m = feet_W.x() - (c * middle_F.x() - s * middle_F.y());
    here.y_m = feet_W.y() - (s * middle_F.x() + c * middle_F.y());
    return here;
  }

  Vector2 StandingMiddle() const {
    DynamicsScratch standing(model_);
    ForwardKinematics(model_, StandingConfiguration(model_), standing);
    Vector2 middle = Vector2::Zero();
    for (std::size_t f = 0; f < model_.legs.size(); ++f)
      middle += ContactFrame(model_, standing, static_cast<int>(f)).translation().head<2>() /
                static_cast<double>(model_.legs.size());
    return middle;
  }

  /// Of two feet, the one towards which the robot falls stays on the ground. With more feet, the plan's own order is
  /// used.
  double LiftTime() const {
    if (model_.legs.size() != 2) return *std::min_element(lifts_.begin(), lifts_.end());
    const Vector2 fall = dcm_W_ - middle_W_;
    const Vector2 p0 = ContactFrame(model_, scratch_, 0).translation().head<2>();
    const Vector2 p1 = ContactFrame(model_, scratch_, 1).translation().head<2>();
    constexpr double kSame = 0.01;  // of the feet's distance: below it the fall is towards neither foot
    const double towards_0 = fall.dot((p0 - p1).normalized()) / (p0 - p1).norm();
    if (std::abs(towards_0) < kSame) return std::min(lifts_[0], lifts_[1]);
    return towards_0 > 0.0 ? lifts_[1] : lifts_[0];
  }

  void Step(double time_s) {
    constexpr double kBefore = 0.002;  // [s]
    state_ = State::kStepping;
    moved_ = CarriedPlan(PoseOf(Here()), 0.0, *recovery_.steps);
    inner_ = MakeStabilised(model_, moved_, stabilised_, gains_);
    later_s_ = LiftTime() - kBefore - time_s;
  }

  JointCommand GetDown() const {
    JointCommand command;
    command.q = recovery_.low;
    command.v = command.tau_ff = VectorX::Zero(recovery_.low.size());
    command.stiffness = options_.brace_gain * joint_gains_.stiffness;
    command.damping = options_.brace_gain * joint_gains_.damping;
    return command;
  }

  const RobotModel& model_;
  const MotionPlan& plan_;
  const RecoveryPlans recovery_;
  RecoveringOptions options_;
  const StabilisedOptions stabilised_;
  const GainOptions gains_;
  const Gains joint_gains_;
  DynamicsScratch scratch_;
  MatrixX J_;
  const std::vector<double> lifts_;
  const double leg_m_;
  MotionPlan moved_;  // the plan of steps, moved to the robot's place
  std::unique_ptr<Controller> inner_;
  State state_ = State::kStanding;
  double later_s_ = 0.0;  // inner plan's clock minus the playback's clock
  // Results of the last Update.
  Vector2 dcm_W_ = Vector2::Zero(), middle_W_ = Vector2::Zero();
  std::vector<Vector2> corners_;
  double out_m_ = 0.0;  // distance of the DCM outside the hull of all feet, at their current places
  double tilt_rad_ = 0.0;
};

}  // namespace

std::unique_ptr<Controller> MakeRecovering(const RobotModel& model, const MotionPlan& plan, RecoveryPlans recovery,
                                           const RecoveringOptions& options, const StabilisedOptions& stabilised,
                                           const GainOptions& gains) {
  return std::make_unique<Recovering>(model, plan, std::move(recovery), options, stabilised, gains);
}

}  // namespace gaitwright
