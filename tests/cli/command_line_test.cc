// SPDX-License-Identifier: BSD-3-Clause
#include "cli/command_line.h"

#include <gtest/gtest.h>

#include <sstream>

#include "cli/usage.h"
#include "kinematics/base/version.h"

namespace gaitwright::cli {
namespace {

/// A program with the verbs `walk` and `robots show`.
class TwoVerbs {
 public:
  TwoVerbs() {
    walk.AddValue("--speed", speed, "Speed, with a description of so many words that no line of a terminal holds it.");
    walk.AddValue("--set", sets, "Sets.").Repeat();
    walk.AddSwitch("--quiet", quiet, "Says less.");
    walk.SetWork([this] { ++walked; });
    show.AddValue("NAME", name, "Which.").Require();
  }

  std::optional<int> Run(std::vector<std::string> words) {
    words.insert(words.begin(), "gaitwright");
    std::vector<const char*> argv;
    for (const std::string& word : words) argv.push_back(word.c_str());
    return line.Run(static_cast<int>(argv.size()), argv.data());
  }
  /// The failure of a command line that cannot be read.
  Failure Refused(const std::vector<std::string>& words) {
    try {
      Run(words);
    } catch (const UsageError& error) {
      return UsageFailure(line.program(), error);
    }
    ADD_FAILURE() << "nothing was refused";
    return {};
  }

  CommandLine line{"Plans gaits.", "Its end."};
  Verb walk = line.program().AddVerb("walk", "Walks."), robots = line.program().AddVerb("robots", "Robots.");
  Verb show = robots.AddVerb("show", "Shows one.");
  double speed = 0.0;
  std::vector<std::string> sets;
  std::string name;
  bool quiet = false;
  int walked = 0;
};

void ExpectSays(const std::string& text, const std::vector<std::string>& parts) {
  for (const std::string& part : parts) EXPECT_NE(text.find(part), std::string::npos) << part << " in: " << text;
}

TEST(CommandLineOfVerbs, RunsTheVerbThatIsNamedWithItsValues) {
  TwoVerbs program;
  EXPECT_FALSE(program.Run({"walk", "--speed", "0.5", "--set", "a=1", "--set", "b=2", "--quiet"}));
  EXPECT_EQ(program.speed, 0.5);
  EXPECT_EQ(program.sets, (std::vector<std::string>{"a=1", "b=2"}));
  EXPECT_TRUE(program.quiet);
  EXPECT_EQ(program.walked, 1);
  EXPECT_EQ(program.line.program().chosen()->name(), "walk");
}

TEST(CommandLineOfVerbs, VerbsHaveTheWordsThatLeadToThem) {
  TwoVerbs program;
  EXPECT_EQ(program.walk.words(), "walk");
  EXPECT_EQ(program.show.words(), "robots show");
  EXPECT_EQ(program.line.program().words(), "gaitwright");
  EXPECT_FALSE(program.Run({"robots", "show", "a1"}));
  EXPECT_EQ(program.name, "a1");
}

TEST(CommandLineOfVerbs, HelpAndVersionEndWithPass) {
  TwoVerbs program;
  program.line.LayOutHelp();
  testing::internal::CaptureStdout();
  const std::optional<int> version = program.Run({"--version"});
  EXPECT_EQ(testing::internal::GetCapturedStdout(), std::string(Version()) + "\n");
  EXPECT_EQ(version, 0);
  testing::internal::CaptureStdout();
  EXPECT_EQ(program.Run({"walk", "--help"}), 0);
  const std::string help = testing::internal::GetCapturedStdout();
  ExpectSays(help, {"Walks.", "--speed", "--set", "-h"});
  std::istringstream lines(help);
  for (std::string text; std::getline(lines, text);) EXPECT_LE(text.size(), 101U) << text;
  EXPECT_EQ(help.find("\n\n\n"), std::string::npos) << "one empty line between groups";
  EXPECT_EQ(program.walked, 0) << "help walks nowhere";
}

TEST(CommandLineOfVerbs, AMisspeltVerbOrFlagNamesTheNearest) {
  TwoVerbs program;
  const Failure verb = program.Refused({"wlak"}), flag = program.Refused({"walk", "--sped", "1"});
  EXPECT_EQ(verb.code, FailureCode::kUsage);
  EXPECT_EQ(verb.kind, FailureKind::kBadInput);
  ExpectSays(verb.message, {"there is no verb 'wlak'", "the nearest is 'walk'", "'robots'"});
  EXPECT_EQ(verb.suggestions.at(0).text, "gaitwright --help");
  EXPECT_EQ(flag.message, "walk has no flag '--sped'; the nearest is '--speed'");
  EXPECT_EQ(flag.suggestions.at(0).text, "gaitwright walk --help");
  EXPECT_EQ(program.Refused({"walk", "--zzzzzz=3"}).message, "walk has no flag '--zzzzzz'") << "nothing is near";
}

TEST(CommandLineOfVerbs, WhatIsMissingOrTooManyIsSaid) {
  TwoVerbs program;
  ExpectSays(program.Refused({}).message, {"a verb is needed", "'walk'", "'robots'"});
  EXPECT_EQ(program.Refused({"walk", "--speed"}).message, "walk: --speed needs a value");
  EXPECT_EQ(program.Refused({"walk", "--speed", "1", "--speed", "2"}).message, "walk: --speed is given more than once");
  EXPECT_EQ(program.Refused({"walk", "fast"}).message, "walk: unexpected argument 'fast'");
  ExpectSays(program.Refused({"robots", "shwo"}).message, {"'robots shwo'", "'show'"});
  ExpectSays(program.Refused({"robots", "show"}).message, {"robots show: ", "NAME"});
}

TEST(CommandLineOfVerbs, AReadersRefusalIsThatOfItsFlag) {
  TwoVerbs program;
  program.walk.AddReader(
      "--mood", [](const std::string& text) { throw InvalidArgument("'" + text + "' is no mood"); }, "Mood.");
  ExpectSays(program.Refused({"walk", "--mood", "blue"}).message, {"walk: ", "--mood", "'blue' is no mood"});
}

TEST(CommandLineOfVerbs, FlagsExcludeAndNeedEachOther) {
  TwoVerbs program;
  double distance = 0.0, duration = 0.0, length = 0.0;
  const Flag far = program.walk.AddValue("--distance", distance, "How far.");
  program.walk.AddValue("--duration", duration, "How long.").Exclude(far);
  program.walk.AddValue("--length", length, "Of a step.").Need(far);
  ExpectSays(program.Refused({"walk", "--distance", "1", "--duration", "2"}).message, {"--distance", "--duration"});
  ExpectSays(program.Refused({"walk", "--length", "1"}).message, {"--length", "--distance"});
  EXPECT_FALSE(program.Run({"walk", "--distance", "1", "--length", "0.1"}));
  EXPECT_TRUE(program.walk.Given("--length"));
  EXPECT_FALSE(program.walk.Given("--duration"));
}

TEST(CommandLineOfVerbs, FlagsTellWhatTheyAre) {
  TwoVerbs program;
  ASSERT_TRUE(program.walk.Find("--speed"));
  const Flag speed = program.walk.Find("--speed")->SetType("m/s").SetGroup("Pace");
  EXPECT_EQ(speed.name(), "--speed");
  EXPECT_EQ(speed.type(), "m/s");
  EXPECT_EQ(speed.group(), "Pace");
  EXPECT_EQ(speed.long_names(), std::vector<std::string>{"speed"});
  EXPECT_FALSE(speed.is_positional());
  EXPECT_EQ(program.walk.Find("--quiet")->type(), "") << "a switch has no value";
  EXPECT_TRUE(program.show.Find("NAME")->is_positional());
  EXPECT_FALSE(program.walk.Find("--spood"));
  program.walk.Find("--quiet")->Trigger();
  EXPECT_TRUE(program.quiet);
  EXPECT_FALSE(program.walk.Given("--quiet")) << "triggered, and not given";
}

}  // namespace
}  // namespace gaitwright::cli
