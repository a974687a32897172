// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/dynamics/chain_kinematics.h"

#include "tests/kinematics/made_robots.h"

namespace gaitwright {
namespace {

class ChainKinematicsTest : public testing::TestWithParam<const char*> {};

TEST_P(ChainKinematicsTest, PlacesABodyAsTheWholeRobotsKinematicsDo) {
  const RobotModel model = AnyRobot(GetParam());
  RandomState random(31);
  const VectorX q = random.Configuration(model);
  DynamicsScratch whole(model);
  ForwardKinematics(model, q, whole);
  for (const Foot& foot : model.feet) {
    DynamicsScratch chain(model);
    const std::vector<int> joints = JointsTo(model, foot.body);
    EXPECT_LT(joints.size(), model.joints.size());
    ChainKinematics(model, q, joints, chain);
    MatrixX J(6, model.nv()), wanted(6, model.nv());
    PointJacobian(model, chain, foot.body, foot.X_BF.translation(), J);
    PointJacobian(model, whole, foot.body, foot.X_BF.translation(), wanted);
    EXPECT_GT(wanted.norm(), 1.0);
    EXPECT_EQ(J, wanted);
    EXPECT_EQ(FramePose(chain, foot.body, foot.X_BF).matrix(), FramePose(whole, foot.body, foot.X_BF).matrix());
  }
}

INSTANTIATE_TEST_SUITE_P(Robots, ChainKinematicsTest, testing::ValuesIn(kAnyRobots),
                         [](const auto& i) { return std::string(i.param); });

}  // namespace
}  // namespace gaitwright
