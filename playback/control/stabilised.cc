// SPDX-License-Identifier: BSD-3-Clause
#include "playback/control/stabilised.h"

#include "playback/control/joint_pd.h"
#include "playback/control/situation.h"
#include "playback/control/stance_feedback.h"
#include "playback/control/swing_feedback.h"

namespace gaitwright {
namespace {

StabilisedOptions Checked(StabilisedOptions options) {
  CheckOptions(options.Fields());
  return options;
}

class Stabilised final : public Controller {
 public:
  Stabilised(const RobotModel& model, const MotionPlan& plan, const StabilisedOptions& options,
             const GainOptions& gains)
      : model_(model),
        options_(Checked(options)),
        replay_(model, plan, gains),
        now_(model, plan),
        stance_(model, plan, options_),
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
    stance_.Update(now_, footing, command.tau_ff);
    swing_.Update(now_, stance_, command);
    return command;
  }

 private:
  const RobotModel& model_;
  StabilisedOptions options_;
  JointPd replay_;
  Situation now_;
  StanceFeedback stance_;
  SwingFeedback swing_;
};

}  // namespace

std::unique_ptr<Controller> MakeStabilised(const RobotModel& model, const MotionPlan& plan,
                                           const StabilisedOptions& options, const GainOptions& gains) {
  return std::make_unique<Stabilised>(model, plan, options, gains);
}

}  // namespace gaitwright
