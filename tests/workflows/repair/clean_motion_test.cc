// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "kinematics/base/result.h"
#include "planning/terrain/load_terrain.h"
#include "tests/workflows/repair/standing_motion.h"
#include "workflows/repair/clean_motion_internal.h"

namespace gaitwright {
namespace {

constexpr int kCleanedRows = 200;

CleanMotion Cleaned(const RobotModel& model, const EvenMotion& motion) {
  const Terrain flat = LoadTerrain("flat", ScaleOf(model)).value();
  const FoundContacts found = FindContacts(model, motion, FeetOf(model, flat, motion), {});
  return CleanContacts(model, flat, motion, found.stance, {});
}

TEST(CleanMotion, PinsTheFeetOfARobotThatFloatsAndDrifts) {
  for (const char* name : {"a1", "h1"}) {
    const RobotModel& model = NamedRobot(name);
    EvenMotion motion = synthetic::Standing(model, kCleanedRows);
    for (int k = 0; k < kCleanedRows; ++k)
      motion.q[static_cast<std::size_t>(k)].head<3>() += Vector3(0.0, 2e-4 * k, 0.02);
    const CleanMotion clean = Cleaned(model, motion);
    EXPECT_NEAR(clean.lift_m, -0.02, 1e-3) << name;
    ASSERT_EQ(clean.stances.size(), model.legs.size());
    EXPECT_NEAR(clean.stances[0].slid_m, 0.02, 1e-3) << "to the middle of the drift";
    EvenMotion cleaned = clean.motion;
    cleaned.v = motion.v;
    const std::vector<FootTrack> feet = FeetOf(model, LoadTerrain("flat", ScaleOf(model)).value(), cleaned);
    for (const FootTrack& foot : feet) {
      EXPECT_LT((foot.X_WF.back().translation() - foot.X_WF.front().translation()).norm(), 1e-5) << name;
      EXPECT_NEAR(foot.height_m[kCleanedRows / 2], 0.0, 1e-5) << name;
    }
    for (const VectorX& q : clean.motion.q)
      EXPECT_LT((q - motion.q.front()).tail(model.num_dofs()).lpNorm<Eigen::Infinity>(), 0.03) << "the base drifts";
  }
}

TEST(CleanMotion, SwingsKeepClearOfTheGround) {
  const RobotModel& model = NamedRobot("a1");
  EvenMotion motion = synthetic::Standing(model, kCleanedRows);
  synthetic::BendKnee(model, 1, 80, 120, motion);
  const CleanMotion clean = Cleaned(model, motion);
  EvenMotion cleaned = clean.motion;
  cleaned.v = motion.v;
  const FootTrack foot = FeetOf(model, LoadTerrain("flat", ScaleOf(model)).value(), cleaned)[1];
  EXPECT_GT(foot.height_m[100], 0.015 * model.leg_length_m());
  EXPECT_NEAR(foot.height_m[40], 0.0, 1e-5);
  EXPECT_LT(clean.unreached_m, 1e-5);
}

/// Feet of a clip move already when their stance ends.
TEST(CleanMotion, SwingsBeginAndEndAtRest) {
  const RobotModel& model = NamedRobot("a1");
  EvenMotion motion = synthetic::Standing(model, kCleanedRows);
  const int knee = model.joints[static_cast<std::size_t>(model.legs[1].knee_joint)].dof;
  for (int k = 80; k <= 120; ++k)
    motion.q[static_cast<std::size_t>(k)][7 + knee] -= 0.5 * std::sin(M_PI * (k - 80) / 40.0);
  const CleanMotion clean = Cleaned(model, motion);
  EvenMotion cleaned = clean.motion;
  cleaned.v = motion.v;
  const FootTrack foot = FeetOf(model, LoadTerrain("flat", ScaleOf(model)).value(), cleaned)[1];
  const auto moved = [&](int k) {
    return (foot.X_WF[static_cast<std::size_t>(k)].translation() -
            foot.X_WF[static_cast<std::size_t>(k - 1)].translation())
        .norm();
  };
  int first = 1, last = kCleanedRows - 1;
  while (moved(first) < 1e-5) ++first;
  while (moved(last) < 1e-5) --last;
  ASSERT_GT(last - first, 20);
  EXPECT_LT(moved(first), 0.002) << "in the clip it moves by 8 mm in its first row";
  EXPECT_LT(moved(last), 0.002);
}

TEST(CleanMotion, RefusesAFootThatNeverStands) {
  const RobotModel& model = NamedRobot("a1");
  EvenMotion motion = synthetic::Standing(model, kCleanedRows);
  synthetic::BendKnee(model, 1, 0, kCleanedRows, motion);
  try {
    Cleaned(model, motion);
    FAIL() << "it was not refused";
  } catch (const InvalidArgument& error) {
    EXPECT_NE(std::string(error.what()).find(model.feet[1].name), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace gaitwright
