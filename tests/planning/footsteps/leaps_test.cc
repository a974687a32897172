// SPDX-License-Identifier: BSD-3-Clause
// Leaps of all feet together over uneven ground.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "kinematics/model/load_robot.h"
#include "planning/footsteps/plan_footsteps.h"
#include "planning/gait/find_gait.h"
#include "planning/plan/terrain_scale.h"
#include "planning/terrain/load_terrain.h"

namespace gaitwright {
namespace {

/// The last foothold of each foot after one leap forward.
std::vector<Foothold> Landing(const std::string& terrain, double leap_m, const FootstepOptions& options = {}) {
  static const RobotModel model = *LoadNamedRobot("a1");
  WalkCommand command;
  command.extent = WalkCommand::Extent::kSteps;
  command.steps = 4;
  command.step_length_m = leap_m / 4.0;
  const Gait gait = *FindGait(model, "jump", 0.0, {});
  const Result<FootstepSkeleton> skeleton =
      PlanFootsteps(model, *LoadTerrain(terrain, ScaleOf(model)), gait, command, options);
  EXPECT_TRUE(skeleton.ok()) << skeleton.failure().message;
  std::map<int, Foothold> last;
  for (const Foothold& foothold : skeleton->footsteps.footholds) last[foothold.foot] = foothold;
  std::vector<Foothold> landing;
  for (const auto& [foot, foothold] : last) landing.push_back(foothold);
  return landing;
}

/// Height difference between the highest and the lowest of them.
double Unevenness(const std::vector<Foothold>& feet) {
  const auto [low, high] = std::minmax_element(feet.begin(), feet.end(), [](const Foothold& a, const Foothold& b) {
    return a.X_WF.translation().z() < b.X_WF.translation().z();
  });
  return high->X_WF.translation().z() - low->X_WF.translation().z();
}

TEST(Leaps, LandWithAllFeetOnOneLevelNearTheEdgeOfABlock) {
  for (const std::string start : {"0.26", "0.3", "0.34", "0.36"}) {
    const std::vector<Foothold> landing = Landing("block:height_m=0.15,length_m=2,start_m=" + start, 0.52);
    ASSERT_EQ(landing.size(), 4U);
    for (const Foothold& foothold : landing) EXPECT_NEAR(foothold.X_WF.translation().z(), 0.15, 1e-9) << start;
  }
}

TEST(Leaps, DownFromABlockLandWithAllFeetBelow) {
  for (const std::string height : {"0.1", "0.15", "0.2"}) {
    const std::vector<Foothold> landing = Landing("block:start_m=-1.5,length_m=1.72,height_m=" + height, 0.6);
    ASSERT_EQ(landing.size(), 4U);
    for (const Foothold& foothold : landing) EXPECT_NEAR(foothold.X_WF.translation().z(), 0.0, 1e-9) << height;
  }
}

TEST(Leaps, WithoutACostOfLandingTiltedFeetStandWhereverTheyAreNearest) {
  FootstepOptions tilted;
  tilted.search.landing_weight = 0.0;
  EXPECT_GT(Unevenness(Landing("block:height_m=0.15,length_m=2,start_m=0.36", 0.52, tilted)), 0.1);
}

}  // namespace
}  // namespace gaitwright
