// SPDX-License-Identifier: BSD-3-Clause
#include "planning/tasks/gestures.h"

#include <gtest/gtest.h>

#include "kinematics/dynamics/dynamics.h"
#include "kinematics/model/load_robot.h"
#include "planning/tasks/free_path.h"

namespace gaitwright {
namespace {

class Gestures : public testing::TestWithParam<std::string> {
 protected:
  const RobotModel model_ = LoadNamedRobot(GetParam()).value();
  const UpperBody upper_ = FindUpperBody(model_);

  Vector3 EndAt(const Limb& arm, const VectorX& joints) const {
    VectorX q = StandingConfiguration(model_);
    q.tail(model_.num_dofs()) = joints;
    DynamicsScratch scratch(model_);
    ForwardKinematics(model_, q, scratch);
    return scratch.p_WB[static_cast<std::size_t>(arm.end_body)] +
           scratch.R_WB[static_cast<std::size_t>(arm.end_body)] * arm.p_BE;
  }
  void ExpectWithinLimits(const VectorX& joints) const {
    for (int d = 0; d < model_.num_dofs(); ++d) {
      EXPECT_GE(joints[d], model_.dof_lower(d) - 1e-9) << model_.dof_names[static_cast<std::size_t>(d)];
      EXPECT_LE(joints[d], model_.dof_upper(d) + 1e-9) << model_.dof_names[static_cast<std::size_t>(d)];
    }
  }
};
INSTANTIATE_TEST_SUITE_P(Robots, Gestures, testing::Values("nao", "h1", "humanoid"),
                         [](const auto& robot) { return robot.param; });

TEST_P(Gestures, ARaisedArmIsHighOnAFreePath) {
  PathCheck check(model_, StandingConfiguration(model_));
  for (const std::optional<Limb>* arm : {&upper_.left_arm, &upper_.right_arm}) {
    ASSERT_TRUE(arm->has_value());
    const Result<VectorX> raised = RaisedArm(model_, **arm, model_.standing_joints);
    ASSERT_TRUE(raised.ok()) << raised.failure().message;
    ExpectWithinLimits(*raised);
    EXPECT_FALSE(check.FirstMeeting(model_.standing_joints, *raised));
    const Vector3 down = EndAt(**arm, model_.standing_joints), up = EndAt(**arm, *raised);
    EXPECT_GT(up.z() - down.z(), 0.25 * model_.leg_length_m());
    for (int d = 0; d < model_.num_dofs(); ++d) {
      const bool of_arm = std::find((*arm)->dofs.begin(), (*arm)->dofs.end(), d) != (*arm)->dofs.end();
      if (!of_arm) {
        EXPECT_EQ((*raised)[d], model_.standing_joints[d]);
      }
    }
  }
}

TEST_P(Gestures, AWaveGoesFromSideToSide) {
  const Limb& arm = *upper_.right_arm;
  const VectorX raised = RaisedArm(model_, arm, model_.standing_joints).value();
  const Result<Wave> wave = WaveOf(model_, arm, raised);
  ASSERT_TRUE(wave.ok()) << wave.failure().message;
  ExpectWithinLimits(wave->out);
  ExpectWithinLimits(wave->in);
  EXPECT_GT(std::abs(EndAt(arm, wave->out).y() - EndAt(arm, wave->in).y()), 0.02 * model_.leg_length_m());
}

TEST(NoddedHead, LooksDown) {
  const RobotModel nao = LoadNamedRobot("nao").value();
  const Limb head = *FindUpperBody(nao).head;
  const int pitch = nao.DofIndex("HeadPitch");
  const VectorX down = NoddedHead(nao, head, nao.standing_joints, 0.3);
  EXPECT_NEAR(down[pitch] - nao.standing_joints[pitch], 0.3, 1e-9);  // for this robot a positive pitch looks down
  const VectorX far = NoddedHead(nao, head, nao.standing_joints, 3.0);
  EXPECT_LE(far[pitch], nao.dof_upper(pitch));
  EXPECT_GT(far[pitch], 0.4);
}

}  // namespace
}  // namespace gaitwright
