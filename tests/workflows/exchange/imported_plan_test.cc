// SPDX-License-Identifier: BSD-3-Clause
// Rows of a plan give the same plan again.
#include "workflows/exchange/imported_plan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "kinematics/base/result.h"
#include "tests/playback/played.h"

namespace gaitwright {
namespace {

EvenMotion RowsOfWalk(const synthetic::Played& walker) {
  EvenMotion motion;
  const WholeBodyTrajectory& body = walker.plan.whole_body;
  motion.step_s = body.step_s;
  motion.q = body.q;
  motion.v = body.v;
  motion.a = body.a;
  for (const LogSample& sample : walker.log.samples) motion.contact.push_back(sample.contact);
  return motion;
}

MotionPlan PlanAgain(const synthetic::Played& walker, EvenMotion motion, ImportNotes& notes,
                     const std::optional<PlanarPose>& goal = {}) {
  return PlanOfMotion(walker.model, walker.plan.terrain, std::move(motion), {}, goal, notes);
}

std::string RefusalOfRows(const synthetic::Played& walker, EvenMotion motion) {
  ImportNotes notes;
  try {
    PlanAgain(walker, std::move(motion), notes);
  } catch (const InvalidArgument& error) {
    return error.what();
  }
  return "nothing was refused";
}

EvenMotion Raised(EvenMotion motion, double by_m) {
  for (VectorX& q : motion.q) q[2] += by_m;
  return motion;
}

TEST(ImportedPlan, HasTheContactsFootholdsAndSwingsOfTheMotion) {
  const synthetic::Played walker = synthetic::Walked(4, {.count = 4});
  ImportNotes notes;
  const MotionPlan plan = PlanAgain(walker, RowsOfWalk(walker), notes);
  ASSERT_EQ(plan.schedule.phases.size(), walker.plan.schedule.phases.size());
  ASSERT_EQ(plan.footsteps.footholds.size(), walker.plan.footsteps.footholds.size());
  const std::size_t feet = walker.model.feet.size();
  EXPECT_EQ(plan.swings.size(), plan.footsteps.footholds.size() - feet) << "one between two footholds of a foot";
  for (std::size_t i = 1; i < plan.swings.size(); ++i) EXPECT_GE(plan.swings[i].start_s, plan.swings[i - 1].start_s);
  EXPECT_TRUE(notes.warnings.empty()) << notes.warnings.front();
}

/// The legs are massless, so the centre of mass is at the base, and the forces carry ten kilograms.
TEST(ImportedPlan, CentreOfMassAndForcesAreThoseOfTheModel) {
  const synthetic::Played walker = synthetic::Walked(2, {.count = 2});
  ImportNotes notes;
  const MotionPlan plan = PlanAgain(walker, RowsOfWalk(walker), notes);
  EXPECT_NEAR(plan.centroidal.omega_rad_s, std::sqrt(kGravity / synthetic::kHeight), 1e-3);
  for (std::size_t k = 0; k < plan.whole_body.q.size(); ++k) {
    EXPECT_LT((plan.centroidal.p_WC[k] - walker.plan.whole_body.q[k].head<3>()).norm(), 1e-9);
    EXPECT_LT((plan.centroidal.v_WC[k] - walker.plan.whole_body.v[k].head<3>()).norm(), 1e-9);
    Vector3 force = Vector3::Zero();
    for (const ContactWrench& wrench : plan.whole_body.wrenches[k]) force += wrench.force_W;
    EXPECT_NEAR(force.z(), walker.model.weight_n(), 0.02 * walker.model.weight_n()) << k;
  }
}

TEST(ImportedPlan, ItsGaitIsTheMeanPatternOfTheContacts) {
  const synthetic::Played walker = synthetic::Walked(2, {.count = 6});
  ImportNotes notes;
  const MotionPlan plan = PlanAgain(walker, RowsOfWalk(walker), notes);
  ASSERT_EQ(plan.parts.size(), 1U);
  const Gait& gait = plan.parts[0].gait;
  EXPECT_EQ(gait.name, "imported");
  EXPECT_NEAR(gait.cycle_s, 1.0, 1e-9) << "a swing of 0.4 s and 0.1 s on both feet, on either side";
  const double apart = gait.phase[1] - gait.phase[0];
  EXPECT_NEAR(std::abs(apart - std::round(apart)), 0.5, 1e-6) << "the feet step in turn";
  for (const double duty : gait.duty_factor) {
    EXPECT_GT(duty, 0.5);
    EXPECT_LT(duty, 1.0);
  }
}

TEST(ImportedPlan, ItsGoalIsItsEndUnlessAnotherIsMeant) {
  const synthetic::Played walker = synthetic::Walked(2, {.count = 4});
  ImportNotes notes, unsaid;
  const MotionPlan own = PlanAgain(walker, RowsOfWalk(walker), notes);
  EXPECT_NEAR(own.goal.x_m, walker.plan.whole_body.q.back()[0], 1e-9);
  const auto says_goal = [](const ImportNotes& of) {
    return std::any_of(of.derived.begin(), of.derived.end(),
                       [](const DerivedPart& part) { return part.what == "goal"; });
  };
  EXPECT_TRUE(says_goal(notes));
  const MotionPlan meant = PlanAgain(walker, RowsOfWalk(walker), unsaid, PlanarPose{1.0, -0.5, 0.25});
  EXPECT_NEAR(meant.goal.x_m, walker.plan.whole_body.q.front()[0] + 1.0, 1e-9);
  EXPECT_NEAR(meant.goal.y_m, walker.plan.whole_body.q.front()[1] - 0.5, 1e-9);
  EXPECT_NEAR(meant.goal.yaw_rad, 0.25, 1e-12);
  EXPECT_FALSE(says_goal(unsaid));
}

TEST(ImportedPlan, FeetOffTheGroundAreWarnedOfOrRefusedWithTheLiftThatMendsIt) {
  const synthetic::Played walker = synthetic::Walked(2, {.count = 2});
  ImportNotes notes;
  PlanAgain(walker, Raised(RowsOfWalk(walker), 0.004), notes);
  const bool warned = std::any_of(notes.warnings.begin(), notes.warnings.end(), [](const std::string& warning) {
    return synthetic::Says(warning, "lift_m=-0.0040");
  });
  EXPECT_TRUE(warned);
  EXPECT_TRUE(synthetic::Says(RefusalOfRows(walker, Raised(RowsOfWalk(walker), 0.2)), "lift_m=-0.2000"));
  EXPECT_TRUE(synthetic::Says(RefusalOfRows(walker, Raised(RowsOfWalk(walker), -0.2)), "lift_m=0.2000"));
}

TEST(ImportedPlan, AMotionThatBeginsAtSpeedIsWarnedOf) {
  const synthetic::Played walker = synthetic::Walked(2, {.count = 2});
  EvenMotion motion = RowsOfWalk(walker);
  motion.v.front()[0] = 0.5;
  ImportNotes notes;
  PlanAgain(walker, std::move(motion), notes);
  const bool warned = std::any_of(notes.warnings.begin(), notes.warnings.end(),
                                  [](const std::string& warning) { return synthetic::Says(warning, "0.500 m/s"); });
  EXPECT_TRUE(warned);
}

TEST(ImportedPlan, AnAccelerationThatNoMotionHasIsRefusedWithItsTime) {
  const synthetic::Played walker = synthetic::Walked(2, {.count = 2});
  EvenMotion motion = RowsOfWalk(walker);
  motion.a[40][8] = 1e10;
  const std::string refusal = RefusalOfRows(walker, std::move(motion));
  EXPECT_TRUE(synthetic::Says(refusal, "an acceleration")) << refusal;
  EXPECT_TRUE(synthetic::Says(refusal, "0.2 s")) << refusal;
}

}  // namespace
}  // namespace gaitwright
