// SPDX-License-Identifier: BSD-3-Clause
#include "playback/control/stabilised.h"

#include "kinematics/base/result.h"
#include "planning/plan/check_motion.h"
#include "playback/control/joint_pd.h"
#include "playback/control/momentum_feedback.h"
#include "playback/control/situation.h"
#include "playback/control/stance_feedback.h"
#include "playback/control/swing_feedback.h"

namespace gaitwright {
namespace {

StabilisedOptions Checked(const RobotModel& model, const MotionPlan& plan, StabilisedOptions options) {
  CheckOptions(options.Fields());
  CheckMotion(model, plan.whole_body, {.torques = true, .wrenches = true});
  if (plan.schedule.phases.empty())
    throw InvalidArgument("the plan has no contact schedule for 'stabilised' to follow");
  CheckSchedule(plan.schedule, static_cast<int>(model.feet.size()));
  return options;
}

class Stabilised final : public Controller {
 public:
  Stabilised(const RobotModel& model, const MotionPlan& plan, const StabilisedOptions& options,
             const GainOptions& gains)
      : model_(model),
        options_(Checked(model, plan, options)),
        replay_(model, plan, gains),
        now_(model, plan),
        predictive_(model, plan, options_),
        stance_(model, options_),
        swing_(model, plan, options_) {}

  void Reset() override {
    replay_.Reset();
    now_.Reset();
    swing_.Reset();
  }

  std::string Name() const override { return "stabilised"; }

  JointCommand Update(const ControlInput& input) override {
    JointCommand command = replay_.Update(input);
    now_.Update(model_, input);
    const Footing& footing = swing_.UpdateFooting(now_);
    predictive_.Update(now_, footing);
    stance_.Update(now_, footing, command.tau_ff, &predictive_);
    swing_.Update(now_, stance_, command, &predictive_);
    return command;
  }

 private:
  const RobotModel& model_;
  StabilisedOptions options_;
  JointPd replay_;
  Situation now_;
  MomentumFeedback predictive_;
  StanceFeedback stance_;
  SwingFeedback swing_;
};

}  // namespace

std::unique_ptr<Controller> MakeStabilised(const RobotModel& model, const MotionPlan& plan,
                                           const StabilisedOptions& options, const GainOptions& gains) {
  return std::make_unique<Stabilised>(model, plan, options, gains);
}

}  // namespace gaitwright
