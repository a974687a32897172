// SPDX-License-Identifier: BSD-3-Clause
// Depths and distances along motions are in overlaps_test.cc.
#include "kinematics/collision/collision_checker.h"

#include <algorithm>

#include "tests/kinematics/model/small_urdf.h"
#include "tests/kinematics/random_state.h"

namespace gaitwright {
namespace {

/// A chain of balls of 0.1 m: the base, then links along x with hinges about z.
/// @param distances  of each hinge from the previous one [m]. @param bare  links without a ball.
RobotModel ChainOfBalls(const std::vector<double>& distances, const std::vector<int>& bare = {}) {
  RobotModel model;
  model.name = "chain";
  for (std::size_t i = 0; i <= distances.size(); ++i) {
    const std::string name = "l" + std::to_string(i);
    model.bodies.push_back({name, 1.0, Vector3::Zero(), Matrix3::Identity()});
    if (std::find(bare.begin(), bare.end(), static_cast<int>(i)) == bare.end()) {
      Shape ball;
      ball.type = ShapeType::kSphere;
      ball.size = Vector3(0.1, 0.0, 0.0);
      ball.body = static_cast<int>(i);
      ball.link = name;
      model.collision_shapes.push_back(ball);
    }
    if (i == 0) continue;
    Joint joint;
    joint.name = "j" + std::to_string(i);
    joint.parent_body = static_cast<int>(i) - 1;
    joint.X_PJ.translation() = distances[i - 1] * Vector3::UnitX();
    joint.lower = -2.0;
    joint.upper = 2.0;
    joint.dof = static_cast<int>(i) - 1;
    model.joints.push_back(joint);
    model.dof_names.push_back(joint.name);
    model.dof_joint.push_back(joint.dof);
  }
  model.standing_joints = VectorX::Zero(model.num_dofs());
  return model;
}

TEST(CollisionChecker, NeighboursAreLeftOutAndOthersAreChecked) {
  const CollisionChecker checker(ChainOfBalls({0.3, 0.3, 0.3}));
  EXPECT_EQ(checker.num_pairs(), 3) << "0-2, 0-3, 1-3";
  ASSERT_EQ(checker.left_out().size(), 3U);
  for (const LeftOutPair& pair : checker.left_out()) EXPECT_TRUE(pair.adjacent);
  EXPECT_EQ(checker.left_out()[0], (LeftOutPair{"l0", "l1", true, "adjacent: joint 'j1' connects them"}));
}

TEST(CollisionChecker, LinksWithoutShapesAndJointsInOnePointJoinTheirNeighbours) {
  EXPECT_EQ(CollisionChecker(ChainOfBalls({0.3, 0.3, 0.3}, {1})).num_pairs(), 1)
      << "0-2 are joined through 1; 0-3 are not";
  // Two hinges 3 mm apart, as in an ankle: the links on both sides of them are neighbours.
  const CollisionChecker ankle(ChainOfBalls({0.3, 0.003}));
  EXPECT_EQ(ankle.num_pairs(), 0);
  EXPECT_EQ(CollisionChecker(ChainOfBalls({0.3, 0.3})).num_pairs(), 1);
}

TEST(CollisionChecker, PairsThatTouchAsItStandsAreLeftOut) {
  const CollisionChecker checker(ChainOfBalls({0.09, 0.09}));
  EXPECT_EQ(checker.num_pairs(), 0);
  ASSERT_EQ(checker.left_out().size(), 3U);
  const LeftOutPair& pair = checker.left_out().back();
  EXPECT_EQ(pair.link_a, "l0");
  EXPECT_EQ(pair.link_b, "l2");
  EXPECT_FALSE(pair.adjacent);
  EXPECT_TRUE(pair.reason.starts_with("always touching")) << pair.reason;
}

TEST(CollisionChecker, AChainThatCurlsUpTouchesItsBase) {
  RobotModel arm = ChainOfBalls({0.3, 0.3});
  arm.collision_shapes.back().X_BS.translation() = 0.3 * Vector3::UnitX();  // at the end of l2
  CollisionChecker of_arm(arm);
  DynamicsScratch scratch(arm);
  VectorX q = StandingConfiguration(arm);
  for (const double bend : {0.0, 1.5, 1.9, 2.0, 2.4, 1.5, 1.8}) {
    q.tail(2) = Vector2(bend, bend);
    ForwardKinematics(arm, q, scratch);
    // Three links of 0.3 m at the angles 0, bend and twice bend.
    const double apart = 0.3 * std::abs(1.0 + 2.0 * std::cos(bend)) - 0.2;
    const std::vector<Overlap>& found = of_arm.Overlaps(scratch);
    ASSERT_EQ(found.size(), apart < 0.0 ? 1U : 0U) << bend;
    if (apart < 0.0) {
      EXPECT_NEAR(found[0].depth_m, -apart, 1e-4) << bend;
    }
  }
}

TEST(CollisionChecker, TheBasesPlaceDoesNotMatter) {
  const RobotModel model = ChainOfBalls({0.3, 0.3, 0.15});
  CollisionChecker here(model), there(model);
  DynamicsScratch scratch(model);
  RandomState random(7);
  for (int i = 0; i < 30; ++i) {
    VectorX q = random.Configuration(model);
    ForwardKinematics(model, q, scratch);
    const std::vector<Overlap> moved = there.Overlaps(scratch);
    q.head<7>() << 0, 0, 0, 0, 0, 0, 1;
    ForwardKinematics(model, q, scratch);
    const std::vector<Overlap>& still = here.Overlaps(scratch);
    ASSERT_EQ(moved.size(), still.size());
    for (std::size_t k = 0; k < still.size(); ++k) EXPECT_NEAR(moved[k].depth_m, still[k].depth_m, 1e-5);
  }
}

TEST(CollisionChecker, AMeshWithoutVerticesIsNoted) {
  RobotModel model = ChainOfBalls({0.3, 0.3});
  model.collision_shapes[2].type = ShapeType::kMesh;
  const CollisionChecker checker(model);
  ASSERT_EQ(checker.notes().size(), 1U);
  ExpectSays(checker.notes()[0], {"'l2'"});
  EXPECT_EQ(checker.num_pairs(), 0);
}

}  // namespace
}  // namespace gaitwright
