// SPDX-License-Identifier: BSD-3-Clause
// Planners and controllers in Python: good, partly good and bad ones.
#include <fmt/format.h>

#include "tests/workflows/grade/made_class.h"

namespace gaitwright {
namespace {

class MarkCodeOfMotions : public MadeClass {
 protected:
  void SetUp() override {
    if (!CanRunCode(true)) GTEST_SKIP() << ReasonNotConfined();
  }
};

const std::string kSteps =
    "{name: steps, kind: planner, file: work.py, points: 4, robot: nao, command: {goal_x_m: [0.08, 0.12]}, "
    "checks: [{measure: pass, points: 3}, {measure: goal_error_m, points: 1, full_at: 0.02}]}\n";

/// A planner that covers a share of the distance.
std::string Planner(double share) {
  return fmt::format(
      "import gaitwright as gw\n"
      "def plan_steps(robot, terrain, goal):\n"
      "    assert terrain.ground_at(0.0, 0.0) is not None\n"
      "    standing = {{f: gw.RobotState(robot).contact_frame(f)[:2, 3] for f in robot.feet[:2]}}\n"
      "    way = goal[0] * {}\n"
      "    places = [min(0.04 * (i + 1), way) for i in range(int(way / 0.04 + 0.999))]\n"
      "    for i, x in enumerate(places + places[-1:]):\n"
      "        foot = robot.feet[i % 2]\n"
      "        yield foot, standing[foot][0] + x, standing[foot][1], 0.0\n",
      share);
}

TEST_F(MarkCodeOfMotions, APlannerIsWalkedOver) {
  const PartMark good = MarkCode(kSteps, Planner(1.0));
  EXPECT_EQ(good.points, 4.0) << (good.reasons.empty() ? "" : good.reasons.front());
  const PartMark half = MarkCode(kSteps, Planner(0.5));
  EXPECT_EQ(half.checks[1].points, 0.0);
  EXPECT_GT(half.checks[1].value.value_or(0.0), 0.03);
}

/// The goal is at 12 cm; points decrease linearly for errors from 2 to 10 cm.
TEST_F(MarkCodeOfMotions, PartialSolutionsGetTheirShare) {
  const std::string part =
      "{name: steps, kind: planner, file: work.py, points: 3, robot: nao, command: {goal_x_m: 0.12}, "
      "checks: [{measure: goal_error_m, points: 3, full_at: 0.02, none_at: 0.1}]}\n";
  double fewer = 0.0;
  for (const double share : {0.35, 0.5, 0.75}) {
    SCOPED_TRACE(share);
    const PartMark mark = MarkCode(part, Planner(share));
    const double error_m = mark.checks.at(0).value.value_or(-1.0);
    EXPECT_NEAR(error_m, 0.12 * (1.0 - share), 0.015);
    EXPECT_NEAR(mark.points, 3.0 * (0.1 - error_m) / 0.08, 0.01);
    EXPECT_GT(mark.points, fewer);
    EXPECT_LT(mark.points, 3.0);
    EXPECT_FALSE(mark.reasons.empty());
    fewer = mark.points;
  }
}

TEST_F(MarkCodeOfMotions, InvalidStepsAreReported) {
  const auto gives = [&](const std::string& steps) {
    return MarkCode(kSteps, "def plan_steps(robot, terrain, goal):\n    return " + steps + "\n");
  };
  ExpectNothing(gives("[]"), {"the planner gave no steps"});
  ExpectNothing(gives("[('tail', 0, 0, 0)]"), {"unknown foot 'tail'; accepted: 'l_ankle', 'r_ankle'"});
  ExpectNothing(gives("[('l_ankle', float('nan'), 0, 0)]"), {"step 1, x is nan"});
  ExpectNothing(gives("[('l_ankle', 0, 0)]"), {"the submission says: ValueError"});
  ExpectNothing(gives("[('l_ankle', 0, 0, 0)] * 5000"), {"more than 1000 steps"});
  ExpectNothing(gives("[('l_ankle', 0, 0, 0)] * 500"), {"500 steps, which last 300.0 s; at most 60 s"});
  ExpectNothing(gives("[('l_ankle', 5.0, 0, 0)]"), {"pass is 0"});
}

const std::string kControl =
    "{name: control, kind: controller, file: work.py, points: 4, robot: a1, gait: trot, command: {speed_m_s: 0.3, "
    "distance_m: 0.2}, "
    "trials: 1, checks: [{measure: stands, points: 2}, {measure: survival, points: 2}]}\n";

std::string ControllerThat(const std::string& update) {
  return "import gaitwright as gw, numpy as np, time\n"
         "class Own(gw.Controller):\n"
         "    def __init__(self, plan):\n"
         "        super().__init__()\n"
         "        self.plan, self.gains = plan, gw.derive_gains(plan.robot)\n"
         "    def update(self, now):\n"
         "        wanted = self.plan.at(now.time_s + now.step_s)\n"
         "        " +
         update +
         "\n"
         "        return gw.JointCommand(wanted['q'][7:], wanted['v'][6:], wanted['tau'], *self.gains)\n"
         "make_controller = Own\n";
}

TEST_F(MarkCodeOfMotions, AControllerIsAskedEachStep) {
  const PartMark good =
      MarkCode(kControl, ControllerThat("assert now.forces_n.shape == (4, 3) and len(now.contact) == 4"));
  EXPECT_EQ(good.points, 4.0) << (good.reasons.empty() ? "" : good.reasons.front());
  const PartMark limp = MarkCode(kControl, ControllerThat("return gw.JointCommand(np.zeros(12))"));
  ExpectNothing(limp, {"stands is 0", "0 of 1 trials survived", "trial 1: under ", "the robot fell while settling"});
}

TEST_F(MarkCodeOfMotions, AControllerThatFailsGetsNothing) {
  const auto does = [&](const std::string& what) { return MarkCode(kControl, ControllerThat(what)); };
  ExpectNothing(does("return gw.JointCommand(np.full(12, np.nan))"),
                {"the controller at 0.000 s: the answer[0, 0] is nan"});
  ExpectNothing(does("return gw.JointCommand(np.zeros(3))"), {"5 x 12 numbers are needed"});
  ExpectNothing(does("return gw.JointCommand(np.zeros(12), stiffness=-np.ones(12))"),
                {"negative stiffness or damping"});
  ExpectNothing(does("return {'score': 100}"), {"the submission says"});
  ExpectNothing(does("if now.time_s > 0.1: raise ValueError('enough')"), {"ValueError: enough"});
  ExpectNothing(MarkCode(kControl, "def make_controller(plan): return 3\n"), {"did not return a controller"});
}

}  // namespace
}  // namespace gaitwright
