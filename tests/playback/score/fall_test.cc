// SPDX-License-Identifier: BSD-3-Clause
#include "playback/score/fall.h"

#include <gtest/gtest.h>

#include <numbers>

#include "tests/playback/played.h"

namespace gaitwright {
namespace {

struct FallCase : synthetic::Played {
  FallCase() : Played(synthetic::Stood()) {}

  Fall Find() const { return FindFall(plan, log, MakeMotionSeries(model, plan, log, {}), {}); }
};

void Turn(VectorX& q, double angle, const Vector3& axis) {
  q.segment<4>(3) = Quaternion(Eigen::AngleAxisd(angle, axis)).coeffs();
}

TEST(Fall, StandingIsNone) {
  const Fall fall = FallCase{}.Find();
  EXPECT_FALSE(fall.fell);
  EXPECT_NEAR(fall.time_s, 1.0, 1e-12) << "the end of the log";
}

TEST(Fall, TiltCountsAgainstThePlansOwnInEveryDirection) {
  for (const double direction : {0.0, 1.0, 2.5, 4.0}) {
    const Vector3 axis(std::cos(direction), std::sin(direction), 0.0);
    FallCase upright;
    Turn(upright.log.samples[50].q, 0.59, axis);
    EXPECT_FALSE(upright.Find().fell);
    Turn(upright.log.samples[50].q, 0.61, axis);
    EXPECT_TRUE(upright.Find().fell);
    FallCase leaning;  // a plan that leans by 0.7 rad is no fall, and neither is following it with another yaw
    for (VectorX& q : leaning.plan.whole_body.q) Turn(q, 0.7, axis);
    for (LogSample& sample : leaning.log.samples) {
      const Quaternion lean(Eigen::AngleAxisd(0.7, axis)), yaw(Eigen::AngleAxisd(2.0, Vector3::UnitZ()));
      sample.q.segment<4>(3) = (yaw * lean).coeffs();
    }
    EXPECT_FALSE(leaning.Find().fell);
    Turn(leaning.log.samples[70].q, -0.7, axis);
    EXPECT_TRUE(leaning.Find().fell) << "the same tilt to the other side is 1.4 rad off";
  }
}

TEST(Fall, TheFirstOfSeveralIsReported) {
  FallCase c;
  synthetic::Sink(c.log, 120, 0.2);
  c.log.body_contacts = {{0.7, "trunk"}, {0.5, "right_z"}};
  const Fall fall = c.Find();
  EXPECT_NEAR(fall.time_s, 0.5, 1e-12);
  EXPECT_EQ(fall.what, "'right_z', which is not a foot, touched the ground");
}

TEST(Fall, HeightIsOverTheFeetWhereTheyStand) {
  FallCase downhill;
  for (LogSample& sample : downhill.log.samples) sample.q[2] -= 0.4;  // the ground descends, and the robot stands on it
  EXPECT_FALSE(downhill.Find().fell);
  FallCase thrown;
  for (int i : {9, 12}) thrown.log.samples[20].q[i] -= 0.3;
  EXPECT_TRUE(thrown.Find().fell) << "0.8 m over its feet where the plan has 0.5";
}

TEST(Fall, InFlightAtAnEdgeTheGroundIsThatOfThePlan) {
  FallCase c;
  c.plan.schedule.phases = {{0.0, 0.4, 3}, {0.4, 0.6, 0}, {0.6, 1.0, 3}};
  const VectorX& standing = c.plan.whole_body.q.front();
  TerrainPatch block;
  block.name = "block";
  block.X_WT.translation() = Vector3(1.0 + standing[0] + 0.01, 0.0, 0.8 * standing[2]);
  block.outline_T = {{-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}};
  c.plan.terrain.patches.push_back(block);
  for (LogSample& sample : c.log.samples) sample.q[0] += 0.02;
  EXPECT_EQ(GroundAt(c.plan.terrain, Vector2(standing[0] + 0.02, 0.0)).height_m, block.X_WT.translation().z());
  const Fall fall = c.Find();
  EXPECT_TRUE(!fall.fell || fall.time_s < 0.4 || fall.time_s > 0.6) << fall.what;
}

TEST(Fall, InFlightTheGroundIsAsFarFromThatOfThePlanAsWhereItStoodLast) {
  FallCase c;
  c.plan.schedule.phases = {{0.0, 0.4, 3}, {0.4, 0.6, 0}, {0.6, 1.0, 3}};
  const double height = c.plan.whole_body.q.front()[2];
  for (LogSample& sample : c.log.samples) sample.q[2] -= 0.8 * height;  // on unplanned ground
  EXPECT_FALSE(c.Find().fell) << c.Find().what;
  for (LogSample& sample : c.log.samples)
    sample.q[2] -= sample.time_s > 0.45 && sample.time_s < 0.55 ? 0.8 * height : 0.0;
  EXPECT_TRUE(c.Find().fell) << "far below where it took off";
}

TEST(Fall, BoundsAreOptions) {
  FallCase c;
  Turn(c.log.samples[50].q, 0.5, Vector3::UnitX());
  ScoreOptions strict;
  strict.fall_tilt_rad = 0.4;
  EXPECT_FALSE(c.Find().fell);
  EXPECT_TRUE(FindFall(c.plan, c.log, MakeMotionSeries(c.model, c.plan, c.log, strict), strict).fell);
}

TEST(Fall, IsLookedForWithTheLogsOwnOptions) {
  FallCase c;
  Turn(c.log.samples[50].q, 0.5, Vector3::UnitX());
  EXPECT_EQ(Score(c.model, c.plan, c.log).At("fell").value, 0.0);
  c.log.options = {{"play.step_s", "0.001"}, {"score.fall_tilt_rad", "0.4"}, {"score.of_another_version", "1"}};
  EXPECT_EQ(Score(c.model, c.plan, c.log).At("fell").value, 1.0);
  c.log.options = {{"score.fall_tilt_rad", "40"}};
  EXPECT_THROW(Score(c.model, c.plan, c.log), InvalidArgument);
}

}  // namespace
}  // namespace gaitwright
