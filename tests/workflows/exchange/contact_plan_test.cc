// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "kinematics/base/result.h"
#include "planning/plan/terrain.h"
#include "tests/named_robot.h"
#include "tests/workflows/exchange/mcap_bytes.h"
#include "workflows/exchange/contact_plan_internal.h"
#include "workflows/exchange/footstep_file.h"

namespace gaitwright {
namespace {

const std::string kTwoSteps = R"(double_support_duration: 0.3
single_support_duration: 0.8
init_dsp_duration: 0.7
swing_height: 0.04
contacts:
- {pose: {translation: [0.0, -0.1, 0.0]}, surface: RightFootCenter}
- {pose: {translation: [0.0, 0.1, 0.0]}, ref_vel: [0, 0, 0], surface: LeftFootCenter}

- pose:
    translation: [0.1, -0.1, 0.0]
    rotation: [0.8, 0.6, 0, -0.6, 0.8, 0, 0, 0, 1]
  surface: RightFootCenter
- {pose: {translation: [0.1, 0.1, 0.0], rotation: [0.9486833, 0, 0, -0.3162278]}, surface: LeftFootCenter}
)";

std::string Changed(const std::string& from, const std::string& to) {
  std::string text = kTwoSteps;
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

std::string ReasonNoContacts(const std::string& text, const char* robot = "h1") {
  std::vector<std::string> unused;
  return synthetic::WhatOf<InvalidArgument>([&] { FootstepsOfContactPlan(NamedRobot(robot), text, unused); });
}

TEST(ContactPlan, BecomesFootsteps) {
  const RobotModel& model = NamedRobot("h1");
  std::vector<std::string> unused;
  const std::string text = FootstepsOfContactPlan(model, kTwoSteps, unused);
  EXPECT_EQ(unused, (std::vector<std::string>{"key 'swing_height'", "key 'ref_vel'"}));
  const auto steps = ReadFootsteps(model, FlatTerrain(), text, "plan.yaml", 0.005);
  ASSERT_TRUE(steps.ok()) << steps.failure().message;
  ASSERT_EQ(steps->footsteps.footholds.size(), 4U);
  const double times_s[] = {0.0, 0.7, 1.5, 1.8, 2.6, 3.2};  // stands, steps, stands, steps, stands 0.6 s
  for (const Foothold& foothold : steps->footsteps.footholds) {
    const bool left = foothold.X_WF.translation().y() > 0.0, start = foothold.touchdown_s == 0.0;
    EXPECT_NEAR(foothold.X_WF.translation().x(), start ? 0.0 : 0.1, 1e-12);
    EXPECT_NEAR(std::abs(foothold.X_WF.translation().y()), 0.1, 1e-12);
    EXPECT_NEAR(foothold.touchdown_s, start ? times_s[0] : times_s[left ? 4 : 2], 1e-9);
    EXPECT_NEAR(foothold.liftoff_s, start ? times_s[left ? 3 : 1] : times_s[5], 1e-9);
    const Vector3 forward = foothold.X_WF.linear().col(0);
    EXPECT_NEAR(std::atan2(forward.y(), forward.x()), start ? 0.0 : std::atan2(0.6, 0.8), 1e-3)
        << "rows of the rotation are the axes of the contact, and quaternions follow";
    const std::string& foot = model.feet[static_cast<std::size_t>(foothold.foot)].name;
    EXPECT_NE(foot.find(left ? "left" : "right"), std::string::npos) << foot;
  }
}

TEST(ContactPlan, IsFoundAmongPlansByRobot) {
  std::vector<std::string> unused;
  std::string inner;
  for (std::size_t from = 0; from < kTwoSteps.size();) {
    const std::size_t end = kTwoSteps.find('\n', from) + 1;
    inner += "      " + kTwoSteps.substr(from, end - from);
    from = end;
  }
  const std::string one = "initial_plan: walk\nplans:\n  hrp:\n    walk:\n" + inner;
  EXPECT_TRUE(HoldsContactPlan(one) && HoldsContactPlan(kTwoSteps));
  EXPECT_FALSE(HoldsContactPlan("footsteps: []\n"));
  EXPECT_NE(FootstepsOfContactPlan(NamedRobot("h1"), one, unused).find("swing_s: 0.8"), std::string::npos);
  EXPECT_EQ(ReasonNoContacts(one + "    back:\n" + inner),
            "line 3: it has 2 plans: 'hrp.walk', 'hrp.back'; a file with one of them is read");
  EXPECT_NE(ReasonNoContacts("plans: {}\n").find("it has 0 plans"), std::string::npos);
}

TEST(ContactPlan, RefusesWithTheLineOfTheContact) {
  EXPECT_NE(ReasonNoContacts(kTwoSteps, "a1").find("is for two feet; robot 'a1' has 4"), std::string::npos);
  EXPECT_NE(ReasonNoContacts(Changed("LeftFootCenter", "Hand")).find("line 7: the surface 'Hand' names neither"),
            std::string::npos);
  EXPECT_NE(ReasonNoContacts(Changed("[0.0, 0.1, 0.0]", "[0.0, 0.1]")).find("line 7: translation has 2 numbers"),
            std::string::npos);
  EXPECT_NE(ReasonNoContacts(Changed("0, 0, 0, 1]", "0, 1]")).find("line 11: rotation has 7 numbers"),
            std::string::npos);
  EXPECT_NE(ReasonNoContacts(Changed("swing_height", "swing_hight")).find("'swing_height'"), std::string::npos);
  EXPECT_NE(ReasonNoContacts(Changed("single_support_duration", "final_dsp_duration")).find("single_support_duration"),
            std::string::npos);
  EXPECT_NE(ReasonNoContacts("single_support_duration: 1\ncontacts: []\n").find("has 0 contacts"), std::string::npos);
  std::vector<std::string> unused;
  const std::string high =
      FootstepsOfContactPlan(NamedRobot("h1"), Changed("[0.1, 0.1, 0.0]", "[0.1, 0.1, 0.5]"), unused);
  const auto steps = ReadFootsteps(NamedRobot("h1"), FlatTerrain(), high, "plan.yaml", 0.005);
  ASSERT_FALSE(steps.ok());
  EXPECT_NE(steps.failure().message.find("line 13: z_m = 0.5 m is not on the ground"), std::string::npos)
      << steps.failure().message;
}

}  // namespace
}  // namespace gaitwright
