// SPDX-License-Identifier: BSD-3-Clause
#include "playback/control/stabilised.h"

#include "playback/control/joint_pd.h"

namespace gaitwright {

std::unique_ptr<Controller> MakeStabilised(const RobotModel& model, const MotionPlan& plan, const StabilisedOptions&) {
  return std::make_unique<JointPd>(model, plan);
}

}  // namespace gaitwright
