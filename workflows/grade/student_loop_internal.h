// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

namespace gaitwright {

/// The text of student_loop.py, which is embedded.
std::string_view StudentLoop();

}  // namespace gaitwright
