// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/walk/idle_options.h"

#include <gtest/gtest.h>

namespace gaitwright {
namespace {

std::string IdleIn(const PlayRequest& request, const std::vector<std::string>& keys,
                   const std::vector<std::string>& open = {}) {
  const std::optional<IdleOption> idle = FirstIdle(request, keys, open);
  return idle ? idle->key + " " + idle->why : "";
}

TEST(IdleOptions, SensorsAndOdometryActOnTheirStates) {
  PlayRequest request;
  EXPECT_EQ(IdleIn(request, {"play.friction", "sensors.imu_rate_hz"}),
            "sensors.imu_rate_hz because the controller uses the true state and no sensors");
  EXPECT_EQ(IdleIn(request, {"odometry.trust_s"}), "odometry.trust_s with the state 'true'");
  EXPECT_EQ(IdleIn(request, {"sensors.imu_rate_hz", "odometry.trust_s"}, {"state"}), "") << "it is varied";
  request.sensing.state = "measured";
  EXPECT_EQ(IdleIn(request, {"sensors.encoder_rate_hz", "stabilised.sensed_damping"}), "");
  EXPECT_EQ(IdleIn(request, {"sensors.imu_rate_hz"}), "sensors.imu_rate_hz with the state 'measured'");
  EXPECT_EQ(IdleIn(request, {"odometry.trust_s"}), "odometry.trust_s with the state 'measured'");
  request.sensing.state = "estimated";
  EXPECT_EQ(IdleIn(request, {"sensors.imu_rate_hz", "odometry.trust_s"}), "");
}

TEST(IdleOptions, GroundsPushesAndGainsActWhereTheyAre) {
  PlayRequest request;
  const std::vector<std::string> slope = {"play.ground_slope_direction_deg"}, push = {"play.push_for_s"},
                                 gain = {"stabilised.dcm_gain"}, wave = {"play.bump_wavelength_m"};
  EXPECT_EQ(IdleIn(request, slope), slope[0] + " without 'ground_slope_deg'");
  EXPECT_EQ(IdleIn(request, slope, {"play.ground_slope_deg"}), "");
  EXPECT_EQ(IdleIn(request, wave), wave[0] + " without 'ground_bumps_m'");
  EXPECT_EQ(IdleIn(request, push), push[0] + " without a push");
  EXPECT_EQ(IdleIn(request, push, {"play.push_force_y_n"}), "");
  EXPECT_EQ(IdleIn(request, gain), "");
  EXPECT_EQ(IdleIn(request, {"stabilised.sensed_damping"}), "stabilised.sensed_damping with the true state");
  request.controller = "joint-pd";
  EXPECT_EQ(IdleIn(request, gain), gain[0] + " on the controller 'joint-pd'");
  request.play.world.ground_slope_deg = -1.0;
  request.play.world.ground_bumps_m = 0.01;
  request.play.push_force_W.y() = 5.0;
  EXPECT_EQ(IdleIn(request, slope), "");
  EXPECT_EQ(IdleIn(request, wave), "");
  EXPECT_EQ(IdleIn(request, push), "");
}

}  // namespace
}  // namespace gaitwright
