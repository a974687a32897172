// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace gaitwright {

/// Why WriteFilesTogether could not write this file, as far as that is seen without making or changing anything, in
/// words that follow "cannot be written: "; "" where nothing speaks against it. A file that is there must be a regular
/// one that this user may write; its folder, or the nearest one above that is there, must take new files of this user.
/// A disk that is full is not seen.
std::string WhyNotWritable(const std::string& path);

/// The same of new files in a folder, which may have to be made; "" is the present one.
std::string WhyNoNewFiles(const std::string& folder);

}  // namespace gaitwright
