// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "playback/viewer/packed_columns_internal.h"

namespace gaitwright {
namespace {

TEST(PackedColumns, NumbersAreLittleEndian) {
  EXPECT_EQ(Packed(1, std::vector<float>{1.0F})["f32"], "AACAPw==");  // 00 00 80 3f
  EXPECT_EQ(Packed(2, std::vector<std::uint32_t>{1, 256})["u32"], "AQAAAAABAAA=");
  EXPECT_EQ(Packed(2, std::vector<std::uint32_t>{1, 256})["columns"], 2);
  EXPECT_EQ(Packed(1, std::vector<std::uint8_t>{0, 1, 255})["u8"], "AAH/");
}

TEST(PackedColumns, APoseIsPlaceThenQuaternion) {
  Pose pose = Pose::Identity();
  pose.translation() = Vector3(1.0, 2.0, 3.0);
  pose.linear() = Eigen::AngleAxisd(M_PI / 2.0, Vector3::UnitZ()).toRotationMatrix();
  const auto json = PoseJson(pose);
  EXPECT_EQ(json.size(), 7U);
  EXPECT_EQ(json[2], 3.0);
  EXPECT_NEAR(json[5].get<double>(), std::sqrt(0.5), 1e-12);
  EXPECT_NEAR(json[6].get<double>(), std::sqrt(0.5), 1e-12);
}

TEST(PackedColumns, WhatIsNotFiniteIsNull) {
  EXPECT_TRUE(FiniteOrNull(std::numeric_limits<double>::infinity()).is_null());
  EXPECT_EQ(FiniteOrNull(-2.5), -2.5);
}

}  // namespace
}  // namespace gaitwright
