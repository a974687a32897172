// SPDX-License-Identifier: BSD-3-Clause
#include "planning/plan/sole_support.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "kinematics/spatial/rotation.h"

namespace gaitwright {
namespace {

Foot Sole() {
  Foot foot;
  foot.type = FootType::kSole;
  foot.sole_F = {{-0.08, -0.04}, {0.08, -0.04}, {0.08, 0.04}, {-0.08, 0.04}};
  return foot;
}

Terrain Tread(double half_m, const Pose& X_WT) {
  Terrain terrain = FlatTerrain();
  terrain.patches[0].X_WT = X_WT;
  terrain.patches[0].outline_T = {{-half_m, -half_m}, {half_m, -half_m}, {half_m, half_m}, {-half_m, half_m}};
  return terrain;
}

TEST(SoleSupport, IsWhatIsOnThePatch) {
  Pose X_WT = Pose::Identity();
  X_WT.translation() = Vector3(2.0, -1.0, 0.4);
  X_WT.linear() = RotationExp(Vector3(0.1, 0.2, 0.9));
  Foothold foothold;
  for (const double over_m : {-0.02, 0.0, 0.03, 0.1}) {
    for (const double yaw : {0.0, 1.5707963267948966}) {  // toe or left side over the edge
      Pose X_TF = Pose::Identity();
      X_TF.linear() = YawRotation(-yaw);
      X_TF.translation().x() = 0.2 - (yaw == 0.0 ? 0.08 : 0.04) + over_m;
      foothold.X_WF = X_WT * X_TF;
      const double width = yaw == 0.0 ? 0.16 : 0.08, other = yaw == 0.0 ? 0.08 : 0.16;
      const double on = std::clamp(width - over_m, 0.0, width);
      const Polygon part = SupportOf(Sole(), foothold, Tread(0.2, X_WT), 0.0);
      EXPECT_NEAR(part.empty() ? 0.0 : Area(part), on * other, 1e-12);
      const Polygon inner = SupportOf(Sole(), foothold, Tread(0.2, X_WT), 0.005);
      const double kept = std::clamp(width - std::max(over_m + 0.005, 0.0), 0.0, width);
      EXPECT_NEAR(inner.empty() ? 0.0 : Area(inner), kept * other, 1e-12);
    }
  }
}

TEST(SoleSupport, IsThePointOfAPointFoot) {
  Foot ball;
  ball.type = FootType::kSphere;
  ball.radius = 0.02;
  Foothold foothold;
  foothold.X_WF.translation().x() = 0.199;
  const Terrain tread = Tread(0.2, Pose::Identity());
  EXPECT_EQ(SupportOf(ball, foothold, tread, 0.0).size(), 1U);
  EXPECT_TRUE(SupportOf(ball, foothold, tread, 0.005).empty());
  foothold.patch = 1;
  EXPECT_TRUE(SupportOf(ball, foothold, tread, 0.0).empty()) << "there is no such surface";
}

TEST(SoleSupport, EndsWhereAFieldEnds) {
  Terrain terrain;
  HeightField field;
  field.columns = field.rows = 11;
  field.resolution_m = 0.1;
  field.height_m.assign(121, 0.0);
  terrain.height_fields = {field};
  Foothold foothold;
  foothold.X_WF.translation() = Vector3(0.5, 1.0, 0.0);
  EXPECT_NEAR(Area(SupportOf(Sole(), foothold, terrain, 0.0)), 0.5 * 0.16 * 0.08, 1e-12);
}

}  // namespace
}  // namespace gaitwright
