// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "cli/verb.h"

namespace gaitwright::cli {

/// A page of Markdown with the flags of every verb below `program`, as in the help of the verbs.
std::string VerbsPage(Verb program);

/// A page of Markdown with every option that a verb below `program` lists: key, default, unit, accepted values,
/// meaning, and the verbs that take it.
std::string OptionsPage(Verb program);

/// Adds the verb `reference`, which prints and writes these pages and the JSON schemas; `status` gets its exit status.
void AddReference(Verb program, int& status);

}  // namespace gaitwright::cli
