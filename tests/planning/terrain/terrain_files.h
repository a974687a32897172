// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "planning/terrain/load_terrain.h"
#include "tests/scratch_folder.h"

namespace gaitwright::terrain_files {

/// The scratch folder of this run, with a slash at the end.
inline std::string Folder() { return ScratchFolder().string() + "/"; }

/// Writes a file into that folder. @return its path.
inline std::string Written(const std::string& name, const std::string& bytes) {
  std::string path = Folder() + name;
  std::ofstream(path, std::ios::binary) << bytes;
  return path;
}

inline Terrain Loaded(const std::string& text) {
  Result<Terrain> terrain = LoadTerrain(text, {});
  EXPECT_TRUE(terrain.ok()) << terrain.failure().message;
  return terrain.ok() ? *terrain : Terrain{};
}

/// The reason why a text is refused; "" if it is accepted.
inline std::string ReasonRefused(const std::string& text) {
  const Result<Terrain> terrain = LoadTerrain(text, {});
  if (terrain.ok()) return "";
  EXPECT_EQ(terrain.failure().kind, FailureKind::kBadInput);
  return terrain.failure().message;
}

inline bool Says(const std::string& text, const std::string& words) { return text.find(words) != std::string::npos; }

}  // namespace gaitwright::terrain_files
