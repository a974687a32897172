// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/exchange/quaternion_order.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "kinematics/base/result.h"
#include "kinematics/spatial/rotation.h"
#include "tests/playback/played.h"

namespace gaitwright {
namespace {

/// The walk of a biped along a heading, as a table.
MotionTable WalkTable(const synthetic::Played& walker, double heading_rad) {
  const Matrix3 R = RotationExp(Vector3(0.0, 0.0, heading_rad));
  MotionTable table;
  for (const LogSample& sample : walker.log.samples) {
    table.time_s.push_back(sample.time_s);
    table.base_m.emplace_back(R * sample.q.head<3>());
    table.quaternion.emplace_back(Quaternion(R).coeffs());
    table.q.emplace_back(sample.q.tail(walker.model.num_dofs()));
  }
  return table;
}

MotionTable WithWFirst(MotionTable table) {
  for (Eigen::Vector4d& c : table.quaternion) c = Eigen::Vector4d(c[3], c[0], c[1], c[2]);
  return table;
}

std::string OrderRefusal(const synthetic::Played& walker, const MotionTable& table, const Terrain* ground,
                         double lift_m = 0.0) {
  try {
    CheckQuaternionOrder(walker.model, ground, lift_m, table);
  } catch (const InvalidArgument& error) {
    return error.what();
  }
  return "";
}

TEST(QuaternionOrder, AWalkInTheNamedOrderIsAcceptedWhateverItsHeading) {
  const synthetic::Played walker = synthetic::Walked();
  for (const double heading : {0.0, 0.4, -1.2, 3.0}) {
    const MotionTable table = WalkTable(walker, heading);
    EXPECT_EQ(OrderRefusal(walker, table, &walker.plan.terrain), "") << heading;
    EXPECT_EQ(OrderRefusal(walker, table, nullptr), "") << heading;
  }
}

TEST(QuaternionOrder, AWalkWithWFirstIsRefusedAndTheOptionNamed) {
  const synthetic::Played walker = synthetic::Walked();
  for (const double heading : {0.0, 0.4, -1.2}) {
    const MotionTable table = WithWFirst(WalkTable(walker, heading));
    for (const Terrain* ground :
         {static_cast<const Terrain*>(&walker.plan.terrain), static_cast<const Terrain*>(nullptr)}) {
      const std::string refusal = OrderRefusal(walker, table, ground);
      EXPECT_TRUE(synthetic::Says(refusal, "--quaternion-order wxyz")) << heading << refusal;
      EXPECT_FALSE(synthetic::Says(refusal, "with either order")) << heading << refusal;
    }
  }
}

TEST(QuaternionOrder, TheOrderIsJudgedByTheBaseAloneWhereItsPlaceIsUnknown) {
  const synthetic::Played walker = synthetic::Walked();
  MotionTable table = WalkTable(walker, 0.4);
  table.base_m.clear();
  EXPECT_EQ(OrderRefusal(walker, table, &walker.plan.terrain), "");
  EXPECT_TRUE(synthetic::Says(OrderRefusal(walker, WithWFirst(table), &walker.plan.terrain), "wxyz"));
}

TEST(QuaternionOrder, ARobotThatLiesInBothOrdersIsRefused) {
  const synthetic::Played walker = synthetic::Walked();
  MotionTable table = WalkTable(walker, 0.0);
  const double half = std::numbers::pi / 3.0;  // rotated by 120 degrees about y
  for (Eigen::Vector4d& c : table.quaternion) c << 0.0, std::sin(half), 0.0, std::cos(half);
  EXPECT_TRUE(synthetic::Says(OrderRefusal(walker, table, &walker.plan.terrain), "not upright with either order"));
}

/// Heights that are wrong in both orders do not decide the order.
TEST(QuaternionOrder, AWrongHeightIsNoMatterOfTheOrder) {
  const synthetic::Played walker = synthetic::Walked();
  EXPECT_EQ(OrderRefusal(walker, WalkTable(walker, 0.4), &walker.plan.terrain, 10.0), "");
  EXPECT_TRUE(synthetic::Says(OrderRefusal(walker, WithWFirst(WalkTable(walker, 0.4)), &walker.plan.terrain, 10.0),
                              "--quaternion-order wxyz"));
}

TEST(QuaternionOrder, AMissingJointIsTakenToStand) {
  const synthetic::Played walker = synthetic::Walked();
  MotionTable table = WalkTable(walker, 0.4);
  for (VectorX& q : table.q) q[0] = std::nan("");
  EXPECT_EQ(OrderRefusal(walker, table, &walker.plan.terrain), "");
}

}  // namespace
}  // namespace gaitwright
