// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/description/mjcf.h"

#include "kinematics/model/robot_yaml.h"
#include "tests/kinematics/description/mjcf_texts.h"

namespace gaitwright {
namespace {

/// A base of 1 kg with two legs of 1 kg on hinges.
std::string TwoLegsMjcf(const std::string& sections = "") {
  return MjcfOf(MjcfBodyOf("left", "<joint name='l' range='-60 60' armature='0.01'/><geom size='0.05' mass='3'/>") +
                    MjcfBodyOf("right", "<joint name='r' range='-60 60'/>"),
                sections);
}

TEST(ConvertMjcf, TheTotalMassOfTheCompilerScalesMassesAndInertias) {
  const RobotModel given = TreeOf(Converted(TwoLegsMjcf()));
  const RobotModel scaled = TreeOf(Converted(TwoLegsMjcf("<compiler settotalmass='12'/>")));
  EXPECT_NEAR(given.total_mass_kg, 3.0, 1e-12) << "<inertial> comes before geoms";
  EXPECT_NEAR(scaled.total_mass_kg, 12.0, 1e-12);
  for (std::size_t b = 0; b < given.bodies.size(); ++b) {
    EXPECT_NEAR(scaled.bodies[b].mass, 4.0 * given.bodies[b].mass, 1e-12);
    EXPECT_LT((scaled.bodies[b].I_C - 4.0 * given.bodies[b].I_C).norm(), 1e-12);
    EXPECT_LT((scaled.bodies[b].p_BC - given.bodies[b].p_BC).norm(), 1e-12);
  }
  const RobotModel as_given = TreeOf(Converted(TwoLegsMjcf("<compiler settotalmass='0'/>")));
  EXPECT_NEAR(as_given.total_mass_kg, 3.0, 1e-12);
}

TEST(ConvertMjcf, AnglesMeanTheSameInBothUnits) {
  const std::string radians =
      Replaced(TwoLegsMjcf("<compiler angle='radian'/>"), "-60 60", "-1.0471975511965976 1.0471975511965976");
  const RobotModel a = TreeOf(Converted(TwoLegsMjcf())), b = TreeOf(Converted(radians));
  EXPECT_NEAR(a.joints[0].upper, std::numbers::pi / 3.0, 1e-12);
  EXPECT_NEAR(a.joints[0].upper, b.joints[0].upper, 1e-12);
}

TEST(ConvertMjcf, OnlyTheFirstYamlHasThePosture) {
  const ConvertedMjcf converted =
      Converted(TwoLegsMjcf("<keyframe><key name='home' qpos='0 0 1 1 0 0 0 0.25 -0.5'/></keyframe>"));
  const RobotYaml with = ParseRobotYaml(converted.yaml), without = ParseRobotYaml(converted.yaml_without_posture);
  ASSERT_EQ(with.standing.size(), 2U);
  EXPECT_EQ(with.standing[0].position, 0.25);
  EXPECT_EQ(with.standing[1].joint, "r");
  EXPECT_TRUE(without.standing.empty());
  EXPECT_EQ(with.name, "made");
  EXPECT_EQ(without.name, "made");
  EXPECT_EQ(without.motors.size(), with.motors.size());
}

TEST(ConvertMjcf, TheSameTextGivesTheSameTexts) {
  const ConvertedMjcf a = Converted(TwoLegsMjcf()), b = Converted(TwoLegsMjcf());
  EXPECT_EQ(a.urdf, b.urdf);
  EXPECT_EQ(a.yaml, b.yaml);
  EXPECT_EQ(a.notes, b.notes);
}

TEST(ConvertMjcf, GeomsCollideAndShowOnTheirOwnBody) {
  const std::string geoms =
      "<geom name='skin' size='0.1' group='1' contype='0' conaffinity='0'/><geom name='hull' size='0.2' group='3'/>"
      "<geom name='ghost' size='0.3' group='4' contype='0' conaffinity='0'/><geom name='both' size='0.4'/>";
  const RobotModel model = TreeOf(Converted(MjcfOf(MjcfBodyOf("leg", "<joint name='j'/>" + geoms))));
  std::vector<double> collision, visual;
  for (const Shape& shape : model.collision_shapes) collision.push_back(shape.size.x());
  for (const Shape& shape : model.visual_shapes) visual.push_back(shape.size.x());
  EXPECT_EQ(collision, (std::vector<double>{0.2, 0.4}));
  EXPECT_EQ(visual, (std::vector<double>{0.1, 0.4}));
  for (const Shape& shape : model.collision_shapes) EXPECT_EQ(shape.link, "leg");
}

TEST(ConvertMjcf, RefusalsAreFailuresOfBadInput) {
  const auto failure = [](const std::string& text) {
    const Result<ConvertedMjcf> converted = ConvertMjcfText(text, {}, "walker.xml");
    EXPECT_FALSE(converted.ok());
    return converted.failure();
  };
  EXPECT_EQ(failure("<robot/>").code, FailureCode::kNotMjcf);
  EXPECT_EQ(failure("<mujoco/>").code, FailureCode::kMjcfBodies);
  const Failure twice = failure(Replaced(TwoLegsMjcf(), "'right'", "'left'"));
  EXPECT_EQ(twice.code, FailureCode::kDoubleName);
  EXPECT_EQ(twice.kind, FailureKind::kBadInput);
  ExpectSays(twice.message, {"walker.xml, line"});
  const std::string mass = Replaced(TwoLegsMjcf("<compiler inertiafromgeom='false'/>"), "mass='1'", "mass='-1'");
  EXPECT_EQ(failure(mass).kind, FailureKind::kBadInput);
}

}  // namespace
}  // namespace gaitwright
