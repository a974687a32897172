// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace gaitwright::cli {

/// A page of Markdown with the flags of every verb below `app`, as their help has them.
std::string VerbsPage(const CLI::App& app);

/// A page of Markdown with every option that a verb below `app` lists: key, default, unit, what is accepted, meaning,
/// and the verbs that take it.
std::string OptionsPage(CLI::App& app);

/// Adds the verb `reference`, which prints and writes them and the JSON schemas; `status` gets its exit status.
void AddReference(CLI::App& app, int& status);

}  // namespace gaitwright::cli
