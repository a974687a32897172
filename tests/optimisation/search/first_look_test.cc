// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/search/first_look.h"

#include <gtest/gtest.h>

#include "kinematics/model/load_robot.h"
#include "planning/terrain/load_terrain.h"

namespace gaitwright {
namespace {

using Extent = WalkCommand::Extent;

struct Asked {
  std::string gait;
  double speed_m_s = 0.0, distance_m = 0.0;
  std::string terrain = "flat";
  double step_length_m = 0.0;  // for four steps, instead of a speed and a distance

  WalkRequest Request() const {
    WalkRequest request;
    request.gait = gait;
    request.terrain = terrain;
    request.command.speed_m_s = speed_m_s;
    request.command.distance_m = distance_m;
    request.motion.footsteps.ramp.acceleration_m_s2 = 0.0;  // full speed within one cycle
    if (step_length_m > 0.0) {
      request.command.extent = Extent::kSteps;
      request.command.steps = 4;
      request.command.step_length_m = step_length_m;
    }
    return request;
  }
};

FirstLook LookOf(const Asked& asked, bool whole = true) {
  const RobotModel a1 = LoadNamedRobot("a1").value();
  const WalkRequest request = asked.Request();
  const Result<Terrain> terrain = LoadTerrain(request.terrain, ScaleOf(a1));
  const Result<Gait> gait = FindGait(a1, asked.gait, CommandedSpeed(a1, request.command), {});
  return LookAt(a1, terrain.value(), request, gait.value(), request.command, whole);
}

TEST(FirstLook, HasNothingAgainstWalksThatPass) {
  for (const Asked& asked :
       {Asked{"trot", 1.5, 3.0}, Asked{"bound", 0.8, 2.0}, Asked{"pronk", 0.5, 2.0}, Asked{"gallop", 1.0, 2.0},
        Asked{"bound", 0.8, 3.0, "gap:width_m=0.3"}, Asked{"jump", 0.0, 0.0, "flat", 0.1},
        Asked{"jump", 0.0, 0.0, "block:height_m=0.15,start_m=0.31,length_m=2", 0.13}}) {
    const FirstLook look = LookOf(asked);
    EXPECT_FALSE(look.refusal) << asked.gait << ' ' << asked.terrain << ": " << look.refusal->message;
    EXPECT_TRUE(look.solved);
  }
}

TEST(FirstLook, NamesTheLimitThatIsPassedAndAPaceThatEasesIt) {
  const FirstLook look = LookOf({"gallop", 4.0, 1.5});
  ASSERT_TRUE(look.refusal);
  EXPECT_EQ(look.refusal->code, FailureCode::kLimits);
  EXPECT_NE(look.refusal->message.find("past its limit of "), std::string::npos) << look.refusal->message;
  EXPECT_LT(look.ease, 1.0);
  EXPECT_FALSE(LookOf({"gallop", 4.0 * look.ease, 1.5}, false).refusal);
}

TEST(FirstLook, LawsThatStayUnmetAreThoseOfTheWholeWalk) {
  const FirstLook slippery = LookOf({"bound", 0.8, 1.5, "flat:friction=0.05"});
  ASSERT_TRUE(slippery.refusal);
  EXPECT_EQ(slippery.refusal->code, FailureCode::kUnmetLaw);
  EXPECT_NE(slippery.refusal->message.find("in all"), std::string::npos) << slippery.refusal->message;
  const FirstLook far = LookOf({"jump", 0.0, 0.0, "flat", 0.375});
  ASSERT_TRUE(far.refusal);
  EXPECT_EQ(far.refusal->code, FailureCode::kUnmetLaw);
}

TEST(FirstLook, WhatNeedsNoSolvingIsSaidToNeedNone) {
  const FirstLook look = LookOf({"trot", 9.0, 1.0});
  ASSERT_TRUE(look.refusal);
  EXPECT_EQ(look.refusal->code, FailureCode::kFootholdOutOfReach);
  EXPECT_FALSE(look.solved);
}

/// Factor of the speed that follows from an audit with these violations.
double Ease(const std::vector<Violation>& violations) {
  AuditReport audit;
  audit.violations = violations;
  return EaseOf(audit);
}

TEST(EaseOf, GoesBySpeedsOfJointsAndRootsOfTheirTorques) {
  const Violation fast{Law::kJointVelocity, 1.0, "knee", 42.0, 21.0, "rad/s"};
  const Violation strong{Law::kJointTorque, 1.0, "hip", -90.0, 40.0, "N m"};
  EXPECT_NEAR(Ease({fast}), 0.95 * 0.5, 1e-12);
  EXPECT_NEAR(Ease({strong}), 0.95 * 2.0 / 3.0, 1e-12);
  EXPECT_NEAR(Ease({strong, fast}), 0.95 * 0.5, 1e-12) << "the one that is passed most counts";
  EXPECT_GT(Ease({}), 0.5) << "where no limit is broken";
  EXPECT_LT(Ease({{Law::kJointVelocity, 1.0, "knee", 21.1, 21.0, "rad/s"}}), 0.9) << "a step that is worth a look";
  EXPECT_GE(Ease({{Law::kJointVelocity, 1.0, "knee", 2100.0, 21.0, "rad/s"}}), 0.3) << "but none too long";
}

/// The first suggestion of a refusal must be a speed at which a plan exists.
void ExpectHintServes(const Asked& asked) {
  const RobotModel a1 = LoadNamedRobot("a1").value();
  WalkRequest request = asked.Request();
  const Result<PlannedWalk> refused = PlanWalk(a1, request);
  ASSERT_FALSE(refused.ok());
  EXPECT_NE(refused.failure().message.find("may be feasible with gait '" + asked.gait), std::string::npos)
      << refused.failure().message;
  const std::string& hint = refused.failure().suggestions.front().text;
  const bool by_speed = hint.starts_with("--speed ");
  ASSERT_TRUE(by_speed || hint.starts_with("--step-length ")) << hint;
  (by_speed ? request.command.speed_m_s : request.command.step_length_m) = std::stod(hint.substr(hint.find(' ')));
  const Result<PlannedWalk> planned = PlanWalk(a1, request);
  ASSERT_TRUE(planned.ok()) << hint << ": " << planned.failure().message;
  EXPECT_TRUE(planned->audit.pass()) << hint << ": " << AuditText(planned->audit);
}

TEST(FirstLook, PacesNamedInsteadServe) {
  ExpectHintServes({"trot", 4.0, 2.0});
  ExpectHintServes({"jump", 0.0, 0.0, "flat", 0.45});
}

}  // namespace
}  // namespace gaitwright
