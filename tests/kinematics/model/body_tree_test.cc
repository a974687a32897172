// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/body_tree.h"

#include <gtest/gtest.h>

#include "kinematics/model/load_robot.h"

namespace gaitwright {
namespace {

TEST(BodyTree, AChainLeadsToTheSamePoseAsTheTree) {
  for (const char* name : {"a1", "nao"}) {
    const RobotModel model = LoadNamedRobot(name).value();
    const VectorX joints = VectorX::LinSpaced(model.num_dofs(), -0.7, 0.9);
    const std::vector<Pose> X_OB = BodyPoses(model, joints);
    for (int body = 0; body < static_cast<int>(model.bodies.size()); ++body) {
      EXPECT_EQ(PoseAlong(model, ChainTo(model, body), joints).matrix(), X_OB[static_cast<std::size_t>(body)].matrix())
          << name << " " << model.bodies[static_cast<std::size_t>(body)].name;
    }
  }
}

}  // namespace
}  // namespace gaitwright
