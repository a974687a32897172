// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace gaitwright {

/// "robot.yaml, line N: message".
std::string AtYamlLine(int line, const std::string& message);

/// Throws InvalidArgument with the text of AtYamlLine.
[[noreturn]] void RefuseYamlLine(int line, const std::string& message);

}  // namespace gaitwright
