// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "tests/scratch_folder.h"
#include "tests/workflows/repair/standing_motion.h"
#include "workflows/repair/prepared_motion_internal.h"

namespace gaitwright {
namespace {

Result<PreparedMotion> Prepared(const RobotModel& model, const EvenMotion& motion) {
  std::ofstream(ScratchFile("prepared.csv")) << synthetic::FramesOf(model, motion);
  RepairRequest request;
  request.source.file = ScratchFile("prepared.csv");
  request.source.options.rate_hz = 100.0;
  return ReadAndFind(model, request);
}

/// The base goes up and down once in 2 s.
EvenMotion Squatting(const RobotModel& model) {
  EvenMotion motion = synthetic::Standing(model, 201);
  for (int k = 0; k < motion.size(); ++k)
    motion.q[static_cast<std::size_t>(k)][2] -= 0.03 * std::pow(std::sin(M_PI * k / 200.0), 2.0);
  return motion;
}

TEST(PreparedMotion, KeepsTheFilesPlanIfItIsSound) {
  const RobotModel& model = NamedRobot("a1");
  const auto sound = Prepared(model, synthetic::Standing(model, 101));
  ASSERT_TRUE(sound.ok()) << sound.failure().message;
  EXPECT_TRUE(sound->as_it_is);
  EXPECT_EQ(sound->findings.smoothing_hz, 0.0);
  EvenMotion floats = synthetic::Standing(model, 101);
  for (VectorX& q : floats.q) q[2] += 0.02;
  const auto broken = Prepared(model, floats);
  ASSERT_TRUE(broken.ok());
  EXPECT_FALSE(broken->as_it_is);
  ASSERT_TRUE(broken->findings.before);
  EXPECT_FALSE(broken->findings.broken.empty());
}

TEST(PreparedMotion, NoiseIsSmoothed) {
  const RobotModel& model = NamedRobot("a1");
  EvenMotion motion = Squatting(model);
  for (int k = 0; k < motion.size(); ++k) motion.q[static_cast<std::size_t>(k)][9] += 0.004 * std::sin(11.0 * k * k);
  const auto noisy = Prepared(model, motion);
  ASSERT_TRUE(noisy.ok()) << noisy.failure().message;
  EXPECT_EQ(noisy->findings.smoothing_hz, 8.0);
}

TEST(PreparedMotion, SlowPartsAreArranged) {
  const RobotModel& model = NamedRobot("a1");
  auto prepared = Prepared(model, Squatting(model));
  ASSERT_TRUE(prepared.ok()) << prepared.failure().message;
  Arrange(model, {}, *prepared);
  const int rows = prepared->original->size();
  EXPECT_EQ(prepared->findings.clean.motion.size(), rows);
  prepared->findings.slowed = {{0.8, 1.2, 1.5, ""}};
  Arrange(model, {}, *prepared);
  // 0.4 s take 0.2 s longer, and so does the change of pace on both sides together.
  EXPECT_NEAR(prepared->original->size() - rows, 40, 3);
  const auto middle = static_cast<std::size_t>(prepared->original->size() / 2);
  EXPECT_NEAR(prepared->findings.rested.file_s[middle], 1.0, 0.02);
  EXPECT_NEAR(prepared->original->q[middle][2], model.standing_base_height_m - 0.03, 1e-3);
}

TEST(PreparedMotion, SmoothCurvesPassThroughTheirRows) {
  const RobotModel& model = NamedRobot("a1");
  const EvenMotion motion = Squatting(model), smooth = SmoothRows(model, motion, 0.0);
  ASSERT_EQ(smooth.size(), motion.size());
  EXPECT_LT((smooth.q[77] - motion.q[77]).norm(), 1e-9);
  const double rate = M_PI / 2.0;  // [1/s]
  EXPECT_NEAR(smooth.v[50][2], -0.03 * rate * std::sin(2.0 * rate * 0.5), 1e-4);
}

}  // namespace
}  // namespace gaitwright
