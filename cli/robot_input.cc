// SPDX-License-Identifier: BSD-3-Clause
#include "cli/robot_input.h"

#include <fmt/format.h>

#include <filesystem>

#include "kinematics/base/file.h"
#include "kinematics/model/draft_yaml.h"
#include "workflows/walk/walk.h"

namespace gaitwright::cli {
namespace {

constexpr char kDraft[] = "robot.draft.yaml";

/// Tells of a draft, once it is there.
void AddDraft(const std::string& urdf, Failure& failure) {
  const Result<std::string> text = ReadFile(urdf);
  const std::string draft = text ? DraftRobotYaml(*text, failure) : "";
  std::error_code error;
  if (draft.empty() || std::filesystem::exists(kDraft, error)) return;
  if (!WriteFileAtomically(kDraft, draft)) return;
  failure.hints.push_back(
      fmt::format("a draft of the robot.yaml that is needed was written to '{}': correct it and put it beside the URDF "
                  "as robot.yaml",
                  kDraft));
}

}  // namespace

Result<RobotModel> ReadRobot(const std::string& name, const std::string& urdf) {
  Result<RobotModel> model = ChooseRobot(name, urdf);
  if (model || urdf.empty() || !WantsRobotYaml(model.failure())) return model;
  Failure failure = model.failure();
  AddDraft(urdf, failure);
  return failure;
}

}  // namespace gaitwright::cli
