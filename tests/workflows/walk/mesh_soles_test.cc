// SPDX-License-Identifier: BSD-3-Clause
// A biped with mesh soles instead of boxes is the same robot: it has the same feet, and its plan walks, also without
// the mesh files.
#include <gtest/gtest.h>

#include <filesystem>

#include "kinematics/base/file.h"
#include "kinematics/model/load_robot.h"
#include "planning/plan/plan_json.h"
#include "tests/built_paths.h"
#include "tests/kinematics/model/mesh_boxes.h"
#include "workflows/walk/walk.h"

namespace gaitwright {
namespace {

class MeshSoles : public testing::TestWithParam<std::string> {
 protected:
  /// NAO with its soles read from files in a folder that is deleted before this returns.
  static RobotModel FromMeshes() {
    const RobotModel nao = LoadNamedRobot("nao").value();
    const std::string box = "<box size=\"0.157 0.088 0.02\"/>", mesh = "<mesh filename=\"" + GetParam() + "\"/>";
    std::string urdf = nao.urdf_text;
    for (std::size_t at = 0; (at = urdf.find(box, at)) != std::string::npos; at += mesh.size())
      urdf.replace(at, box.size(), mesh);
    EXPECT_NE(urdf, nao.urdf_text);
    const std::string folder =
        BuildFolder() + "/test_files/mesh_soles/" + testing::UnitTest::GetInstance()->current_test_info()->name();
    const Vector3 half(0.0785, 0.044, 0.01);
    WriteFileAtomically(folder + "/" + GetParam(), GetParam() == "sole.stl" ? BinaryStl(half) : Obj(half)).value();
    WriteFileAtomically(folder + "/robot.urdf", urdf).value();
    WriteFileAtomically(folder + "/robot.yaml", nao.yaml_text + "name: nao\n").value();
    Result<RobotModel> model = LoadRobot(folder + "/robot.urdf");
    EXPECT_TRUE(model.ok()) << (model.ok() ? "" : model.failure().message);
    std::filesystem::remove_all(folder);
    return std::move(model).value();
  }
};

INSTANTIATE_TEST_SUITE_P(Files, MeshSoles, testing::Values("sole.stl", "sole.obj"),
                         [](const auto& file) { return file.param.substr(5); });

TEST_P(MeshSoles, AreTheSolesOfTheBoxes) {
  const RobotModel nao = LoadNamedRobot("nao").value(), mesh = FromMeshes();
  ASSERT_EQ(mesh.feet.size(), nao.feet.size());
  for (std::size_t f = 0; f < nao.feet.size(); ++f) {
    EXPECT_EQ(mesh.feet[f].type, FootType::kSole);
    EXPECT_LT((mesh.feet[f].X_BF.matrix() - nao.feet[f].X_BF.matrix()).norm(), 1e-6);
    ASSERT_EQ(mesh.feet[f].sole_F.size(), nao.feet[f].sole_F.size());
    for (std::size_t c = 0; c < nao.feet[f].sole_F.size(); ++c) {
      EXPECT_LT((mesh.feet[f].sole_F[c] - nao.feet[f].sole_F[c]).norm(), 1e-6);
    }
    EXPECT_NE(mesh.feet[f].derived_from.find("mesh '" + GetParam() + "'"), std::string::npos);
  }
  EXPECT_NEAR(mesh.standing_base_height_m, nao.standing_base_height_m, 1e-6);
}

TEST_P(MeshSoles, WalkFromThePlanAlone) {
  const RobotModel model = FromMeshes();
  WalkRequest request;
  request.command.extent = WalkCommand::Extent::kSteps;
  request.command.steps = 4;
  request.command.step_length_m = 0.04;
  const PlannedWalk planned = PlanWalk(model, request).value();
  EXPECT_TRUE(planned.audit.violations.empty());
  const Result<MotionPlan> read = PlanFromJson(PlanToJson(planned.motion.plan), "plan");
  ASSERT_TRUE(read.ok()) << read.failure().message;
  EXPECT_EQ(read->meshes, planned.motion.plan.meshes);
  const Result<RobotModel> again = RobotOf(*read);
  ASSERT_TRUE(again.ok()) << again.failure().message;
  EXPECT_EQ(again->hash, model.hash);
  const PlayRequest usual;
  const StabilityReport report = PlayWalk(*again, *read, usual).value().report;
  EXPECT_TRUE(report.pass) << report.reason;
}

TEST_P(MeshSoles, OfAPlanThatWereChangedAreRefused) {
  const RobotModel model = FromMeshes();
  MotionPlan plan;
  plan.robot = model.name;
  plan.robot_hash = model.hash;
  plan.urdf_text = model.urdf_text;
  plan.yaml_text = model.yaml_text;
  plan.meshes = model.meshes;
  EXPECT_TRUE(RobotOf(plan).ok());
  plan.meshes[0].vertices[0].x() -= 0.01;
  ASSERT_FALSE(RobotOf(plan).ok());
  EXPECT_EQ(RobotOf(plan).failure().code, FailureCode::kRobotHash);
  plan.meshes.clear();
  ASSERT_FALSE(RobotOf(plan).ok());
  EXPECT_NE(RobotOf(plan).failure().message.find(GetParam()), std::string::npos);
}

}  // namespace
}  // namespace gaitwright
