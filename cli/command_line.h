// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "cli/verb.h"

namespace gaitwright::cli {

/// A command line that cannot be read; UsageFailure turns it into a message.
struct UsageError : std::runtime_error {
  enum class Kind { kUnexpectedWord, kCountOfValues, kOther };

  UsageError(Kind the_kind, const std::string& what, std::vector<std::string> words)
      : std::runtime_error(what), kind(the_kind), unread(std::move(words)) {}

  Kind kind;
  std::vector<std::string> unread;  ///< words that belong to no verb and no flag
};

/// The program's verbs and flags.
class CommandLine {
 public:
  CommandLine(const std::string& description, const std::string& footer);
  ~CommandLine();
  CommandLine(const CommandLine&) = delete;
  CommandLine& operator=(const CommandLine&) = delete;

  Verb program() const { return Verb(*app_); }

  /// Lays out the help of all verbs in columns, with lines of readable length. Call it after the last flag is added.
  void LayOutHelp();

  /// Parses the command line and runs the verb that it names. @return the exit status after --help and --version, which
  /// end the program; otherwise nothing.
  /// @throws UsageError; exceptions of the actions of switches pass through.
  std::optional<int> Run(int argc, const char* const* argv);

 private:
  std::unique_ptr<CLI::App> app_;
};

}  // namespace gaitwright::cli
