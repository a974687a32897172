// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace gaitwright::architecture {

/// Types and functions of a header that stand without a `///` above: "12: struct GaitOptions".
///
/// Looked at are type definitions and functions in namespaces, and functions in the public parts of classes. A function
/// that follows another statement without a blank line belongs to its group and shares its words. Left out are
/// constructors, destructors, operators, overrides, what is defaulted or deleted, enumerations within a class,
/// Fields(), accessors (snake_case, R_WB), and what is in a namespace without a name.
std::vector<std::string> WithoutDocstring(const std::string& header_text);

}  // namespace gaitwright::architecture
