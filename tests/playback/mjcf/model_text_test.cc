// SPDX-License-Identifier: BSD-3-Clause
// The text of a MuJoCo model, read without MuJoCo.
#include <gtest/gtest.h>

#include <sstream>

#include "playback/mjcf/model_text_internal.h"
#include "tests/playback/one_body.h"
#include "tests/playback/one_joint.h"
#include "tests/playback/xml_check.h"

namespace gaitwright::mujoco {
namespace {

/// The tags that begin with the given text.
std::vector<std::string> TagsOf(const std::string& mjcf, const std::string& begin) {
  std::vector<std::string> tags;
  for (std::size_t at = mjcf.find(begin); at != std::string::npos; at = mjcf.find(begin, at + 1))
    tags.push_back(mjcf.substr(at, mjcf.find('>', at) - at));
  return tags;
}

/// The numbers of an attribute of a tag.
std::vector<double> NumbersOf(const std::string& tag, const std::string& attribute) {
  const std::size_t at = tag.find(" " + attribute + "=\"");
  if (at == std::string::npos) return {};
  const std::size_t begin = at + attribute.size() + 3;
  std::istringstream text(tag.substr(begin, tag.find('"', begin) - begin));
  std::vector<double> numbers;
  for (double number; text >> number;) numbers.push_back(number);
  return numbers;
}

VectorX StartOf(const RobotModel& model) {
  VectorX q = VectorX::Zero(model.nq());
  q[6] = 1.0;
  return q;
}

ModelText TextOf(const RobotModel& model, const WorldOptions& options = {}, const Terrain& terrain = FlatTerrain(),
                 const FileParts* parts = nullptr) {
  return WriteModel(model, terrain, StartOf(model), options, parts);
}

TEST(ModelText, NamesOfAnyKindLeaveItWellFormed) {
  RobotModel model = one_joint::Make(JointType::kRevolute);
  model.name = "a<b>\"&'";
  model.bodies[1].name = "<light>";
  model.joints[0].name = "\"joint\"";
  EXPECT_EQ(XmlFault(TextOf(model).mjcf), "");
}

TEST(ModelText, StepAndGravityAreTheWorlds) {
  WorldOptions options;
  options.step_s = 0.002;
  const std::string option = TagsOf(TextOf(one_body::Ball(), options).mjcf, "<option ").at(0);
  EXPECT_EQ(NumbersOf(option, "timestep"), std::vector<double>{0.002});
  EXPECT_EQ(NumbersOf(option, "gravity"), (std::vector<double>{0.0, 0.0, -kGravity}));
}

// [[2, 1], [1, 2]] has moments 1 and 3.
TEST(ModelText, InertiasAreByPrincipalAxes) {
  RobotModel model = one_body::Ball();
  model.bodies[0].I_C << 2.0, 1.0, 0.0, 1.0, 2.0, 0.0, 0.0, 0.0, 3.5;
  const auto moments = NumbersOf(TagsOf(TextOf(model).mjcf, "<inertial ").at(0), "diaginertia");
  ASSERT_EQ(moments.size(), 3U);
  EXPECT_NEAR(moments[0], 1.0, 1e-12);
  EXPECT_NEAR(moments[1], 3.0, 1e-12);
  EXPECT_NEAR(moments[2], 3.5, 1e-12);
}

TEST(ModelText, MassesAndInertiasScaleAndOnlyTheBaseIsShifted) {
  const RobotModel model = one_joint::Make(JointType::kPrismatic);  // 4 kg and 1 kg
  WorldOptions options;
  options.mass_scale = 2.0;
  options.inertia_scale = 3.0;
  options.com_shift_x_m = 0.1;
  options.com_shift_z_m = -0.2;
  const auto inertials = TagsOf(TextOf(model, options).mjcf, "<inertial ");
  ASSERT_EQ(inertials.size(), 2U);
  EXPECT_EQ(NumbersOf(inertials[0], "mass"), std::vector<double>{8.0});
  EXPECT_EQ(NumbersOf(inertials[1], "mass"), std::vector<double>{2.0});
  EXPECT_NEAR(NumbersOf(inertials[0], "diaginertia").at(1), 24.0, 1e-12);
  EXPECT_NEAR(NumbersOf(inertials[1], "diaginertia").at(1), 6.0, 1e-12);
  EXPECT_EQ(NumbersOf(inertials[0], "pos"), (std::vector<double>{0.1, 0.0, -0.2}));
  EXPECT_EQ(NumbersOf(inertials[1], "pos"), (std::vector<double>{0.0, 0.0, 0.0}));
}

TEST(ModelText, ABodyWithoutMassHasTheLeast) {
  RobotModel model = one_joint::Make(JointType::kPrismatic);
  model.bodies[1].mass = 0.0;
  model.bodies[1].I_C.setZero();
  const auto inertials = TagsOf(TextOf(model).mjcf, "<inertial ");
  const double mass = NumbersOf(inertials.at(1), "mass").at(0),
               moment = NumbersOf(inertials.at(1), "diaginertia").at(0);
  EXPECT_GT(mass, 0.0);
  EXPECT_LT(mass, 1e-9);
  EXPECT_GT(moment, 0.0);
  EXPECT_LT(moment, 1e-12);
}

TEST(ModelText, ALockedSlideIsWeldedWhereItStands) {
  const RobotModel model = one_joint::Make(JointType::kPrismatic);
  EXPECT_EQ(TagsOf(TextOf(model).mjcf, "<joint ").size(), 1U);
  WorldOptions options;
  options.locked_dofs = {0};
  VectorX q = StartOf(model);
  q[7] = 0.25;
  const std::string mjcf = WriteModel(model, FlatTerrain(), q, options).mjcf;
  EXPECT_EQ(TagsOf(mjcf, "<joint ").size(), 0U);
  EXPECT_EQ(NumbersOf(TagsOf(mjcf, "<body name=\"light\"").at(0), "pos"), (std::vector<double>{0.25, 0.0, 0.0}));
}

TEST(ModelText, ASoleHasASphereOnEachCornerAndAPlateWhereAsked) {
  const RobotModel block = one_body::Block(0.4, 0.2, 0.1);
  WorldOptions options;
  options.sole_contact = "corners";
  const ModelText corners = TextOf(block, options);
  EXPECT_EQ(TagsOf(corners.mjcf, "<geom name=\"g").size(), 4U);
  options.sole_contact = "plate";
  const ModelText plate = TextOf(block, options);
  ASSERT_EQ(plate.parts.size(), 5U) << "the four corners, and the plate";
  for (const GeomPart& part : plate.parts) {
    EXPECT_EQ(part.foot, 0);
    EXPECT_EQ(part.link, "body");
  }
  // The lowest point of a sphere is at the sole, 0.05 m below the body's centre.
  const auto sphere = TagsOf(corners.mjcf, "<geom name=\"g0\"").at(0);
  EXPECT_NEAR(NumbersOf(sphere, "pos").at(2) - NumbersOf(sphere, "size").at(0), -0.05, 1e-12);
}

TEST(ModelText, TheFrictionOfTheGroundIsTheTerrainsUnlessGiven) {
  Terrain terrain = FlatTerrain();
  terrain.patches[0].friction = 0.35;
  const auto friction = [&](double given) {
    WorldOptions options;
    options.friction = given;
    return NumbersOf(TagsOf(TextOf(one_body::Ball(), options, terrain).mjcf, "<geom name=\"t0\"").at(0), "friction");
  };
  EXPECT_EQ(friction(0.0), (std::vector<double>{0.35, 0.0, 0.0}));
  EXPECT_EQ(friction(0.9), (std::vector<double>{0.9, 0.0, 0.0}));
}

// Rows along x as in HeightField; heights are shares of the rise. The tests of MuJoCo's world check the diagonal of a
// cell.
TEST(ModelText, AHeightFieldKeepsItsRowsAndIsScaledToItsRise) {
  Terrain rough;
  HeightField field;
  field.columns = 3;
  field.rows = 2;
  field.resolution_m = 0.5;
  field.origin_W = Vector2(1.0, 2.0);
  field.height_m = {-0.1, 0.0, 0.1, 0.3, -0.1, 0.1};  // row by row along x
  rough.height_fields = {field};
  const ModelText text = TextOf(one_body::Ball(), {}, rough);
  ASSERT_EQ(text.fields.size(), 1U);
  const FieldHeights& heights = text.fields[0];
  EXPECT_EQ(heights.rows, 2);
  EXPECT_EQ(heights.columns, 3);
  const std::vector<float> expected = {0.0F, 0.25F, 0.5F, 1.0F, 0.0F, 0.5F};
  ASSERT_EQ(heights.heights.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(heights.heights[i], expected[i], 1e-6) << i;
  const auto size = NumbersOf(TagsOf(text.mjcf, "<hfield ").at(0), "size");
  ASSERT_EQ(size.size(), 4U);
  EXPECT_NEAR(size[0], 0.5, 1e-12) << "half of the length along x";
  EXPECT_NEAR(size[1], 0.25, 1e-12);
  EXPECT_NEAR(size[2], 0.4, 1e-12);
  const auto at = NumbersOf(TagsOf(text.mjcf, "<geom name=\"t0\"").at(0), "pos");
  ASSERT_EQ(at.size(), 3U);
  EXPECT_NEAR(at[0], 1.5, 1e-12);
  EXPECT_NEAR(at[1], 2.25, 1e-12);
  EXPECT_NEAR(at[2], -0.1, 1e-12);
}

TEST(ModelText, AJointThatFollowsHasItsGear) {
  RobotModel model = one_joint::Make(JointType::kRevolute);
  model.bodies.push_back(model.bodies[1]);
  model.bodies.back().name = "third";
  model.joints.push_back(model.joints[0]);
  model.joints.back().name = "follower";
  model.joints.back().parent_body = 1;
  model.joints.back().is_mimic = true;
  model.joints.back().multiplier = -2.0;
  model.joints.back().offset = 0.5;
  const auto gears = TagsOf(TextOf(model).mjcf, "<joint joint1=");
  ASSERT_EQ(gears.size(), 1U);
  EXPECT_NE(gears[0].find("joint1=\"follower\" joint2=\"joint\""), std::string::npos);
  EXPECT_EQ(NumbersOf(gears[0], "polycoef"), (std::vector<double>{0.5, -2.0, 0.0, 0.0, 0.0}));
}

TEST(ModelText, OnlyAFileHasMotorsLimitsAndAKeyFrame) {
  RobotModel model = one_joint::Make(JointType::kRevolute);
  model.joints[0].lower = -1.5;
  model.joints[0].upper = 0.5;
  const FileParts parts{VectorX::Constant(1, 40.0), VectorX::Constant(1, 2.0), {}};
  const std::string world = TextOf(model).mjcf, file = TextOf(model, {}, FlatTerrain(), &parts).mjcf;
  for (const char* part : {"<actuator>", "<keyframe>", "range="})
    EXPECT_EQ(world.find(part), std::string::npos) << part;
  const std::string motor = TagsOf(file, "<general ").at(0);
  EXPECT_EQ(NumbersOf(motor, "gainprm"), std::vector<double>{40.0});
  EXPECT_EQ(NumbersOf(motor, "biasprm"), (std::vector<double>{0.0, -40.0, -2.0}));
  EXPECT_EQ(NumbersOf(motor, "forcerange"), (std::vector<double>{-one_joint::kEffort, one_joint::kEffort}));
  EXPECT_EQ(NumbersOf(TagsOf(file, "<joint ").at(0), "range"), (std::vector<double>{-1.5, 0.5}));
  const std::string key = TagsOf(file, "<key ").at(0);
  EXPECT_EQ(NumbersOf(key, "qpos"), (std::vector<double>{0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0})) << "w is first";
  EXPECT_EQ(NumbersOf(key, "ctrl"), std::vector<double>{0.0});
}

}  // namespace
}  // namespace gaitwright::mujoco
