// SPDX-License-Identifier: BSD-3-Clause
// The feet, contacts, footholds and swings of a walk whose plan is known.
#include "workflows/exchange/foot_track.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "kinematics/base/result.h"
#include "kinematics/spatial/rotation.h"
#include "tests/playback/played.h"

namespace gaitwright {
namespace {

EvenMotion EvenRowsOf(const synthetic::Played& walker, bool contacts) {
  EvenMotion motion;
  const WholeBodyTrajectory& body = walker.plan.whole_body;
  motion.step_s = body.step_s;
  motion.q = body.q;
  motion.v = body.v;
  motion.a = body.a;
  if (!contacts) return motion;
  for (const LogSample& sample : walker.log.samples) motion.contact.push_back(sample.contact);
  return motion;
}

void ExpectSameSchedule(const ContactSchedule& found, const ContactSchedule& expected, double within_s) {
  ASSERT_EQ(found.phases.size(), expected.phases.size());
  for (std::size_t i = 0; i < found.phases.size(); ++i) {
    EXPECT_EQ(found.phases[i].stance, expected.phases[i].stance) << i;
    EXPECT_NEAR(found.phases[i].start_s, expected.phases[i].start_s, within_s) << i;
    EXPECT_NEAR(found.phases[i].end_s, expected.phases[i].end_s, within_s) << i;
  }
}

TEST(FootTrack, FeetAreOnTheGroundAndAtRestInStanceAndLiftedByTheSwing) {
  const synthetic::Played walker = synthetic::Walked(2, {.count = 2, .lift_m = 0.04});
  const EvenMotion motion = EvenRowsOf(walker, true);
  const std::vector<FootTrack> feet = FeetOf(walker.model, walker.plan.terrain, motion);
  ASSERT_EQ(feet.size(), 2U);
  for (std::size_t f = 0; f < feet.size(); ++f) {
    ASSERT_EQ(static_cast<int>(feet[f].X_WF.size()), motion.size());
    for (std::size_t k = 0; k < motion.q.size(); ++k) {
      if (!Contains(motion.contact[k], static_cast<int>(f))) continue;
      EXPECT_NEAR(feet[f].height_m[k], 0.0, 1e-9);
      EXPECT_TRUE(feet[f].rolled_W[k].isZero(1e-12)) << "it does not turn";
    }
    EXPECT_NEAR(*std::max_element(feet[f].height_m.begin(), feet[f].height_m.end()), 0.04, 1e-4);
    EXPECT_NEAR(feet[f].speed_m_s.front(), 0.0, 1e-9);
  }
}

TEST(FootTrack, ASphereThatTurnsForwardHasRolledByRadiusTimesAngle) {
  const synthetic::Played walker = synthetic::Stood();
  RobotModel model = synthetic::Robot(2, FootType::kSphere);
  EvenMotion motion;
  motion.step_s = 0.01;
  VectorX q = VectorX::Zero(model.nq());
  q[2] = 0.5;
  q.tail(6) = model.standing_joints;
  for (int k = 0; k <= 10; ++k) {
    q.segment<4>(3) = Quaternion(RotationExp(Vector3(0.0, 0.05 * k, 0.0))).coeffs();  // about y, rolls towards +x
    motion.q.push_back(q);
    motion.v.emplace_back(VectorX::Zero(model.nv()));
  }
  const std::vector<FootTrack> feet = FeetOf(model, walker.plan.terrain, motion);
  for (const FootTrack& foot : feet) EXPECT_LT((foot.rolled_W.back() - Vector3(0.02 * 0.5, 0.0, 0.0)).norm(), 1e-9);
}

TEST(FootTrack, WithoutGroundFeetAreInfinitelyHigh) {
  const synthetic::Played walker = synthetic::Stood();
  const std::vector<FootTrack> feet = FeetOf(walker.model, Terrain{}, EvenRowsOf(walker, true));
  EXPECT_TRUE(std::isinf(feet[0].height_m.front()) && feet[0].height_m.front() > 0.0);
}

TEST(FootTrack, TheScheduleIsThatOfTheContactColumn) {
  const synthetic::Played walker = synthetic::Walked(4);
  const EvenMotion motion = EvenRowsOf(walker, true);
  std::vector<DerivedPart> derived;
  const ContactSchedule schedule =
      ScheduleOf(walker.model, motion, FeetOf(walker.model, walker.plan.terrain, motion), {}, derived);
  ExpectSameSchedule(schedule, walker.plan.schedule, 1e-9);
  EXPECT_TRUE(derived.empty());
}

TEST(FootTrack, WithoutContactsTheScheduleIsThatOfLowAndSlowFeet) {
  for (const int legs : {2, 4}) {
    const synthetic::Played walker = synthetic::Walked(legs);
    const EvenMotion motion = EvenRowsOf(walker, false);
    std::vector<DerivedPart> derived;
    const ContactSchedule schedule =
        ScheduleOf(walker.model, motion, FeetOf(walker.model, walker.plan.terrain, motion), {}, derived);
    ExpectSameSchedule(schedule, walker.plan.schedule, 0.05);
    ASSERT_EQ(derived.size(), 1U);
    EXPECT_EQ(derived[0].what, "contacts");
  }
}

TEST(FootTrack, AContactThatFlickersIsOne) {
  const synthetic::Played walker = synthetic::Stood();
  const EvenMotion motion = EvenRowsOf(walker, false);
  std::vector<FootTrack> feet = FeetOf(walker.model, walker.plan.terrain, motion);
  for (const std::size_t k : {50U, 51U, 90U}) feet[0].height_m[k] = 0.1;  // shorter than contact_least_s
  std::vector<DerivedPart> derived;
  EXPECT_EQ(ScheduleOf(walker.model, motion, feet, {}, derived).phases.size(), 1U);
  for (std::size_t k = 50; k < 70; ++k) feet[0].height_m[k] = 0.1;  // longer
  EXPECT_EQ(ScheduleOf(walker.model, motion, feet, {}, derived).phases.size(), 3U);
}

TEST(FootTrack, AFootThatIsNeverDownIsRefusedByName) {
  const synthetic::Played walker = synthetic::Stood();
  const EvenMotion motion = EvenRowsOf(walker, false);
  std::vector<FootTrack> feet = FeetOf(walker.model, walker.plan.terrain, motion);
  for (double& height : feet[1].height_m) height = 0.25;
  std::vector<DerivedPart> derived;
  try {
    ScheduleOf(walker.model, motion, feet, {}, derived);
    FAIL() << "nothing was refused";
  } catch (const InvalidArgument& error) {
    EXPECT_TRUE(synthetic::Says(error.what(), "'right'")) << error.what();
    EXPECT_TRUE(synthetic::Says(error.what(), "0.2500 m")) << error.what();
  }
}

TEST(FootTrack, FootholdsAreThoseOfThePlan) {
  const synthetic::Played walker = synthetic::Walked(4);
  const EvenMotion motion = EvenRowsOf(walker, true);
  const std::vector<FootTrack> feet = FeetOf(walker.model, walker.plan.terrain, motion);
  const FootstepPlan found = FootholdsOf(walker.model, walker.plan.terrain, walker.plan.schedule, motion, feet);
  ASSERT_EQ(found.footholds.size(), walker.plan.footsteps.footholds.size());
  for (std::size_t i = 0; i < found.footholds.size(); ++i) {
    const Foothold &a = found.footholds[i], &b = walker.plan.footsteps.footholds[i];
    EXPECT_EQ(a.foot, b.foot);
    EXPECT_LT((a.X_WF.translation() - b.X_WF.translation()).norm(), 1e-6) << i;
    EXPECT_NEAR(a.touchdown_s, b.touchdown_s, 1e-9);
    EXPECT_NEAR(a.liftoff_s, b.liftoff_s, 1e-9);
  }
  EXPECT_THROW(FootholdsOf(walker.model, Terrain{}, walker.plan.schedule, motion, feet), InvalidArgument);
}

TEST(FootTrack, ASwingFollowsThePathOfItsFoot) {
  const synthetic::Played walker = synthetic::Walked(2, {.count = 3, .length_m = 0.2, .lift_m = 0.05});
  const EvenMotion motion = EvenRowsOf(walker, true);
  const std::vector<FootTrack> feet = FeetOf(walker.model, walker.plan.terrain, motion);
  std::vector<Foothold> of_left;
  for (const Foothold& foothold : walker.plan.footsteps.footholds) {
    if (foothold.foot == 0) of_left.push_back(foothold);
  }
  ASSERT_GE(of_left.size(), 2U);
  double farthest_m = -1.0;
  const SwingTrajectory swing = SwingOf(of_left[0], of_left[1], motion, feet[0], farthest_m);
  EXPECT_EQ(swing.foot, 0);
  EXPECT_EQ(swing.start_s, of_left[0].liftoff_s);
  EXPECT_EQ(swing.end_s, of_left[1].touchdown_s);
  EXPECT_GE(farthest_m, 0.0);
  EXPECT_LT(farthest_m, 1e-3);
  EXPECT_NEAR(swing.lift_m, 0.05, 1e-3);
  EXPECT_GT(swing.clearance_m, 0.5 * 0.05);
  EXPECT_LE(swing.clearance_m, 0.05);
}

}  // namespace
}  // namespace gaitwright
