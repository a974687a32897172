// SPDX-License-Identifier: BSD-3-Clause
#include "playback/mjcf/model_file.h"

#include <fmt/format.h>

#include <cstdint>
#include <cstring>
#include <filesystem>

#include "kinematics/base/distinct_names.h"
#include "kinematics/base/text.h"
#include "playback/engine/world.h"
#include "playback/mjcf/elements_internal.h"
#include "playback/mjcf/ground_text_internal.h"
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

/// File names of the height fields, which are in the same folder as the file `path`.
std::vector<std::string> HeightFiles(const Terrain& terrain, const std::filesystem::path& path) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < terrain.height_fields.size(); ++i)
    names.push_back(fmt::format("{}_field{}.bin", path.stem().string(), i));
  return names;
}

/// A text together with the files of its height fields.
std::vector<OutputFile> WithHeights(const std::filesystem::path& path, const std::string& text,
                                    const std::vector<mujoco::FieldHeights>& fields,
                                    const std::vector<std::string>& names) {
  std::vector<OutputFile> files = {{path.string(), text}};
  for (std::size_t i = 0; i < fields.size(); ++i)
    files.push_back({(path.parent_path() / names[i]).string(), HeightBytes(fields[i])});
  return files;
}

}  // namespace

std::vector<OutputFile> MujocoFiles(const RobotModel& model, const Terrain& terrain, const VectorX& q,
                                    const VectorX& stiffness, const VectorX& damping, const std::string& path) {
  const mujoco::FileParts parts{stiffness, damping, HeightFiles(terrain, path)};
  const mujoco::ModelText text = mujoco::WriteModel(model, terrain, q, WorldOptions{}, &parts);
  return WithHeights(path, text.mjcf, text.fields, parts.heights);
}

std::vector<OutputFile> MujocoGroundFiles(const Terrain& terrain, const std::string& path) {
  mujoco::GroundStyle style;
  style.names = DistinctNames(SolidNames(terrain, false), " ");
  style.attributes = mujoco::ContactAttributes(WorldOptions{}) + " contype=\"1\" conaffinity=\"1\" priority=\"1\"";
  style.height_files = HeightFiles(terrain, path);
  const mujoco::GroundText ground = mujoco::WriteGround(terrain, style);
  const std::string text =
      fmt::format("<mujoco model=\"{}\">\n<asset>\n{}</asset>\n<worldbody>\n{}</worldbody>\n</mujoco>\n",
                  EscapedXml(terrain.name), ground.assets, ground.geoms);
  return WithHeights(path, text, ground.fields, style.height_files);
}

}  // namespace gaitwright
