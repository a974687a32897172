// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "kinematics/stability/polygon.h"
#include "tests/playback/synthetic.h"
#include "tests/playback/xml_check.h"
#include "workflows/render/drawn_view_internal.h"

namespace gaitwright {
namespace {

Shape TrunkShape(ShapeType type, const Vector3& size, const Vector3& p_BS = Vector3::Zero()) {
  Shape shape;
  shape.type = type;
  shape.link = "trunk";
  shape.size = size;
  shape.X_BS.translation() = p_BS;
  return shape;
}

/// The solids of a robot whose trunk has these shapes and is at the origin of W.
std::vector<DrawnSolid> SolidsWith(const std::vector<Shape>& visual, const std::vector<Shape>& collision = {}) {
  RobotModel model = synthetic::Robot(2, FootType::kSole);
  model.visual_shapes = visual;
  model.collision_shapes = collision;
  DynamicsScratch scratch(model);
  VectorX q = VectorX::Zero(model.nq());
  q[6] = 1.0;
  ForwardKinematics(model, q, scratch);
  return SolidsOf(model, scratch, "");
}

double AreaOf(const std::vector<Vector2>& outline) {
  double area = 0.0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vector2 &a = outline[i], &b = outline[(i + 1) % outline.size()];
    area += 0.5 * (a.x() * b.y() - a.y() * b.x());
  }
  return area;
}

/// The outline of the only solid in the side view.
std::vector<Vector2> SideOutline(const Shape& shape) {
  const std::vector<DrawnSolid> solids = SolidsWith({shape});
  EXPECT_EQ(solids.size(), 1U);
  return solids.empty() ? std::vector<Vector2>{} : OutlineOf(DrawnView{}, solids.front());
}

TEST(DrawnBodies, OutlinesHaveTheAreasOfTheirProjections) {
  EXPECT_NEAR(AreaOf(SideOutline(TrunkShape(ShapeType::kBox, {0.4, 9.0, 0.2}))), 0.4 * 0.2, 1e-9);
  EXPECT_NEAR(AreaOf(SideOutline(TrunkShape(ShapeType::kCylinder, {0.1, 0.6, 0.0}))), 0.2 * 0.6, 0.01 * 0.12);
  const double circle = std::numbers::pi * 0.1 * 0.1;
  EXPECT_NEAR(AreaOf(SideOutline(TrunkShape(ShapeType::kSphere, {0.1, 0.0, 0.0}))), circle, 0.02 * circle);
  EXPECT_NEAR(AreaOf(SideOutline(TrunkShape(ShapeType::kCapsule, {0.1, 0.6, 0.0}))), circle + 0.2 * 0.6, 0.02 * 0.15);
}

TEST(DrawnBodies, OutlinesAreWhereTheirShapesAre) {
  for (const Vector2& p : SideOutline(TrunkShape(ShapeType::kBox, {0.4, 0.2, 0.2}, {1.0, 5.0, -2.0}))) {
    EXPECT_NEAR(std::abs(p.x() - 1.0), 0.2, 1e-9);
    EXPECT_NEAR(std::abs(p.y() + 2.0), 0.1, 1e-9);
  }
}

TEST(DrawnBodies, CollisionShapesAreDrawnOfLinksWithoutVisualOnes) {
  const Shape box = TrunkShape(ShapeType::kBox, {0.4, 0.2, 0.2});
  Shape of_leg = box;
  of_leg.link = "left_z";
  EXPECT_EQ(SolidsWith({box}, {box}).size(), 1U);
  EXPECT_EQ(SolidsWith({box}, {box, of_leg}).size(), 2U);
  EXPECT_EQ(SolidsWith({}, {box, of_leg}).size(), 2U);
  Shape mesh = TrunkShape(ShapeType::kMesh, Vector3::Ones());
  mesh.mesh_file = "nowhere.stl";
  EXPECT_EQ(SolidsWith({mesh}, {box}).size(), 1U) << "a mesh that is not there is replaced";
  EXPECT_TRUE(SolidsWith({mesh}, {}).empty());
}

TEST(DrawnBodies, SolidsNearTheReaderCoverThoseBehind) {
  const RobotModel model = synthetic::Robot(2, FootType::kSole);
  DynamicsScratch scratch(model);
  ForwardKinematics(model, StandingConfiguration(model), scratch);
  const DrawnSolid near{{Vector3(0, -1, 0), Vector3(0.1, -1, 0), Vector3(0, -1, 0.1)}, 0.0},
      far{{Vector3(5, 1, 0), Vector3(5.1, 1, 0), Vector3(5, 1, 0.1)}, 0.0};
  const DrawnView view;  // from the right, the side of negative y
  const std::string svg = DrawnBody(view, model, scratch, {near, far});
  EXPECT_EQ(XmlFault(svg), "");
  EXPECT_EQ(svg, DrawnBody(view, model, scratch, {far, near})) << "whatever their order";
  EXPECT_LT(svg.find("5.0,"), svg.find("points=\"0.")) << "the far one is drawn first";
}

}  // namespace
}  // namespace gaitwright
