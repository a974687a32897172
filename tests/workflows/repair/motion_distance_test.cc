// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "kinematics/model/upper_body.h"
#include "tests/workflows/repair/standing_motion.h"
#include "workflows/repair/motion_distance_internal.h"

namespace gaitwright {
namespace {

/// A plan with the rows of a motion.
MotionPlan PlanWith(const RobotModel& model, const EvenMotion& motion) {
  MotionPlan plan;
  WholeBodyTrajectory& rows = plan.whole_body;
  rows.step_s = motion.step_s;
  rows.q = motion.q;
  rows.v = motion.v;
  rows.a = motion.a;
  rows.tau.assign(rows.q.size(), VectorX::Zero(model.num_dofs()));
  rows.wrenches.assign(rows.q.size(), std::vector<ContactWrench>(model.feet.size()));
  return plan;
}

std::vector<std::string> NamesOf(const MotionDistance& distance) {
  std::vector<std::string> names;
  for (const GroupDistance& group : distance.groups) names.push_back(group.group);
  return names;
}

TEST(MotionDistance, OfAnArmIsThatOfItsJointAndHand) {
  const RobotModel& model = NamedRobot("h1");
  const EvenMotion plan = synthetic::Standing(model, 101);
  EvenMotion original = plan;
  const UpperBody upper = FindUpperBody(model);
  ASSERT_TRUE(upper.left_arm && upper.right_arm);
  const int dof = upper.left_arm->dofs.front();
  for (std::size_t k = 51; k < original.q.size(); ++k) original.q[k][7 + dof] += k == 60 ? 0.3 : 0.2;
  const MotionDistance distance = DistanceOf(model, original, PlanWith(model, plan));
  EXPECT_EQ(NamesOf(distance), (std::vector<std::string>{"legs", "arms", "torso_and_head", "base", "hands", "feet"}));
  const GroupDistance& arms = *distance.Group("arms");
  const auto joints = static_cast<double>(upper.left_arm->dofs.size() + upper.right_arm->dofs.size());
  EXPECT_EQ(arms.unit, "rad");
  EXPECT_NEAR(arms.largest, 0.3, 1e-9);
  EXPECT_NEAR(arms.largest_s, 0.6, 1e-9);
  EXPECT_EQ(arms.largest_where, model.dof_names[static_cast<std::size_t>(dof)]);
  EXPECT_NEAR(arms.rms, std::sqrt((49.0 * 0.04 + 0.09) / (101.0 * joints)), 1e-9);
  ASSERT_EQ(arms.over_time.size(), 101U);
  EXPECT_EQ(arms.over_time[50], 0.0F);
  EXPECT_NEAR(arms.over_time[60], 0.3 / std::sqrt(joints), 1e-6);
  EXPECT_GT(distance.Group("hands")->largest, 0.02);
  EXPECT_NEAR(distance.Group("hands")->largest_s, 0.6, 1e-9);
  for (const char* still : {"legs", "torso_and_head", "base", "feet"})
    EXPECT_NEAR(distance.Group(still)->largest, 0.0, 1e-9) << still;
  EXPECT_NEAR(distance.joint_largest_rad, 0.3, 1e-9);
}

TEST(MotionDistance, OfAShiftIsThatOfBaseHandsAndFeet) {
  const RobotModel& model = NamedRobot("h1");
  const EvenMotion plan = synthetic::Standing(model, 11);
  EvenMotion original = plan;
  for (VectorX& q : original.q) q[2] += 0.03;
  const MotionDistance distance = DistanceOf(model, original, PlanWith(model, plan));
  for (const char* group : {"base", "hands", "feet"}) {
    EXPECT_EQ(distance.Group(group)->unit, "m");
    EXPECT_NEAR(distance.Group(group)->rms, 0.03, 1e-9) << group;
  }
  EXPECT_NEAR(distance.base_rms_m, 0.03, 1e-9);
  EXPECT_NEAR(distance.joint_rms_rad, 0.0, 1e-12);
}

TEST(MotionDistance, HasOnlyGroupsOfTheRobot) {
  const RobotModel& model = NamedRobot("a1");
  const EvenMotion plan = synthetic::Standing(model, 11);
  const MotionDistance distance = DistanceOf(model, plan, PlanWith(model, plan));
  EXPECT_EQ(NamesOf(distance), (std::vector<std::string>{"legs", "base", "feet"}));
  EXPECT_EQ(distance.Group("arms"), nullptr);
}

}  // namespace
}  // namespace gaitwright
