// SPDX-License-Identifier: BSD-3-Clause
#include "cli/reference_pages.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <vector>

#include "cli/listed_options.h"

namespace gaitwright::cli {
namespace {

constexpr char kMade[] = "<!-- Written by `gaitwright reference`; do not edit. -->\n\n";

/// All verbs below `app`, each before those below it, with the words that call it.
struct Verb {
  std::string words;
  CLI::App* app;
};

void Collect(CLI::App& app, const std::string& before, std::vector<Verb>& verbs) {
  for (CLI::App* verb : app.get_subcommands([](const CLI::App*) { return true; })) {
    verbs.push_back({before + verb->get_name(), verb});
    Collect(*verb, verbs.back().words + " ", verbs);
  }
}

/// Text for a cell of a table: on one line, bars and stars as they are.
std::string Cell(const std::string& text) {
  std::string cell;
  for (const char c : text) {
    if (c == '|' || c == '*' || c == '<') cell += '\\';
    cell += c == '\n' ? ' ' : c;
  }
  return cell;
}

std::string OptionsTable(const CLI::App& verb, const std::string& group) {
  std::string table = fmt::format("| {} | value | does |\n|---|---|---|\n", group == "Options" ? "flag" : group);
  for (const CLI::Option* option : verb.get_options()) {
    if (option->get_group() != group) continue;
    const std::string type = option->get_type_size() == 0 ? "" : option->get_type_name();
    const std::string name = option->get_positional() ? option->get_name(true, false) : option->get_name(false, true);
    table += fmt::format("| `{}` | {} | {} |\n", name, Cell(type), Cell(option->get_description()));
  }
  return table + "\n";
}

/// The examples of a help's end.
std::string ExamplesOf(const CLI::App& verb) {
  std::istringstream footer(verb.get_footer());
  std::string examples;
  for (std::string line; std::getline(footer, line);) {
    if (line.starts_with("  gaitwright ")) examples += line.substr(2) + "\n";
  }
  return examples.empty() ? "" : "```text\n" + examples + "```\n\n";
}

/// Groups of a verb's flags, in order; what every verb has is told once.
std::vector<std::string> GroupsOf(const CLI::App& verb) {
  std::vector<std::string> groups;
  for (const CLI::Option* option : verb.get_options()) {
    const std::string& group = option->get_group();
    if (group.empty() || group == "Flags of every verb" || option->get_name(false, true) == "-h,--help") continue;
    if (std::find(groups.begin(), groups.end(), group) == groups.end()) groups.push_back(group);
  }
  return groups;
}

/// What --list-options of a verb would print; empty where it has none.
OptionFields ListedBy(CLI::App& verb) {
  CLI::Option* option = verb.get_option_no_throw("--list-options");
  if (option == nullptr) return {};
  option->add_result("true");
  OptionFields fields;
  try {
    option->run_callback();
  } catch (const ListedOptions& listed) {
    fields = listed.fields();
  }
  option->clear();
  return fields;
}

/// A line of the page of options.
struct Line {
  std::string key, text;
  std::vector<std::string> verbs;
};

std::string GroupOf(const std::string& key) {
  const std::size_t dot = key.find('.');
  return dot == std::string::npos ? "" : key.substr(0, dot);
}

std::vector<Line> LinesOf(CLI::App& app) {
  std::vector<Verb> verbs;
  Collect(app, "", verbs);
  std::vector<Line> lines;
  for (const Verb& verb : verbs) {
    for (const OptionField& field : ListedBy(*verb.app)) {
      const std::string value = OptionText(field);
      const std::string text = fmt::format("{} | {} | {} | {}", value.empty() ? "" : "`" + value + "`", field.unit,
                                           Cell(AcceptedOf(field)), Cell(field.meaning));
      const auto same = [&](const Line& line) { return line.key == field.key && line.text == text; };
      auto line = std::find_if(lines.begin(), lines.end(), same);
      if (line == lines.end()) line = lines.insert(lines.end(), {field.key, text, {}});
      line->verbs.push_back(verb.words);
    }
  }
  return lines;
}

}  // namespace

std::string VerbsPage(const CLI::App& app) {
  std::vector<Verb> verbs;
  Collect(const_cast<CLI::App&>(app), "", verbs);
  std::string page = std::string(kMade) +
                     "# Every verb and its flags\n\nThe same as `gaitwright VERB --help`. Flags that every verb has "
                     "stand at the end.\n\n";
  for (const Verb& verb : verbs) {
    page += fmt::format("## {}\n\n{}.\n\n{}", verb.words, verb.app->get_description(), ExamplesOf(*verb.app));
    for (const std::string& group : GroupsOf(*verb.app)) page += OptionsTable(*verb.app, group);
  }
  const std::string common = "Flags of every verb";
  return page + "## " + common + "\n\n" + OptionsTable(*verbs.front().app, common);
}

std::string OptionsPage(CLI::App& app) {
  const std::vector<Line> lines = LinesOf(app);
  std::vector<std::string> groups;
  for (const Line& line : lines) {
    if (std::find(groups.begin(), groups.end(), GroupOf(line.key)) == groups.end()) groups.push_back(GroupOf(line.key));
  }
  std::sort(groups.begin(), groups.end());
  std::string page = std::string(kMade) +
                     "# Every option\n\nKeys of `--set KEY=VALUE` and of files of options. What `gaitwright VERB "
                     "--list-options` prints, of all verbs.\n\n";
  for (const std::string& group : groups) {
    page += fmt::format("## {}\n\n| key | default | unit | accepted | meaning | of |\n|---|---|---|---|---|---|\n",
                        group.empty() ? "Without a group" : group);
    for (const Line& line : lines) {
      if (GroupOf(line.key) != group) continue;
      page += fmt::format("| `{}` | {} | {} |\n", line.key, line.text, fmt::join(line.verbs, ", "));
    }
    page += "\n";
  }
  page.pop_back();
  return page;
}

}  // namespace gaitwright::cli
