// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "playback/trials/orbit_stability_internal.h"

namespace gaitwright {
namespace {

OrbitStability OrbitOf(double largest) {
  OrbitStability orbit;
  orbit.cycle_s = 0.8;
  orbit.cycles = 7;
  orbit.multipliers.values = {{0.0, largest}, {0.0, -largest}, {0.1, 0.0}};
  return orbit;
}

TEST(OrbitStability, TheLargestMagnitudeDecides) {
  EXPECT_EQ(OrbitOf(0.94).verdict(), OrbitVerdict::kStable);
  EXPECT_EQ(OrbitOf(0.96).verdict(), OrbitVerdict::kNeutral);
  EXPECT_EQ(OrbitOf(1.04).verdict(), OrbitVerdict::kNeutral);
  EXPECT_EQ(OrbitOf(1.06).verdict(), OrbitVerdict::kUnstable);
  OrbitStability unknown;
  unknown.missing = "too short";
  EXPECT_EQ(unknown.verdict(), OrbitVerdict::kUnknown);
}

TEST(OrbitStability, TheTextSaysHowFastDeviationsChange) {
  EXPECT_NE(OrbitText(OrbitOf(2.0)).find("unstable; largest Floquet multiplier 2.00 over 7 cycles of 0.800 s"),
            std::string::npos);
  EXPECT_NE(OrbitText(OrbitOf(2.0)).find("doubles in 1.0 cycles"), std::string::npos);
  EXPECT_NE(OrbitText(OrbitOf(std::sqrt(0.5))).find("halve in 2.0 cycles"), std::string::npos);
  EXPECT_NE(OrbitText(OrbitOf(0.3)).find("more than halve"), std::string::npos);
  OrbitStability rough = OrbitOf(0.3);
  EXPECT_EQ(OrbitText(rough).find("rough"), std::string::npos);
  rough.multipliers.unexplained = 0.6;
  EXPECT_NE(OrbitText(rough).find("60 % of deviations unexplained, so that the multipliers are rough"),
            std::string::npos);
  EXPECT_NE(OrbitText(OrbitOf(1.0)).find("neither grows nor decays"), std::string::npos);
}

}  // namespace
}  // namespace gaitwright
