// SPDX-License-Identifier: BSD-3-Clause
// The part of a rounded foot that is its sole.
#include <gtest/gtest.h>

#include "kinematics/dynamics/foot_contact.h"
#include "tests/kinematics/model/small_urdf.h"

namespace gaitwright {
namespace {

/// NAO with bevelled soles of 20 mm thickness: 140 by 70 mm at the bottom, 157 by 88 mm from 3 mm above it.
Result<RobotModel> Bevelled(const std::string& more_yaml) {
  const RobotModel nao = LoadNamedRobot("nao").value();
  MeshHull hull{"sole.obj", {}};
  const auto add = [&](double x, double y, double z) {
    for (const double a : {-x, x}) {
      for (const double b : {-y, y}) hull.vertices.emplace_back(a, b, z);
    }
  };
  add(0.070, 0.035, -0.010);
  add(0.0785, 0.044, -0.007);
  add(0.0785, 0.044, 0.010);
  return LoadRobotFromText(Replaced(nao.urdf_text, "<box size=\"0.157 0.088 0.02\"/>", "<mesh filename=\"sole.obj\"/>"),
                           nao.yaml_text + "\n" + more_yaml + "\n", "nao", {hull});
}

std::string ReasonNoSole(const std::string& more_yaml) {
  const Result<RobotModel> model = Bevelled(more_yaml);
  return model.ok() ? "" : model.failure().message;
}

/// Length and width of the sole of a foot [mm].
Vector2 SizeOf(const RobotModel& model, const std::string& link) {
  for (const Foot& foot : model.feet) {
    if (foot.link != link) continue;
    EXPECT_EQ(foot.type, FootType::kSole);
    Eigen::AlignedBox2d box;
    for (const Vector2& corner : foot.sole_F) box.extend(corner);
    return 1e3 * box.sizes();
  }
  ADD_FAILURE() << link;
  return Vector2::Zero();
}

void ExpectSize(const RobotModel& model, const std::string& link, double length_mm, double width_mm) {
  EXPECT_NEAR(SizeOf(model, link).x(), length_mm, 1e-6) << link;
  EXPECT_NEAR(SizeOf(model, link).y(), width_mm, 1e-6) << link;
}

TEST(SoleGive, IsTwoPercentOfTheFootUnlessGiven) {
  const RobotModel model = Bevelled("").value();  // 2 % of 157 mm: 3.14 mm
  for (const char* link : {"l_ankle", "r_ankle"}) ExpectSize(model, link, 157.0, 88.0);
  const RobotModel alike = Bevelled("sole_give_m: 0.00314").value();
  for (std::size_t f = 0; f < model.feet.size(); ++f) {
    EXPECT_EQ(alike.feet[f].sole_F, model.feet[f].sole_F);
    EXPECT_TRUE(alike.feet[f].X_BF.isApprox(model.feet[f].X_BF));
  }
}

TEST(SoleGive, ChangesTheCornersOfAllFeet) {
  for (const char* yaml : {"sole_give_m: 0", "sole_give_m: 0.0029"}) {
    const RobotModel model = Bevelled(yaml).value();
    for (const char* link : {"l_ankle", "r_ankle"}) ExpectSize(model, link, 140.0, 70.0);
  }
  ExpectSize(Bevelled("sole_give_m: 0.0031").value(), "l_ankle", 157.0, 88.0);
}

TEST(SoleGive, OfAFootComesBeforeThatOfAll) {
  const RobotModel model =
      Bevelled("sole_give_m: 0.004\nfeet: [{link: l_ankle}, {link: r_ankle, sole_give_m: 0.001}]").value();
  ExpectSize(model, "l_ankle", 157.0, 88.0);
  ExpectSize(model, "r_ankle", 140.0, 70.0);
}

TEST(SoleGive, HoldsForShapesOfAnyKind) {
  const RobotModel nao = LoadNamedRobot("nao").value();
  std::string urdf = Replaced(nao.urdf_text, "<box size=\"0.157 0.088 0.02\"/>", "<sphere radius=\"0.001\"/>");
  std::string balls;  // three at one height and one that is 3 mm higher
  for (const char* at : {"0.05 0.03 -0.04", "0.05 -0.03 -0.04", "-0.05 0.03 -0.04", "-0.05 -0.03 -0.037"}) {
    balls += std::string("<collision><origin xyz=\"") + at +
             "\"/><geometry><sphere radius=\"0.01\"/></geometry></collision>";
  }
  for (const char* link : {"<link name=\"l_ankle\">", "<link name=\"r_ankle\">"})
    urdf = Replaced(urdf, link, link + balls);
  const Result<RobotModel> usual = LoadRobotFromText(urdf, nao.yaml_text, "nao");
  const Result<RobotModel> wide = LoadRobotFromText(urdf, nao.yaml_text + "\nsole_give_m: 0.0035\n", "nao");
  ASSERT_TRUE(usual.ok()) << usual.failure().message;
  ASSERT_TRUE(wide.ok()) << wide.failure().message;
  EXPECT_NE(usual->feet[0].derived_from.find("3 spheres"), std::string::npos) << usual->feet[0].derived_from;
  EXPECT_NE(wide->feet[0].derived_from.find("4 spheres"), std::string::npos) << wide->feet[0].derived_from;
}

TEST(SoleGive, IsThatOfAPlansRobotToo) {
  const RobotModel model = Bevelled("sole_give_m: 0.001").value();
  const RobotModel again = LoadRobotFromText(model.urdf_text, model.yaml_text, model.name, model.meshes).value();
  EXPECT_EQ(again.hash, model.hash);
  DynamicsScratch scratch(again);
  ForwardKinematics(again, StandingConfiguration(again), scratch);
  const std::vector<Vector3> corners_W = ContactPoints(again, scratch, 0);
  ASSERT_EQ(corners_W.size(), 4U);
  for (const Vector3& corner : corners_W) EXPECT_NEAR(corner.z(), 0.0, 1e-6);
  EXPECT_NEAR((corners_W[0] - corners_W[2]).norm(), std::hypot(0.140, 0.070), 1e-6);
}

TEST(SoleGive, IsRefusedOutOfItsRangeAndWhereItCannotBe) {
  ExpectSays(ReasonNoSole("sole_give_m: 0.051"), {"'sole_give_m'", "0.051", "0.05"});
  ExpectSays(ReasonNoSole("sole_give_m: -0.001"), {"'sole_give_m'", "-0.001"});
  ExpectSays(ReasonNoSole("feet: [{link: l_ankle, type: point, sole_give_m: 0.001}, {link: r_ankle}]"),
             {"'l_ankle'", "'sole_give_m'", "'type'"});
  ExpectSays(MessageOf(FourLegs(), "feet: [{link: A_foot, sole_give_m: 0.001}, {link: B_foot}]"),
             {"line 1", "'A_foot'", "'sole_give_m'", "no sole"});
}

TEST(SoleGive, IsRefusedWhereItTakesASoleAway) {
  MeshHull hull{"sole.obj", {}};  // a keel, and an edge 1 mm over it
  for (const double x : {-0.07, 0.07}) {
    hull.vertices.emplace_back(x, 0.0, -0.010);
    for (const double y : {-0.04, 0.04}) {
      hull.vertices.emplace_back(x, y, -0.009);
      hull.vertices.emplace_back(x, y, 0.010);
    }
  }
  const RobotModel nao = LoadNamedRobot("nao").value();
  const std::string urdf = Replaced(nao.urdf_text, "<box size=\"0.157 0.088 0.02\"/>", "<mesh filename=\"sole.obj\"/>");
  EXPECT_TRUE(LoadRobotFromText(urdf, nao.yaml_text, "nao", {hull}).ok());
  const Result<RobotModel> keel = LoadRobotFromText(urdf, nao.yaml_text + "\nsole_give_m: 0.0001\n", "nao", {hull});
  ASSERT_FALSE(keel.ok());
  ExpectSays(keel.failure().message, {"'sole_give_m'", "ankle'", "0.0001"});
}

}  // namespace
}  // namespace gaitwright
