// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace gaitwright {

// Defined in a source that CMake writes (tests/CMakeLists.txt), so that all other sources of the tests are the same for
// the compiler in every checkout, and a compiler cache serves them all.
std::string SourceFolder();  ///< of this checkout, absolute
std::string BuildFolder();   ///< that the tests were built in, absolute

}  // namespace gaitwright
