// SPDX-License-Identifier: BSD-3-Clause
#include "cli/usage.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "kinematics/base/nearest_name.h"
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

/// Without their dashes.
std::vector<std::string> Flags(const CLI::App& verb) {
  std::vector<std::string> names;
  for (const CLI::Option* option : verb.get_options()) {
    names.insert(names.end(), option->get_lnames().begin(), option->get_lnames().end());
  }
  return names;
}

/// "; the nearest is '--set'", or nothing: dashes are alike in all and make nothing near.
std::string NearestFlag(const std::string& flag, const CLI::App& verb) {
  const std::size_t name = std::min(flag.find_first_not_of('-'), flag.size());
  const std::string nearest = NearestName(flag.substr(name), Flags(verb));
  return nearest.empty() ? "" : fmt::format("; the nearest is '--{}'", nearest);
}

/// A word that no verb and no flag took.
std::string Unexpected(const CLI::App& app, const CLI::App& verb, const std::string& word) {
  if (word.starts_with("-")) {
    const std::string flag = word.substr(0, word.find('='));
    return fmt::format("{} has no flag '{}'{}", NameOf(verb), flag, NearestFlag(flag, verb));
  }
  const std::vector<std::string> verbs = Verbs(verb);
  if (verbs.empty()) return fmt::format("{} does not know what to do with '{}'", NameOf(verb), word);
  const std::string list = QuotedList(verbs);
  return &verb == &app ? fmt::format("there is no verb '{}'{}; there are {}", word, NearestHint(word, verbs), list)
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

/// The text in lines of at most `width`.
std::string Wrapped(const std::string& text, std::size_t width) {
  std::istringstream words(text);
  std::string wrapped;
  std::size_t column = 0;
  for (std::string word; words >> word;) {
    if (column > 0 && column + 1 + word.size() > width) {
      wrapped += '\n';
      column = 0;
    }
    if (column > 0) wrapped += ' ';
    wrapped += word;
    column += word.size() + (column > 0 ? 1 : 0);
  }
  return wrapped;
}

/// Names and types alone at the left, and one empty line between groups.
class HelpFormatter : public CLI::Formatter {
 public:
  std::string make_option_opts(const CLI::Option* option) const override {
    return option->get_type_size() == 0 ? "" : " " + option->get_type_name();
  }
  std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override {
    std::string text = CLI::Formatter::make_help(app, std::move(name), mode);
    for (std::size_t at = 0; (at = text.find("\n\n\n", at)) != std::string::npos;) text.erase(at, 1);
    return text;
  }
};

}  // namespace

void LayOutHelp(CLI::App& app) {
  constexpr std::size_t kNames = 28, kDescriptions = 72;
  app.formatter(std::make_shared<HelpFormatter>());
  app.get_formatter()->column_width(kNames);
  for (CLI::Option* option : app.get_options()) option->description(Wrapped(option->get_description(), kDescriptions));
  for (CLI::App* verb : app.get_subcommands({})) LayOutHelp(*verb);
}

Failure UsageFailure(const CLI::App& app, const CLI::ParseError& error) {
  const CLI::App& verb = Reached(app);
  const std::string help = &verb == &app ? "gaitwright --help" : fmt::format("gaitwright {} --help", NameOf(verb));
  return {FailureKind::kBadInput, "usage", "program", Message(app, verb, error), {help}};
}

}  // namespace gaitwright::cli
