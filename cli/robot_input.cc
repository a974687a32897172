// SPDX-License-Identifier: BSD-3-Clause
#include "cli/robot_input.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "cli/flags.h"
#include "kinematics/base/file.h"
#include "kinematics/model/draft_yaml.h"

namespace gaitwright::cli {
namespace {

constexpr char kDraft[] = "robot.draft.yaml";

/// Writes a draft of robot.yaml and adds a hint that says so to the failure.
void AddDraft(const RobotFlags& flags, Failure& failure) {
  const Result<RobotDescription> description = ReadDescription(flags.file, flags.loading);
  const std::string draft = description ? DraftRobotYaml(description->urdf, failure) : "";
  std::error_code error;
  if (draft.empty() || std::filesystem::exists(kDraft, error)) return;
  if (!WriteFileAtomically(kDraft, draft)) return;
  failure.suggestions.push_back(
      fmt::format("a draft of the required robot.yaml was written to '{}': correct it and save it beside the robot "
                  "description as robot.yaml",
                  kDraft));
}

}  // namespace

std::vector<Flag> RobotFlags::AddTo(Verb verb, const std::string& text) {
  const Flag named = AddText(verb, "--robot", "NAME", name, text);
  const Flag urdf = AddText(verb, "--urdf", "FILE", file, "Your own URDF or xacro file; default none.");
  const Flag mjcf = AddText(verb, "--mjcf", "FILE", file, "Your own MJCF (MuJoCo) file; default none.");
  named.Exclude(urdf).Exclude(mjcf);
  urdf.Exclude(mjcf);
  AddLoadingTo(verb);
  return {named, urdf, mjcf};
}

void RobotFlags::AddLoadingTo(Verb verb) {
  verb.AddSwitch("--strict", loading.strict, "Refuse a robot description that would need a repair.");
  const auto add = [&](const char* flag, const char* type, auto& target, const char* help) {
    verb.AddReader(
            flag,
            [&target, flag, type](const std::string& text) {
              const std::size_t equals = text.find('=');
              if (equals == 0 || equals == std::string::npos)
                throw InvalidArgument(fmt::format("{}: '{}' is not {}", flag, text, type));
              target.insert_or_assign(text.substr(0, equals), text.substr(equals + 1));
            },
            help)
        .SetType(type)
        .Repeat();
  };
  add("--package", "NAME=DIR", loading.packages,
      "Folder of package NAME, for package://NAME and $(find NAME); default: searched for.");
  add("--xacro-arg", "NAME=VALUE", loading.xacro_arguments,
      "Value of an argument of a xacro file; default: as in the file.");
}

std::string RobotFlags::folder() const { return std::filesystem::path(file).parent_path().string(); }

void RobotFlags::AddTo(Paths& paths) const {
  if (file.empty()) return;
  const std::string ending = EndingOf(file);
  const std::string flag = ending == ".xml" || ending == ".mjcf" ? "--mjcf" : "--urdf";
  paths.Read(flag, file);
  paths.Read("the robot.yaml beside " + flag, (std::filesystem::path(file).parent_path() / "robot.yaml").string());
}

Result<RobotModel> ReadRobot(const RobotFlags& flags) {
  if (!flags.is_file()) return LoadNamedRobot(flags.name);
  Result<RobotModel> model = LoadRobot(flags.file, flags.loading);
  if (model || !WantsRobotYaml(model.failure())) return model;
  Failure failure = model.failure();
  AddDraft(flags, failure);
  return failure;
}

Failure WithDraft(Failure failure, const RobotFlags& flags, const RobotModel& model) {
  const bool unknown = std::any_of(model.feet.begin(), model.feet.end(), [&](const Foot& foot) {
    return std::none_of(model.collision_shapes.begin(), model.collision_shapes.end(),
                        [&](const Shape& shape) { return shape.body == foot.body; });
  });
  if (flags.is_file() && unknown && failure.code == FailureCode::kNoSupport) AddDraft(flags, failure);
  return failure;
}

}  // namespace gaitwright::cli
