// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "kinematics/collision/link_distances_internal.h"
#include "kinematics/model/body_tree.h"
#include "kinematics/model/upper_body.h"
#include "tests/workflows/repair/standing_motion.h"
#include "workflows/repair/part_links_internal.h"

namespace gaitwright {
namespace {

constexpr int kPartedRows = 201;
constexpr double kLinksDistance = 0.005;  // [m]

/// The deepest overlap of a posture [m]; negative if links are apart.
double DeepestOf(const RobotModel& model, const VectorX& q) {
  LinkDistances distances(model);
  DynamicsScratch scratch(model);
  ForwardKinematics(model, q, scratch);
  double deepest_m = -1.0;
  for (const NearPair& near : distances.Near(scratch, 0.5)) deepest_m = std::max(deepest_m, -near.distance_m);
  return deepest_m;
}

/// The joint of the left arm, and its angle from the standing posture, that takes the arm deepest into the body.
std::pair<int, double> DeepestArmJoint(const RobotModel& model) {
  std::pair<int, double> deepest;
  double deepest_m = 0.0;
  const UpperBody upper = FindUpperBody(model);
  for (const int dof : upper.left_arm->dofs) {
    for (double angle = -1.0; angle <= 1.0; angle += 0.1) {
      VectorX q = StandingConfiguration(model);
      q[7 + dof] = std::clamp(q[7 + dof] + angle, model.dof_lower(dof), model.dof_upper(dof));
      if (const double depth_m = DeepestOf(model, q); depth_m > deepest_m && depth_m < 0.05) {
        deepest_m = depth_m;
        deepest = {dof, angle};
      }
    }
  }
  return deepest;
}

TEST(PartLinks, TakesAnArmOutOfTheBodySmoothly) {
  const RobotModel& model = NamedRobot("g1");
  const auto [dof, angle] = DeepestArmJoint(model);
  ASSERT_NE(angle, 0.0);
  EvenMotion motion = synthetic::Standing(model, kPartedRows);
  for (int k = 0; k < kPartedRows; ++k)
    motion.q[static_cast<std::size_t>(k)][7 + dof] += angle * std::pow(std::sin(M_PI * k / (kPartedRows - 1.0)), 2.0);
  const EvenMotion before = motion;
  const std::vector<PartedLinks> parted = PartLinks(model, kLinksDistance, motion);
  ASSERT_FALSE(parted.empty());
  const double deepest_m = parted.front().depth_m;
  EXPECT_GT(deepest_m, 0.01);
  EXPECT_FALSE(parted.front().links.empty());
  EXPECT_GT(parted.front().start_s, 0.0);
  EXPECT_NEAR(parted.front().start_s + parted.front().end_s, motion.TimeOf(kPartedRows - 1), 0.011) << "symmetric";
  EXPECT_NEAR(deepest_m, DeepestOf(model, before.q[kPartedRows / 2]), 0.2 * deepest_m);
  const std::vector<bool> of_leg = DofsOfLegs(model);
  for (std::size_t k = 0; k < motion.q.size(); ++k) {
    EXPECT_LT(DeepestOf(model, motion.q[k]), 1e-3) << k;
    const VectorX moved = (motion.q[k] - before.q[k]).tail(model.num_dofs());
    for (int d = 0; d < model.num_dofs(); ++d) {
      if (!of_leg[static_cast<std::size_t>(d)]) continue;
      EXPECT_EQ(moved[d], 0.0);
    }
    const VectorX& last = motion.q[std::max<std::size_t>(1, k) - 1];
    EXPECT_LT((motion.q[k] - last).lpNorm<Eigen::Infinity>(), 0.1) << k;
  }
  EXPECT_EQ(motion.q.front(), before.q.front());
}

TEST(PartLinks, LeavesAMotionWhoseLinksAreApart) {
  const RobotModel& model = NamedRobot("g1");
  EvenMotion motion = synthetic::Standing(model, 20);
  const EvenMotion before = motion;
  EXPECT_TRUE(PartLinks(model, kLinksDistance, motion).empty());
  EXPECT_TRUE(motion.q == before.q);
}

}  // namespace
}  // namespace gaitwright
