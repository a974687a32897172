// SPDX-License-Identifier: BSD-3-Clause
// The times for which `stabilised` commands the motors of stance and swing legs.
#include <gtest/gtest.h>

#include "playback/control/joint_pd.h"
#include "playback/control/swing_feedback.h"
#include "tests/playback/displaced.h"
#include "tests/playback/hops.h"

namespace gaitwright {
namespace {

constexpr double kStepTime = 0.001;

class CommandTimes : public ::testing::Test {
 protected:
  /// The robot on its plan; velocities belong to the middle of a step.
  ControlInput Measured(double time_s) const {
    ControlInput input = displaced::OnPlan(plan_, time_s);
    input.v = displaced::OnPlan(plan_, time_s - 0.5 * kStepTime).v;
    return input;
  }
  VectorX PlannedSpeeds(double time_s) const { return displaced::OnPlan(plan_, time_s).v.tail(12); }

  JointCommand Commanded(const ControlInput& input) {
    JointCommand command = replay_.Update(input);
    now_.Update(model_, input);
    const Footing& footing = swing_.UpdateFooting(now_);
    stance_.Update(now_, footing, command.tau_ff);
    swing_.Update(now_, stance_, command);
    return command;
  }

  const RobotModel model_ = synthetic::Robot(4, FootType::kPoint);
  const MotionPlan plan_ = synthetic::HoppingPlan(model_);
  const StabilisedOptions options_ = [] {
    StabilisedOptions options;
    options.hover = 0.0;
    return options;
  }();
  JointPd replay_{model_, plan_};
  Situation now_{model_, plan_};
  StanceFeedback stance_{model_, options_};
  SwingFeedback swing_{model_, plan_, options_};
};

/// In flight the base decelerates by g: with its velocity a step too early, damping would press the feet down.
TEST_F(CommandTimes, FeetInFlightAreCommandedForTheTimeAtWhichMotorsCompare) {
  for (const double lead_steps : {0.0, 1.0}) {
    int flights = 0;
    for (double t = 0.3; t < 1.0; t += kStepTime) {
      ControlInput input = Measured(t);
      input.lead_steps = lead_steps;
      const JointCommand command = Commanded(input);
      if (now_.scheduled != 0) continue;
      ++flights;
      const double compared_s = t + lead_steps * kStepTime;
      EXPECT_LT((command.q - displaced::OnPlan(plan_, compared_s).q.tail(12)).cwiseAbs().maxCoeff(), 1e-4) << t;
      EXPECT_LT((command.v - PlannedSpeeds(compared_s - 0.5 * kStepTime)).cwiseAbs().maxCoeff(), 4e-3) << t;
    }
    EXPECT_GT(flights, 100);
    swing_.Reset();
    now_.Reset();
  }
}

/// Damping against the joint's present speed would act like more rotor inertia.
TEST_F(CommandTimes, StanceLegsAreDampedAboutThePlannedAcceleration) {
  double with_change = 0.0, without_change = 0.0;
  for (double t = 0.3; t < 1.0; t += kStepTime) {
    const ControlInput input = Measured(t);
    const JointCommand command = Commanded(input);
    if (now_.bearing != 0b1111) continue;
    const VectorX later = PlannedSpeeds(t + 0.5 * kStepTime);
    with_change += (command.v - later).squaredNorm();
    without_change += (input.v.tail(12) - later).squaredNorm();
  }
  EXPECT_GT(without_change, 0.0);
  EXPECT_LT(with_change, 0.01 * without_change);
}

}  // namespace
}  // namespace gaitwright
