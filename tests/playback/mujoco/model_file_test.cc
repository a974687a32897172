// SPDX-License-Identifier: BSD-3-Clause
// The files that are written for other programs are read by MuJoCo itself, and the robot stands in them.
#include "playback/mjcf/model_file.h"

#include <gtest/gtest.h>

#include <cmath>

#include "kinematics/dynamics/dynamics.h"
#include "kinematics/model/load_robot.h"
#include "playback/control/gains.h"
#include "playback/mujoco/compiled_internal.h"
#include "tests/scratch_folder.h"

namespace gaitwright {
namespace {

class ModelFileTest : public testing::TestWithParam<const char*> {
 protected:
  /// Writes the files and has MuJoCo read them.
  mujoco::ModelPtr Read(const Terrain& terrain) const {
    const Gains gains = DeriveGains(model_);
    const std::string path = ScratchFile(model_.name + "_model_file.xml");
    const auto written = WriteFilesTogether(
        MujocoFiles(model_, terrain, StandingConfiguration(model_), gains.stiffness, gains.damping, path));
    EXPECT_TRUE(written.ok());
    char error[500] = "";
    mujoco::ModelPtr read(mj_loadXML(path.c_str(), nullptr, error, sizeof error));
    EXPECT_NE(read, nullptr) << error;
    return read;
  }

  const RobotModel model_ = *LoadNamedRobot(GetParam());
};

TEST_P(ModelFileTest, HasTheRobotsMassJointsAndMotors) {
  const mujoco::ModelPtr m = Read(FlatTerrain());
  ASSERT_NE(m, nullptr);
  EXPECT_NEAR(mj_getTotalmass(m.get()), model_.total_mass_kg, 1e-6 * model_.total_mass_kg);
  EXPECT_EQ(m->nv, 6 + static_cast<int>(model_.joints.size()));
  EXPECT_EQ(m->nu, model_.num_dofs());
  for (int dof = 0; dof < model_.num_dofs(); ++dof) {
    const std::string& name = model_.dof_names[static_cast<std::size_t>(dof)];
    const int joint = mujoco::IdOf(*m, mjOBJ_JOINT, name);
    ASSERT_GE(joint, 0) << name;
    EXPECT_NEAR(m->actuator_forcerange[2 * dof + 1], model_.dof_effort_limit(dof), 1e-9) << name;
    EXPECT_NEAR(m->jnt_range[2 * joint],
                model_.joints[static_cast<std::size_t>(model_.dof_joint[static_cast<std::size_t>(dof)])].lower, 1e-9)
        << name;
  }
}

TEST_P(ModelFileTest, StandsFromTheKeyFrame) {
  const mujoco::ModelPtr m = Read(FlatTerrain());
  ASSERT_NE(m, nullptr);
  const mujoco::DataPtr d(mj_makeData(m.get()));
  mj_resetDataKeyframe(m.get(), d.get(), 0);
  const double height = d->qpos[2];
  EXPECT_NEAR(height, StandingConfiguration(model_)[2], 1e-12);
  for (int k = 0; k < 1000; ++k) mj_step(m.get(), d.get());
  EXPECT_GT(d->qpos[2], 0.9 * height);
  EXPECT_GT(std::abs(d->qpos[3]), std::cos(0.5 * 0.2)) << "tilted by more than 0.2 rad";
}

TEST_P(ModelFileTest, HasHeightFieldsInFilesOfTheirOwn) {
  Terrain rough;
  HeightField field;
  field.columns = 4;
  field.rows = 3;
  field.resolution_m = 0.5;
  field.origin_W = Vector2(-1.0, -0.5);
  field.height_m = {0.0, 0.1, 0.0, 0.2, 0.0, 0.0, 0.0, 0.0, 0.3, 0.0, 0.0, 0.0};
  rough.height_fields = {field};
  const mujoco::ModelPtr m = Read(rough);
  ASSERT_NE(m, nullptr);
  ASSERT_EQ(m->nhfield, 1);
  EXPECT_EQ(m->hfield_nrow[0] * m->hfield_ncol[0], 12);
  EXPECT_NEAR(m->hfield_size[2], 0.3, 1e-9);
  double sum = 0.0;
  for (int i = 0; i < 12; ++i) sum += 0.3 * static_cast<double>(m->hfield_data[i]);
  EXPECT_NEAR(sum, 0.6, 1e-6);
}

INSTANTIATE_TEST_SUITE_P(Robots, ModelFileTest, testing::Values("a1", "h1", "mini_cheetah"),
                         [](const auto& robot) { return std::string(robot.param); });

}  // namespace
}  // namespace gaitwright
