// SPDX-License-Identifier: BSD-3-Clause
// Overlaps along a motion: known depths, and the same results as a new checker.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "kinematics/collision/collision_checker.h"
#include "kinematics/model/load_robot.h"

namespace gaitwright {
namespace {

/// Two bodies on prismatic joints above a base, with one shape each.
RobotModel TwoOnSlides(ShapeType type, const Vector3& size) {
  RobotModel model;
  model.bodies = {{"base", 1.0, Vector3::Zero(), Matrix3::Identity()},
                  {"left", 1.0, Vector3::Zero(), Matrix3::Identity()},
                  {"right", 1.0, Vector3::Zero(), Matrix3::Identity()}};
  for (int i = 0; i < 2; ++i) {
    Joint slide;
    slide.type = JointType::kPrismatic;
    slide.axis_J = Vector3::UnitX();
    slide.dof = i;
    model.joints.push_back(slide);
    model.dof_names.push_back(i == 0 ? "left" : "right");
    model.dof_joint.push_back(i);
    Shape shape;
    shape.type = type;
    shape.size = size;
    shape.body = i + 1;
    shape.link = model.dof_names.back();
    model.collision_shapes.push_back(shape);
  }
  model.standing_joints = Eigen::Vector2d(-1.0, 1.0);
  return model;
}

TEST(Overlaps, DepthsOfShapesThatMeetHeadOn) {
  struct Case {
    ShapeType type;
    Vector3 size;
    double width_m;
  };
  for (const Case& c :
       {Case{ShapeType::kBox, {0.1, 0.3, 0.3}, 0.1}, Case{ShapeType::kSphere, {0.05, 0.0, 0.0}, 0.1},
        Case{ShapeType::kCylinder, {0.05, 0.3, 0.0}, 0.1}, Case{ShapeType::kCapsule, {0.05, 0.3, 0.0}, 0.1}}) {
    const RobotModel model = TwoOnSlides(c.type, c.size);
    CollisionChecker checker(model);
    ASSERT_EQ(checker.num_pairs(), 1);
    DynamicsScratch scratch(model);
    VectorX q = StandingConfiguration(model);
    for (double gap = 0.5; gap > -0.03; gap -= 0.0037) {
      q.tail(2) = Eigen::Vector2d(0.0, c.width_m + gap);
      ForwardKinematics(model, q, scratch);
      const std::vector<Overlap>& found = checker.Overlaps(scratch);
      ASSERT_EQ(found.size(), gap < 0.0 ? 1U : 0U) << "gap " << gap;
      if (gap > 0.0) continue;
      EXPECT_EQ(found[0].link_a, "left");
      EXPECT_EQ(found[0].link_b, "right");
      EXPECT_NEAR(found[0].depth_m, -gap, 1e-5);
    }
  }
}

TEST(NearestPair, IsAsFarAsTheShapesAreApartAndOnlyNamedWhereItIsNearer) {
  const RobotModel model = TwoOnSlides(ShapeType::kSphere, {0.05, 0.0, 0.0});
  CollisionChecker checker(model);
  DynamicsScratch scratch(model);
  VectorX q = StandingConfiguration(model);
  for (const double gap : {0.5, 0.1, 0.3, 0.02, -0.01, 0.2}) {
    q.tail(2) = Eigen::Vector2d(0.0, 0.1 + gap);
    ForwardKinematics(model, q, scratch);
    const Overlap nearest = checker.Nearest(scratch, gap + 0.01);
    EXPECT_EQ(nearest.link_a, "left") << gap;
    EXPECT_EQ(nearest.link_b, "right") << gap;
    EXPECT_NEAR(nearest.depth_m, -gap, 2e-5);
    EXPECT_EQ(checker.Nearest(scratch, gap).link_a, "") << gap;
    EXPECT_EQ(checker.Overlaps(scratch).size(), gap < 0.0 ? 1U : 0U) << "what was asked changes no answer";
  }
}

TEST(NearestPair, OfALegThatComesNearIsTheLeastOverAllPairs) {
  const RobotModel model = LoadNamedRobot("nao").value();
  CollisionChecker watching(model);
  DynamicsScratch scratch(model);
  VectorX q = StandingConfiguration(model);
  double least = 0.2;
  for (int k = 0; k <= 40; ++k) {
    for (int d = 0; d < model.num_dofs(); ++d)
      q[7 + d] = model.standing_joints[d] + 0.2 * std::sin(0.1 * k + d) * (d % 3 == 0 ? 1.0 : 0.2);
    ForwardKinematics(model, q, scratch);
    const Overlap nearest = watching.Nearest(scratch, least);
    CollisionChecker fresh(model);
    const Overlap at_once = fresh.Nearest(scratch, 0.2);
    if (nearest.link_a.empty()) {
      EXPECT_GE(-at_once.depth_m, least - 1.2e-4) << k;
    } else {
      EXPECT_NEAR(nearest.depth_m, at_once.depth_m, 1.2e-4) << k;
      least = -nearest.depth_m;
    }
  }
  EXPECT_LT(least, 0.1);
}

TEST(Overlaps, DoNotDependOnWhatWasSeenBefore) {
  for (const char* name : {"a1", "nao"}) {
    const RobotModel model = LoadNamedRobot(name).value();
    CollisionChecker watching(model);
    DynamicsScratch scratch(model);
    std::mt19937 random(7);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    int touched = 0;
    for (int motion = 0; motion < 10; ++motion) {
      VectorX direction(model.num_dofs());
      for (double& d : direction) d = uniform(random);
      for (int k = 0; k < 40; ++k) {
        VectorX q = StandingConfiguration(model);
        q[0] += 0.02 * k;
        q.tail(model.num_dofs()) += 0.08 * k * direction;
        ForwardKinematics(model, q, scratch);
        CollisionChecker fresh(model);
        const std::vector<Overlap> expected = fresh.Overlaps(scratch);
        const std::vector<Overlap>& found = watching.Overlaps(scratch);
        ASSERT_EQ(found.size(), expected.size()) << name << ", motion " << motion << ", pose " << k;
        for (std::size_t i = 0; i < found.size(); ++i) {
          EXPECT_EQ(found[i].link_a, expected[i].link_a);
          EXPECT_EQ(found[i].link_b, expected[i].link_b);
          EXPECT_EQ(found[i].depth_m, expected[i].depth_m);
        }
        touched += static_cast<int>(found.size());
      }
    }
    EXPECT_GT(touched, 20) << "the motions must bring links together";
  }
}

const LeftOutPair* PairOf(const CollisionChecker& checker, const std::string& a, const std::string& b) {
  for (const LeftOutPair& pair : checker.left_out()) {
    if ((pair.link_a == a && pair.link_b == b) || (pair.link_a == b && pair.link_b == a)) return &pair;
  }
  return nullptr;
}

TEST(LeftOutPairs, AreNamedOnceWithTheirReason) {
  for (const char* name : {"a1", "nao"}) {
    const RobotModel model = LoadNamedRobot(name).value();
    const CollisionChecker checker(model);
    ASSERT_FALSE(checker.left_out().empty());
    for (const LeftOutPair& pair : checker.left_out()) {
      EXPECT_NE(pair.reason.find(": "), std::string::npos) << pair.reason;
      EXPECT_EQ(std::count_if(checker.left_out().begin(), checker.left_out().end(),
                              [&](const LeftOutPair& other) {
                                return other.link_a == pair.link_a && other.link_b == pair.link_b;
                              }),
                1);
    }
  }
  const RobotModel a1 = LoadNamedRobot("a1").value();
  const CollisionChecker checker(a1);
  const LeftOutPair* knee = PairOf(checker, "FL_thigh", "FL_calf");
  ASSERT_NE(knee, nullptr);
  EXPECT_EQ(knee->reason, "adjacent: joint 'FL_calf_joint' connects them");
  EXPECT_EQ(PairOf(checker, "FL_calf", "FR_calf"), nullptr) << "these are checked";
}

/// Two balls on prismatic joints along x, each on the base. The ranges of the joints decide whether they always touch.
TEST(LeftOutPairs, PairsThatAlwaysTouchDifferFromThoseOfTheStandingPosture) {
  for (const bool always : {true, false}) {
    RobotModel model = TwoOnSlides(ShapeType::kSphere, {0.1, 0.0, 0.0});
    model.standing_joints = Eigen::Vector2d(0.0, 0.1);
    for (std::size_t j = 0; j < 2; ++j) {
      model.joints[j].lower = 0.0;
      model.joints[j].upper = always ? 0.15 : 1.0;
    }
    const CollisionChecker checker(model);
    EXPECT_EQ(checker.num_pairs(), 0);
    ASSERT_EQ(checker.left_out().size(), 1U);
    const std::string& reason = checker.left_out()[0].reason;
    EXPECT_EQ(reason.substr(0, reason.find_first_of(":,")),
              always ? "always touching" : "touching in the standing posture");
  }
}

}  // namespace
}  // namespace gaitwright
