// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/robot_yaml.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "kinematics/base/file.h"
#include "kinematics/model/describe.h"
#include "kinematics/model/robot_yaml_shape.h"
#include "tests/built_paths.h"
#include "tests/kinematics/model/small_urdf.h"

namespace gaitwright {
namespace {

RobotModel With(const std::string& yaml) {
  Result<RobotModel> model = LoadRobotFromText(FourLegs(), yaml);
  EXPECT_TRUE(model.ok()) << (model.ok() ? "" : model.failure().message);
  return std::move(model).value();
}

std::string ReasonRefused(const std::string& yaml) { return MessageOf(FourLegs(), yaml); }

const Joint& JointOf(const RobotModel& model, const std::string& name) {
  return model.joints[static_cast<std::size_t>(model.dof_joint[static_cast<std::size_t>(model.DofIndex(name))])];
}

std::string NotesOf(const RobotModel& model) {
  return std::accumulate(model.notes.begin(), model.notes.end(), std::string(),
                         [](const auto& all, const auto& note) { return all + note + "\n"; });
}

/// The small robot with prismatic knees.
std::string Sliding() {
  return Replaced(Replaced(FourLegs(), "_knee' type='revolute'", "_knee' type='prismatic'"), "lower='-2' upper='1'",
                  "lower='-0.1' upper='0.1'");
}

TEST(RobotYaml, NamesAndDescribes) {
  const RobotModel model = With("name: bob\ndescription: four legs");
  EXPECT_EQ(model.name, "bob");
  EXPECT_EQ(model.description, "four legs");
}

TEST(RobotYaml, LimitsTakeTheUrdfsPlace) {
  const RobotModel model = With(
      "limits: {A_knee: {lower_rad: -1.5, upper_rad: 0.5, velocity_rad_s: 7, effort_nm: 11}, B_knee: {effort_nm: 3}}");
  const Joint &a = JointOf(model, "A_knee"), &b = JointOf(model, "B_knee");
  EXPECT_EQ(a.lower, -1.5);
  EXPECT_EQ(a.upper, 0.5);
  EXPECT_EQ(a.velocity_limit, 7.0);
  EXPECT_EQ(a.effort_limit, 11.0);
  EXPECT_EQ(b.lower, -2.0);
  EXPECT_EQ(b.effort_limit, 3.0);
  ExpectSays(NotesOf(model), {"limits of 'A_knee', 'B_knee': from robot.yaml"});
}

TEST(RobotYaml, MotorsSayWhatTheyCan) {
  const RobotModel model = With(
      "motors: {A_knee: {corner_velocity_rad_s: 4, no_load_velocity_rad_s: 8, continuous_nm: 9, thermal_s: 3, "
      "rotor_inertia_kg_m2: 0.02, acceleration_rad_s2: 200, jerk_rad_s3: 5000, damping_nm_s_rad: 0.3, friction_nm: "
      "0.7}}");
  const Motor& motor = model.MotorOf(model.DofIndex("A_knee"));
  EXPECT_EQ(motor.continuous_effort, 9.0);
  EXPECT_EQ(motor.thermal_s, 3.0);
  EXPECT_EQ(motor.rotor_inertia, 0.02);
  EXPECT_EQ(motor.acceleration_limit, 200.0);
  EXPECT_EQ(motor.jerk_limit, 5000.0);
  EXPECT_EQ(JointOf(model, "A_knee").damping, 0.3);
  EXPECT_EQ(JointOf(model, "A_knee").friction, 0.7);
  EXPECT_EQ(motor.EffortAt(4.0, 30.0), 30.0);
  EXPECT_NEAR(motor.EffortAt(6.0, 30.0), 15.0, 1e-12);
  EXPECT_EQ(motor.EffortAt(9.0, 30.0), 0.0);
  EXPECT_EQ(motor.EffortAt(-9.0, 30.0), 30.0);
  EXPECT_FALSE(model.MotorOf(model.DofIndex("B_knee")).has_curve());
  EXPECT_EQ(model.MotorOf(model.DofIndex("B_knee")).EffortAt(1e3, 30.0), 30.0);
  ExpectSays(DescribeRobot(model),
             {"full effort up to speed 4, none from 8 on", "continuous 9 (root mean square over 3 s)",
              "rotor inertia 0.02", "damping 0.3, friction 0.7"});
}

TEST(RobotYaml, ACurveWithoutAPeakIsNoted) {
  const char* curve = "motors: {A_knee: {corner_velocity_rad_s: 4, no_load_velocity_rad_s: 8}}";
  const char* note = "joint 'A_knee': its torque-speed curve has no peak torque";
  const Result<RobotModel> endless = LoadRobotFromText(Replaced(FourLegs(), "effort='30'", "effort='1e6'"), curve);
  ASSERT_TRUE(endless.ok()) << endless.failure().message;
  ExpectSays(NotesOf(*endless), {note, "'limits' of robot.yaml"});
  EXPECT_EQ(NotesOf(With(curve)).find(note), std::string::npos);
}

TEST(RobotYaml, RefusesMotorsThatContradictThemselves) {
  ExpectSays(ReasonRefused("motors: {A_knee: {corner_velocity_rad_s: 8, no_load_velocity_rad_s: 4}}"),
             {"line 1", "'A_knee' has a corner velocity of 8, which is not below its no-load velocity of 4"});
  ExpectSays(ReasonRefused("motors: {A_knee: {no_load_velocity_rad_s: 4}}"), {"one end of its torque-speed curve"});
  ExpectSays(ReasonRefused("motors: {A_knee: {continuous_nm: 31}}"),
             {"a continuous effort of 31, above the joint's limit of 30"});
  ExpectSays(ReasonRefused("motors: {A_knee: {thermal_s: 3}}"),
             {"line 1", "'A_knee'", "'thermal_s'", "no 'continuous_nm'"});
  ExpectSays(ReasonRefused("motors: {A_knee: {continuous_n: 3}}"), {"joint 'A_knee' is revolute"});
  ExpectSays(ReasonRefused("motors: {A_knee: {rotor_inertia_kg_m2: 0}}"), {"rotor_inertia_kg_m2"});
}

TEST(RobotYaml, LimitsBoundAContinuousJointAndReplaceAPlaceholder) {
  const std::string turning = Replaced(Replaced(FourLegs(), "revolute", "continuous"), "lower='-2' upper='1'", "");
  const std::string urdf = Replaced(turning, "effort='30'", "effort='1e6'");
  const Result<RobotModel> model =
      LoadRobotFromText(urdf, "limits: {A_knee: {lower_rad: -1, upper_rad: 1, effort_nm: 2000}}");
  ASSERT_TRUE(model.ok()) << model.failure().message;
  EXPECT_EQ(JointOf(*model, "A_knee").type, JointType::kRevolute);
  EXPECT_FALSE(JointOf(*model, "A_knee").effort_limit_is_placeholder);
  EXPECT_TRUE(JointOf(*model, "B_knee").effort_limit_is_placeholder);
  ExpectSays(MessageOf(urdf, "limits: {A_knee: {lower_rad: -1}}"), {"'A_knee' is continuous", "both"});
}

TEST(RobotYaml, RefusesLimitsThatCannotBe) {
  ExpectSays(ReasonRefused("limits: {A_kne: {effort_nm: 3}}"),
             {"line 1", "no moving joint 'A_kne'", "nearest is 'A_knee'"});
  ExpectSays(ReasonRefused("limits:\n  A_knee: {lower_rad: 2}"),
             {"line 2", "'A_knee'", "lower limit 2 is above its upper limit 1"});
  ExpectSays(ReasonRefused("limits: {A_knee: {effort_nm: -3}}"), {"'effort_nm' is -3", "above 0"});
  ExpectSays(ReasonRefused("limits: {A_knee: {effort: 3}}"),
             {"unknown key 'effort'", "nearest are 'effort_nm', 'effort_n'"});
  ExpectSays(ReasonRefused("limits: {A_knee: {lower_m: 0}}"), {"'A_knee' is revolute", "_rad"});
  ExpectSays(ReasonRefused("limits: {A_knee: {lower_m: 0, effort_nm: 2}}"), {"'A_knee'", "use only one kind"});
  ExpectSays(MessageOf(Sliding(), "limits: {A_knee: {effort_nm: 2}}"), {"'A_knee' is prismatic", "_n"});
  ExpectSays(ReasonRefused("limits: {A_knee: 3}"), {"the limits of 'A_knee'", "a single value", "a map"});
  ExpectSays(ReasonRefused("limits: 3"), {"'limits' is a single value"});
}

TEST(RobotYaml, FeetAreNamedWithTypeRadiusAndSole) {
  const RobotModel model = With(
      "feet:\n- {link: A_foot, type: point}\n- {link: B_foot, radius_m: 0.03}\n"
      "- {link: C_foot, sole_m: [[0.1, 0.05], [0.1, -0.05], [-0.05, -0.05], [-0.05, 0.05]]}\n"
      "- {link: D_foot, type: line, sole_m: [[-0.05, -0.02], [0.1, -0.02], [0.1, 0.02], [-0.05, 0.02]]}\n");
  ASSERT_EQ(model.feet.size(), 4U);
  for (const Foot& foot : model.feet) {
    if (foot.link == "A_foot") {
      EXPECT_EQ(foot.type, FootType::kPoint);
      EXPECT_EQ(foot.radius, 0.0);
    } else if (foot.link == "B_foot") {
      EXPECT_EQ(foot.type, FootType::kSphere);
      EXPECT_EQ(foot.radius, 0.03);
    } else if (foot.link == "C_foot") {
      EXPECT_EQ(foot.type, FootType::kSole);
      EXPECT_NEAR(foot.X_BF.translation().x(), 0.025, 1e-12);
      const Vector2 a = foot.sole_F[1] - foot.sole_F[0], b = foot.sole_F[2] - foot.sole_F[1];
      EXPECT_GT(a.x() * b.y() - a.y() * b.x(), 0.0);  // turned to be counter-clockwise
    } else {
      EXPECT_EQ(foot.type, FootType::kLine);
    }
  }
  ExpectSays(NotesOf(model),
             {"foot 'A_foot': named in robot.yaml", "its radius from robot.yaml", "its 4 corners from robot.yaml"});
}

TEST(RobotYaml, RefusesFeetThatCannotBe) {
  const auto foot = [](const std::string& keys) { return ReasonRefused("feet:\n- {link: B_foot}\n- {" + keys + "}"); };
  ExpectSays(ReasonRefused("feet: 3"), {"line 1", "'feet' is a single value", "a list"});
  ExpectSays(ReasonRefused("feet: []"), {"'feet' is empty"});
  ExpectSays(ReasonRefused("feet: [3]"), {"a foot is a single value", "a map"});
  ExpectSays(foot("type: point"), {"line 3", "lacks the key 'link'"});
  ExpectSays(foot("link: [A_foot]"), {"'link' is a list"});
  ExpectSays(foot("link: A_foot, typ: sole"), {"line 3", "unknown key 'typ'", "nearest is 'type'"});
  ExpectSays(foot("link: A_foot, type: claw"), {"line 3", "'claw' is unknown", "'point', 'sphere', 'line', 'sole'"});
  ExpectSays(foot("link: A_foot, radius_m: -0.02"), {"line 3", "'radius_m' is -0.02"});
  ExpectSays(foot("link: A_foot, radius_m: big"), {"'radius_m' is 'big'; a number is needed"});
  ExpectSays(foot("link: A_foot, type: point, radius_m: 0.02"), {"'A_foot' is not a sphere but has 'radius_m'"});
  ExpectSays(foot("link: A_foot, type: sole"), {"line 3", "'A_foot' of type sole or line needs its corners"});
  ExpectSays(foot("link: A_foot, type: sphere, sole_m: [[0, 0], [1, 0], [0, 1]]"), {"'A_foot' is not a sole"});
  ExpectSays(
      MessageOf(FourLegs("<box size='0.04 0.04 0.04'/>"), "feet: [{link: A_foot, type: sphere}, {link: B_foot}]"),
      {"line 1", "'A_foot' of type sphere needs 'radius_m'"});
  ExpectSays(foot("link: A_fot"), {"line 3", "no link 'A_fot'", "nearest is 'A_foot'"});
}

TEST(RobotYaml, RefusesSolesThatAreNoConvexPolygon) {
  const auto sole = [](const std::string& corners) {
    return ReasonRefused("feet:\n- {link: B_foot}\n- {link: A_foot, sole_m: " + corners + "}");
  };
  ExpectSays(sole("3"), {"'sole_m' is a single value"});
  ExpectSays(sole("[[0, 0], [0.1, 0]]"), {"line 3", "2 corners", "three or more"});
  ExpectSays(sole("[[0, 0], [0.1], [0, 0.1]]"), {"has 1 numbers", "[x, y]"});
  ExpectSays(sole("[[0, 0], [0.1, .nan], [0, 0.1]]"), {"finite number"});
  ExpectSays(sole("[[0, 0], [0.1, 0.1], [0.2, 0.2]]"), {"area of 0 m^2"});
  ExpectSays(sole("[[0, 0], [0.1, 0.1], [0.1, 0], [0, 0.1]]"), {"crosses itself"});
  ExpectSays(sole("[[0, 0], [0.1, 0], [0.02, 0.02], [0, 0.1]]"), {"not convex", "covers 40 %"});
}

TEST(RobotYaml, LegsTakeKneesAndSides) {
  const RobotModel derived = With("");
  ASSERT_EQ(derived.legs[0].name, "A_foot");
  EXPECT_LT(derived.legs[0].knee_sign, 0.0);
  const RobotModel model = With("legs: {A_foot: {joints: [A_hip, A_knee], knee: A_hip, knee_side: plus}}");
  EXPECT_EQ(model.joints[static_cast<std::size_t>(model.legs[0].knee_joint)].name, "A_hip");
  EXPECT_EQ(model.legs[0].knee_sign, 1.0);
  const RobotModel side = With("limits: {A_knee: {upper_rad: 2}}\nlegs: {A_foot: {knee_side: plus}}");
  EXPECT_GT(side.standing_joints[side.DofIndex("A_knee")], 0.1);
  EXPECT_LT(side.standing_joints[side.DofIndex("B_knee")], -0.1);
}

TEST(RobotYaml, RefusesLegsThatCannotBe) {
  ExpectSays(ReasonRefused("legs: 3"), {"'legs' is a single value"});
  ExpectSays(ReasonRefused("legs: {A_fot: {knee: A_knee}}"), {"no foot 'A_fot'", "'A_foot', 'B_foot'"});
  ExpectSays(ReasonRefused("legs: {A_foot: {kne: A_knee}}"), {"unknown key 'kne'", "nearest is 'knee'"});
  ExpectSays(ReasonRefused("legs: {A_foot: {knee: B_knee}}"),
             {"'B_knee' is not a joint of leg 'A_foot'", "'A_hip', 'A_knee'"});
  ExpectSays(ReasonRefused("legs: {A_foot: {joints: [A_knee, A_hip]}}"), {"'A_hip', 'A_knee', from the base"});
  ExpectSays(ReasonRefused("legs: {A_foot: {joints: A_knee}}"), {"'joints' is a single value"});
  ExpectSays(ReasonRefused("legs: {A_foot: {knee_side: left}}"), {"'knee_side' is 'left'", "'plus', 'minus'"});
  ExpectSays(ReasonRefused("limits: {A_knee: {upper_rad: -0.5}}\nlegs: {A_foot: {knee_side: plus}}"),
             {"line 2", "'A_knee' cannot bend to plus", "-2 to -0.5"});
}

TEST(RobotYaml, MirrorPairsTakeThePlaceOfDerivedOnes) {
  const RobotModel derived = With("");
  EXPECT_EQ(derived.legs[0].mirror, 1);
  const RobotModel model = With("mirror_pairs: [[A_foot, D_foot]]");
  EXPECT_EQ(model.legs[0].mirror, 3);
  EXPECT_EQ(model.legs[3].mirror, 0);
  EXPECT_EQ(model.legs[1].mirror, -1);
  EXPECT_EQ(With("mirror_pairs: []").legs[0].mirror, -1);
  ExpectSays(NotesOf(model),
             {"'A_foot' and 'D_foot' mirror each other: robot.yaml", "leg 'B_foot' has no mirrored leg"});
}

TEST(RobotYaml, RefusesPairsThatAreNone) {
  ExpectSays(ReasonRefused("mirror_pairs: A_foot"), {"'mirror_pairs' is a single value"});
  ExpectSays(ReasonRefused("mirror_pairs: [[A_foot]]"), {"has 1 feet; two are needed"});
  ExpectSays(ReasonRefused("mirror_pairs: [[A_foot, A_foot]]"), {"paired with itself"});
  ExpectSays(ReasonRefused("mirror_pairs:\n- [A_foot, B_foot]\n- [A_foot, C_foot]"),
             {"line 3", "'A_foot' is in two pairs"});
  ExpectSays(ReasonRefused("mirror_pairs: [[A_foot, E_foot]]"), {"no foot 'E_foot'"});
}

TEST(RobotYaml, StandingPositionsAndTheirHeight) {
  std::string all = "standing: {";
  for (const std::string leg : {"A", "B", "C", "D"}) all += leg + "_hip: 0.5, " + leg + "_knee: -1.0, ";
  all += "}\n";
  const double height = 0.2 * std::cos(0.5) + 0.2 * std::cos(0.5) + 0.02;
  const RobotModel model = With(all);
  EXPECT_EQ(model.standing_joints[model.DofIndex("A_hip")], 0.5);
  EXPECT_NEAR(model.standing_base_height_m, height, 1e-12);
  EXPECT_NEAR(With(all + "standing_base_height_m: 0.372").standing_base_height_m, 0.372, 1e-12);
  ExpectSays(ReasonRefused(all + "standing_base_height_m: 0.5"), {"line 2", "is 0.5", "0.3710 m", "129.0 mm off"});
  // One knee is straighter, so its foot is lower and the other feet do not touch the ground.
  ExpectSays(ReasonRefused(Replaced(all, "C_knee: -1.0", "C_knee: -0.9")),
             {"foot 'A_foot' is", "mm above foot 'C_foot'", "5 mm"});
  ExpectSays(ReasonRefused("standing_base_height_m: -1"), {"'standing_base_height_m' is -1"});
}

TEST(RobotYaml, RefusesStandingThatCannotBe) {
  ExpectSays(ReasonRefused("standing: 3"), {"'standing' is a single value"});
  ExpectSays(ReasonRefused("standing: {A_knee: bent}"), {"'A_knee' is 'bent'; a number is needed"});
  ExpectSays(ReasonRefused("standing:\n  A_knee: .inf"), {"line 2", "finite"});
  ExpectSays(ReasonRefused("standing: {A_knee: 1.5}"), {"1.5", "'A_knee' is outside its limits -2 to 1"});
  ExpectSays(MessageOf(FourLegsWhere("A", "<mimic joint='B_knee'/>"), "standing: {A_knee: -1}"),
             {"'A_knee' mimics another", "name 'B_knee'"});
}

TEST(RobotYaml, GainsAndOwnSpeed) {
  const RobotModel model = With(
      "gains: {A_knee: {stiffness_nm_rad: 120, damping_nm_s_rad: 3}, B_knee: {damping_nm_s_rad: 4}}\n"
      "nominal_speed_m_s: 0.4");
  EXPECT_EQ(model.stiffness[model.DofIndex("A_knee")], 120.0);
  EXPECT_EQ(model.damping[model.DofIndex("A_knee")], 3.0);
  EXPECT_EQ(model.stiffness[model.DofIndex("B_knee")], 0.0);
  EXPECT_EQ(model.nominal_speed_m_s, 0.4);
  ExpectSays(NotesOf(model),
             {"gains of 'A_knee', 'B_knee': from robot.yaml", "default speed 0.400 m/s: from robot.yaml"});
  const Result<RobotModel> sliding = LoadRobotFromText(Sliding(), "gains: {A_knee: {stiffness_n_m: 900}}");
  ASSERT_TRUE(sliding.ok()) << sliding.failure().message;
  EXPECT_EQ(sliding->stiffness[sliding->DofIndex("A_knee")], 900.0);
}

TEST(RobotYaml, KeysOfMotorsThatAreNearAreThoseOfEitherKindOfJoint) {
  ExpectSays(ReasonRefused("motors: {A_knee: {jerk: 5}}"),
             {"unknown key 'jerk'", "nearest are 'jerk_rad_s3', 'jerk_m_s3'"});
  ExpectSays(ReasonRefused("motors: {A_knee: {jerk_m_s3: 5}}"), {"'A_knee' is revolute", "_rad_s3"});
  ExpectSays(MessageOf(Sliding(), "motors: {A_knee: {jerk_rad_s3: 5}}"), {"'A_knee' is prismatic", "_m_s3"});
}

TEST(RobotYaml, RefusesGainsAndSpeedsThatCannotBe) {
  ExpectSays(ReasonRefused("gains: 5"), {"'gains' is a single value"});
  ExpectSays(ReasonRefused("gains: {A_knee: 5}"), {"the gains of 'A_knee' is a single value"});
  ExpectSays(ReasonRefused("gains: {A_knee: {stiffness: 5}}"),
             {"unknown key 'stiffness'", "nearest are 'stiffness_nm_rad', 'stiffness_n_m'"});
  ExpectSays(ReasonRefused("gains: {A_knee: {stiffness_nm_rad: -5}}"), {"'stiffness_nm_rad' is -5", "above 0"});
  ExpectSays(ReasonRefused("gains: {A_knee: {stiffness_n_m: 5}}"), {"'A_knee' is revolute"});
  ExpectSays(ReasonRefused("gains: {A_kneee: {stiffness_nm_rad: 5}}"),
             {"no moving joint 'A_kneee'", "nearest is 'A_knee'"});
  ExpectSays(ReasonRefused("nominal_speed_m_s: 0"), {"'nominal_speed_m_s' is 0"});
  ExpectSays(ReasonRefused("nominal_speed_m_s: fast"), {"'fast'; a number is needed"});
}

TEST(RobotYaml, RefusesWhatIsNoMapOfKnownKeysOnce) {
  ExpectSays(ReasonRefused("3"), {"the file is a single value", "a map"});
  ExpectSays(ReasonRefused("name: a\nname: b"), {"line 2", "the key 'name' twice"});
  ExpectSays(ReasonRefused("standing:\n  A_hip: 0\n  A_hip: 1"), {"line 3", "'standing' has the key 'A_hip' twice"});
  ExpectSays(ReasonRefused("name: a\nstandin: {}"), {"line 2", "unknown key 'standin'", "nearest is 'standing'"});
  ExpectSays(ReasonRefused("name: ''"), {"'name' is empty"});
  ExpectSays(ReasonRefused("name: a\n---\nname: b"), {"second YAML document"});
  ExpectSays(ReasonRefused("[a]: 3"), {"a key of the file is a list"});
  for (const char* broken : {"a: [1", "a: 'b", "\tname: a", "a: b: c", "&"}) {
    const std::string message = ReasonRefused(broken);
    ExpectSays(message, {"robot.yaml, line", "column", "not YAML"});
    EXPECT_EQ(message.find("yaml-cpp"), std::string::npos);
  }
  EXPECT_EQ(ReasonRefused(""), "");
  EXPECT_EQ(ReasonRefused("# nothing\n"), "");
}

/// Adds the keys of an object and of the objects in it.
void AddKeys(const DataShape& shape, std::vector<std::string>& keys) {
  for (const ShapeMember& member : shape.members) {
    keys.push_back(member.key);
    AddKeys(member.shape, keys);
  }
  for (const DataShape& of : shape.of) AddKeys(of, keys);
}

TEST(RobotYaml, EveryKeyStandsInItsPageOfTheHandbook) {
  const std::string page = ReadFile(SourceFolder() + "/docs/robot-yaml.md").value();
  std::vector<std::string> keys;
  AddKeys(RobotYamlShape(), keys);
  EXPECT_GT(keys.size(), 40U);
  for (const std::string& key : keys) EXPECT_NE(page.find('`' + key + '`'), std::string::npos) << key;
}

TEST(RobotYaml, TheExampleOfItsPageIsGood) {
  const std::string source = SourceFolder();
  const std::string page = ReadFile(source + "/docs/robot-yaml.md").value();
  const std::string opening = "```yaml file=goat/robot.yaml\n";
  const std::size_t begin = page.find(opening) + opening.size(), end = page.find("```", begin);
  ASSERT_LT(end, page.size());
  const Result<RobotModel> model =
      LoadRobotFromText(ReadFile(source + "/examples/robots/goat.urdf").value(), page.substr(begin, end - begin));
  ASSERT_TRUE(model.ok()) << model.failure().message;
  EXPECT_EQ(model->name, "my_goat");
}

}  // namespace
}  // namespace gaitwright
