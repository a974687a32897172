// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "planning/terrain/load_terrain.h"

namespace gaitwright::terrain_files {

/// A folder of this run's own, gone with it; with the slash.
inline std::string Folder() {
  struct Own {
    std::filesystem::path path =
        std::filesystem::temp_directory_path() / ("gaitwright_terrain_" + std::to_string(::getpid()));
    Own() { std::filesystem::create_directories(path); }
    Own(const Own&) = delete;
    Own& operator=(const Own&) = delete;
    ~Own() {
      std::error_code error;
      std::filesystem::remove_all(path, error);
    }
  };
  static const Own own;
  return own.path.string() + "/";
}

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

/// Why a text is refused; "" when it is not.
inline std::string WhyRefused(const std::string& text) {
  const Result<Terrain> terrain = LoadTerrain(text, {});
  if (terrain.ok()) return "";
  EXPECT_EQ(terrain.failure().kind, FailureKind::kBadInput);
  return terrain.failure().message;
}

inline bool Says(const std::string& text, const std::string& words) { return text.find(words) != std::string::npos; }

}  // namespace gaitwright::terrain_files
