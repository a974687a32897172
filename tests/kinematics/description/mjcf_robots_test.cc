// SPDX-License-Identifier: BSD-3-Clause
// Made-up robots in the style of MuJoCo's models of robots: classes for kinds of joints and geoms, given inertias,
// visual meshes, primitive collision shapes, a keyframe with the standing posture.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "kinematics/model/leg_plane.h"
#include "kinematics/model/passive_joints.h"
#include "kinematics/spatial/convex_hull.h"
#include "tests/built_paths.h"
#include "tests/kinematics/description/mjcf_texts.h"

namespace gaitwright {
namespace {

/// A leg of a quadruped: abduction, hip, knee; a ball as foot.
std::string DogLeg(const std::string& name, double x, double side) {
  return fmt::format(R"(
      <body name="{0}_hip" pos="{1} {2} 0">
        <inertial pos="0 {3} 0" quat="0.5 0.5 0.5 0.5" mass="0.6" diaginertia="0.0008 0.0006 0.0005"/>
        <joint name="{0}_abduct" class="abduct"/>
        <geom class="visual" mesh="hip"/>
        <geom class="touch" type="cylinder" size="0.04 0.02" quat="1 1 0 0" pos="0 {4} 0"/>
        <body name="{0}_thigh" pos="0 {4} 0">
          <inertial pos="0 {3} -0.03" mass="1.1" diaginertia="0.006 0.0055 0.0009"/>
          <joint name="{0}_swing" class="swing"/>
          <geom class="visual" mesh="thigh"/>
          <geom class="touch" type="box" size="0.1 0.012 0.016" pos="0 0 -0.1" euler="0 90 0"/>
          <body name="{0}_shank" pos="0 0 -0.2">
            <inertial pos="0 0 -0.11" mass="0.25" diaginertia="0.0014 0.0014 0.00006"/>
            <joint name="{0}_knee" class="knee"/>
            <geom class="visual" mesh="shank"/>
            <geom class="touch" type="capsule" size="0.012" fromto="0 0 0 0 0 -0.18"/>
            <geom name="{0}" class="foot"/>
            <site name="{0}_site" pos="0 0 -0.21"/>
          </body>
        </body>
      </body>)",
                     name, x, 0.05 * side, -0.01 * side, 0.09 * side);
}

std::string Dog() {
  std::string legs, motors;
  for (const std::string name : {"fl", "fr", "rl", "rr"}) {
    legs += DogLeg(name, name[0] == 'f' ? 0.19 : -0.19, name[1] == 'l' ? 1.0 : -1.0);
    motors += fmt::format(
        "<motor class='abduct' name='{0}_a' joint='{0}_abduct'/><motor class='swing' name='{0}_s' joint='{0}_swing'/>"
        "<motor class='knee' name='{0}_k' joint='{0}_knee'/>",
        name);
  }
  return R"(<mujoco model="dog">
  <compiler angle="degree" meshdir="assets"/>
  <option cone="elliptic" impratio="100"/>
  <default>
    <default class="dog">
      <geom friction="0.7" margin="0.001" condim="1"/>
      <joint axis="0 1 0" damping="1" armature="0.011" frictionloss="0.2"/>
      <motor ctrlrange="-25 25"/>
      <default class="abduct"><joint axis="1 0 0" range="-50 50"/></default>
      <default class="swing"><joint range="-80 210"/></default>
      <default class="knee"><joint range="-155 -45"/><motor gear="2" ctrlrange="-22 22"/></default>
      <default class="visual"><geom type="mesh" contype="0" conaffinity="0" group="2"/></default>
      <default class="touch">
        <geom group="3"/>
        <default class="foot"><geom size="0.021" pos="0 0 -0.21" priority="1" condim="6"/></default>
      </default>
    </default>
  </default>
  <asset>
    <material name="grey" rgba="0.6 0.6 0.6 1"/>
    <mesh file="trunk.obj"/> <mesh file="hip.obj"/> <mesh file="thigh.obj"/> <mesh file="shank.obj"/>
  </asset>
  <worldbody>
    <light pos="0 0 3"/>
    <geom name="floor" type="plane" size="0 0 0.05"/>
    <body name="trunk" pos="0 0 0.4" childclass="dog">
      <freejoint/>
      <inertial pos="0.01 0 0" mass="7" fullinertia="0.03 0.09 0.1 0.0001 0.0002 0.0003"/>
      <geom class="visual" mesh="trunk"/>
      <geom class="touch" type="box" size="0.19 0.05 0.06"/>
      <camera name="track" mode="trackcom"/>)" +
         legs + R"(
    </body>
  </worldbody>
  <actuator>)" +
         motors + R"(</actuator>
  <sensor><gyro site="fl_site"/></sensor>
  <keyframe>
    <key name="home" qpos="0 0 0.3 1 0 0 0 0 0.8 -1.6 0 0.8 -1.6 0 0.8 -1.6 0 0.8 -1.6"/>
  </keyframe>
</mujoco>
)";
}

RobotModel LoadedModel(const ConvertedMjcf& converted) {
  const Result<RobotModel> model = LoadRobotFromText(converted.urdf, converted.yaml);
  EXPECT_TRUE(model.ok()) << (model.ok() ? "" : model.failure().message);
  return model.ok() ? *model : RobotModel();
}

TEST(MjcfRobots, AQuadrupedStandsOnFourFeet) {
  const ConvertedMjcf converted = Converted(Dog());
  const RobotModel model = LoadedModel(converted);
  EXPECT_EQ(model.name, "dog");
  ASSERT_EQ(model.legs.size(), 4U);
  EXPECT_EQ(model.num_dofs(), 12);
  EXPECT_EQ(model.feet[0].link, "fl_shank");
  for (const Foot& foot : model.feet) {
    EXPECT_EQ(foot.type, FootType::kSphere) << foot.name;
    EXPECT_DOUBLE_EQ(foot.radius, 0.021) << foot.name;
  }
  EXPECT_EQ(model.legs[0].mirror, 1);
  EXPECT_NEAR(model.total_mass_kg, 7.0 + 4.0 * (0.6 + 1.1 + 0.25), 1e-12);
  EXPECT_EQ(model.standing_joints[model.DofIndex("rr_knee")], -1.6);
  EXPECT_NEAR(model.standing_base_height_m, 0.2 * std::cos(0.8) + 0.21 * std::cos(0.8) + 0.021, 1e-9);
  const int knee = model.DofIndex("fl_knee");
  EXPECT_DOUBLE_EQ(model.dof_effort_limit(knee), 44.0);
  EXPECT_DOUBLE_EQ(model.dof_effort_limit(model.DofIndex("fl_swing")), 25.0);
  EXPECT_TRUE(std::isinf(model.dof_velocity_limit(knee)));
  EXPECT_NEAR(model.dof_lower(knee), -155.0 * 3.141592653589793 / 180.0, 1e-12);
  EXPECT_EQ(model.MotorOf(knee).rotor_inertia, 0.011);
  EXPECT_EQ(model.LeaderOf(knee).damping, 1.0);
  EXPECT_EQ(model.LeaderOf(knee).friction, 0.2);
  ExpectSays(converted.urdf, {"<mesh filename=\"assets/thigh.obj\"/>"});
  // The meshes are visual only.
  EXPECT_EQ(model.collision_shapes.size(), 1U + 4U * 4U);
  EXPECT_TRUE(model.missing_meshes.empty());
}

/// A leg of a biped: hip yaw, roll and pitch in one body each, knee, ankle pitch and roll; four capsules under a sole.
std::string WalkerLeg(const std::string& side, double y) {
  return fmt::format(R"(
      <body name="{0}_hip" pos="0 {1} -0.1">
        <inertial pos="0 0 0" mass="0.8" diaginertia="0.002 0.002 0.002"/>
        <joint name="{0}_yaw" axis="0 0 1" range="-0.6 0.6"/>
        <body name="{0}_roll_link">
          <inertial pos="0 0 0" mass="0.8" diaginertia="0.002 0.002 0.002"/>
          <joint name="{0}_roll" axis="1 0 0" range="-0.5 0.5"/>
          <body name="{0}_thigh">
            <inertial pos="0 0 -0.15" mass="4" diaginertia="0.05 0.05 0.008"/>
            <joint name="{0}_pitch" axis="0 1 0" range="-1.6 1.2"/>
            <geom class="collision" type="capsule" size="0.05" fromto="0 0 -0.05 0 0 -0.3"/>
            <body name="{0}_shin" pos="0 0 -0.35">
              <inertial pos="0 0 -0.15" mass="2.5" diaginertia="0.03 0.03 0.004"/>
              <joint name="{0}_knee" axis="0 1 0" range="-0.05 2.2"/>
              <geom class="collision" type="capsule" size="0.04" fromto="0 0 -0.05 0 0 -0.28"/>
              <body name="{0}_foot" pos="0 0 -0.35">
                <inertial pos="0.02 0 -0.03" mass="0.9" diaginertia="0.001 0.003 0.003"/>
                <joint name="{0}_ankle" axis="0 1 0" range="-0.9 0.6"/>
                <joint name="{0}_ankle_roll" axis="1 0 0" range="-0.3 0.3"/>
                <geom class="collision" type="box" size="0.11 0.05 0.015" pos="0.03 0 -0.045"/>
              </body>
            </body>
          </body>
        </body>
      </body>)",
                     side, y);
}

std::string WalkerArm(const std::string& side, double y) {
  return fmt::format(R"(
      <body name="{0}_upper_arm" pos="0 {1} 0.25">
        <inertial pos="0 0 -0.1" mass="1.2" diaginertia="0.008 0.008 0.001"/>
        <joint name="{0}_shoulder" axis="0 1 0" range="-2.5 1.5"/>
        <geom class="collision" type="capsule" size="0.035" fromto="0 0 -0.04 0 0 -0.2"/>
        <body name="{0}_forearm" pos="0 0 -0.24">
          <inertial pos="0 0 -0.08" mass="0.7" diaginertia="0.004 0.004 0.0005"/>
          <joint name="{0}_elbow" axis="0 1 0" range="-2 0"/>
          <geom class="collision" type="ellipsoid" size="0.03 0.03 0.1" pos="0 0 -0.1"/>
        </body>
      </body>)",
                     side, y);
}

std::string Walker() {
  std::string motors;
  for (const std::string side : {"l", "r"}) {
    for (const std::string joint : {"yaw", "roll", "pitch", "knee", "ankle", "ankle_roll"})
      motors += fmt::format("<position name='{0}_{1}' joint='{0}_{1}' kp='{2}' forcerange='-150 150'/>", side, joint,
                            joint == "knee" ? 300 : 200);
    for (const std::string joint : {"shoulder", "elbow"})
      motors += fmt::format("<position name='{0}_{1}' joint='{0}_{1}' kp='40' forcerange='-25 25'/>", side, joint);
  }
  return R"(<mujoco model="walker">
  <compiler angle="radian"/>
  <default>
    <joint damping="0.8" armature="0.02"/>
    <default class="collision"><geom group="3"/></default>
  </default>
  <worldbody>
    <body name="pelvis" pos="0 0 0.9">
      <freejoint name="root"/>
      <inertial pos="0 0 0.1" mass="12" diaginertia="0.25 0.2 0.15"/>
      <geom class="collision" type="box" size="0.08 0.13 0.15" pos="0 0 0.12"/>)" +
         WalkerLeg("l", 0.09) + WalkerLeg("r", -0.09) + WalkerArm("l", 0.2) + WalkerArm("r", -0.2) + R"(
    </body>
  </worldbody>
  <actuator>)" +
         motors + R"(</actuator>
</mujoco>
)";
}

TEST(MjcfRobots, ABipedStandsOnTwoSoles) {
  const RobotModel model = LoadedModel(Converted(Walker()));
  ASSERT_EQ(model.legs.size(), 2U);
  EXPECT_EQ(model.num_dofs(), 16);
  EXPECT_EQ(model.feet[0].link, "l_foot");
  for (const Foot& foot : model.feet) {
    EXPECT_EQ(foot.type, FootType::kSole) << foot.name;
    EXPECT_NEAR(Area(foot.sole_F), 0.22 * 0.1, 1e-9) << foot.name;
  }
  EXPECT_EQ(model.legs[0].joints.size(), 6U);
  EXPECT_EQ(model.legs[0].mirror, 1);
  EXPECT_EQ(model.dof_effort_limit(model.DofIndex("l_knee")), 150.0);
  EXPECT_EQ(model.stiffness[model.DofIndex("l_knee")], 300.0);
  EXPECT_GT(model.standing_base_height_m, 0.8);
}

TEST(MjcfRobots, PassiveJointsAreLoadedWithoutMotor) {
  const std::string text = Replaced(Walker(), "<position name='l_elbow'", "<position name='other' class='main'");
  const std::string passive = Replaced(text, "joint='l_elbow'", "joint='r_elbow'");
  const RobotModel model = LoadedModel(Converted(passive));
  EXPECT_TRUE(IsPassive(model, model.DofIndex("l_elbow")));
  EXPECT_EQ(model.dof_effort_limit(model.DofIndex("r_elbow")), 50.0);
}

TEST(MjcfRobots, AKeyframeWithStraightLegsIsLeftForAPostureWithBentKnees) {
  const std::string file = SourceFolder() + "/tests/robots/made/mjcf_waist/robot.xml";
  const Result<RobotModel> model = LoadRobot(file);
  ASSERT_TRUE(model.ok()) << model.failure().message;
  ASSERT_EQ(model->legs.size(), 2U);
  for (const Leg& leg : model->legs) {
    const Foot& foot = model->feet[static_cast<std::size_t>(leg.foot)];
    EXPECT_GT(std::abs(KneeBend(*model, leg, foot, model->standing_joints)), 0.3);
  }
  EXPECT_TRUE(std::any_of(model->findings.begin(), model->findings.end(), [](const Finding& finding) {
    return finding.code == FailureCode::kMjcf && finding.message.find("straight in its keyframe") != std::string::npos;
  }));
}

}  // namespace
}  // namespace gaitwright
