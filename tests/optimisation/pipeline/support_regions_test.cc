// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/pipeline/support_regions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "kinematics/model/load_robot.h"
#include "planning/paths/standing_feet.h"

namespace gaitwright {
namespace {

/// A quadruped on its left feet for a second between two stands, while they roll sideways by an arc and back.
struct Sway {
  static constexpr double kStep = 0.005;
  RobotModel model = *LoadNamedRobot("a1");
  ContactSchedule schedule;
  FootstepPlan footsteps;
  SupportInputs inputs;

  explicit Sway(double bend_m) {
    schedule.phases = {{0.0, 0.5, 15}, {0.5, 1.5, 5}, {1.5, 2.0, 15}};
    const std::vector<Pose> standing = StandingFeet(model);
    for (int f = 0; f < 4; ++f) {
      const bool swings = f % 2 == 1;
      const Pose& X_WF = standing[static_cast<std::size_t>(f)];
      footsteps.footholds.push_back({f, X_WF, Vector3::Zero(), 0, 0.0, swings ? 0.5 : 2.0});
      if (swings) footsteps.footholds.push_back({f, X_WF, Vector3::Zero(), 0, 1.5, 2.0});
    }
    inputs.step_s = kStep;
    inputs.contact_W.resize(4);
    for (int f = 0; f < 4; ++f) {
      for (int k = 0; k <= 400; ++k) inputs.contact_W[static_cast<std::size_t>(f)].push_back(At(f, k * kStep, bend_m));
    }
  }

  Vector3 At(int foot, double time_s, double bend_m) const {
    const double phase = std::clamp(time_s - 0.5, 0.0, 1.0);
    Vector3 p = StandingFeet(model)[static_cast<std::size_t>(foot)].translation();
    p.y() += bend_m * std::sin(std::numbers::pi * phase);
    return p;
  }

  std::vector<ZmpPhase> Regions() const { return SupportRegions(model, schedule, footsteps, inputs); }
};

TEST(SupportRegions, LinesFollowFeetThatRollToAndFro) {
  constexpr double kBend = 0.008, kAllowed = 6e-4;
  const Sway sway(kBend);
  const std::vector<ZmpPhase> regions = sway.Regions();
  EXPECT_GT(regions.size(), 4u);
  for (const ZmpPhase& region : regions) {
    if (region.region_start.size() != 2) continue;
    for (double t = region.start_s; t <= region.end_s; t += Sway::kStep) {
      for (const int foot : {0, 2}) {
        const Vector2 corner = sway.At(foot, t, kBend).head<2>();
        EXPECT_LT(std::abs(SignedDistance(RegionAt(region, t), corner)), kAllowed) << "at " << t;
      }
      EXPECT_LT(std::abs(SignedDistance(RegionAt(region, t), PreferredAt(region, t))), 1e-9);
    }
  }
}

TEST(SupportRegions, PartsAbutAndCoverTheSchedule) {
  const std::vector<ZmpPhase> regions = Sway(0.008).Regions();
  EXPECT_EQ(regions.front().start_s, 0.0);
  EXPECT_EQ(regions.back().end_s, 2.0);
  for (std::size_t i = 0; i + 1 < regions.size(); ++i) {
    EXPECT_EQ(regions[i].end_s, regions[i + 1].start_s);
    if (regions[i].region_end.size() != regions[i + 1].region_start.size()) continue;
    for (const Vector2& corner : regions[i].region_end)
      EXPECT_LT(std::abs(SignedDistance(regions[i + 1].region_start, corner)), 1e-9);
  }
}

TEST(SupportRegions, StraightOnesStayWhole) {
  EXPECT_EQ(Sway(0.0).Regions().size(), 3u);
  EXPECT_EQ(Sway(4e-4).Regions().size(), 3u);
}

}  // namespace
}  // namespace gaitwright
