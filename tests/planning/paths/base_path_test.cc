// SPDX-License-Identifier: BSD-3-Clause
#include "planning/paths/base_path.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace gaitwright {
namespace {

void ExpectSamePose(const PlanarPose& a, const PlanarPose& b, double tolerance = 1e-9) {
  EXPECT_NEAR(a.x_m, b.x_m, tolerance);
  EXPECT_NEAR(a.y_m, b.y_m, tolerance);
  EXPECT_NEAR(a.yaw_rad, b.yaw_rad, tolerance);
}

TEST(PoseAlong, AForwardTwistWithATurnIsAnArcOfACircle) {
  const double radius_m = 2.0, yaw = 0.5 * std::numbers::pi;
  ExpectSamePose(PoseAlong({radius_m * yaw, 0.0, yaw}, 1.0), {radius_m, radius_m, yaw});
  ExpectSamePose(PoseAlong({radius_m * yaw, 0.0, yaw}, 2.0), {0.0, 2.0 * radius_m, 2.0 * yaw});
  ExpectSamePose(PoseAlong({1.5, -0.5, 0.0}, 0.5), {0.75, -0.25, 0.0});
}

TEST(PoseAlong, GoingOnIsGoingFromWhereItIs) {
  const PlanarTwist twist{0.7, -0.3, 0.9};
  for (const double share : {0.1, 0.5, 0.8})
    ExpectSamePose(Carried(PoseAlong(twist, share), PoseAlong(twist, 1.0 - share)), PoseAlong(twist, 1.0));
  ExpectSamePose(Carried(PoseAlong(twist, 1.0), PoseAlong(twist, -1.0)), {});
}

TEST(PoseAlong, HardlyTurningIsNearlyStraight) {
  ExpectSamePose(PoseAlong({1.0, 0.2, 1e-7}, 1.0), PoseAlong({1.0, 0.2, 2e-6}, 1.0), 3e-6);
  ExpectSamePose(PoseAlong({1.0, 0.0, 1e-8}, 1.0), {1.0, 0.5e-8, 1e-8}, 1e-14);
}

TEST(ProgressOfPath, HasTheRateOfItsLengthLessHalfItsRamps) {
  constexpr double kStep = 1e-4;
  for (const auto& [start, stop] : {std::pair(1.0, 0.5), std::pair(0.0, 1.0), std::pair(0.0, 0.0)}) {
    const double rate =
        (ProgressAt(2.0 + kStep, 4.0, start, stop) - ProgressAt(2.0 - kStep, 4.0, start, stop)) / (2.0 * kStep);
    EXPECT_NEAR(rate, 1.0 / (4.0 - 0.5 * (start + stop)), 1e-9);
    EXPECT_EQ(ProgressAt(0.0, 4.0, start, stop), 0.0);
    EXPECT_NEAR(ProgressAt(4.0, 4.0, start, stop), 1.0, 1e-12);
  }
}

TEST(ProgressOfPath, ItsRampsAreMirrorImagesAndShrinkTogether) {
  for (double t = 0.0; t <= 3.0; t += 0.1)
    EXPECT_NEAR(ProgressAt(t, 3.0, 1.2, 0.4), 1.0 - ProgressAt(3.0 - t, 3.0, 0.4, 1.2), 1e-12) << t;
  for (double t = 0.0; t <= 2.0; t += 0.1)
    EXPECT_NEAR(ProgressAt(t, 2.0, 3.0, 1.0), ProgressAt(t, 2.0, 1.5, 0.5), 1e-12) << "to 2 s of 4";
}

TEST(MadeBasePath, IsSampledEvenlyToItsEndAndStandsBeforeAndAfter) {
  const BasePath path = MakeBasePath({1.0, 0.0, 0.0}, 0.5, 2.0, 0.5, 3.217);
  EXPECT_EQ(path.time_s.front(), 0.0);
  EXPECT_DOUBLE_EQ(path.time_s.back(), 3.217);
  for (std::size_t k = 1; k < path.time_s.size(); ++k) EXPECT_LE(path.time_s[k] - path.time_s[k - 1], 0.01 + 1e-9);
  ExpectSamePose(PoseAt(path, 0.5), {});
  ExpectSamePose(PoseAt(path, 2.5), {1.0, 0.0, 0.0});
  ExpectSamePose(PoseAt(path, 1.5), {0.5, 0.0, 0.0}, 1e-4);
  ExpectSamePose(PoseAt(path, -1.0), {});
  ExpectSamePose(PoseAt(path, 99.0), {1.0, 0.0, 0.0});
}

TEST(MadeBasePath, PiecesFollowEachOtherFromWhereTheLastOneLeads) {
  const PlanarTwist quarter{1.0, 0.0, 0.5 * std::numbers::pi};
  const BasePath path = MakeBasePath({{quarter, 0.0, 2.0, 0.5, 0.5}, {quarter, 2.5, 2.0, 0.5, 0.5}}, 5.0);
  ExpectSamePose(PoseAt(path, 2.2), PoseAlong(quarter, 1.0));
  ExpectSamePose(path.pose.back(), Carried(PoseAlong(quarter, 1.0), PoseAlong(quarter, 1.0)));
}

TEST(MadeBasePath, OfEqualSpeedsWhoseRampsCoincideKeepsItsSpeed) {
  // Both have a full speed of 0.5 m/s; the second accelerates while the first decelerates.
  const PathPiece first{{0.75, 0.0, 0.0}, 0.0, 2.0, 0.5, 0.5}, second{{0.75, 0.0, 0.0}, 1.5, 2.0, 0.5, 0.5};
  const BasePath path = MakeBasePath({first, second}, 3.5);
  for (double t = 0.6; t < 2.9; t += 0.1)
    EXPECT_NEAR((PoseAt(path, t + 0.05).x_m - PoseAt(path, t).x_m) / 0.05, 0.5, 1e-6) << t;
}

}  // namespace
}  // namespace gaitwright
