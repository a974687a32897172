// SPDX-License-Identifier: BSD-3-Clause
#include "planning/tasks/posture_motion.h"

#include <gtest/gtest.h>

#include "kinematics/base/result.h"
#include "kinematics/model/load_robot.h"

namespace gaitwright {
namespace {

const RobotModel& Nao() {
  static const RobotModel nao = LoadNamedRobot("nao").value();
  return nao;
}

PostureKey KeyAt(double after_s, const Vector3& shift, double turn, double joint) {
  PostureKey key;
  key.after_s = after_s;
  key.shift = shift;
  key.turn_rad.y() = turn;
  key.joints = VectorX::Constant(Nao().num_dofs(), joint);
  return key;
}

PostureMotion TwoMoves() {
  return {"test",
          {KeyAt(0.0, {0, 0, 0}, 0.0, 0.1), KeyAt(0.8, {0.01, 0.02, -0.05}, 0.3, 0.4),
           KeyAt(0.5, {0.0, 0.0, -0.01}, 0.1, 0.2)}};
}

TEST(PostureMotion, IsAtItsKeysAtRest) {
  const PostureMotion motion = TwoMoves();
  PostureSample sample;
  for (std::size_t k = 0; k < motion.keys.size(); ++k) {
    SampleAt(motion, motion.TimeOf(k), sample);
    EXPECT_NEAR(sample.shift[2].value, motion.keys[k].shift.z(), 1e-12);
    EXPECT_NEAR(sample.turn[1].value, motion.keys[k].turn_rad.y(), 1e-12);
    EXPECT_NEAR(sample.q[0], motion.keys[k].joints[0], 1e-12);
    EXPECT_NEAR(sample.shift[2].rate, 0.0, 1e-9);
    EXPECT_NEAR(sample.v.norm(), 0.0, 1e-9);
  }
  SampleAt(motion, 99.0, sample);
  EXPECT_NEAR(sample.q[0], 0.2, 1e-12);
}

TEST(PostureMotion, RatesAreDerivatives) {
  constexpr double kStep = 1e-5;
  PostureMotion motion = TwoMoves();
  motion.keys[1].cruise = 0.4;
  PostureSample before, here, after;
  double largest = 0.0;
  for (double t = 0.05; t < motion.duration_s() - 0.05; t += 0.037) {
    SampleAt(motion, t - kStep, before);
    SampleAt(motion, t, here);
    SampleAt(motion, t + kStep, after);
    EXPECT_NEAR((after.shift[2].value - before.shift[2].value) / (2 * kStep), here.shift[2].rate, 1e-6);
    EXPECT_NEAR((after.shift[2].rate - before.shift[2].rate) / (2 * kStep), here.shift[2].acceleration, 1e-4);
    EXPECT_NEAR((after.turn[1].value - before.turn[1].value) / (2 * kStep), here.turn[1].rate, 1e-6);
    EXPECT_NEAR((after.q[3] - before.q[3]) / (2 * kStep), here.v[3], 1e-6);
    EXPECT_NEAR((after.v[3] - before.v[3]) / (2 * kStep), here.a[3], 1e-4);
    largest = std::max(largest, std::abs(here.v[3]));
  }
  EXPECT_GT(largest, 0.1);
}

TEST(PostureMotion, StretchedMovesAreOnTheGrid) {
  const PostureMotion slow = Stretched(TwoMoves(), 1.4, 0.005);
  EXPECT_NEAR(slow.keys[1].after_s, 1.12, 1e-12);
  EXPECT_NEAR(slow.keys[2].after_s, 0.7, 1e-12);
  EXPECT_NEAR(Stretched(TwoMoves(), 1.0, 0.3).keys[1].after_s, 0.9, 1e-12);
}

TEST(PostureMotion, AChainIsAllOfThem) {
  PostureMotion lifted = TwoMoves();
  lifted.name = "lifted";
  lifted.lifts = {{1, 0, 1, 0.05}};
  const PostureMotion chain = Chained({TwoMoves(), lifted, lifted});
  EXPECT_EQ(chain.keys.size(), 7U);
  EXPECT_NEAR(chain.duration_s(), 3 * 1.3, 1e-12);
  ASSERT_EQ(chain.lifts.size(), 2U);
  EXPECT_EQ(chain.lifts[1].from_key, 4U);
  ASSERT_EQ(chain.sections.size(), 3U);
  EXPECT_EQ(chain.sections[1].name, "lifted");
  EXPECT_EQ(chain.sections[2].last_key, 6U);
  EXPECT_THROW(Chained({}), InvalidArgument);
}

TEST(PostureMotion, NoneIsRefused) {
  const auto refuses = [](auto change, const std::string& word) {
    PostureMotion motion = TwoMoves();
    change(motion);
    try {
      CheckPostureMotion(Nao(), motion);
      ADD_FAILURE() << word;
    } catch (const InvalidArgument& error) {
      EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
    }
  };
  CheckPostureMotion(Nao(), TwoMoves());
  refuses([](PostureMotion& m) { m.keys.resize(1); }, "1 keys");
  refuses([](PostureMotion& m) { m.keys[1].joints.resize(3); }, "3 joints");
  refuses([](PostureMotion& m) { m.keys[1].after_s = -1.0; }, "time below 0");
  refuses([](PostureMotion& m) { m.keys[2].shift.x() = std::nan(""); }, "not finite");
  refuses([](PostureMotion& m) { m.lifts = {{2, 0, 1, 0.1}}; }, "lifts a foot");
  refuses([](PostureMotion& m) { m.lifts = {{0, 1, 1, 0.1}}; }, "lifts a foot");
  refuses([](PostureMotion& m) { m.rests = {{0, 0, 1}}; }, "unknown support link");
}

}  // namespace
}  // namespace gaitwright
