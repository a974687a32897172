// SPDX-License-Identifier: BSD-3-Clause
#include "playback/play/whole_steps.h"

#include <gtest/gtest.h>

#include "kinematics/base/result.h"
#include "tests/playback/played.h"

namespace gaitwright {
namespace {

TEST(WholeSteps, ARateThatDividesTheSteps) {
  EXPECT_EQ(WholeSteps("r", 1000.0, 0.001), 1);
  EXPECT_EQ(WholeSteps("r", 200.0, 0.001), 5);
  EXPECT_EQ(WholeSteps("r", 333.333, 0.001), 3) << "six digits of a third";
  EXPECT_EQ(WholeSteps("r", 0.5, 0.002), 1000);
}

TEST(WholeSteps, ARateThatDoesNotIsRefusedWithTheNearest) {
  const auto why = [](double rate_hz) -> std::string {
    try {
      WholeSteps("sensors.imu_rate_hz", rate_hz, 0.001);
    } catch (const InvalidArgument& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_TRUE(synthetic::Says(why(400.0), "'sensors.imu_rate_hz' is 400 Hz"));
  EXPECT_TRUE(synthetic::Says(why(400.0), "1000 steps per second; the nearest accepted value is 333.333"));
  EXPECT_TRUE(synthetic::Says(why(2000.0), "the nearest accepted value is 1000"));
}

}  // namespace
}  // namespace gaitwright
