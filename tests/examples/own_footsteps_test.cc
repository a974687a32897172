// SPDX-License-Identifier: BSD-3-Clause
#include "examples/own_footsteps.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "examples/walk_own_footsteps.h"
#include "kinematics/model/load_robot.h"
#include "planning/paths/standing_feet.h"

namespace gaitwright::examples {
namespace {

const RobotModel& Robot() {
  static const RobotModel model = *LoadNamedRobot("a1");
  return model;
}

Vector2 PlaceOf(const PlacedStep& step) { return {step.place.x_m, step.place.y_m}; }

// A body that turns about a point takes every foot round that point.
TEST(OwnFootstepsExample, EveryFootStaysOnACircleOfItsOwn) {
  const std::vector<Pose> standing = StandingFeet(Robot());
  for (const double turn_rad : {1.0, -0.7}) {
    const Vector2 middle(0.0, std::copysign(0.6, turn_rad));
    const std::vector<PlacedStep> steps = StepsOnArc(Robot(), 0.6, turn_rad, 0.12);
    ASSERT_EQ(steps.size() % 4, 0U);
    EXPECT_EQ(steps.size() / 4, std::ceil(0.6 * std::abs(turn_rad) / 0.12));
    for (std::size_t k = 0; k < steps.size(); ++k) {
      const Vector3 first = standing[static_cast<std::size_t>(steps[k].foot)].translation();
      const Vector2 from = first.head<2>() - middle, to = PlaceOf(steps[k]) - middle;
      EXPECT_NEAR(to.norm(), from.norm(), 1e-12);
      const double turned = std::atan2(from.x() * to.y() - from.y() * to.x(), from.dot(to));
      const std::size_t round = k / 4 + 1, rounds = steps.size() / 4;
      EXPECT_NEAR(turned, turn_rad * static_cast<double>(round) / static_cast<double>(rounds), 1e-12);
      EXPECT_NEAR(steps[k].place.yaw_rad, turned, 1e-12);
    }
  }
}

TEST(OwnFootstepsExample, AllFeetStepInTurnFromTheRearToTheFront) {
  const std::vector<PlacedStep> steps = StepsOnArc(Robot(), 0.6, 1.0, 0.12);
  for (std::size_t k = 0; k < steps.size(); k += 4) {
    std::set<int> round;
    for (std::size_t i = k; i < k + 4; ++i) round.insert(steps[i].foot);
    EXPECT_EQ(round.size(), 4U) << "each foot once";
    for (std::size_t i = k; i < k + 4; i += 2)
      EXPECT_LT(PlaceOf(steps[i]).dot(Vector2(std::cos(steps[i].place.yaw_rad), std::sin(steps[i].place.yaw_rad))),
                PlaceOf(steps[i + 1]).dot(Vector2(std::cos(steps[i].place.yaw_rad), std::sin(steps[i].place.yaw_rad))));
  }
}

TEST(OwnFootstepsExample, IsWalkedAsItWasPlaced) {
  const WalkedSteps walk = WalkSteps(Robot(), StepsOnArc(Robot(), 0.6, 0.6, 0.12));
  EXPECT_TRUE(walk.audit.pass()) << AuditText(walk.audit);
  EXPECT_TRUE(walk.report.pass) << walk.report.reason;
  EXPECT_GT(walk.miss_m, 0.0) << "measured, not copied";
  EXPECT_LT(walk.miss_m, 0.005);
  EXPECT_NEAR(walk.plan.goal.x_m, 0.6 * std::sin(0.6), 1e-9);
  EXPECT_NEAR(walk.plan.goal.y_m, 0.6 * (1.0 - std::cos(0.6)), 1e-9);
  EXPECT_NEAR(walk.plan.goal.yaw_rad, 0.6, 1e-9);
}

TEST(OwnFootstepsExample, StepsThatCannotBeAreRefused) {
  EXPECT_THROW(StepsOnArc(Robot(), 0.0, 1.0, 0.1), InvalidArgument);
  EXPECT_THROW(StepsOnArc(Robot(), 0.6, 0.0, 0.1), InvalidArgument);
  EXPECT_THROW(StepsOnArc(Robot(), 0.6, 1.0, -0.1), InvalidArgument);
  EXPECT_THROW(StepsOnArc(Robot(), 0.6, std::nan(""), 0.1), InvalidArgument);
  EXPECT_THROW(WalkSteps(Robot(), {}), InvalidArgument);
  try {
    WalkSteps(Robot(), StepsOnArc(Robot(), 1.0, 1.0, 1.0));
    ADD_FAILURE();
  } catch (const InvalidArgument& error) {
    EXPECT_NE(std::string(error.what()).find("_foot'"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace gaitwright::examples
