// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "kinematics/base/result.h"
#include "tests/workflows/exchange/mcap_bytes.h"
#include "workflows/exchange/bvh_file_internal.h"

namespace gaitwright {
namespace {

const std::string kSmallBvh = R"(HIERARCHY
ROOT Hips
{
  OFFSET 0 0 0
  CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation
  JOINT left knee
  {
    OFFSET 1 -2 3.5
    CHANNELS 1 Xrotation
    End Site
    {
      OFFSET 0 -1 0
    }
  }
  JOINT head
  {
    OFFSET 0 4 0
  }
}
MOTION
Frames: 2
Frame Time: 0.04
1 2 3 90 0 0 30
4 5 6 10 20 30 -45
)";

std::string ReasonNoBvh(const std::string& from, const std::string& to) {
  std::string text = kSmallBvh;
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  text.replace(at, from.size(), to);
  return synthetic::WhatOf<InvalidArgument>([&] { ParseBvh(text); });
}

TEST(BvhFile, ReadsSkeletonAndFrames) {
  const BvhFile file = ParseBvh(kSmallBvh);
  ASSERT_EQ(file.joints.size(), 3U);
  EXPECT_EQ(file.joints[1].name, "left knee");
  EXPECT_EQ(file.joints[1].parent, 0);
  EXPECT_EQ(file.joints[2].parent, 0);
  EXPECT_EQ(file.joints[1].offset, Vector3(1.0, -2.0, 3.5));
  EXPECT_EQ(file.frames(), 2);
  EXPECT_EQ(file.step_s, 0.04);
  EXPECT_EQ(file.PositionOf(0, 1), Vector3(4.0, 5.0, 6.0));
  EXPECT_EQ(file.PositionOf(1, 0), Vector3(1.0, -2.0, 3.5)) << "the offset, without channels";
  const double degree = M_PI / 180.0;
  EXPECT_LT((file.RotationOf(0, 0, degree) * Vector3::UnitX() - Vector3::UnitY()).norm(), 1e-12);
  const Matrix3 in_order =
      (Eigen::AngleAxisd(10.0 * degree, Vector3::UnitZ()) * Eigen::AngleAxisd(20.0 * degree, Vector3::UnitX()) *
       Eigen::AngleAxisd(30.0 * degree, Vector3::UnitY()))
          .toRotationMatrix();
  EXPECT_LT((file.RotationOf(0, 1, degree) - in_order).norm(), 1e-12) << "in the order of the channels";
  EXPECT_LT(
      (file.RotationOf(1, 1, degree) - Eigen::AngleAxisd(-45.0 * degree, Vector3::UnitX()).toRotationMatrix()).norm(),
      1e-12);
  EXPECT_TRUE(file.RotationOf(2, 1, degree).isIdentity());
  EXPECT_NO_THROW(ParseBvh(kSmallBvh + "\r\n\n"));
}

TEST(BvhFile, RefusesOthersWithTheLine) {
  EXPECT_EQ(ReasonNoBvh("HIERARCHY", "#"), "line 1: 'HIERARCHY' is expected, found '#'");
  EXPECT_EQ(ReasonNoBvh("3.5", "3,5"), "line 8: a finite number is expected, found '3,5'");
  EXPECT_EQ(ReasonNoBvh("3.5", "nan"), "line 8: a finite number is expected, found 'nan'");
  EXPECT_EQ(ReasonNoBvh("1 Xrotation", "1 Wrotation"),
            "line 9: a channel such as 'Xrotation' is expected, found 'wrotation'");
  EXPECT_NE(ReasonNoBvh("1 Xrotation", "2 Xrotation Xrotation").find("line 9: the channel 'Xrotation'"),
            std::string::npos);
  EXPECT_EQ(ReasonNoBvh("head", "left knee"), "line 15: the joint 'left knee' is given twice");
  EXPECT_NE(ReasonNoBvh("1 Xrotation", "7 Xrotation").find("line 9: 7 is given; a whole number from 0 to 6"),
            std::string::npos);
  EXPECT_NE(ReasonNoBvh("Frames: 2", "Frames: 0").find("line 21: 0 is given"), std::string::npos);
  EXPECT_NE(ReasonNoBvh("0.04", "4").find("line 22: the frame time is 4 s"), std::string::npos);
  EXPECT_EQ(ReasonNoBvh("0 0 30\n", "0 0\n"), "line 24: frame 1 of 2 has 6 values; its skeleton has 7 channels");
  EXPECT_EQ(ReasonNoBvh("-45", "-45 1"), "line 24: the end after 2 frames is expected, found '1'");
  EXPECT_EQ(ReasonNoBvh("-45\n", ""), "line 24: a finite number is expected, but the file ends");
  EXPECT_NE(ReasonNoBvh("    End Site", "    Begin").find("'CHANNELS', 'JOINT', 'End Site' or '}'"), std::string::npos);
}

}  // namespace
}  // namespace gaitwright
