// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "cli/verb.h"

namespace gaitwright::cli {

/// A command line that cannot be read; UsageFailure says it in words.
struct UsageError : std::runtime_error {
  enum class Kind { kUnexpectedWord, kCountOfValues, kOther };

  UsageError(Kind the_kind, const std::string& what, std::vector<std::string> words)
      : std::runtime_error(what), kind(the_kind), unread(std::move(words)) {}

  Kind kind;
  std::vector<std::string> unread;  ///< words that no verb and no flag took
};

/// The program's verbs and flags.
class CommandLine {
 public:
  CommandLine(const std::string& description, const std::string& footer);
  ~CommandLine();
  CommandLine(const CommandLine&) = delete;
  CommandLine& operator=(const CommandLine&) = delete;

  Verb program() const { return Verb(*app_); }

  /// Sets the help of all verbs in columns, with descriptions in lines of readable length. Call it after the last flag.
  void LayOutHelp();

  /// Reads the words and runs the verb that they name. @return the exit status after --help or --version, which end the
  /// program; otherwise nothing.
  /// @throws UsageError, and what the actions of switches throw.
  std::optional<int> Run(int argc, const char* const* argv);

 private:
  std::unique_ptr<CLI::App> app_;
};

}  // namespace gaitwright::cli
