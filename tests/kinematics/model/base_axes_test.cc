// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/base_axes.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>

#include "kinematics/base/file.h"
#include "kinematics/dynamics/dynamics.h"
#include "kinematics/dynamics/foot_contact.h"
#include "tests/kinematics/model/small_urdf.h"
#include "tests/kinematics/random_state.h"
#include "tests/scratch_folder.h"

namespace gaitwright {
namespace {

/// The URDF of a robot with an additional root link, in whose frame the robot's x and z are the given axes.
std::string Turned(const std::string& urdf, const std::string& root, const BaseAxes& axes) {
  Matrix3 R;  // rotation of the robot's frame in the frame of the root link
  R << axes.forward, axes.up.cross(axes.forward), axes.up;
  const Vector3 ypr = R.eulerAngles(2, 1, 0);
  return Replaced(urdf, "</robot>",
                  fmt::format("<link name='turned'/><joint name='turn' type='fixed'><parent link='turned'/><child "
                              "link='{}'/><origin rpy='{:.17g} {:.17g} {:.17g}'/></joint></robot>",
                              root, ypr[2], ypr[1], ypr[0]));
}

/// Expects two models of the same robot, with the same frame of the base.
void ExpectSame(const RobotModel& a, const RobotModel& b) {
  ASSERT_EQ(a.num_dofs(), b.num_dofs());
  ASSERT_EQ(a.feet.size(), b.feet.size());
  RandomState random(3);
  const VectorX q = random.Configuration(a);
  MatrixX M_a, M_b;
  DynamicsScratch of_a(a), of_b(b);
  ForwardKinematics(a, q, of_a);
  ForwardKinematics(b, q, of_b);
  MassMatrix(a, q, of_a, M_a);
  MassMatrix(b, q, of_b, M_b);
  EXPECT_LT((M_a - M_b).norm(), 1e-9);
  EXPECT_LT((a.standing_joints - b.standing_joints).norm(), 1e-9);
  EXPECT_NEAR(a.standing_base_height_m, b.standing_base_height_m, 1e-9);
  for (std::size_t f = 0; f < a.feet.size(); ++f) EXPECT_EQ(a.feet[f].link, b.feet[f].link);
}

BaseAxes Axes(const std::string& forward, const std::string& up) {
  const auto named = [](const std::string& name) {
    const auto& names = AxisNames();
    return AxisNamed(static_cast<int>(std::find(names.begin(), names.end(), name) - names.begin()));
  };
  return {named(forward), named(up)};
}

class TurnedRobot : public testing::TestWithParam<std::pair<const char*, const char*>> {};

/// A biped has one plane of symmetry, and its feet are longer in front.
TEST_P(TurnedRobot, ABipedIsSeenAsItStands) {
  const RobotModel h1 = Robot("h1");
  const RobotModel turned =
      LoadRobotFromText(Turned(h1.urdf_text, "pelvis", Axes(GetParam().first, GetParam().second)), "").value();
  ExpectSame(h1, turned);
}
INSTANTIATE_TEST_SUITE_P(Turns, TurnedRobot,
                         testing::Values(std::pair("x", "z"), std::pair("y", "z"), std::pair("-y", "z"),
                                         std::pair("x", "y"), std::pair("z", "y"), std::pair("x", "-y"),
                                         std::pair("y", "-x")));

TEST(BaseAxes, FourLegsHangDownAndStandFartherApartAlong) {
  const RobotModel a1 = Robot("a1");
  for (const auto& [forward, up] :
       {std::pair("x", "z"), std::pair("z", "y"), std::pair("x", "y"), std::pair("y", "z")}) {
    SCOPED_TRACE(std::string(forward) + " " + up);
    ExpectSame(a1, LoadRobotFromText(Turned(a1.urdf_text, "base", Axes(forward, up)), "").value());
  }
}

/// Front and back are alike, and left and right are not: the right feet are farther out.
TEST(BaseAxes, LegsThatBendAboutYStepAlongXThoughSidesDiffer) {
  std::string urdf = FourLegs();
  for (const char* leg : {"B", "D"}) {
    const std::size_t at = urdf.find("xyz='0 0 -0.2'", urdf.find(std::string("'") + leg + "_knee'"));
    urdf.replace(at, 14, "xyz='0 -0.06 -0.2'");
  }
  const Result<RobotModel> model = LoadRobotFromText(urdf, "");
  ASSERT_TRUE(model.ok()) << model.failure().message;
  EXPECT_TRUE(DeriveBaseAxes(*model).are_usual());
}

/// Legs of which no joint turns about y cannot step along x, though left and right are not quite alike.
TEST(BaseAxes, LegsThatTurnAboutXAloneStepAlongY) {
  std::string urdf = Replaced(FourLegs(), "<axis xyz='0 1 0'/>", "<axis xyz='1 0 0'/>");
  for (const std::string y : {"0.1", "-0.1"}) urdf = Replaced(urdf, "xyz='0.2 " + y + " 0'", "xyz='0.26 " + y + " 0'");
  const RobotModel one = LoadRobotFromText(urdf, "").value();
  const Vector3 axis_B = one.joints[0].X_PJ.linear() * one.joints[0].axis_J;
  EXPECT_NEAR(std::abs(axis_B.y()), 1.0, 1e-9);
}

TEST(BaseAxes, RobotYamlSaysWhatCannotBeSeen) {
  const RobotModel a1 = Robot("a1");
  const std::string backwards = Turned(a1.urdf_text, "base", Axes("-y", "z"));
  const RobotModel corrected = LoadRobotFromText(backwards, "ahead: -y\nup: z\n").value();
  ExpectSame(a1, corrected);
  std::string notes;
  for (const std::string& note : corrected.notes) notes += note + "\n";
  ExpectSays(notes, {"base: axis -y of link 'turned' points forward and z up (robot.yaml)"});
  ExpectSays(MessageOf(backwards, "up: z\n"), {"line 1", "'ahead' and 'up' must be given together"});
  ExpectSays(MessageOf(backwards, "up: z\nahead: -z\n"), {"two perpendicular axes"});
  ExpectSays(MessageOf(backwards, "up: w\nahead: x\n"), {"'up' is 'w'", "'-z'"});
}

/// As published for the robot that Bullet loads with globalScaling 0.25, converted to z up.
TEST(BaseAxes, TheHumanoidIsAsPublished) {
  const RobotModel humanoid = Robot("humanoid");
  EXPECT_NEAR(humanoid.total_mass_kg, 45.0001, 1e-9);
  EXPECT_EQ(humanoid.num_dofs(), 28);
  EXPECT_NEAR(humanoid.leg_length_m(), 0.881416, 1e-6);
  VectorX straight = StandingConfiguration(humanoid);
  straight.tail(humanoid.num_dofs()).setZero();
  straight[2] = 0.88142;
  DynamicsScratch scratch(humanoid);
  ForwardKinematics(humanoid, straight, scratch);
  EXPECT_LT((CentreOfMass(humanoid, scratch) - Vector3(-0.00121, 0.0, 0.89216)).norm(), 2e-5);
  const Pose left = ContactFrame(humanoid, scratch, 0);
  EXPECT_LT((left.translation() - Vector3(0.045, 0.08489, 0.0)).norm(), 2e-5);
  const Vector2 sole = humanoid.feet[0].sole_F[2] - humanoid.feet[0].sole_F[0];
  EXPECT_LT((sole - Vector2(0.177, 0.09)).norm(), 1e-9);
}

TEST(BaseAxes, ScaleIsOfLengthsAlone) {
  const RobotModel one = LoadRobotFromText(FourLegs(), "").value();
  const RobotModel three = LoadRobotFromText(FourLegs(), "scale: 3\n").value();
  EXPECT_NEAR(three.leg_length_m(), 3.0 * one.leg_length_m(), 1e-9);
  EXPECT_NEAR(three.feet[0].radius, 3.0 * one.feet[0].radius, 1e-12);
  EXPECT_NEAR(three.total_mass_kg, one.total_mass_kg, 1e-12);
  ExpectSays(MessageOf(FourLegs(), "scale: 0\n"), {"line 1", "'scale'"});
}

TEST(BaseAxes, FilesOfSimulatorsMayEndInNuls) {
  const std::string file = ScratchFile("with_nul.urdf");
  const std::string text = FourLegs();
  std::ofstream(file, std::ios::binary) << text << "\r\n" << '\0';
  const Result<RobotModel> model = LoadRobot(file, "none");
  ASSERT_TRUE(model.ok()) << model.failure().message;
  EXPECT_EQ(model->urdf_text, text + "\r\n");
}

}  // namespace
}  // namespace gaitwright
