// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace gaitwright {

/// The text without spaces, tabs and ends of lines before and after it.
std::string Trimmed(const std::string& text);

}  // namespace gaitwright
