// SPDX-License-Identifier: BSD-3-Clause
#include "cli/paths.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "cli/word_list.h"
#include "kinematics/base/file.h"
#include "kinematics/base/result.h"
#include "kinematics/base/writable.h"
#include "planning/gait/find_gait.h"
#include "planning/gait/read_sequence.h"
#include "planning/terrain/load_terrain.h"

namespace gaitwright::cli {
namespace {

namespace fs = std::filesystem;

/// @throws InvalidArgument if `why_not`, the reason, is not empty.
void CheckWritable(const std::string& what, const std::string& path, const std::string& why_not) {
  if (!why_not.empty()) throw InvalidArgument(fmt::format("{} '{}' cannot be written: {}", what, path, why_not));
}

void CheckEnding(const NamedPath& output) {
  static const std::vector<std::string> kOfFormats = {".avi", ".csv", ".gif",  ".html", ".jpeg", ".jpg", ".json",
                                                      ".mkv", ".mp4", ".npy",  ".npz",  ".obj",  ".pdf", ".png",
                                                      ".svg", ".txt", ".urdf", ".webm", ".xml",  ".yaml"};
  const std::string written = EndingOf(output.path), ending = written == ".yml" ? ".yaml" : written;
  const auto has = [&](const std::vector<std::string>& endings) {
    return std::find(endings.begin(), endings.end(), ending) != endings.end();
  };
  if (output.endings.empty() || has(output.endings) || (!output.ending_decides && !has(kOfFormats))) return;
  throw InvalidArgument(fmt::format("{} '{}' ends in '{}'; accepted: {}", output.name, output.path, written,
                                    JoinWords(output.endings, " or ")));
}

void CheckOutput(const NamedPath& output, const Paths& paths) {
  CheckWritable(output.name, output.path, ReasonNotWritable(output.path));
  for (const NamedPath& input : paths.read) {
    if (input.path.empty() || !IsSameFile(output.path, input.path)) continue;
    throw InvalidArgument(fmt::format("{} '{}' would overwrite an input, {} '{}'; give another file", output.name,
                                      output.path, input.name, input.path));
  }
  CheckEnding(output);
}

/// Checks the folder of plots; each plot there has its own name, which ends in .svg.
void CheckPlots(const Paths& paths) {
  CheckWritable("--plot-dir", paths.plot_folder, ReasonNoNewFiles(paths.plot_folder));
  for (const NamedPath& input : paths.read) {
    const fs::path path(input.path), folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
    if (path.extension() != ".svg" || !IsSameFile(folder.string(), paths.plot_folder)) continue;
    throw InvalidArgument(fmt::format("plots in --plot-dir '{}' could overwrite an input, {} '{}'; give another folder",
                                      paths.plot_folder, input.name, input.path));
  }
}

}  // namespace

std::string EndingOf(const std::string& path) {
  std::string ending = fs::path(path).extension().string();
  for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return ending;
}

void Paths::Read(std::string_view name, const std::string& path) { read.push_back({std::string(name), path}); }

void Paths::Write(std::string_view name, const std::string& path, std::initializer_list<std::string_view> endings) {
  written.push_back({std::string(name), path, {endings.begin(), endings.end()}});
}

void Paths::WriteByEnding(std::string_view name, const std::string& path,
                          std::initializer_list<std::string_view> endings) {
  Write(name, path, endings);
  written.back().ending_decides = true;
}

void Paths::AddGait(const std::string& gait) { Read("--gait", GaitFileOf(gait)); }

void Paths::AddSequence(const std::string& sequence) {
  const std::string file = SequenceFileOf(sequence);
  if (!file.empty()) Read("--sequence", file);
}

void Paths::AddTerrain(const std::string& terrain) {
  for (const std::string& file : TerrainFilesOf(terrain)) Read("the terrain", file);
}

void CheckPaths(const Paths& paths) {
  for (std::size_t i = 0; i < paths.written.size(); ++i) {
    const NamedPath& output = paths.written[i];
    if (output.path.empty()) continue;
    CheckOutput(output, paths);
    for (std::size_t k = 0; k < i; ++k) {
      const NamedPath& other = paths.written[k];
      if (other.path.empty() || !IsSameFile(other.path, output.path)) continue;
      throw InvalidArgument(fmt::format("{} '{}' and {} '{}' are the same file; give each output its own file",
                                        other.name, other.path, output.name, output.path));
    }
  }
  if (!paths.plot_folder.empty()) CheckPlots(paths);
}

std::string WithSuffix(const std::string& path, const std::string& suffix) {
  if (path.empty()) return "";
  const std::filesystem::path file(path);
  return (file.parent_path() / (file.stem().string() + suffix + file.extension().string())).string();
}

}  // namespace gaitwright::cli
