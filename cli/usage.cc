// SPDX-License-Identifier: BSD-3-Clause
#include "cli/usage.h"

#include <fmt/format.h>

#include <string>
#include <vector>

#include "kinematics/base/options.h"

namespace gaitwright::cli {
namespace {

/// The verb that was reached, or the program itself.
const CLI::App& Reached(const CLI::App& app) {
  const CLI::App* at = &app;
  while (!at->get_subcommands().empty()) at = at->get_subcommands().front();
  return *at;
}

/// "robots show"; for the program itself its own name.
std::string NameOf(const CLI::App& verb) {
  const CLI::App* parent = verb.get_parent();
  const bool nested = parent != nullptr && parent->get_parent() != nullptr;
  return nested ? NameOf(*parent) + " " + verb.get_name() : verb.get_name();
}

std::vector<std::string> Verbs(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* verb : app.get_subcommands({})) names.push_back(verb->get_name());
  return names;
}

std::vector<std::string> Flags(const CLI::App& verb) {
  std::vector<std::string> names;
  for (const CLI::Option* option : verb.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

/// A word that no verb and no flag took.
std::string Unexpected(const CLI::App& app, const CLI::App& verb, const std::string& word) {
  if (word.starts_with("-")) {
    const std::string flag = word.substr(0, word.find('='));
    return fmt::format("{} has no flag '{}'; the nearest is '{}'", NameOf(verb), flag, NearestName(flag, Flags(verb)));
  }
  const std::vector<std::string> verbs = Verbs(verb);
  if (verbs.empty()) return fmt::format("{} does not know what to do with '{}'", NameOf(verb), word);
  const std::string list = QuotedList(verbs);
  return &verb == &app ? fmt::format("there is no verb '{}'; the nearest is '{}'; there are {}", word,
                                     NearestName(word, verbs), list)
                       : fmt::format("there is no '{} {}'; there is {}", NameOf(verb), word, list);
}

std::string Message(const CLI::App& app, const CLI::App& verb, const CLI::ParseError& error) {
  const bool no_verb = &verb == &app;
  const std::vector<std::string> left = app.remaining(true);
  const bool extra = error.get_exit_code() == static_cast<int>(CLI::ExitCodes::ExtrasError);
  if (!left.empty() && (extra || no_verb)) return Unexpected(app, verb, left.front());
  if (no_verb) return fmt::format("a verb is needed; there are {}", QuotedList(Verbs(app)));
  std::string what = error.what();
  what = what.substr(0, what.find('\n'));
  if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::ArgumentMismatch)) {
    const bool missing = what.ends_with("missing");
    what = what.substr(0, what.find(':')) + (missing ? " needs a value" : " is given more than once");
  }
  return fmt::format("{}: {}", NameOf(verb), what);
}

}  // namespace

Failure UsageFailure(const CLI::App& app, const CLI::ParseError& error) {
  const CLI::App& verb = Reached(app);
  const std::string help = &verb == &app ? "gaitwright --help" : fmt::format("gaitwright {} --help", NameOf(verb));
  return {FailureKind::kBadInput, "usage", "program", Message(app, verb, error), {help}};
}

}  // namespace gaitwright::cli
