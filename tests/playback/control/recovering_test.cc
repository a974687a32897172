// SPDX-License-Identifier: BSD-3-Clause
#include "playback/control/recovering.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include "kinematics/base/result.h"
#include "kinematics/dynamics/dynamics.h"
#include "kinematics/dynamics/foot_contact.h"
#include "tests/playback/short_walk.h"
#include "tests/playback/standing_plan.h"

namespace gaitwright {
namespace {

/// Stands still, with a pendulum of 4 rad/s.
MotionPlan PlanToRecover(const RobotModel& model) {
  MotionPlan plan = standing::Plan(model, 1.0);
  plan.centroidal.omega_rad_s = 4.0;
  return plan;
}

class RecoveringTest : public testing::TestWithParam<const char*> {
 protected:
  std::unique_ptr<Controller> Made(const RecoveringOptions& options = {}) const {
    return MakeRecovering(model_, plan_, {std::nullopt, low_}, options);
  }
  /// The robot exactly on its plan, in the middle of the plan.
  ControlInput Standing() const {
    ControlInput input;
    input.time_s = 0.5;
    input.q = plan_.whole_body.q.front();
    input.v = VectorX::Zero(model_.nv());
    input.wrenches = plan_.whole_body.wrenches.front();
    input.contact = AllFeet(static_cast<int>(model_.legs.size()));
    return input;
  }
  /// Standing, with the base turned about y.
  ControlInput Tilted(double angle_rad) const {
    ControlInput input = Standing();
    const Quaternion turn(Eigen::AngleAxisd(angle_rad, Vector3::UnitY()));
    input.q.segment<4>(3) = (turn * Quaternion(input.q.segment<4>(3))).coeffs();
    return input;
  }
  /// Standing, with the whole robot moving forward.
  ControlInput Pushed(double speed_m_s) const {
    ControlInput input = Standing();
    input.v[0] = speed_m_s;
    return input;
  }
  bool Braces(Controller& controller, const ControlInput& input) const { return controller.Update(input).q == low_; }

  const RobotModel model_ = standing::Load(GetParam());
  const MotionPlan plan_ = PlanToRecover(model_);
  const VectorX low_ = 0.5 * model_.standing_joints + VectorX::Constant(model_.num_dofs(), 0.01);
};

INSTANTIATE_TEST_SUITE_P(Robots, RecoveringTest, testing::Values("a1", "nao"),
                         [](const auto& i) { return std::string(i.param); });

TEST_P(RecoveringTest, StandsAsStabilisedDoesWhileNothingIsWrong) {
  const auto recovering = Made(), stabilised = MakeStabilised(model_, plan_, {});
  EXPECT_EQ(recovering->Name(), "recovering");
  for (const ControlInput& input : {Standing(), Tilted(0.01)}) {
    const JointCommand ours = recovering->Update(input), theirs = stabilised->Update(input);
    EXPECT_EQ(ours.q, theirs.q);
    EXPECT_EQ(ours.v, theirs.v);
    EXPECT_EQ(ours.tau_ff, theirs.tau_ff);
    EXPECT_EQ(ours.stiffness, theirs.stiffness);
    EXPECT_EQ(ours.damping, theirs.damping);
  }
}

TEST_P(RecoveringTest, BracesSoftlyWhenItTiltsTooFar) {
  const auto controller = Made();
  const JointCommand command = controller->Update(Tilted(1.0));
  const Gains gains = DeriveGains(model_);
  EXPECT_EQ(command.q, low_);
  EXPECT_EQ(command.v, VectorX::Zero(model_.num_dofs()));
  EXPECT_EQ(command.tau_ff, VectorX::Zero(model_.num_dofs()));
  EXPECT_TRUE(command.stiffness.isApprox(0.5 * gains.stiffness, 1e-12));
  EXPECT_TRUE(command.damping.isApprox(0.5 * gains.damping, 1e-12));
}

TEST_P(RecoveringTest, StaysBracedUntilItIsReset) {
  const auto controller = Made();
  EXPECT_TRUE(Braces(*controller, Tilted(1.0)));
  EXPECT_TRUE(Braces(*controller, Standing())) << "a fall that began is not taken back";
  controller->Reset();
  EXPECT_FALSE(Braces(*controller, Standing()));
}

TEST_P(RecoveringTest, TheLimitOfTheTiltIsItsOption) {
  RecoveringOptions options;
  options.brace_margin = 10.0;
  options.brace_tilt_rad = 0.3;
  EXPECT_FALSE(Braces(*Made(options), Tilted(0.29)));
  EXPECT_TRUE(Braces(*Made(options), Tilted(0.31)));
}

// At 3 m/s the DCM is 0.75 m in front: far beyond a quarter of the leg, less than ten legs.
TEST_P(RecoveringTest, BracesWhenTheDcmIsTooFarOut) {
  RecoveringOptions far;
  far.brace_margin = 10.0;
  EXPECT_TRUE(Braces(*Made(), Pushed(3.0)));
  EXPECT_FALSE(Braces(*Made(), Pushed(0.01)));
  EXPECT_FALSE(Braces(*Made(far), Pushed(3.0)));
}

// The DCM is at the front edge of the feet: closer than step_margin, but a fall is not yet certain.
TEST_P(RecoveringTest, StepsNearTheEdgeWhereItHasSteps) {
  const MotionPlan steps = model_.legs.size() == 4 ? ShortWalk(model_, "trot", 4, 0.0) : ShortWalk(model_, "", 4, 0.0);
  const auto with = MakeRecovering(model_, plan_, {steps, low_}), without = Made();
  DynamicsScratch scratch(model_);
  ForwardKinematics(model_, plan_.whole_body.q.front(), scratch);
  double front_m = -1.0;
  for (int foot = 0; foot < static_cast<int>(model_.legs.size()); ++foot) {
    for (const Vector3& p_W : ContactPoints(model_, scratch, foot)) front_m = std::max(front_m, p_W.x());
  }
  const double speed_m_s = plan_.centroidal.omega_rad_s * (front_m - CentreOfMass(model_, scratch).x());
  EXPECT_EQ(with->Update(Standing()).q, without->Update(Standing()).q) << "it stands in the middle of its feet";
  EXPECT_NE(with->Update(Pushed(speed_m_s)).q, low_);
  EXPECT_NE(without->Update(Pushed(speed_m_s)).q, low_);
  ControlInput later = Standing();
  later.time_s += 0.1;
  const VectorX stepping = with->Update(later).q, standing = without->Update(later).q;
  EXPECT_GT((stepping - standing).cwiseAbs().maxCoeff(), 0.02) << "a foot is in the air";
  EXPECT_NE(stepping, low_);
}

TEST_P(RecoveringTest, RefusesPlansThatDoNotStand) {
  MotionPlan lifted = plan_;
  lifted.schedule.phases.front().stance &= ~FootSet{1};
  EXPECT_THROW(MakeRecovering(model_, lifted, {std::nullopt, low_}), InvalidArgument);
  MotionPlan twice = plan_;
  twice.schedule.phases.push_back(twice.schedule.phases.front());
  EXPECT_THROW(MakeRecovering(model_, twice, {std::nullopt, low_}), InvalidArgument);
}

TEST_P(RecoveringTest, RefusesStepsOfAnotherRobot) {
  MotionPlan other = plan_;
  other.robot_hash = "another";
  EXPECT_THROW(MakeRecovering(model_, plan_, {other, low_}), InvalidArgument);
  EXPECT_THROW(MakeRecovering(model_, plan_, {std::nullopt, VectorX::Zero(2)}), InvalidArgument);
}

TEST_P(RecoveringTest, RefusesOptionsOutOfRange) {
  RecoveringOptions options;
  options.brace_tilt_rad = 0.05;
  EXPECT_THROW(Made(options), InvalidArgument);
}

}  // namespace
}  // namespace gaitwright
