// SPDX-License-Identifier: BSD-3-Clause
#include "cli/ground_file.h"

#include <fmt/format.h>

#include <filesystem>
#include <utility>

#include "cli/paths.h"
#include "planning/terrain/write_heights.h"
#include "planning/terrain/write_obj.h"
#include "playback/mjcf/model_file.h"

namespace gaitwright::cli {
namespace {

GroundFiles MakeMjcf(const Terrain& terrain, const std::string& path) {
  GroundFiles made;
  made.files = MujocoGroundFiles(terrain, path);
  for (std::size_t i = 1; i < made.files.size(); ++i) {
    made.notes.push_back(
        fmt::format("heights are in '{}'; MuJoCo looks for it beside the model that it loads, or in the "
                    "model's meshdir",
                    std::filesystem::path(made.files[i].path).filename().string()));
  }
  return made;
}

}  // namespace

Result<GroundFiles> MakeGroundFiles(const Terrain& terrain, const std::string& path) {
  const std::string ending = EndingOf(path);
  if (ending == ".xml") return MakeMjcf(terrain, path);
  if (ending != ".obj" && ending != ".png")
    throw InvalidArgument(fmt::format("'{}' ends in '{}'; accepted: .xml or .obj or .png", path, ending));
  Result<WrittenGround> written = ending == ".obj" ? WriteObj(terrain) : WriteHeights(terrain);
  if (!written) return written.failure();
  GroundFiles made;
  made.files = {{path, std::move(written->bytes)}};
  made.terrain = written->parameters.empty() ? path : path + ":" + written->parameters;
  made.notes = std::move(written->notes);
  return made;
}

}  // namespace gaitwright::cli
