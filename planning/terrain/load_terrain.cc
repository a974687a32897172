// SPDX-License-Identifier: BSD-3-Clause
#include "planning/terrain/load_terrain.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "kinematics/base/options.h"
#include "kinematics/model/mesh_file.h"
#include "planning/plan/built_in_terrain.h"
#include "planning/plan/terrain_spec.h"
#include "planning/terrain/height_map.h"
#include "planning/terrain/mesh_terrain.h"
#include "planning/terrain/terrain_yaml.h"

namespace gaitwright {
namespace {

namespace fs = std::filesystem;

const std::vector<std::string> kKinds = {".yaml", ".yml", ".csv", ".png", ".obj", ".stl", ".dae"};

/// A file and its parameters.
struct FileText {
  std::string path, kind, parameters;
  bool has_parameters = false;
};

std::string Lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](char c) { return static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c); });
  return text;
}

/// Splits a text after the ending of a supported file kind; the kind is "" for other texts.
FileText Part(const std::string& text) {
  const std::string lower = Lower(text);
  for (const std::string& kind : kKinds) {
    if (lower.ends_with(kind)) return {text, kind, "", false};
    const std::size_t at = lower.rfind(kind + ":");
    if (at == std::string::npos) continue;
    const std::size_t end = at + kind.size();
    return {text.substr(0, end), kind, text.substr(end + 1), true};
  }
  return {text, "", "", false};
}

Failure Refused(FailureCode code, const std::string& message) {
  return {FailureKind::kBadInput, code, "LoadTerrain", message, {}};
}

/// The ground of a file with the parameters of the text. @throws InvalidArgument for a wrong parameter.
Result<Terrain> LoadFile(const FileText& file, const TerrainScale& scale) {
  const OptionTexts texts = file.has_parameters ? ParseParameters(file.parameters) : OptionTexts{};
  const auto set = [&](OptionFields fields) {
    for (const auto& [key, text] : texts) SetOption(fields, key, text);
  };
  if (file.kind == ".yaml" || file.kind == ".yml") {
    if (!texts.empty()) throw InvalidArgument("a YAML file accepts no parameters; set them in the file");
    return ReadTerrainYaml(file.path, scale);
  }
  if (file.kind == ".csv" || file.kind == ".png") {
    HeightMapOptions options;
    set(options.Fields());
    Result<HeightField> field = ReadHeightMap(file.path, options);
    if (!field) return field.failure();
    return Terrain{"", {}, {std::move(*field)}, {}};
  }
  MeshTerrainOptions options;
  options.least_m = std::min(scale.foot_length_m, scale.foot_width_m);
  set(options.Fields());
  const Result<Mesh> mesh = ReadMesh(file.path);
  if (!mesh) return mesh.failure();
  return TerrainFromMesh(*mesh, options, file.path);
}

}  // namespace

std::string TerrainFileOf(const std::string& name_or_file) {
  const FileText file = Part(name_or_file);
  const std::string before = name_or_file.substr(0, name_or_file.find(':'));
  return !file.kind.empty() || before.find_first_of("./") != std::string::npos ? file.path : "";
}

std::vector<std::string> TerrainFilesOf(const std::string& name_or_file) {
  const FileText file = Part(name_or_file);
  if (TerrainFileOf(name_or_file).empty()) return {};
  std::vector<std::string> files = {file.path};
  if (file.kind == ".yaml" || file.kind == ".yml") {
    for (const std::string& named : FilesOfTerrainYaml(file.path)) files.push_back(TerrainFileOf(named));
  }
  return files;
}

Result<Terrain> LoadTerrain(const std::string& name_or_file, const TerrainScale& scale) {
  if (TerrainFileOf(name_or_file).empty()) return MakeTerrain(name_or_file, scale);
  const FileText file = Part(name_or_file);
  if (file.kind.empty()) {
    return Refused(
        FailureCode::kTerrainKind,
        fmt::format("'{}' is a terrain file in an unsupported format; accepted: {}", name_or_file, QuotedList(kKinds)));
  }
  std::error_code error;
  if (!fs::is_regular_file(file.path, error))
    return Refused(FailureCode::kNoFile, fmt::format("terrain file '{}' does not exist", file.path));
  try {
    Result<Terrain> terrain = LoadFile(file, scale);
    if (!terrain) return terrain;
    terrain->name = fs::path(file.path).filename().string();
    if (file.has_parameters) terrain->name += ":" + file.parameters;
    return terrain;
  } catch (const InvalidArgument& wrong) {
    return Refused(FailureCode::kTerrainParameter, fmt::format("terrain '{}': {}", file.path, wrong.what()));
  }
}

}  // namespace gaitwright
