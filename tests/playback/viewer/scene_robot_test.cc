// SPDX-License-Identifier: BSD-3-Clause
// The robot of a scene: tree, limits and shapes.
#include <gtest/gtest.h>

#include <fstream>
#include <limits>

#include "playback/viewer/scene_parts_internal.h"
#include "tests/playback/one_joint.h"
#include "tests/playback/viewer/unpacked.h"
#include "tests/scratch_folder.h"

namespace gaitwright {
namespace {

using SceneJsonValue = nlohmann::ordered_json;

Shape ShapeNamed(const std::string& link, ShapeType type, const Vector3& size) {
  Shape shape;
  shape.link = link;
  shape.type = type;
  shape.size = size;
  return shape;
}

/// A visual mesh of a file.
Shape MeshNamed(const std::string& link, const std::string& file) {
  Shape shape = ShapeNamed(link, ShapeType::kMesh, Vector3::Ones());
  shape.mesh_file = file;
  return shape;
}

TEST(SceneRobot, JointsHaveTheirParentAxisAndUnit) {
  for (const JointType type : {JointType::kPrismatic, JointType::kRevolute, JointType::kContinuous}) {
    RobotModel model = one_joint::Make(type);
    model.joints[0].multiplier = 2.0;
    model.joints[0].offset = 0.5;
    const auto robot = RobotScene(model, std::nullopt);
    EXPECT_EQ(robot["bodies"], SceneJsonValue({"heavy", "light"}));
    const auto& joint = robot["joints"][0];
    EXPECT_EQ(joint["parent_body"], 0);
    EXPECT_EQ(joint["multiplier"], 2.0);
    EXPECT_EQ(joint["offset"], 0.5);
    const bool slides = type == JointType::kPrismatic;
    EXPECT_EQ(joint["type"], slides ? "prismatic" : type == JointType::kRevolute ? "revolute" : "continuous");
    EXPECT_EQ(joint["axis"], slides ? SceneJsonValue({1.0, 0.0, 0.0}) : SceneJsonValue({0.0, 0.0, 1.0}));
    EXPECT_EQ(robot["dofs"][0]["unit"], slides ? "m" : "rad");
  }
}

TEST(SceneRobot, ALimitThatDoesNotExistIsNull) {
  RobotModel model = one_joint::Make(JointType::kRevolute);
  const auto free = RobotScene(model, std::nullopt)["dofs"][0];
  EXPECT_TRUE(free["lower"].is_null());
  EXPECT_TRUE(free["upper"].is_null());
  EXPECT_EQ(free["effort_limit"], one_joint::kEffort);
  model.joints[0].lower = -0.5;
  model.joints[0].effort_limit = std::numeric_limits<double>::infinity();
  const auto bounded = RobotScene(model, std::nullopt)["dofs"][0];
  EXPECT_EQ(bounded["lower"], -0.5);
  EXPECT_TRUE(bounded["upper"].is_null());
  EXPECT_TRUE(bounded["effort_limit"].is_null());
}

TEST(SceneRobot, ShapesHaveTheSizesOfTheirKind) {
  RobotModel model = one_joint::Make(JointType::kRevolute);
  model.visual_shapes = {ShapeNamed("heavy", ShapeType::kBox, {1.0, 2.0, 3.0}),
                         ShapeNamed("heavy", ShapeType::kCylinder, {0.1, 0.5, 0.0}),
                         ShapeNamed("heavy", ShapeType::kSphere, {0.2, 0.0, 0.0}),
                         ShapeNamed("light", ShapeType::kCapsule, {0.3, 0.6, 0.0})};
  model.visual_shapes[3].body = 1;
  const auto shapes = RobotScene(model, std::nullopt)["shapes"];
  ASSERT_EQ(shapes.size(), 4U);
  EXPECT_EQ(shapes[0]["type"], "box");
  EXPECT_EQ(shapes[0]["size_m"], SceneJsonValue({1.0, 2.0, 3.0}));
  EXPECT_EQ(shapes[1]["type"], "cylinder");
  EXPECT_EQ(shapes[1]["size_m"], SceneJsonValue({0.1, 0.5}));
  EXPECT_EQ(shapes[2]["type"], "sphere");
  EXPECT_EQ(shapes[2]["size_m"], SceneJsonValue::array({0.2}));
  EXPECT_EQ(shapes[3]["type"], "capsule");
  EXPECT_EQ(shapes[3]["body"], 1);
}

// Visual shapes have priority over collision shapes, by link; only a link whose mesh is missing shows its collision
// shapes.
TEST(SceneRobot, ALinkWhoseMeshIsMissingIsDrawnAsItTouches) {
  RobotModel model = one_joint::Make(JointType::kRevolute);
  model.visual_shapes = {ShapeNamed("heavy", ShapeType::kSphere, {0.2, 0.0, 0.0}), MeshNamed("light", "none.stl")};
  model.collision_shapes = {ShapeNamed("heavy", ShapeType::kBox, {1.0, 1.0, 1.0}),
                            ShapeNamed("light", ShapeType::kCylinder, {0.1, 0.5, 0.0})};
  const auto shapes = RobotScene(model, std::nullopt)["shapes"];
  ASSERT_EQ(shapes.size(), 2U);
  EXPECT_EQ(shapes[0]["type"], "sphere");
  EXPECT_EQ(shapes[1]["type"], "cylinder");
  model.visual_shapes.clear();
  EXPECT_EQ(RobotScene(model, std::nullopt)["shapes"].size(), 2U) << "a robot without looks is drawn as it touches";
}

TEST(SceneRobot, AHullIsDrawnFromItsPoints) {
  RobotModel model = one_joint::Make(JointType::kRevolute);
  Shape hull = MeshNamed("heavy", "hull.stl");
  hull.vertices = {{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 2.0}};
  model.collision_shapes = {hull};
  const auto shapes = RobotScene(model, std::nullopt)["shapes"];
  ASSERT_EQ(shapes.size(), 1U);
  EXPECT_EQ(shapes[0]["type"], "hull");
  EXPECT_EQ(unpacked::Floats(shapes[0]["points_m"]).back(), 2.0F);
}

TEST(SceneRobot, AMeshThatTwoShapesUseIsThereOnce) {
  const std::string folder = ScratchFolder().string();
  std::ofstream(folder + "/twice.obj") << "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
  RobotModel model = one_joint::Make(JointType::kRevolute);
  model.visual_shapes = {MeshNamed("heavy", "twice.obj"), MeshNamed("light", "twice.obj")};
  const auto robot = RobotScene(model, folder);
  EXPECT_EQ(robot["meshes"].size(), 1U);
  ASSERT_EQ(robot["shapes"].size(), 2U);
  EXPECT_EQ(robot["shapes"][0]["mesh"], 0);
  EXPECT_EQ(robot["shapes"][1]["mesh"], 0);
  EXPECT_EQ(unpacked::Numbers<std::uint32_t>(robot["meshes"][0]["triangles"], "u32").size(), 12U);
}

}  // namespace
}  // namespace gaitwright
