// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/name_of_description.h"

#include <tinyxml2.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>

namespace gaitwright {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLongestName = 64;
constexpr std::array<std::string_view, 10> kFoldersOfAllRobots = {"description", "mjcf", "model", "models", "robot",
                                                                  "robots",      "urdf", "urdfs", "xacro",  "xml"};

/// The <robot name> if it is also a valid file name; else "".
std::string NameInText(const std::string& urdf) {
  tinyxml2::XMLDocument document;
  if (document.Parse(urdf.c_str(), urdf.size()) != tinyxml2::XML_SUCCESS) return "";
  const char* given = document.RootElement() == nullptr ? nullptr : document.RootElement()->Attribute("name");
  const std::string name = given == nullptr ? "" : given;
  const auto is_plain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
  };
  return name.size() <= kLongestName && std::all_of(name.begin(), name.end(), is_plain) ? name : "";
}

}  // namespace

std::string NameOfDescription(const std::string& path, const std::string& urdf) {
  const fs::path folder = fs::path(path).parent_path();
  std::string stem = fs::path(path).stem().string();
  if (fs::path(stem).extension() == ".urdf") stem = fs::path(stem).stem().string();  // of `go1.urdf.xacro`
  if ((stem != "robot" && !stem.empty()) || !folder.has_filename()) return stem;
  std::string of_folder = folder.filename().string();
  if (std::find(kFoldersOfAllRobots.begin(), kFoldersOfAllRobots.end(), of_folder) == kFoldersOfAllRobots.end())
    return of_folder;
  const std::string in_text = NameInText(urdf);
  return in_text.empty() ? of_folder : in_text;
}

}  // namespace gaitwright
