// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/search/refuse_walk.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace gaitwright {
namespace {

Violation Broken(Law law, const std::string& where, double value, double limit, const std::string& unit = "rad") {
  return {law, 1.25, where, value, limit, unit};
}

PlannedWalk WalkWith(const std::vector<Violation>& violations) {
  PlannedWalk walk;
  walk.audit.violations = violations;
  return walk;
}

std::vector<std::string> Places(const std::vector<Violation>& violations) {
  std::vector<std::string> places;
  for (const Violation& v : violations) places.push_back(v.where);
  return places;
}

using PlaceNames = std::vector<std::string>;

TEST(BrokenLimits, AreThoseOfTheRobotWorstFirstInShareOfTheirLimit) {
  AuditReport audit;
  audit.violations = {Broken(Law::kJointPosition, "a", 1.1, 1.0), Broken(Law::kDynamics, "base", 99.0, 1.0),
                      Broken(Law::kJointTorque, "b", 60.0, 40.0), Broken(Law::kJointVelocity, "c", -12.0, -10.0),
                      Broken(Law::kFrictionCone, "d", 9.0, 0.8)};
  EXPECT_EQ(Places(BrokenLimits(audit)), (PlaceNames{"b", "c", "a"}));
  EXPECT_EQ(Places(Forbidding(audit)), (PlaceNames{"b", "c", "a", "base", "d"})) << "then other laws in their order";
}

TEST(BrokenLimits, EqualOnesStayInTheAuditsOrder) {
  AuditReport audit;
  audit.violations = {Broken(Law::kJointPosition, "a", 1.5, 1.0), Broken(Law::kJointPosition, "b", 3.0, 2.0),
                      Broken(Law::kJointTorque, "c", 15.0, 10.0)};
  EXPECT_EQ(Places(BrokenLimits(audit)), (PlaceNames{"a", "b", "c"}));
}

TEST(BrokenLimits, AMotorPastItsSpeedIsNamedForThatFirst) {
  AuditReport audit;
  audit.violations = {Broken(Law::kTorqueSpeed, "knee", 50.0, 1.0), Broken(Law::kTorqueSpeed, "hip", 3.0, 2.0),
                      Broken(Law::kJointVelocity, "knee", 11.0, 10.0)};
  const std::vector<Violation> broken = BrokenLimits(audit);
  EXPECT_EQ(Places(broken), (PlaceNames{"hip", "knee", "knee"}));
  EXPECT_EQ(broken[1].law, Law::kJointVelocity);
  EXPECT_EQ(broken[2].law, Law::kTorqueSpeed);
}

TEST(BrokenLimits, ALimitOfZeroIsNoDivisionByZero) {
  AuditReport audit;
  audit.violations = {Broken(Law::kJointPosition, "a", 1.0, 1e-3), Broken(Law::kReach, "b", 1.0, 0.0)};
  EXPECT_EQ(Places(BrokenLimits(audit)), (PlaceNames{"b", "a"}));
}

TEST(IsTooMuch, IsWhatASlowerWalkMayNotHave) {
  const auto too_much = [](FailureKind kind, FailureCode code) { return IsTooMuch({kind, code, "PlanWalk", "", {}}); };
  for (const FailureCode code : {FailureCode::kLimits, FailureCode::kOutOfReach, FailureCode::kZmpSupport,
                                 FailureCode::kUnmetLaw, FailureCode::kDynamics}) {
    EXPECT_TRUE(too_much(FailureKind::kInfeasible, code)) << code;
    EXPECT_FALSE(too_much(FailureKind::kBadInput, code)) << code;
  }
  for (const FailureCode code :
       {FailureCode::kGait, FailureCode::kPassiveJoint, FailureCode::kFreedoms, FailureCode::kHeight,
        FailureCode::kNoSupport, FailureCode::kNoFootholds, FailureCode::kSearchBudget, FailureCode::kStartBlocked,
        FailureCode::kGoalBlocked, FailureCode::kWayBlocked, FailureCode::kWayNotFound})
    EXPECT_FALSE(too_much(FailureKind::kInfeasible, code)) << code;
}

TEST(IsSound, NeedsAPlanWithinLimitsThatPassesItsAudit) {
  EXPECT_TRUE(IsSound(WalkWith({})));
  EXPECT_FALSE(IsSound(Failure{}));
  EXPECT_FALSE(IsSound(WalkWith({Broken(Law::kDynamics, "base", 1.0, 0.1)})));
  EXPECT_FALSE(IsSound(WalkWith({Broken(Law::kJointTorque, "knee", 41.0, 40.0)})));
  PlannedWalk slight = WalkWith({}), far = slight;
  slight.motion.limit_violation = 0.9 * kSlightViolation;
  far.motion.limit_violation = 1.1 * kSlightViolation;
  EXPECT_TRUE(IsSound(slight));
  EXPECT_FALSE(IsSound(far)) << "past limits between the audit's samples";
}

TEST(ReasonForbidden, NamesTheWorstLimitAndHowManyThereAre) {
  const Failure one = ReasonForbidden(WalkWith({Broken(Law::kJointTorque, "knee", 44.0, 40.0, "N m")}));
  EXPECT_EQ(one.kind, FailureKind::kInfeasible);
  EXPECT_EQ(one.code, FailureCode::kLimits);
  ASSERT_TRUE(one.violation);
  EXPECT_EQ(one.violation->where, "knee");
  EXPECT_EQ(one.message.find("worst of"), std::string::npos);
  const Failure two = ReasonForbidden(
      WalkWith({Broken(Law::kJointPosition, "hip", 1.05, 1.0), Broken(Law::kJointTorque, "knee", 44.0, 40.0, "N m"),
                Broken(Law::kDynamics, "base", 9.0, 1.0)}));
  EXPECT_EQ(two.violation->where, "knee");
  EXPECT_NE(two.message.find("worst of 2 violated limits"), std::string::npos) << two.message;
}

TEST(ReasonForbidden, WithoutABrokenLimitHasTheCodeOfTheFirstLaw) {
  const PlannedWalk walk =
      WalkWith({Broken(Law::kZmpSupport, "ZMP", 0.004, 0.002, "m"), Broken(Law::kDynamics, "base", 9.0, 1.0)});
  EXPECT_EQ(ReasonForbidden(walk).code, FailureCode::kZmpSupport);
  EXPECT_EQ(ReasonRefused(walk), FailureCode::kZmpSupport);
  EXPECT_EQ(ReasonRefused(Failure{FailureKind::kInfeasible, FailureCode::kNoFootholds, "", "", {}}),
            FailureCode::kNoFootholds);
}

TEST(ReasonForbidden, OfLimitsPassedBetweenSamplesHasThePlansWarnings) {
  PlannedWalk walk;
  walk.motion.limit_violation = 1.0;
  walk.motion.plan.warnings = {"first", "second"};
  const Failure failure = ReasonForbidden(walk);
  EXPECT_EQ(failure.code, FailureCode::kLimits);
  EXPECT_EQ(failure.message, "first; second");
  EXPECT_FALSE(failure.violation);
  EXPECT_EQ(failure.suggestions, std::vector<Suggestion>{AllowLimits()});
}

struct LimitTextCase {
  Violation violation;
  std::vector<std::string> has;
};

TEST(LimitText, HasThePlaceTheValueTheLimitAndTheDifference) {
  const std::vector<LimitTextCase> cases = {
      {Broken(Law::kJointVelocity, "knee", 12.5, 10.0, "rad/s"), {"'knee'", "12.5 rad/s", "1.25 s", "2.5 rad/s", "10"}},
      {Broken(Law::kJointTorque, "hip", -44.0, -40.0, "N m"), {"'hip'", "-44 N m", "4 N m past", "-40"}},
      {Broken(Law::kSelfCollision, "'a' and 'b'", -0.01, 0.0, "m"), {"'a' and 'b'", "1.25 s"}},
      {Broken(Law::kZmpSupport, "ZMP", 0.0123, 0.002, "m"), {"ZMP", "12.3 mm", "2 mm"}},
      {Broken(Law::kBodyClearance, "shank", -0.0042, 0.0, "m"), {"'shank'", "4.2 mm"}},
      {Broken(Law::kDynamics, "base, force", 31.0, 2.5, "N"), {"31 N", "2.5"}},
      {Broken(Law::kFrictionCone, "toe", 0.91, 0.8, "1"), {LawName(Law::kFrictionCone), "toe", "0.91", "0.8"}}};
  for (const LimitTextCase& c : cases) {
    const std::string text = LimitText(c.violation);
    for (const std::string& part : c.has) EXPECT_NE(text.find(part), std::string::npos) << part << " in: " << text;
    EXPECT_FALSE(text.ends_with(".")) << text;
  }
}

TEST(LimitText, TellsEachKindOfLimitFromTheOthers) {
  std::vector<std::string> texts;
  for (const Law law : {Law::kJointPosition, Law::kJointVelocity, Law::kJointAcceleration, Law::kJointJerk,
                        Law::kJointTorque, Law::kTorqueSpeed, Law::kContinuousTorque, Law::kReach}) {
    const std::string text = LimitText(Broken(law, "knee", 3.0, 2.0, "1"));
    for (const std::string& other : texts) EXPECT_NE(text, other) << law;
    texts.push_back(text);
  }
}

TEST(AllowLimits, IsAnOptionWithItsValue) {
  const Suggestion suggestion = AllowLimits();
  EXPECT_EQ(suggestion.what, "pipeline.allow_limits");
  EXPECT_EQ(std::get<std::string>(suggestion.value), "true");
}

}  // namespace
}  // namespace gaitwright
