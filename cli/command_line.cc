// SPDX-License-Identifier: BSD-3-Clause
#include "cli/command_line.h"

#include <CLI/CLI.hpp>
#include <functional>
#include <memory>
#include <sstream>
#include <string_view>
#include <utility>

#include "cli/verb.h"
#include "kinematics/base/result.h"
#include "kinematics/base/version.h"

namespace gaitwright::cli {
namespace {

/// The text, broken into lines of at most `width` characters.
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

/// Prints only names and types in the left column, and one empty line between groups.
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

void LayOut(CLI::App& app) {
  constexpr std::size_t kNames = 28, kDescriptions = 72;
  app.formatter(std::make_shared<HelpFormatter>());
  app.get_formatter()->column_width(kNames);
  for (CLI::Option* option : app.get_options()) option->description(Wrapped(option->get_description(), kDescriptions));
  for (CLI::App* verb : app.get_subcommands({})) LayOut(*verb);
}

template <class Target>
Flag AddOption(CLI::App& app, std::string_view names, Target& target, std::string_view help) {
  return Flag(*app.add_option(std::string(names), target, std::string(help)));
}

/// Wraps `read`: an InvalidArgument that it throws becomes a usage error of the flag.
std::function<void(const std::string&)> ReadOrRefuse(std::string_view flag,
                                                     std::function<void(const std::string&)> read) {
  return [flag = std::string(flag), read = std::move(read)](const std::string& text) {
    try {
      read(text);
    } catch (const InvalidArgument& error) {
      throw CLI::ValidationError(flag, error.what());
    }
  };
}

UsageError::Kind KindOf(const CLI::ParseError& error) {
  switch (static_cast<CLI::ExitCodes>(error.get_exit_code())) {
    case CLI::ExitCodes::ExtrasError:
      return UsageError::Kind::kUnexpectedWord;
    case CLI::ExitCodes::ArgumentMismatch:
      return UsageError::Kind::kCountOfValues;
    default:
      return UsageError::Kind::kOther;
  }
}

}  // namespace

Flag Flag::SetGroup(std::string_view group) const { return Flag(*option_->group(std::string(group))); }
Flag Flag::SetType(std::string_view type) const { return Flag(*option_->type_name(std::string(type))); }
Flag Flag::Require() const { return Flag(*option_->required()); }
Flag Flag::Exclude(Flag other) const { return Flag(*option_->excludes(other.option_)); }
Flag Flag::Need(Flag other) const { return Flag(*option_->needs(other.option_)); }
Flag Flag::SplitAt(char separator) const { return Flag(*option_->delimiter(separator)); }
Flag Flag::Repeat() const { return Flag(*option_->expected(1)->take_all()); }

Flag Flag::AcceptOnly(const std::vector<std::string>& choices) const {
  return Flag(*option_->check(CLI::IsMember(choices)));
}

Flag Flag::Check(std::function<std::string(const std::string&)> reason_refused) const {
  return Flag(*option_->check(std::move(reason_refused)));
}

bool Flag::given() const { return option_->count() > 0; }
bool Flag::is_positional() const { return option_->get_positional(); }
std::string Flag::name() const { return option_->get_name(); }
std::string Flag::all_names() const { return option_->get_name(is_positional(), !is_positional()); }
std::vector<std::string> Flag::long_names() const { return option_->get_lnames(); }
std::string Flag::group() const { return option_->get_group(); }
std::string Flag::type() const { return option_->get_type_size() == 0 ? "" : option_->get_type_name(); }
std::string Flag::description() const { return option_->get_description(); }

void Flag::Trigger(const std::string& value) const {
  struct Cleared {
    CLI::Option& option;
    ~Cleared() { option.clear(); }
  };
  const Cleared cleared{*option_};
  option_->add_result(value);
  option_->run_callback();
}

Verb Verb::AddVerb(std::string_view name, std::string_view description) const {
  return Verb(*app_->add_subcommand(std::string(name), std::string(description)));
}

Flag Verb::AddValue(std::string_view names, std::string& target, std::string_view help) const {
  return AddOption(*app_, names, target, help);
}

Flag Verb::AddValue(std::string_view names, std::vector<std::string>& target, std::string_view help) const {
  return AddOption(*app_, names, target, help);
}

Flag Verb::AddValue(std::string_view names, double& target, std::string_view help) const {
  return AddOption(*app_, names, target, help);
}

Flag Verb::AddValue(std::string_view names, std::optional<double>& target, std::string_view help) const {
  return AddOption(*app_, names, target, help);
}

Flag Verb::AddValue(std::string_view names, int& target, std::string_view help) const {
  return AddOption(*app_, names, target, help);
}

Flag Verb::AddValue(std::string_view names, std::optional<int>& target, std::string_view help) const {
  return AddOption(*app_, names, target, help);
}

Flag Verb::AddReader(std::string_view names, std::function<void(const std::string&)> read,
                     std::string_view help) const {
  const auto read_or_refuse = ReadOrRefuse(names, std::move(read));
  return Flag(*app_->add_option_function<std::string>(std::string(names), read_or_refuse, std::string(help)));
}

Flag Verb::AddSwitch(std::string_view names, bool& target, std::string_view help) const {
  return Flag(*app_->add_flag(std::string(names), target, std::string(help)));
}

Flag Verb::AddSwitch(std::string_view names, std::function<void()> action, std::string_view help) const {
  return Flag(*app_->add_flag_callback(std::string(names), std::move(action), std::string(help)));
}

Flag Verb::AddSwitchReader(std::string_view names, std::function<void(const std::string&)> read,
                           std::string_view help) const {
  const auto read_or_refuse = [read = std::move(read)](const std::string& text) {
    try {
      read(text);
    } catch (const InvalidArgument& error) {
      throw CLI::ValidationError(std::string(error.what()));  // CLI11 puts the flag's name before it
    }
  };
  return Flag(*app_->add_flag(std::string(names))->each(read_or_refuse)->description(std::string(help)));
}

void Verb::SetGroup(std::string_view group) const { app_->option_defaults()->group(std::string(group)); }
void Verb::RequireVerbs(std::size_t lowest, std::size_t highest) const { app_->require_subcommand(lowest, highest); }
void Verb::SetFooter(std::string_view footer) const { app_->footer(std::string(footer)); }
void Verb::SetWork(std::function<void()> work) const { app_->callback(std::move(work)); }

bool Verb::Given(std::string_view flag) const { return app_->count(std::string(flag)) > 0; }

std::optional<Flag> Verb::Find(std::string_view flag) const {
  CLI::Option* const option = app_->get_option_no_throw(std::string(flag));
  return option == nullptr ? std::nullopt : std::optional(Flag(*option));
}

std::vector<Flag> Verb::flags() const {
  std::vector<Flag> flags;
  for (CLI::Option* option : app_->get_options()) flags.emplace_back(*option);
  return flags;
}

std::vector<Verb> Verb::verbs() const {
  std::vector<Verb> verbs;
  for (CLI::App* verb : app_->get_subcommands({})) verbs.emplace_back(*verb);
  return verbs;
}

std::optional<Verb> Verb::chosen() const {
  const std::vector<CLI::App*> chosen = app_->get_subcommands();
  return chosen.empty() ? std::nullopt : std::optional(Verb(*chosen.front()));
}

std::string Verb::words() const {
  CLI::App* const parent = app_->get_parent();
  const bool nested = parent != nullptr && parent->get_parent() != nullptr;
  return nested ? Verb(*parent).words() + " " + app_->get_name() : app_->get_name();
}

std::string Verb::name() const { return app_->get_name(); }
std::string Verb::description() const { return app_->get_description(); }
std::string Verb::footer() const { return app_->get_footer(); }

CommandLine::CommandLine(const std::string& description, const std::string& footer)
    : app_(std::make_unique<CLI::App>(description, "gaitwright")) {
  app_->set_version_flag("--version", Version(), "Print the version and exit.");
  app_->require_subcommand(1);
  app_->set_help_flag("-h,--help", "Print this help and exit.");
  app_->footer(footer);
}

CommandLine::~CommandLine() = default;

void CommandLine::LayOutHelp() { LayOut(*app_); }

std::optional<int> CommandLine::Run(int argc, const char* const* argv) {
  try {
    app_->parse(argc, argv);
  } catch (const CLI::Success& asked) {  // --help and --version
    return app_->exit(asked);
  } catch (const CLI::ParseError& error) {
    throw UsageError(KindOf(error), error.what(), app_->remaining(true));
  }
  return std::nullopt;
}

}  // namespace gaitwright::cli
