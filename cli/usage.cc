// SPDX-License-Identifier: BSD-3-Clause
#include "cli/usage.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "kinematics/base/nearest_name.h"
#include "kinematics/base/options.h"

namespace gaitwright::cli {
namespace {

/// The verb that the command line names, or the program itself.
Verb ReachedVerb(Verb program) {
  Verb at = program;
  while (const std::optional<Verb> next = at.chosen()) at = *next;
  return at;
}

std::vector<std::string> VerbNames(Verb program) {
  std::vector<std::string> names;
  for (const Verb& verb : program.verbs()) names.push_back(verb.name());
  return names;
}

/// Names of the verb's flags, without dashes.
std::vector<std::string> FlagNames(Verb verb) {
  std::vector<std::string> names;
  for (const Flag& flag : verb.flags()) {
    const std::vector<std::string> of_flag = flag.long_names();
    names.insert(names.end(), of_flag.begin(), of_flag.end());
  }
  return names;
}

/// "; the nearest is '--set'", or nothing. Compares without dashes, which all flags share.
std::string NearestFlag(const std::string& flag, Verb verb) {
  const std::size_t name = std::min(flag.find_first_not_of('-'), flag.size());
  const std::string nearest = NearestName(flag.substr(name), FlagNames(verb));
  return nearest.empty() ? "" : fmt::format("; the nearest is '--{}'", nearest);
}

/// The message for a word that belongs to no verb and no flag.
std::string UnexpectedWord(Verb program, Verb verb, const std::string& word) {
  if (word.starts_with("-")) {
    const std::string flag = word.substr(0, word.find('='));
    return fmt::format("{} has no flag '{}'{}", verb.words(), flag, NearestFlag(flag, verb));
  }
  const std::vector<std::string> verbs = VerbNames(verb);
  if (verbs.empty()) return fmt::format("{}: unexpected argument '{}'", verb.words(), word);
  const std::string list = QuotedList(verbs);
  return verb == program ? fmt::format("there is no verb '{}'{}; accepted: {}", word, NearestHint(word, verbs), list)
                         : fmt::format("'{} {}' does not exist; accepted: {}", verb.words(), word, list);
}

std::string UsageText(Verb program, Verb verb, const UsageError& error) {
  const bool no_verb = verb == program;
  if (!error.unread.empty() && (no_verb || error.kind == UsageError::Kind::kUnexpectedWord))
    return UnexpectedWord(program, verb, error.unread.front());
  if (no_verb) return fmt::format("a verb is needed; accepted: {}", QuotedList(VerbNames(program)));
  std::string what = error.what();
  what = what.substr(0, what.find('\n'));
  if (error.kind == UsageError::Kind::kCountOfValues) {
    const bool missing = what.ends_with("missing");
    what = what.substr(0, what.find(':')) + (missing ? " needs a value" : " is given more than once");
  }
  return fmt::format("{}: {}", verb.words(), what);
}

}  // namespace

Failure UsageFailure(Verb program, const UsageError& error) {
  const Verb verb = ReachedVerb(program);
  const std::string help = verb == program ? "gaitwright --help" : fmt::format("gaitwright {} --help", verb.words());
  return {FailureKind::kBadInput, FailureCode::kUsage, "program", UsageText(program, verb, error), {help}};
}

}  // namespace gaitwright::cli
