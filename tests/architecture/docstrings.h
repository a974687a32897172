// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace gaitwright::architecture {

/// Types and functions of a header without a `///` above: "12: struct GaitOptions".
///
/// Checked are type definitions and functions in namespaces, and functions in the public parts of classes. A function
/// that follows another statement without a blank line belongs to its group and shares its docstring. Not checked are
/// constructors, destructors, operators, overrides, defaulted or deleted functions, enumerations within a class,
/// Fields(), accessors (snake_case, R_WB), and everything in anonymous namespaces.
std::vector<std::string> WithoutDocstring(const std::string& header_text);

}  // namespace gaitwright::architecture
