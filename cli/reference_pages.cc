// SPDX-License-Identifier: BSD-3-Clause
#include "cli/reference_pages.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <sstream>
#include <vector>

#include "cli/listed_options.h"
#include "cli/word_list.h"

namespace gaitwright::cli {
namespace {

constexpr char kMade[] = "<!-- Written by `gaitwright reference`; do not edit. -->\n\n";

/// All verbs below `verb`, each before its own sub-verbs.
std::vector<Verb> VerbsBelow(Verb verb) {
  std::vector<Verb> all;
  for (const Verb& child : verb.verbs()) {
    all.push_back(child);
    const std::vector<Verb> below = VerbsBelow(child);
    all.insert(all.end(), below.begin(), below.end());
  }
  return all;
}

/// Text for a cell of a Markdown table: on one line, with bars and stars escaped.
std::string TableCell(const std::string& text) {
  std::string cell;
  for (const char c : text) {
    if (c == '|' || c == '*' || c == '<') cell += '\\';
    cell += c == '\n' ? ' ' : c;
  }
  return cell;
}

std::string OptionsTable(Verb verb, const std::string& group) {
  std::string table = fmt::format("| {} | value | does |\n|---|---|---|\n", group == "Options" ? "flag" : group);
  for (const Flag& flag : verb.flags()) {
    if (flag.group() != group) continue;
    table +=
        fmt::format("| `{}` | {} | {} |\n", flag.all_names(), TableCell(flag.type()), TableCell(flag.description()));
  }
  return table + "\n";
}

/// The examples at the end of a verb's help.
std::string ExamplesOf(Verb verb) {
  std::istringstream footer(verb.footer());
  std::string examples;
  for (std::string line; std::getline(footer, line);) {
    if (line.starts_with("  gaitwright ")) examples += line.substr(2) + "\n";
  }
  return examples.empty() ? "" : "```text\n" + examples + "```\n\n";
}

/// Groups of a verb's flags, in order, without the flags that every verb has.
std::vector<std::string> GroupsOf(Verb verb) {
  std::vector<std::string> groups;
  for (const Flag& flag : verb.flags()) {
    const std::string group = flag.group();
    if (group.empty() || group == "Flags of every verb" || flag.all_names() == "-h,--help") continue;
    if (std::find(groups.begin(), groups.end(), group) == groups.end()) groups.push_back(group);
  }
  return groups;
}

/// All options of a verb, basic ones first; empty for a verb without options.
OptionFields ListedBy(Verb verb) {
  const std::optional<Flag> list = verb.Find("--list-options");
  if (!list) return {};
  try {
    list->Trigger("all");
  } catch (const ListedOptions& listed) {
    return listed.fields();
  }
  return {};
}

/// A line of the page of options.
struct OptionLine {
  std::string key, text;
  std::vector<std::string> verbs;
};

std::string GroupOf(const std::string& key) {
  const std::size_t dot = key.find('.');
  return dot == std::string::npos ? "" : key.substr(0, dot);
}

std::vector<OptionLine> OptionLines(Verb program) {
  std::vector<OptionLine> lines;
  for (const Verb& verb : VerbsBelow(program)) {
    for (const OptionField& field : ListedBy(verb)) {
      const std::string value = OptionText(field);
      const std::string text =
          fmt::format("{} | {} | {} | {} | {}", value.empty() ? "" : "`" + value + "`", field.unit,
                      TableCell(AcceptedOf(field)), field.advanced ? "advanced" : "basic", TableCell(field.meaning));
      const auto same = [&](const OptionLine& line) { return line.key == field.key && line.text == text; };
      auto line = std::find_if(lines.begin(), lines.end(), same);
      if (line == lines.end()) line = lines.insert(lines.end(), {field.key, text, {}});
      line->verbs.push_back(verb.words());
    }
  }
  return lines;
}

}  // namespace

std::string VerbsPage(Verb program) {
  const std::vector<Verb> verbs = VerbsBelow(program);
  std::string page =
      std::string(kMade) +
      "# Every verb and its flags\n\nAs printed by `gaitwright VERB --help`. Flags of every verb are at the end.\n\n";
  for (const Verb& verb : verbs) {
    page += fmt::format("## {}\n\n{}.\n\n{}", verb.words(), verb.description(), ExamplesOf(verb));
    for (const std::string& group : GroupsOf(verb)) page += OptionsTable(verb, group);
  }
  const std::string common = "Flags of every verb";
  return page + "## " + common + "\n\n" + OptionsTable(verbs.front(), common);
}

std::string OptionsPage(Verb program) {
  const std::vector<OptionLine> lines = OptionLines(program);
  std::vector<std::string> groups;
  for (const OptionLine& line : lines) {
    if (std::find(groups.begin(), groups.end(), GroupOf(line.key)) == groups.end()) groups.push_back(GroupOf(line.key));
  }
  std::sort(groups.begin(), groups.end());
  std::string page = std::string(kMade) +
                     "# Every option\n\nKeys of `--set KEY=VALUE` and of option files, for all verbs. `gaitwright VERB "
                     "--list-options` prints the basic options of a verb, `--list-options=all` the advanced ones "
                     "too.\n\n";
  for (const std::string& group : groups) {
    page += fmt::format(
        "## {}\n\n| key | default | unit | accepted | level | meaning | verbs |\n|---|---|---|---|---|---|---|\n",
        group.empty() ? "Without a group" : group);
    for (const OptionLine& line : lines) {
      if (GroupOf(line.key) != group) continue;
      page += fmt::format("| `{}` | {} | {} |\n", line.key, line.text, JoinWords(line.verbs, ", "));
    }
    page += "\n";
  }
  page.pop_back();
  return page;
}

}  // namespace gaitwright::cli
