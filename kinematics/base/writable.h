// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace gaitwright {

/// Reason why WriteFilesTogether could not write this file, as text after "cannot be written: "; "" if it can. Nothing
/// is created or changed by this check. An existing file must be a regular file that this user may write; its folder,
/// or the nearest existing one above it, must allow new files. A full disk is not detected.
std::string ReasonNotWritable(const std::string& path);

/// Reason why new files could not be written in a folder, as text; "" if they can. The folder may not exist yet. The
/// argument "" is the current folder.
std::string ReasonNoNewFiles(const std::string& folder);

}  // namespace gaitwright
