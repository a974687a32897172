// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace gaitwright::cli {

/// One flag of a verb, or one positional argument: a handle that is valid as long as its CommandLine. All members are
/// in command_line.cc, the only file that includes CLI11, because each file that includes it takes seconds to compile.
class Flag {
 public:
  explicit Flag(CLI::Option& option) : option_(&option) {}

  // Settings. Each returns the flag, so that calls can be chained.
  Flag SetGroup(std::string_view group) const;  ///< heading in the help
  Flag SetType(std::string_view type) const;    ///< word that stands after the flag in the help
  Flag Require() const;
  Flag Exclude(Flag other) const;  ///< in both directions
  Flag Need(Flag other) const;
  Flag AcceptOnly(const std::vector<std::string>& choices) const;
  /// @param reason_refused  says why a text is not accepted, or "" if it is accepted.
  Flag Check(std::function<std::string(const std::string&)> reason_refused) const;
  Flag SplitAt(char separator) const;  ///< for lists: one text may have several values
  Flag Repeat() const;                 ///< for lists: the flag may be given several times, with one value each

  bool given() const;
  bool is_positional() const;
  std::string name() const;                     ///< "--speed"
  std::string all_names() const;                ///< "-n,--trials"
  std::vector<std::string> long_names() const;  ///< without dashes
  std::string group() const;
  std::string type() const;  ///< "" for a switch
  std::string description() const;

  /// Runs the action of a switch as if it were given with this value. The action may return or throw.
  void Trigger(const std::string& value = "true") const;

 private:
  CLI::Option* option_;
};

/// The program or one of its verbs: a handle that is valid as long as its CommandLine. Targets of flags must live as
/// long.
class Verb {
 public:
  explicit Verb(CLI::App& app) : app_(&app) {}

  Verb AddVerb(std::string_view name, std::string_view description) const;

  /// A flag with a value; a name without dashes makes a positional argument.
  Flag AddValue(std::string_view names, std::string& target, std::string_view help) const;
  Flag AddValue(std::string_view names, std::vector<std::string>& target, std::string_view help) const;
  Flag AddValue(std::string_view names, double& target, std::string_view help) const;
  Flag AddValue(std::string_view names, std::optional<double>& target, std::string_view help) const;
  Flag AddValue(std::string_view names, int& target, std::string_view help) const;
  Flag AddValue(std::string_view names, std::optional<int>& target, std::string_view help) const;
  /// A flag whose text `read` takes; an InvalidArgument that it throws becomes a usage error of the flag.
  Flag AddReader(std::string_view names, std::function<void(const std::string&)> read, std::string_view help) const;
  /// A flag without a value.
  Flag AddSwitch(std::string_view names, bool& target, std::string_view help) const;
  Flag AddSwitch(std::string_view names, std::function<void()> action, std::string_view help) const;
  /// A switch that may have a value after '='. `read` gets it, or "true" without one, and may throw as for AddReader.
  Flag AddSwitchReader(std::string_view names, std::function<void(const std::string&)> read,
                       std::string_view help) const;

  void SetGroup(std::string_view group) const;  ///< heading of the flags that are added after this
  void RequireVerbs(std::size_t lowest, std::size_t highest) const;
  void SetFooter(std::string_view footer) const;
  void SetWork(std::function<void()> work) const;  ///< runs after the verb has been parsed

  bool Given(std::string_view flag) const;
  std::optional<Flag> Find(std::string_view flag) const;
  std::vector<Flag> flags() const;
  std::vector<Verb> verbs() const;
  std::optional<Verb> chosen() const;  ///< sub-verb that the command line names
  std::string name() const;
  std::string words() const;  ///< "robots show"; for the program its own name
  std::string description() const;
  std::string footer() const;

  bool operator==(const Verb&) const = default;

 private:
  CLI::App* app_;
};

}  // namespace gaitwright::cli
