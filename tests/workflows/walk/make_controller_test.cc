// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "tests/playback/standing_plan.h"
#include "workflows/walk/walk.h"

namespace gaitwright {
namespace {

/// The damping of `stabilised` for the joints of stance legs.
double StanceDamping(const PlayRequest& request) {
  const RobotModel model = standing::Load("a1");
  const MotionPlan plan = standing::Plan(model, 0.6);
  ControlInput input;
  input.time_s = 0.1;
  input.step_s = 0.001;
  input.q = plan.whole_body.q.front();
  input.v = VectorX::Zero(model.nv());
  input.contact = AllFeet(4);
  input.wrenches.resize(4);
  for (ContactWrench& wrench : input.wrenches) wrench.force_W.z() = 0.25 * model.weight_n();
  return MakeController(model, plan, request)->Update(input).damping.minCoeff();
}

TEST(MakeController, LegsThatStandAreDampedLessWhereTheStateIsSensed) {
  PlayRequest request;
  const double whole = StanceDamping(request);
  EXPECT_GT(whole, 1.0);
  for (const char* state : {"measured", "estimated"}) {
    request.sensing.state = state;
    EXPECT_NEAR(StanceDamping(request), 0.2 * whole, 1e-9);
  }
  request.stabilised.sensed_damping = 1.0;
  EXPECT_NEAR(StanceDamping(request), whole, 1e-9);
}

}  // namespace
}  // namespace gaitwright
