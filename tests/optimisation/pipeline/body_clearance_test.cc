// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/pipeline/body_clearance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "kinematics/dynamics/dynamics.h"
#include "kinematics/model/load_robot.h"
#include "planning/plan/built_in_terrain.h"

namespace gaitwright {
namespace {

/// A robot whose base is moved forward and up in the middle of a motion, and that stands at both ends.
struct Visit {
  RobotModel model = *LoadNamedRobot("a1");
  WholeBodyTrajectory rows;
  std::vector<RigidBodySample> samples;

  explicit Visit(const Vector3& by, int rows_there = 1) {
    const VectorX standing = StandingConfiguration(model);
    const auto add = [&](const Vector3& moved) {
      VectorX q = standing;
      q.head<3>() += moved;
      DynamicsScratch scratch(model);
      ForwardKinematics(model, q, scratch);
      const Vector3 zero = Vector3::Zero();
      const double time_s = 0.005 * static_cast<double>(rows.q.size());
      samples.push_back({time_s, 0, CentreOfMass(model, scratch), zero, zero, zero, zero, zero, zero, {}});
      rows.q.push_back(q);
    };
    add(Vector3::Zero());
    for (int k = 0; k < rows_there; ++k) add(by);
    add(Vector3::Zero());
  }
};

Terrain BlockAt(double start_m) {
  return MakeTerrain("block:height_m=0.4,length_m=1,start_m=" + std::to_string(start_m), TerrainScale{}).value();
}

/// Foremost point of the standing robot that does not belong to a link that ends in a foot.
double NoseOf(const Terrain& terrain, double start_m) {
  Visit visit(Vector3::Zero());
  GroundWatch watch(visit.model, terrain);
  DynamicsScratch scratch(visit.model);
  ForwardKinematics(visit.model, visit.rows.q.front(), scratch);
  double nearest = 1.0;
  const GroundLimits limits{std::vector<double>(4, -1.0), 0.25};
  for (const GroundHit& hit : watch.Look(scratch, limits)) {
    const ExitPlane out = watch.ExitPlaneOf(hit);
    if (out.normal_W.x() < -0.99) nearest = std::min(nearest, hit.distance_m);
  }
  return start_m - nearest;
}

TEST(BodyClearance, AsksForNothingWhereNothingIsNear) {
  Visit visit({0.05, 0.0, 0.02});
  BodyClearance clearance(visit.model, BlockAt(0.6));
  EXPECT_EQ(clearance.Look(visit.rows, visit.samples), 0.0);
  EXPECT_TRUE(clearance.Wanted().empty());
}

TEST(BodyClearance, HoldsTheNoseOffABlockByAShareOfTheLeg) {
  constexpr double kStart = 0.4;
  const Terrain block = BlockAt(kStart);
  const double nose = NoseOf(block, kStart);
  ASSERT_GT(nose, 0.15);
  ASSERT_LT(nose, 0.3);
  for (const double gap : {0.02, 0.004, -0.005}) {
    Visit visit({kStart - gap - nose, 0.0, 0.0});
    BodyClearance clearance(visit.model, block);
    const double wanted = 0.07 * visit.model.leg_length_m();
    EXPECT_NEAR(clearance.Look(visit.rows, visit.samples), std::max(0.0, 0.25 * wanted - gap), 1e-4);
    ASSERT_FALSE(clearance.Wanted().empty());
    double farthest = 0.0;
    for (const RigidClearance& plane : clearance.Wanted()) {
      EXPECT_NEAR(plane.normal_W.x(), -1.0, 1e-3);
      EXPECT_NEAR(plane.time_s, 0.005, 1e-12);
      farthest = std::max(farthest, plane.offset_m - plane.normal_W.dot(visit.samples[1].p_WC + plane.p_CQ_B));
    }
    EXPECT_NEAR(farthest, wanted - gap, 1e-3) << "that far back it is clear";
  }
}

TEST(BodyClearance, KeptToItIsClear) {
  constexpr double kStart = 0.4;
  const Terrain block = BlockAt(kStart);
  const double nose = NoseOf(block, kStart);
  const Vector3 too_far(kStart - 0.01 - nose, 0.0, 0.0);
  Visit visit(too_far);
  BodyClearance clearance(visit.model, block);
  (void)clearance.Look(visit.rows, visit.samples);
  double back = 0.0;
  for (const RigidClearance& plane : clearance.Wanted())
    back = std::max(back, plane.offset_m - plane.normal_W.dot(visit.samples[1].p_WC + plane.p_CQ_B));
  ASSERT_GT(back, 0.01);
  Visit clear(too_far - (back + 2e-4) * Vector3::UnitX());
  BodyClearance again(clear.model, block);
  EXPECT_EQ(again.Look(clear.rows, clear.samples), 0.0);
  EXPECT_TRUE(again.Wanted().empty());
}

TEST(BodyClearance, OnePlaneForEachPartAndWhile) {
  const Terrain block = BlockAt(0.4);
  const Vector3 there(0.4 - 0.01 - NoseOf(block, 0.4), 0.0, 0.0);
  Visit brief(there, 3), longer(there, 11);
  BodyClearance once(brief.model, block), often(longer.model, block);
  (void)once.Look(brief.rows, brief.samples);
  (void)often.Look(longer.rows, longer.samples);
  EXPECT_EQ(often.Wanted().size(), 3 * once.Wanted().size()) << "20 ms each";
}

TEST(BodyClearance, IsEasedToAQuarter) {
  const Terrain block = BlockAt(0.4);
  Visit visit({0.4 - NoseOf(block, 0.4), 0.0, 0.0});
  BodyClearance clearance(visit.model, block);
  (void)clearance.Look(visit.rows, visit.samples);
  const double whole = 0.07 * visit.model.leg_length_m(), first = clearance.Wanted().front().offset_m;
  EXPECT_TRUE(clearance.Ease());
  EXPECT_NEAR(first - clearance.Wanted().front().offset_m, 0.5 * whole, 1e-12);
  EXPECT_TRUE(clearance.Ease());
  EXPECT_NEAR(first - clearance.Wanted().front().offset_m, 0.75 * whole, 1e-12);
  EXPECT_FALSE(clearance.Ease());
  EXPECT_NEAR(first - clearance.Wanted().front().offset_m, 0.75 * whole, 1e-12);
}

TEST(BodyClearance, WhereTheRobotStandsNearNoMoreIsAsked) {
  const double nose = NoseOf(BlockAt(0.4), 0.4);
  Visit visit(Vector3::Zero());
  BodyClearance clearance(visit.model, BlockAt(nose + 0.01));
  EXPECT_EQ(clearance.Look(visit.rows, visit.samples), 0.0);
  EXPECT_TRUE(clearance.Wanted().empty());
}

}  // namespace
}  // namespace gaitwright
