// SPDX-License-Identifier: BSD-3-Clause
// Forces and torques of walks on massless legs: a joint force is minus the force on its foot.
#include "workflows/exchange/given_forces.h"

#include <gtest/gtest.h>

#include "tests/playback/played.h"

namespace gaitwright {
namespace {

constexpr double kSlightForce = 0.05;  // [N]; the weight is 98 N

enum class Given { kNothing, kForces, kTorques, kBoth };

/// The rows of a walk with some of its forces and torques.
EvenMotion RowsWith(const synthetic::Played& walker, Given given) {
  EvenMotion motion;
  const WholeBodyTrajectory& body = walker.plan.whole_body;
  motion.step_s = body.step_s;
  motion.q = body.q;
  motion.v = body.v;
  motion.a = body.a;
  if (given == Given::kTorques || given == Given::kBoth) motion.tau = body.tau;
  if (given == Given::kTorques || given == Given::kNothing) return motion;
  for (const std::vector<ContactWrench>& row : body.wrenches) {
    motion.force_W.emplace_back();
    for (const ContactWrench& wrench : row) motion.force_W.back().push_back(wrench.force_W);
  }
  return motion;
}

/// The plan without its forces and torques.
MotionPlan Unloaded(MotionPlan plan) {
  for (auto& row : plan.whole_body.wrenches) row.assign(row.size(), {});
  for (VectorX& tau : plan.whole_body.tau) tau.setZero();
  return plan;
}

double FarthestForce(const MotionPlan& a, const MotionPlan& b) {
  double farthest = 0.0;
  for (std::size_t k = 0; k < a.whole_body.wrenches.size(); ++k) {
    for (std::size_t f = 0; f < a.whole_body.wrenches[k].size(); ++f)
      farthest = std::max(farthest, (a.whole_body.wrenches[k][f].force_W - b.whole_body.wrenches[k][f].force_W).norm());
  }
  return farthest;
}

double FarthestTorque(const MotionPlan& a, const MotionPlan& b) {
  double farthest = 0.0;
  for (std::size_t k = 0; k < a.whole_body.tau.size(); ++k)
    farthest = std::max(farthest, (a.whole_body.tau[k] - b.whole_body.tau[k]).norm());
  return farthest;
}

TEST(GivenForces, ForcesOfAFileGiveTheTorquesThatTheMotionNeeds) {
  for (const int legs : {2, 4}) {
    const synthetic::Played walker = synthetic::Walked(legs, {.count = 2});
    MotionPlan plan = Unloaded(walker.plan);
    ASSERT_GT(FarthestTorque(plan, walker.plan), 1.0);
    std::vector<DerivedPart> derived;
    TakeGivenForces(walker.model, RowsWith(walker, Given::kForces), plan, derived);
    EXPECT_LT(FarthestTorque(plan, walker.plan), kSlightForce) << legs;
    EXPECT_LT(FarthestForce(plan, walker.plan), 1e-12) << "as given";
    ASSERT_EQ(derived.size(), 1U);
    EXPECT_EQ(derived[0].what, "torques");
  }
}

TEST(GivenForces, TorquesOfAFileGiveTheForcesOnItsFeet) {
  const synthetic::Played walker = synthetic::Walked(2, {.count = 2});
  MotionPlan plan = Unloaded(walker.plan);
  std::vector<DerivedPart> derived;
  TakeGivenForces(walker.model, RowsWith(walker, Given::kTorques), plan, derived);
  EXPECT_LT(FarthestForce(plan, walker.plan), 1.0) << "the base's rows are worth as much as the torques'";
  EXPECT_EQ(FarthestTorque(plan, walker.plan), 0.0) << "as given";
  ASSERT_EQ(derived.size(), 1U);
  EXPECT_EQ(derived[0].what, "contact forces");
}

TEST(GivenForces, BothAreTakenAsTheyAre) {
  const synthetic::Played walker = synthetic::Walked(2, {.count = 2});
  EvenMotion motion = RowsWith(walker, Given::kBoth);
  for (VectorX& tau : motion.tau) tau *= 1.5;  // they no longer fit the forces
  MotionPlan plan = Unloaded(walker.plan);
  std::vector<DerivedPart> derived;
  TakeGivenForces(walker.model, motion, plan, derived);
  EXPECT_EQ(plan.whole_body.tau, motion.tau);
  EXPECT_LT(FarthestForce(plan, walker.plan), 1e-12);
  EXPECT_TRUE(derived.empty());
}

TEST(GivenForces, AJointWithoutATorqueGetsTheOneThatIsNeeded) {
  const synthetic::Played walker = synthetic::Walked(2, {.count = 2});
  EvenMotion motion = RowsWith(walker, Given::kBoth);
  for (VectorX& tau : motion.tau) tau[2] = std::nan("");
  MotionPlan plan = Unloaded(walker.plan);
  std::vector<DerivedPart> derived;
  TakeGivenForces(walker.model, motion, plan, derived);
  EXPECT_LT(FarthestTorque(plan, walker.plan), kSlightForce);
}

TEST(GivenForces, AFileWithoutEitherLeavesThePlanAsItIs) {
  const synthetic::Played walker = synthetic::Walked(2, {.count = 2});
  MotionPlan plan = walker.plan;
  std::vector<DerivedPart> derived;
  TakeGivenForces(walker.model, RowsWith(walker, Given::kNothing), plan, derived);
  EXPECT_EQ(FarthestForce(plan, walker.plan), 0.0);
  EXPECT_EQ(FarthestTorque(plan, walker.plan), 0.0);
  ASSERT_EQ(derived.size(), 1U);
  EXPECT_EQ(derived[0].what, "contact forces and torques");
}

}  // namespace
}  // namespace gaitwright
