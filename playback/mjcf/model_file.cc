// SPDX-License-Identifier: BSD-3-Clause
#include "playback/mjcf/model_file.h"

#include <fmt/format.h>

#include <cstdint>
#include <cstring>
#include <filesystem>

#include "playback/mjcf/model_text_internal.h"

namespace gaitwright {
namespace {

template <class Number>
void Append(Number value, std::string& bytes) {
  char raw[sizeof(Number)];
  std::memcpy(raw, &value, sizeof raw);
  bytes.append(raw, sizeof raw);
}

/// MuJoCo's own format of height fields: rows and columns as 32-bit integers, then the heights as 32-bit floats.
std::string HeightBytes(const mujoco::FieldHeights& field) {
  std::string bytes;
  Append(static_cast<std::int32_t>(field.rows), bytes);
  Append(static_cast<std::int32_t>(field.columns), bytes);
  for (const float height : field.heights) Append(height, bytes);
  return bytes;
}

}  // namespace

std::vector<OutputFile> MujocoFiles(const RobotModel& model, const Terrain& terrain, const VectorX& q,
                                    const VectorX& stiffness, const VectorX& damping, const std::string& path) {
  const std::filesystem::path file(path);
  mujoco::FileParts parts{stiffness, damping, {}};
  for (std::size_t i = 0; i < terrain.height_fields.size(); ++i)
    parts.heights.push_back(fmt::format("{}_field{}.bin", file.stem().string(), i));
  const mujoco::ModelText text = mujoco::WriteModel(model, terrain, q, WorldOptions{}, &parts);
  std::vector<OutputFile> files = {{path, text.mjcf}};
  for (std::size_t i = 0; i < text.fields.size(); ++i)
    files.push_back({(file.parent_path() / parts.heights[i]).string(), HeightBytes(text.fields[i])});
  return files;
}

}  // namespace gaitwright
