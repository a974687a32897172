// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/render/robot_drawing.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "kinematics/dynamics/foot_contact.h"
#include "kinematics/model/load_robot.h"
#include "tests/kinematics/model/small_urdf.h"

namespace gaitwright {
namespace {

int CountOf(const std::string& text, const std::string& part) {
  int count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

/// Centres [px] of the circles of a class in a part of an SVG.
std::vector<Vector2> CirclesOf(const std::string& svg, const std::string& css) {
  const std::string begin = "<circle class=\"" + css + "\" cx=\"";
  std::vector<Vector2> middles;
  for (std::size_t at = svg.find(begin); at != std::string::npos; at = svg.find(begin, at + 1)) {
    const double x = std::strtod(svg.c_str() + at + begin.size(), nullptr);
    middles.emplace_back(x, std::strtod(svg.c_str() + svg.find("cy=\"", at) + 4, nullptr));
  }
  return middles;
}

RobotModel Named(const std::string& name) { return std::move(LoadNamedRobot(name)).value(); }

TEST(RobotDrawing, HasTheVeryCornersOfEachFoot) {
  for (const char* name : {"a1", "nao"}) {
    const RobotModel model = Named(name);
    const std::string svg = RobotDrawing(model, "").svg;
    DynamicsScratch scratch(model);
    ForwardKinematics(model, StandingConfiguration(model), scratch);
    std::vector<Vector3> corners_W;
    for (int f = 0; f < static_cast<int>(model.feet.size()); ++f) {
      for (const Vector3& p : ContactPoints(model, scratch, f)) corners_W.push_back(p);
    }
    EXPECT_EQ(CountOf(svg, "data-foot="), 4 * static_cast<int>(model.feet.size())) << name;
    const std::string above = svg.substr(svg.find("feet from above"));
    std::vector<Vector2> drawn = CirclesOf(above, "corner");
    ASSERT_EQ(drawn.size(), corners_W.size() + 1) << name << ": and one in the table of signs";
    const double px_per_m = (drawn[0] - drawn[1]).norm() / (corners_W[0] - corners_W[1]).head<2>().norm();
    EXPECT_GT(px_per_m, 100.0) << name;
    for (std::size_t i = 0; i < corners_W.size(); ++i) {
      const Vector2 to = (corners_W[i] - corners_W[0]).head<2>();
      EXPECT_NEAR((drawn[i] - drawn[0]).x(), px_per_m * to.x(), 0.5) << name;
      EXPECT_NEAR((drawn[i] - drawn[0]).y(), -px_per_m * to.y(), 0.5) << name;
    }
  }
}

TEST(RobotDrawing, HasAnArrowAndANameForEachJoint) {
  for (const char* name : {"a1", "nao", "h1"}) {
    const RobotModel model = Named(name);
    const std::string svg = RobotDrawing(model, "").svg;
    const std::size_t corner = svg.find("front right corner");
    for (const Joint& joint : model.joints) {
      EXPECT_NE(svg.find("data-joint=\"" + joint.name + "\"", corner), std::string::npos) << name << joint.name;
      EXPECT_GE(CountOf(svg, ">" + joint.name), 1) << name << joint.name;
    }
  }
}

TEST(RobotDrawing, LeavesOutOfTheSideViewWhatLiesBehind) {
  const std::string svg = RobotDrawing(Named("a1"), "").svg;
  const std::string side = svg.substr(svg.find("right side"), svg.find("from its front<") - svg.find("right side"));
  EXPECT_EQ(CountOf(side, "data-joint=\"FR_calf_joint\""), 1);
  EXPECT_EQ(CountOf(side, "data-joint=\"FL_calf_joint\""), 0);
}

TEST(RobotDrawing, DrawsWhatSlidesWhatFollowsAndOddNames) {
  std::string urdf = Replaced(FourLegs(), "'A_knee' type='revolute'", "'A_knee' type='prismatic'");
  urdf = Replaced(urdf, "<!--B_extra-->", "<mimic joint='C_knee'/>");
  urdf = Replaced(urdf, "'D_hip'", "'D&amp;&lt;b>hip'");
  const Result<RobotModel> model = LoadRobotFromText(urdf, "");
  ASSERT_TRUE(model.ok()) << model.failure().message;
  const std::string svg = RobotDrawing(*model, "").svg;
  EXPECT_NE(svg.find("A_knee (prismatic)"), std::string::npos);
  EXPECT_NE(svg.find("B_knee (follows 6)"), std::string::npos);
  EXPECT_NE(svg.find("D&amp;&lt;b&gt;hip"), std::string::npos);
  EXPECT_EQ(svg.find("<b>"), std::string::npos);
  EXPECT_EQ(svg.find("nan"), std::string::npos);
}

TEST(RobotDrawing, BecomesAPictureOfItsSize) {
  const SvgDrawing drawing = RobotDrawing(Named("a1"), "");
  const Result<std::string> png = SvgToPng(drawing);
  ASSERT_TRUE(png.ok()) << png.failure().message;
  const auto number = [&](std::size_t at) {
    int value = 0;
    for (std::size_t i = 0; i < 4; ++i) value = value << 8 | static_cast<unsigned char>((*png)[at + i]);
    return value;
  };
  ASSERT_GT(png->size(), 33U);
  EXPECT_EQ(number(16), drawing.width_px);
  EXPECT_EQ(number(20), drawing.height_px);
}

}  // namespace
}  // namespace gaitwright
