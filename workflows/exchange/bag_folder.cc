// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <filesystem>
#include <system_error>
#include <utility>

#include "kinematics/base/file.h"
#include "kinematics/base/strict_yaml_internal.h"
#include "workflows/exchange/mcap_records_internal.h"
#include "workflows/exchange/packed_bytes_internal.h"
#include "workflows/exchange/read_motion_internal.h"
#include "workflows/exchange/recorded_motion_internal.h"
#include "workflows/exchange/sqlite_bag_internal.h"

namespace gaitwright {
namespace {

namespace fs = std::filesystem;

constexpr const char* kBagDescription = "metadata.yaml";
constexpr const char* kBagKey = "rosbag2_bagfile_information";

struct BagDescription {
  std::vector<std::string> files;
  bool packed = false;  ///< each file as a whole, by zstd; messages may be packed one by one
};

std::string BagText(const YAML::Node& bag, const std::string& key) {
  const YAML::Node value = bag[key];
  return value && !value.IsNull() ? TextOf(value, key) : "";
}

/// @throws InvalidArgument with the line.
BagDescription ParseBagDescription(const std::string& text) {
  const YAML::Node root = LoadYaml(text);
  if (!root.IsMap() || !root[kBagKey] || !root[kBagKey].IsMap())
    throw InvalidArgument(fmt::format("it has no map '{}'", kBagKey));
  const YAML::Node bag = root[kBagKey];
  const std::string storage = BagText(bag, "storage_identifier"), packing = BagText(bag, "compression_format"),
                    mode = BagText(bag, "compression_mode");
  if (storage != "mcap" && storage != "sqlite3") {
    RefuseYaml(bag["storage_identifier"] ? bag["storage_identifier"] : bag,
               fmt::format("the storage '{}' is not read; 'mcap' and 'sqlite3' are, to which 'ros2 bag convert' "
                           "converts others",
                           storage));
  }
  BagDescription description;
  description.packed = mode == "FILE" || mode == "file";
  const bool by_message = mode == "MESSAGE" || mode == "message";
  if (!packing.empty() && (packing != "zstd" || (!description.packed && !by_message))) {
    RefuseYaml(bag["compression_format"],
               fmt::format("the compression '{}' of '{}' is not read; 'ros2 bag convert' writes a bag without it",
                           packing, mode));
  }
  if (!bag["relative_file_paths"]) RefuseYaml(bag, "it lacks 'relative_file_paths'");
  for (const YAML::Node& file : ListOf(bag["relative_file_paths"], "relative_file_paths")) {
    // Old versions list paths from another folder; all files lie in the bag's.
    description.files.push_back(fs::path(TextOf(file, "relative_file_paths")).filename().string());
  }
  if (description.files.empty()) RefuseYaml(bag["relative_file_paths"], "relative_file_paths is empty");
  return description;
}

}  // namespace

bool IsRecording(const std::string& bytes) { return bytes.starts_with(kMcapMagic) || bytes.starts_with(kSqliteMagic); }

bool IsBagFolder(const std::string& path) {
  std::error_code ignored;
  const fs::path description = fs::path(path) / kBagDescription;
  if (!fs::is_regular_file(description, ignored)) return false;
  const Result<std::string> text = ReadFile(description.string(), kLargestYaml);
  return text && text->find(kBagKey) != std::string::npos;
}

Result<std::vector<std::string>> ReadBagFolder(const std::string& path) {
  const std::string description_file = (fs::path(path) / kBagDescription).string();
  const Result<std::string> text = ReadFile(description_file);
  if (!text) return text.failure();
  BagDescription description;
  try {
    description = ParseBagDescription(*text);
  } catch (const InvalidArgument& error) {
    return RefusedMotion(description_file, error.what());
  } catch (const YAML::Exception& error) {
    return RefusedMotion(description_file, fmt::format("line {}: {}", error.mark.line + 1, error.msg));
  }
  std::vector<std::string> files;
  for (const std::string& name : description.files) {
    const std::string file = (fs::path(path) / name).string();
    Result<std::string> bytes = ReadBytes(file);
    if (!bytes) return bytes.failure();
    try {
      files.push_back(description.packed ? UnpackedZstd(*bytes, kLargestFile) : std::move(*bytes));
    } catch (const InvalidArgument& error) {
      return RefusedMotion(file, error.what());
    }
    if (!IsRecording(files.back())) return RefusedMotion(file, "it is neither an MCAP file nor a database of SQLite");
  }
  return files;
}

}  // namespace gaitwright
