// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/yaml_line.h"

#include <fmt/format.h>

#include "kinematics/base/result.h"

namespace gaitwright {

std::string AtYamlLine(int line, const std::string& message) {
  return fmt::format("robot.yaml, line {}: {}", line, message);
}

void RefuseYamlLine(int line, const std::string& message) { throw InvalidArgument(AtYamlLine(line, message)); }

}  // namespace gaitwright
