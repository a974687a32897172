// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "kinematics/collision/feet_overlap_internal.h"
#include "kinematics/model/load_robot.h"

namespace gaitwright {
namespace {

/// Bodies "left", "right" and "hand" on slides along x, with a cube of 0.1 m each.
RobotModel ThreeOnSlides() {
  RobotModel model;
  model.bodies = {{"base", 1.0, Vector3::Zero(), Matrix3::Identity()}};
  for (const std::string name : {"left", "right", "hand"}) {
    model.bodies.push_back({name, 1.0, Vector3::Zero(), Matrix3::Identity()});
    Joint slide;
    slide.type = JointType::kPrismatic;
    slide.axis_J = Vector3::UnitX();
    slide.dof = model.num_dofs();
    model.joints.push_back(slide);
    model.dof_joint.push_back(model.num_dofs());
    model.dof_names.push_back(name);
    Shape cube;
    cube.size = Vector3::Constant(0.1);
    cube.body = static_cast<int>(model.bodies.size()) - 1;
    cube.link = name;
    model.collision_shapes.push_back(cube);
  }
  model.standing_joints = Vector3(-1.0, 1.0, 3.0);
  return model;
}

void AddFoot(RobotModel& model, FootType type, int body) {
  Foot foot;
  foot.name = foot.link = model.bodies[static_cast<std::size_t>(body)].name;
  foot.body = body;
  foot.type = type;
  model.feet.push_back(foot);
}

/// With the slides at these positions.
bool OverlapAt(const RobotModel& model, double left_m, double right_m, double hand_m) {
  VectorX q = StandingConfiguration(model);
  q.tail(3) = Vector3(left_m, right_m, hand_m);
  return FeetOverlap(model, q);
}

TEST(FeetOverlap, IsOfTwoFeetAlone) {
  for (const FootType type : {FootType::kSole, FootType::kPoint}) {
    RobotModel model = ThreeOnSlides();
    AddFoot(model, type, 1);
    AddFoot(model, type, 2);
    EXPECT_FALSE(OverlapAt(model, 0.0, 0.11, 3.0));
    EXPECT_TRUE(OverlapAt(model, 0.0, 0.09, 3.0));
    EXPECT_FALSE(OverlapAt(model, 0.0, 1.0, 0.05)) << "a hand moves away";
  }
}

/// All of a sole's body is fixed by its foothold. The shank of a point foot turns about it.
TEST(FeetOverlap, LinksOfTheBodyCountForSoles) {
  for (const FootType type : {FootType::kSole, FootType::kPoint}) {
    RobotModel model = ThreeOnSlides();
    AddFoot(model, type, 1);
    AddFoot(model, type, 2);
    for (Foot& foot : model.feet) {
      foot.link += "_foot";
      foot.X_BF.translation() = Vector3(0.0, 0.0, -0.5);  // far below the cube, which is then not a shape of the foot
    }
    EXPECT_EQ(OverlapAt(model, 0.0, 0.05, 3.0), type == FootType::kSole);
  }
}

}  // namespace
}  // namespace gaitwright
