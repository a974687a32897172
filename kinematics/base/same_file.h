// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace gaitwright {

/// Whether two paths lead to the same file, however they are written: relative or absolute, with '.' and '..', through
/// symbolic links. Neither need exist.
bool IsSameFile(const std::string& a, const std::string& b);

}  // namespace gaitwright
