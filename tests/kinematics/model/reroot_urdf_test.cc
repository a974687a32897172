// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/reroot_urdf.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "kinematics/model/body_tree.h"
#include "kinematics/model/load_robot.h"
#include "tests/kinematics/model/small_urdf.h"
#include "tests/unusual_robots.h"

namespace gaitwright {
namespace {

constexpr double kTurned = 0.3;  // [rad] tilt of a frame between the old and the new root

/// Two legs of four joints with soles. The tree starts at the left sole, and goes up to the body and down to the right
/// sole.
std::string FromTheSole(double right_foot_kg = 0.6) {
  unusual::UrdfText urdf;
  const std::string sole = urdf.Block(0.16, 0.09, 0.02);
  urdf.Link("left_foot", 0.6, 0.1, sole);
  urdf.Link("left_shank", 1.0, 0.2);
  urdf.Link("left_thigh", 1.5, 0.2);
  urdf.Link("left_hip", 0.5, 0.1);
  urdf.Link("body", 10.0, 0.3, urdf.Block(0.2, 0.2, 0.3, -0.2));
  urdf.Joint("left_foot", "left_shank", {0.0, 0.0, 0.05}, {.lower = -0.9, .upper = 0.9, .turned = kTurned});
  urdf.Joint("left_shank", "left_thigh", {0.0, 0.0, 0.25}, {.lower = -2.0, .upper = 0.0, .turned = -kTurned});
  urdf.Joint("left_thigh", "left_hip", {0.0, 0.0, 0.25}, {.lower = -1.5, .upper = 1.5});
  urdf.Joint("left_hip", "body", {0.0, 0.0, 0.02}, {.axis = "1 0 0", .lower = -0.5, .upper = 0.5});
  urdf.Link("right_hip", 0.5, 0.1);
  urdf.Link("right_thigh", 1.5, 0.2);
  urdf.Link("right_shank", 1.0, 0.2);
  urdf.Link("right_foot", right_foot_kg, 0.1, sole);
  urdf.Joint("body", "right_hip", {0.0, -0.2, -0.02}, {.axis = "1 0 0", .lower = -0.5, .upper = 0.5});
  urdf.Joint("right_hip", "right_thigh", {0.0, 0.0, 0.0}, {.lower = -1.5, .upper = 1.5});
  urdf.Joint("right_thigh", "right_shank", {0.0, 0.0, -0.25}, {.lower = 0.0, .upper = 2.0});
  urdf.Joint("right_shank", "right_foot", {0.0, 0.0, -0.25}, {.lower = -0.9, .upper = 0.9});
  return urdf.Done("from_the_sole");
}

Pose PoseOfLink(const RobotModel& model, const VectorX& joints, const std::string& link) {
  const Frame& frame = model.frames[static_cast<std::size_t>(model.FrameIndex(link))];
  return BodyPoses(model, joints)[static_cast<std::size_t>(frame.body)] * frame.X_BF;
}

TEST(RerootFromLimbEnd, TheBodyIsTheBase) {
  const std::optional<RerootedUrdf> rerooted = RerootFromLimbEnd(FromTheSole());
  ASSERT_TRUE(rerooted.has_value());
  EXPECT_EQ(rerooted->root, "body");
  EXPECT_EQ(rerooted->former, "left_foot");
  const Result<RobotModel> model = LoadRobotFromText(FromTheSole(), "feet: [{link: left_foot}, {link: right_foot}]");
  ASSERT_TRUE(model.ok()) << model.failure().message;
  EXPECT_EQ(model->bodies.front().name, "body");
  EXPECT_EQ(model->legs.size(), 2U);
  EXPECT_TRUE(std::any_of(model->findings.begin(), model->findings.end(),
                          [](const Finding& f) { return f.code == FailureCode::kRootOfLimb; }));
}

/// The pose of the right foot relative to the left one is that of the chain in the file, for any base link.
TEST(RerootFromLimbEnd, JointPositionsKeepTheirMeaning) {
  const RobotModel model = LoadRobotFromText(FromTheSole(), "feet: [{link: left_foot}, {link: right_foot}]").value();
  VectorX joints(model.num_dofs());
  for (int dof = 0; dof < model.num_dofs(); ++dof) joints[dof] = 0.3 - 0.07 * dof;
  const auto q = [&](const char* name) { return joints[model.DofIndex(name)]; };
  const auto move = [](double x, double y, double z) { return Pose(Eigen::Translation3d(x, y, z)); };
  const auto turn = [](double angle, const Vector3& axis) { return Pose(Eigen::AngleAxisd(angle, axis)); };
  const Vector3 X = Vector3::UnitX(), Y = Vector3::UnitY(), Z = Vector3::UnitZ();
  const Pose X_LR = move(0, 0, 0.05) * turn(kTurned, Z) * turn(q("left_shank_joint"), Y) * move(0, 0, 0.25) *
                    turn(-kTurned, Z) * turn(q("left_thigh_joint"), Y) * move(0, 0, 0.25) *
                    turn(q("left_hip_joint"), Y) * move(0, 0, 0.02) * turn(q("body_joint"), X) * move(0, -0.2, -0.02) *
                    turn(q("right_hip_joint"), X) * turn(q("right_thigh_joint"), Y) * move(0, 0, -0.25) *
                    turn(q("right_shank_joint"), Y) * move(0, 0, -0.25) * turn(q("right_foot_joint"), Y);
  // The box of the left sole is at the origin of the foot, as in the file.
  const auto box = std::find_if(model.collision_shapes.begin(), model.collision_shapes.end(),
                                [](const Shape& shape) { return shape.link == "left_foot"; });
  ASSERT_NE(box, model.collision_shapes.end());
  const Pose X_OL = BodyPoses(model, joints)[static_cast<std::size_t>(box->body)] * box->X_BS;
  const Pose found = X_OL.inverse() * PoseOfLink(model, joints, "right_foot");
  EXPECT_GT(X_LR.translation().norm(), 0.1);
  EXPECT_TRUE(found.matrix().isApprox(X_LR.matrix(), 1e-9)) << found.matrix() << "\n" << X_LR.matrix();
}

TEST(RerootFromLimbEnd, OtherRootsStay) {
  EXPECT_FALSE(RerootFromLimbEnd(FourLegs()).has_value());
  EXPECT_FALSE(RerootFromLimbEnd(unusual::SoledBiped(true, true)).has_value());
  EXPECT_FALSE(RerootFromLimbEnd(FromTheSole(0.1)).has_value()) << "an arm on its foot ends in a lighter link";
}

}  // namespace
}  // namespace gaitwright
