// SPDX-License-Identifier: BSD-3-Clause
// Named places of a ground, and their positions.
#include "workflows/words/places.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "kinematics/base/result.h"
#include "planning/plan/built_in_terrain.h"

namespace gaitwright {
namespace {

bool Has(const std::vector<PlaceName>& places, const PlaceName& place) {
  return std::find(places.begin(), places.end(), place) != places.end();
}

TEST(Places, StairsHaveTheirStepsAndTheGroundAtBothEnds) {
  const Terrain stairs = MakeTerrain("stairs:start_m=0.8,tread_m=0.3,count=3,landing_m=1", TerrainScale{}).value();
  const std::vector<PlaceName> places = PlacesOf(stairs);
  for (const PlaceName& place :
       {PlaceName{"step", 3}, PlaceName{"step 1 down", 0}, PlaceName{kStartOfStairs, 0}, PlaceName{kEndOfStairs, 0}})
    EXPECT_TRUE(Has(places, place)) << place.name;
  EXPECT_NEAR(CentreOf(stairs, {"step", -1}).x(), 0.8 + 2 * 0.3 + 0.5, 1e-12);
  EXPECT_NEAR(CentreOf(stairs, {kStartOfStairs, 0}).x(), 0.0, 1e-12) << "where the robot begins";
  EXPECT_NEAR(CentreOf(stairs, {kEndOfStairs, 0}).x(), 0.8 + 4 * 0.3 + 1.0 + 0.8, 1e-12) << "as far behind as before";
}

TEST(Places, GroundsWithoutStairsHaveNoEndsOfThem) {
  for (const char* name : {"flat", "block", "stepping-stones"}) {
    const std::vector<PlaceName> places = PlacesOf(MakeTerrain(name, TerrainScale{}).value());
    EXPECT_FALSE(Has(places, {kStartOfStairs, 0}) || Has(places, {kEndOfStairs, 0})) << name;
  }
  // A single step has no direction.
  EXPECT_FALSE(Has(PlacesOf(MakeTerrain("stairs:count=1", TerrainScale{}).value()), {kEndOfStairs, 0}));
  EXPECT_THROW(CentreOf(MakeTerrain("flat", TerrainScale{}).value(), {kEndOfStairs, 0}), InvalidArgument);
}

}  // namespace
}  // namespace gaitwright
