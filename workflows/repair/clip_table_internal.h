// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "workflows/repair/repair_folder_internal.h"

namespace gaitwright {

/// An outcome as one line of a journal, and back. @throws std::runtime_error for a line of something else.
std::string LineOf(const ClipOutcome& outcome);
ClipOutcome ClipOfLine(const std::string& line);

}  // namespace gaitwright
