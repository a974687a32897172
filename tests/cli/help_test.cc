// SPDX-License-Identifier: BSD-3-Clause
// Every example in the help works, and every flag says which values it accepts.
#include <algorithm>
#include <cctype>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>

#include "tests/built_paths.h"
#include "tests/cli/stranger.h"

namespace gaitwright::cli {
namespace {

/// All verbs, in an order in which the files for the examples of each verb exist.
const std::vector<std::vector<std::string>> kVerbs = {{"plan"},           {"walk"},
                                                      {"audit"},          {"play"},
                                                      {"trials"},         {"sweep"},
                                                      {"tune"},           {"grade"},
                                                      {"export"},         {"import"},
                                                      {"view"},           {"render"},
                                                      {"compare"},        {"robots"},
                                                      {"robots", "show"}, {"robots", "check"},
                                                      {"gaits"},          {"reference"},
                                                      {"terrains"},       {"terrains", "show"},
                                                      {"bench"},          {"bench", "centroidal"}};

class Help : public Stranger {
 protected:
  std::string Of(std::vector<std::string> verb) const {
    verb.push_back("--help");
    const Ran ran = Run(verb);
    EXPECT_EQ(ran.status, 0);
    EXPECT_EQ(ran.err, "");
    return ran.out;
  }
};

std::vector<std::string> Words(const std::string& line) {
  std::vector<std::string> words;
  bool quoted = false, within = false;
  for (const char c : line) {
    if (c == '\'') {
      quoted = !quoted;
    } else if (c == ' ' && !quoted) {
      within = false;
    } else {
      if (!within) words.emplace_back();
      within = true;
      words.back() += c;
    }
  }
  return words;
}

TEST_F(Help, EveryExampleWorks) {
  const std::string start = "  gaitwright ";
  Write("rubric.yaml", "title: t\nparts:\n- {name: dcm, kind: answers, file: dcm.csv, points: 4, reference: dcm}\n");
  Write("submissions/ada/dcm.csv", "case,answer_0,answer_1\n0,1,2\n");
  for (const auto& verb : kVerbs) {
    std::istringstream help(Of(verb));
    int examples = 0;
    for (std::string line; std::getline(help, line);) {
      if (!line.starts_with(start)) continue;
      SCOPED_TRACE(line);
      const Ran ran = Run(Words(line.substr(start.size())));
      EXPECT_EQ(ran.status, 0) << ran.out.substr(0, 300) << ran.err;
      EXPECT_FALSE(ran.out.empty());
      ++examples;
    }
    EXPECT_GE(examples, 1) << verb.front();
  }
}

TEST_F(Help, NamesTheExitStatusesAndFitsItsLines) {
  std::vector<std::vector<std::string>> verbs = kVerbs;
  verbs.push_back({});
  for (const auto& verb : verbs) {
    const std::string help = Of(verb);
    for (const char* status : {"Exit status:", "  0  done", "  1  the input", "  2  no plan", "  3  the plan"}) {
      EXPECT_NE(help.find(status), std::string::npos) << status;
    }
    std::istringstream lines(help);
    for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 110U) << line;
  }
}

TEST_F(Help, FlagsSayWhatTheyTakeAndWhatHoldsWithoutThem) {
  const std::vector<std::string> switches = {
      "--json",    "--quiet",     "--list-options", "--resume",  "--show-disturbances",
      "--margins", "--preflight", "--strict",       "--explain", "--orbit"};
  std::vector<std::string> bare = {"--help", "--set", "--urdf"};
  bare.insert(bare.end(), switches.begin(), switches.end());
  const auto is_one_of = [](const std::vector<std::string>& flags, const std::string& flag) {
    return std::find(flags.begin(), flags.end(), flag) != flags.end();
  };
  for (const char* verb : {"walk", "plan", "play", "trials", "audit"}) {
    std::istringstream help(Of({verb}));
    std::string flag, text;
    const auto check = [&] {
      if (flag.empty() || is_one_of(bare, flag)) return;
      const bool optional = flag == "--distance" || flag == "--goal" || flag == "--steps";  // only one of them
      EXPECT_TRUE(optional || text.find("default") != std::string::npos || text.find("Default") != std::string::npos)
          << verb << " " << flag << ": " << text;
    };
    for (std::string line; std::getline(help, line);) {
      if (line.starts_with("  --")) {
        check();
        flag = Words(line).front();
        text = line;
        EXPECT_TRUE(is_one_of(switches, flag) || line.substr(2 + flag.size(), 2) != "  ")
            << verb << " " << flag << " has no type or unit";
      } else if (line.starts_with("     ")) {
        text += line;
      } else {
        check();
        flag.clear();
      }
    }
  }
}

TEST_F(Help, EveryOptionOfTheListCanBeSetToItsDefault) {
  MakePlan("plan.json");
  for (const std::string verb : {"plan", "play"}) {
    const Json options = Run({verb, "--list-options=all", "--json"}).json().at("options");
    EXPECT_GT(options.size(), 10U);
    std::vector<std::string> arguments = {"play", "plan.json", "--quiet"};
    if (verb == "plan") arguments = {"plan", "--distance", "0.3", "--quiet"};
    const std::string without = verb == "plan" ? Read("plan.json") : Run(arguments).out;
    for (const Json& option : options) {
      EXPECT_FALSE(option.at("meaning").get<std::string>().empty()) << option;
      arguments.insert(arguments.end(),
                       {"--set", option.at("key").get<std::string>() + "=" + option.at("default").get<std::string>()});
    }
    const Ran ran = Run(arguments);
    EXPECT_EQ(ran.status, 0) << ran.err;
    EXPECT_TRUE(without == (verb == "plan" ? Read("plan.json") : ran.out)) << "the defaults change nothing";
  }
  EXPECT_NE(Run({"walk", "--list-options"}).out.find("swing.height_m = 0 m  (0 to 1)"), std::string::npos);
  EXPECT_NE(Run({"play", "--list-options"}).out.find("play.push_on = base  (text)"), std::string::npos);
}

TEST_F(Help, AdvancedOptionsAreListedWhenAskedFor) {
  for (const std::string verb : {"walk", "play", "audit", "import", "bench centroidal"}) {
    std::istringstream words(verb);
    std::vector<std::string> arguments(std::istream_iterator<std::string>(words), {});
    const auto listed = [&](const char* flag) {
      std::vector<std::string> with = arguments;
      with.insert(with.end(), {flag, "--json"});
      return Run(with).json().at("options");
    };
    const Json basic = listed("--list-options"), all = listed("--list-options=all");
    EXPECT_LT(basic.size(), all.size()) << verb;
    for (std::size_t i = 0; i < all.size(); ++i) {
      EXPECT_EQ(all[i].at("advanced").get<bool>(), i >= basic.size()) << verb << " " << all[i];
      if (i < basic.size()) {
        EXPECT_EQ(all[i], basic[i]);
      }
    }
  }
  const auto refused = Run({"walk", "--list-options=some"});
  EXPECT_EQ(refused.status, 1);
  EXPECT_NE(refused.err.find(": walk: --list-options: 'some' is not accepted"), std::string::npos) << refused.err;
}

TEST_F(Help, EveryOptionTextStandsAlone) {
  const std::vector<std::string> dependent = {"The same", "Of ", "And ", "Or ", "By which", "Likewise"};
  std::set<std::string> texts;
  for (const auto& verb : kVerbs) {
    std::vector<std::string> arguments = verb;
    arguments.insert(arguments.end(), {"--list-options=all", "--json"});
    const Ran ran = Run(arguments);
    if (ran.status != 0) continue;  // a verb without options
    const Json options = ran.json().at("options");
    for (const Json& option : options) texts.insert(option.at("meaning").get<std::string>());
  }
  EXPECT_GT(texts.size(), 200U);
  for (const std::string& text : texts) {
    EXPECT_TRUE(text.size() > 10 && std::isupper(static_cast<unsigned char>(text.front()))) << text;
    EXPECT_TRUE(text.ends_with('.')) << text;
    EXPECT_LE(std::count(text.begin(), text.end(), ' '), 27) << text;
    for (const std::string& start : dependent) EXPECT_FALSE(text.starts_with(start)) << text;
    EXPECT_EQ(text.find("likewise"), std::string::npos) << text;
  }
}

TEST_F(Help, TheReadmeNamesTheVerbsThatListTheirOptions) {
  std::ifstream file(SourceFolder() + "/README.md");
  const std::string readme(std::istreambuf_iterator<char>(file), {});
  const std::size_t begin = readme.find("have options (");
  ASSERT_NE(begin, std::string::npos);
  const std::string named = readme.substr(begin, readme.find(')', begin) - begin);
  for (const auto& verb : kVerbs) {
    std::string name;
    for (const std::string& word : verb) name += (name.empty() ? "`" : " ") + word;
    std::vector<std::string> arguments = verb;
    arguments.push_back("--list-options");
    EXPECT_EQ(named.find(name + "`") != std::string::npos, Run(arguments).status == 0) << name;
  }
}

TEST_F(Help, VersionIsANumber) {
  const Ran ran = Run({"--version"});
  EXPECT_EQ(ran.status, 0);
  int major = 0, minor = 0, patch = 0;
  EXPECT_EQ(std::sscanf(ran.out.c_str(), "%d.%d.%d", &major, &minor, &patch), 3) << ran.out;
}

}  // namespace
}  // namespace gaitwright::cli
