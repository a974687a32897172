// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/names_description.h"

#include <algorithm>
#include <array>
#include <filesystem>

#include "kinematics/base/text.h"

namespace gaitwright {

bool NamesDescription(const std::string& text) {
  constexpr std::array kEndings = {".urdf", ".xacro", ".xml", ".mjcf", ".sdf"};
  const std::string ending = LowerCase(std::filesystem::path(text).extension().string());
  return text.find('/') != std::string::npos || std::count(kEndings.begin(), kEndings.end(), ending) > 0;
}

}  // namespace gaitwright
