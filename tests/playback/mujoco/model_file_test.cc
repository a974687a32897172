// SPDX-License-Identifier: BSD-3-Clause
// MuJoCo reads the files that are written for other programs, and the robot stands in them.
#include "playback/mjcf/model_file.h"

#include <gtest/gtest.h>

#include <cmath>

#include "kinematics/base/random.h"
#include "kinematics/dynamics/dynamics.h"
#include "kinematics/model/load_robot.h"
#include "planning/plan/built_in_terrain.h"
#include "playback/control/gains.h"
#include "playback/mujoco/compiled_internal.h"
#include "tests/scratch_folder.h"

namespace gaitwright {
namespace {

class ModelFileTest : public testing::TestWithParam<const char*> {
 protected:
  /// Writes the files and compiles them with MuJoCo.
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

/// MuJoCo's model of a ground that is written alone, or of another file that includes it.
mujoco::ModelPtr ReadGround(const Terrain& terrain, const std::string& including = "") {
  const auto written = WriteFilesTogether(MujocoGroundFiles(terrain, ScratchFile("ground_file.xml")));
  EXPECT_TRUE(written.ok());
  if (!including.empty()) {
    EXPECT_TRUE(WriteFileAtomically(ScratchFile("including.xml"), including).ok());
  }
  const std::string path = ScratchFile(including.empty() ? "ground_file.xml" : "including.xml");
  char error[500] = "";
  mujoco::ModelPtr read(mj_loadXML(path.c_str(), nullptr, error, sizeof error));
  EXPECT_NE(read, nullptr) << error;
  return read;
}

/// Height at which a ray from above meets the ground; -1 without a hit.
double HeightByRay(const mjModel& m, const mjData& d, const Vector2& p) {
  constexpr double kAbove = 20.0;
  const mjtNum from[3] = {p.x(), p.y(), kAbove}, down[3] = {0.0, 0.0, -1.0};
  int geom = -1;
  const double length = mj_ray(&m, &d, from, down, nullptr, 1, -1, &geom);
  return geom < 0 ? -1.0 : kAbove - length;
}

TEST(GroundFile, HasTheHeightsOfEveryBuiltInGround) {
  for (const BuiltInTerrain& entry : BuiltInTerrains()) {
    SCOPED_TRACE(entry.name);
    const Terrain terrain = *MakeTerrain(entry.name, {});
    const mujoco::ModelPtr m = ReadGround(terrain);
    ASSERT_NE(m, nullptr);
    EXPECT_EQ(static_cast<std::size_t>(m->ngeom),
              terrain.obstacles.size() + static_cast<std::size_t>(terrain.num_surfaces()));
    for (const TerrainPatch& patch : terrain.patches) {
      const int geom = mujoco::IdOf(*m, mjOBJ_GEOM, patch.name);
      ASSERT_GE(geom, 0) << patch.name;
      EXPECT_NEAR(m->geom_friction[3 * geom], patch.friction, 1e-12);
    }
    const mujoco::DataPtr d(mj_makeData(m.get()));
    mj_forward(m.get(), d.get());
    SplitMix random(5);
    int compared = 0;
    for (int i = 0; i < 500; ++i) {
      const Vector2 p(-1.0 + 5.0 * random.Uniform(), -1.0 + 2.0 * random.Uniform());
      const GroundPoint ground = GroundAt(terrain, p);
      const double height = HeightByRay(*m, *d, p);
      if (ground.patch < 0 || (!terrain.obstacles.empty() && height > ground.height_m + 0.01)) continue;
      ++compared;
      ASSERT_NEAR(height, ground.height_m, 2e-5) << p.transpose();  // MuJoCo's meshes have 32-bit floats
    }
    EXPECT_GT(compared, 50);
  }
}

TEST(GroundFile, HasCellsPartedByOurDiagonal) {
  Terrain ridge;
  HeightField cell;
  cell.columns = cell.rows = 2;
  cell.resolution_m = 1.0;
  cell.height_m = {1.0, 0.0, 0.0, 1.0};  // the middle is as high as the ends of the diagonal
  ridge.height_fields = {cell};
  ASSERT_NEAR(GroundAt(ridge, {0.5, 0.5}).height_m, 1.0, 1e-12);
  const mujoco::ModelPtr m = ReadGround(ridge, R"(<mujoco><include file="ground_file.xml"/>
<worldbody><body pos="0.5 0.5 1.05"><freejoint/><geom type="sphere" size="0.1"/></body></worldbody></mujoco>)");
  ASSERT_NE(m, nullptr);
  const mujoco::DataPtr d(mj_makeData(m.get()));
  mj_forward(m.get(), d.get());
  ASSERT_GT(d->ncon, 0) << "the ball is over a valley";
  EXPECT_NEAR(d->contact[0].dist, -0.05, 0.005);
}

TEST(GroundFile, IsIncludedInAFileWithOtherDefaults) {
  Terrain terrain;
  terrain.patches = {PatchThrough("ground", {{-1, -1, 0.5}, {1, -1, 0.5}, {1, 1, 0.5}, {-1, 1, 0.5}}, 0.6)};
  terrain.patches.push_back(PatchThrough("ground", {{1, -1, 0.1}, {3, -1, 0.1}, {3, 1, 0.1}, {1, 1, 0.1}}, 0.6));
  HeightField field;
  field.columns = field.rows = 2;
  field.origin_W = Vector2(4.0, 0.0);
  field.resolution_m = 1.0;
  field.height_m = {0.0, 0.1, 0.2, 0.3};
  terrain.height_fields = {field};
  const mujoco::ModelPtr m = ReadGround(terrain, R"(<mujoco model="ball">
<compiler angle="degree"/>
<default><geom contype="0" conaffinity="0" condim="1" friction="0"/><mesh scale="0.001 0.001 0.001"/></default>
<include file="ground_file.xml"/>
<worldbody><body name="ball" pos="0 0 0.7"><freejoint/><geom type="sphere" size="0.05" mass="1" contype="1"/></body></worldbody>
</mujoco>)");
  ASSERT_NE(m, nullptr);
  EXPECT_EQ(m->nhfield, 1);
  EXPECT_EQ(m->ngeom, 4);
  EXPECT_GE(mujoco::IdOf(*m, mjOBJ_GEOM, "ground 2"), 0);
  const mujoco::DataPtr d(mj_makeData(m.get()));
  for (int k = 0; k < 1000; ++k) mj_step(m.get(), d.get());
  EXPECT_NEAR(d->qpos[2], 0.55, 1e-3);
}

}  // namespace
}  // namespace gaitwright
