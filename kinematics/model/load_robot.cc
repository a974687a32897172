// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/load_robot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <limits>

#include "kinematics/base/file.h"
#include "kinematics/base/hash.h"
#include "kinematics/base/options.h"
#include "kinematics/model/build_model.h"
#include "kinematics/model/derive_legs.h"
#include "kinematics/model/robot_yaml.h"
#include "kinematics/model/urdf_check.h"

namespace gaitwright {
namespace {

namespace fs = std::filesystem;

Failure BadInput(const std::string& code, const std::string& message) {
  return {FailureKind::kBadInput, code, "LoadRobot", message, {}};
}

VectorX GivenPosture(const RobotModel& model, const RobotYaml& yaml) {
  VectorX given = VectorX::Constant(model.num_dofs(), std::numeric_limits<double>::quiet_NaN());
  for (const auto& [joint, position] : yaml.standing) {
    const int dof = model.DofIndex(joint);
    if (position < model.dof_lower(dof) || position > model.dof_upper(dof)) {
      throw InvalidArgument(fmt::format("robot.yaml: standing position {} of joint '{}' is outside its limits {} to {}",
                                        position, joint, model.dof_lower(dof), model.dof_upper(dof)));
    }
    given[dof] = position;
  }
  return given;
}

Result<RobotModel> Load(const std::string& urdf_text, const std::string& yaml_text, const std::string& name) {
  if (const auto failure = CheckUrdf(urdf_text)) return *failure;
  const RobotYaml yaml = ParseRobotYaml(yaml_text);
  Result<RobotModel> built = BuildModel(SplitUrdf(urdf_text), name);
  if (!built) return built;
  RobotModel model = std::move(*built);
  model.name = yaml.name.empty() ? name : yaml.name;
  const Result<int> legs = DeriveLegs(model, yaml.feet, GivenPosture(model, yaml));
  if (!legs) return legs.failure();
  if (yaml.standing_base_height_m) model.standing_base_height_m = *yaml.standing_base_height_m;
  if (yaml.nominal_speed_m_s) model.nominal_speed_m_s = *yaml.nominal_speed_m_s;
  for (const auto& [joint, gains] : yaml.gains) {
    model.stiffness[model.DofIndex(joint)] = gains.stiffness;
    model.damping[model.DofIndex(joint)] = gains.damping;
  }
  model.urdf_text = urdf_text;
  model.yaml_text = yaml_text;
  model.hash = HexHash(urdf_text + '\0' + yaml_text);
  return model;
}

std::string RobotsFolder() {
  if (const char* folder = std::getenv("GAITWRIGHT_ROBOTS")) return folder;
  std::error_code error;
  if (fs::is_directory(GAITWRIGHT_SOURCE_ROBOTS, error)) return GAITWRIGHT_SOURCE_ROBOTS;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  const fs::path beside = program.parent_path().parent_path() / "share/gaitwright/robots";
  if (!error && fs::is_directory(beside, error)) return beside.string();
  return GAITWRIGHT_INSTALLED_ROBOTS;
}

}  // namespace

Result<RobotModel> LoadRobotFromText(const std::string& urdf_text, const std::string& yaml_text,
                                     const std::string& name) {
  try {
    return Load(urdf_text, yaml_text, name);
  } catch (const InvalidArgument& error) {
    return BadInput("robot_yaml", error.what());
  }
}

Result<RobotModel> LoadRobot(const std::string& urdf_path, const std::string& yaml_path) {
  const Result<std::string> urdf = ReadFile(urdf_path);
  if (!urdf) return urdf.failure();
  const fs::path folder = fs::path(urdf_path).parent_path();
  std::string yaml_text;
  std::error_code error;
  if (yaml_path.empty() ? fs::exists(folder / "robot.yaml", error) : yaml_path != "none") {
    const Result<std::string> yaml = ReadFile(yaml_path.empty() ? (folder / "robot.yaml").string() : yaml_path);
    if (!yaml) return yaml.failure();
    yaml_text = *yaml;
  }
  const std::string stem = fs::path(urdf_path).stem().string();
  return LoadRobotFromText(*urdf, yaml_text,
                           stem == "robot" && folder.has_filename() ? folder.filename().string() : stem);
}

std::vector<std::string> RobotNames() {
  std::vector<std::string> names;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(RobotsFolder(), error)) {
    if (fs::exists(entry.path() / "robot.urdf", error)) names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

Result<RobotModel> LoadNamedRobot(const std::string& name) {
  const std::vector<std::string> names = RobotNames();
  if (std::find(names.begin(), names.end(), name) == names.end()) {
    return BadInput("unknown_robot",
                    fmt::format("there is no robot '{}'; there are {}; a URDF of your own goes with --urdf FILE", name,
                                QuotedList(names)));
  }
  return LoadRobot((fs::path(RobotsFolder()) / name / "robot.urdf").string());
}

}  // namespace gaitwright
