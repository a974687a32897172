// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tests/playback/synthetic.h"
#include "tests/playback/xml_check.h"
#include "workflows/render/drawn_view_internal.h"

namespace gaitwright {
namespace {

int PartsOf(const std::string& svg, const std::string& part) {
  int count = 0;
  for (std::size_t at = svg.find(part); at != std::string::npos; at = svg.find(part, at + part.size())) ++count;
  return count;
}

/// The side view of a large picture, with 500 px per metre.
DrawnView SideView() {
  DrawnView view;
  view.px_per_m = 500.0;
  view.zero_px = Vector2(500.0, 700.0);
  view.frame_px = Eigen::AlignedBox2d(Vector2(0.0, 0.0), Vector2(1000.0, 1000.0));
  return view;
}

std::string JointsIn(const DrawnView& view, const RobotModel& model) {
  DynamicsScratch scratch(model);
  ForwardKinematics(model, StandingConfiguration(model), scratch);
  return DrawnJoints(view, model, scratch);
}

TEST(DrawnJointsOfView, AxesAlongTheWorldsHaveItsClassesWhicheverTheirSign) {
  EXPECT_STREQ(AxisClass(Vector3::UnitX()), "jx");
  EXPECT_STREQ(AxisClass(-Vector3::UnitY()), "jy");
  EXPECT_STREQ(AxisClass(Vector3::UnitZ()), "jz");
  EXPECT_STREQ(AxisClass(Vector3(1.0, 1.0, 0.0).normalized()), "jo");
  EXPECT_EQ(AxisText(Vector3::UnitY()), "+y");
  EXPECT_EQ(AxisText(-Vector3::UnitZ()), "-z");
  const std::string oblique = AxisText(Vector3(0.6, 0.0, -0.8));
  EXPECT_NE(oblique.find("0.6"), std::string::npos) << oblique;
  EXPECT_NE(oblique.find("0.8"), std::string::npos) << oblique;
}

/// A point to the right of and above another point is so in the picture too, whose y axis points down.
TEST(DrawnJointsOfView, PointsOfTheWorldGoToThePictureToScale) {
  const DrawnView view = SideView();
  const Vector2 origin = view.ToPx(Vector3::Zero()), point = view.ToPx(Vector3(0.2, 5.0, 0.1));
  EXPECT_EQ(origin, view.zero_px);
  EXPECT_NEAR(point.x() - origin.x(), 100.0, 1e-9);
  EXPECT_NEAR(point.y() - origin.y(), -50.0, 1e-9);
  EXPECT_EQ(view.ToPx(Vector3(0.2, -5.0, 0.1)), point) << "depth does not show";
}

TEST(DrawnJointsOfView, AJointBehindAParallelOneIsNotDrawn) {
  const RobotModel model = synthetic::Robot(2, FootType::kSole);  // its legs are side by side
  const std::string svg = JointsIn(SideView(), model);
  EXPECT_EQ(XmlFault(svg), "");
  DrawnView front = SideView();
  front.right_W = Vector3::UnitY();
  front.toward_W = Vector3::UnitX();
  const std::string both = JointsIn(front, model);
  EXPECT_GT(PartsOf(both, "<text"), PartsOf(svg, "<text")) << "from the front both legs show";
}

TEST(DrawnJointsOfView, AnAxisThatPointsAtTheReaderIsARing) {
  RobotModel model = synthetic::Robot(2, FootType::kSole);
  const std::string svg = JointsIn(SideView(), model);
  EXPECT_GT(PartsOf(svg, "jy ring"), 0) << "y goes away from the side";
  EXPECT_EQ(PartsOf(svg, "jx ring"), 0);
}

}  // namespace
}  // namespace gaitwright
