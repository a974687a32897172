// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/read_description.h"

#include <fmt/format.h>
#include <tinyxml2.h>
#include <yaml-cpp/yaml.h>

#include <filesystem>
#include <optional>

#include "kinematics/base/file.h"
#include "kinematics/base/text.h"
#include "kinematics/description/mjcf.h"
#include "kinematics/description/xacro.h"
#include "kinematics/model/mesh_file.h"

namespace gaitwright {
namespace {

namespace fs = std::filesystem;

/// The text of a file. Unless `strict`, an encoding other than UTF-8 is accepted.
Result<std::string> ReadText(const std::string& path, bool strict) {
  Result<std::string> text = ReadFile(path);
  if (text || strict || text.failure().code != FailureCode::kNotText) return text;
  Result<std::string> bytes = ReadBytes(path);
  if (!bytes) return bytes;
  const std::optional<std::string> converted = InUtf8(*bytes);
  return converted ? Result<std::string>(*converted) : text;
}

/// The robot.yaml of a description; "" if it has none.
Result<std::string> ReadYaml(const fs::path& folder, const std::string& yaml_path) {
  std::error_code error;
  const std::string path = yaml_path.empty() ? (folder / "robot.yaml").string() : yaml_path;
  if (yaml_path == "none" || (yaml_path.empty() && !fs::exists(path, error))) return std::string();
  return ReadFile(path);
}

std::string RootOf(const std::string& text) {
  tinyxml2::XMLDocument document;
  document.Parse(text.c_str(), text.size());
  return document.RootElement() == nullptr ? "" : document.RootElement()->Name();
}

/// The given YAML, with the keys of another YAML that it does not contain.
std::string Joined(const std::string& given, const std::string& other) {
  if (given.empty() || other.empty()) return given + other;
  const YAML::Node mine = YAML::Load(given), theirs = YAML::Load(other);
  if (!mine.IsMap() || !theirs.IsMap()) return given;
  YAML::Node added;
  for (const auto& item : theirs) {
    if (!mine[item.first.as<std::string>()]) added[item.first] = item.second;
  }
  if (added.size() == 0) return given;
  return given + (given.ends_with('\n') ? "" : "\n") + YAML::Dump(added) + "\n";
}

Result<MjcfMesh> ReadMjcfMesh(const std::string& path, const fs::path& folder) {
  const Result<Mesh> mesh = ReadMesh(fs::path(path).is_absolute() ? path : (folder / path).string());
  if (!mesh) return mesh.failure();
  return MjcfMesh{mesh->vertices, mesh->triangles};
}

}  // namespace

Result<RobotDescription> ReadDescription(const std::string& path, const RobotLoading& loading) {
  const Result<std::string> text = ReadText(path, loading.strict);
  if (!text) return text.failure();
  const fs::path folder = fs::path(path).parent_path();
  const Result<std::string> yaml = ReadYaml(folder, loading.yaml_path);
  if (!yaml) return yaml.failure();
  RobotDescription description{*text, *yaml, "", {}, {}};
  const auto note = [&](FailureCode code, const std::string& message) {
    description.findings.push_back({FindingLevel::kInfo, code, RobotPart(), 0, message});
  };
  if (IsMjcf(*text)) {
    Result<ConvertedMjcf> converted =
        ConvertMjcf(path, [&](const std::string& mesh) { return ReadMjcfMesh(mesh, folder); });
    if (!converted) return converted.failure();
    description.urdf = std::move(converted->urdf);
    for (MjcfInlineMesh& inner : converted->meshes)
      description.meshes.push_back({inner.file, HullPoints(std::move(inner.mesh.vertices))});
    try {
      description.yaml = Joined(*yaml, converted->yaml);
      description.yaml_without_posture = Joined(*yaml, converted->yaml_without_posture);
    } catch (const YAML::Exception&) {
      description.yaml = *yaml;  // ParseRobotYaml refuses it later
    }
    for (const std::string& said : converted->notes) note(FailureCode::kMjcf, said);
  } else if (IsXacro(*text)) {
    Result<std::string> expanded =
        ExpandXacro({path, loading.xacro_arguments, {loading.packages.begin(), loading.packages.end()}});
    if (!expanded) return expanded.failure();
    description.urdf = std::move(*expanded);
    note(FailureCode::kXacro, "the file is a xacro file and was expanded");
  } else if (text->starts_with("version https://git-lfs")) {
    return Failure{FailureKind::kBadInput,
                   FailureCode::kNotUrdf,
                   "LoadRobot",
                   fmt::format("'{}' is a Git LFS pointer, not the file itself", path),
                   {"fetch the file with 'git lfs pull'"}};
  } else if (text->find_first_not_of(" \t\r\n") == std::string::npos) {
    return Failure{FailureKind::kBadInput, FailureCode::kNotUrdf, "LoadRobot", fmt::format("'{}' is empty", path), {}};
  } else if (RootOf(*text) == "sdf") {
    return Failure{FailureKind::kBadInput,
                   FailureCode::kNotUrdf,
                   "LoadRobot",
                   fmt::format("'{}' is an SDF (Gazebo) file; accepted: URDF, xacro or MJCF", path),
                   {"most manufacturers also publish a URDF; use that file"}};
  }
  return description;
}

}  // namespace gaitwright
