// SPDX-License-Identifier: BSD-3-Clause
// Flags are parsed as in the program, without starting it.
#include "cli/flags.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "cli/command_line.h"
#include "cli/listed_options.h"
#include "kinematics/base/result.h"

namespace gaitwright::cli {
namespace {

/// A program with one verb, `go`, whose flags tests add.
class GoProgram {
 public:
  Verb verb() const { return verb_; }

  /// @throws UsageError
  void Read(std::vector<std::string> words) {
    words.insert(words.begin(), {"gaitwright", "go"});
    std::vector<const char*> argv;
    for (const std::string& word : words) argv.push_back(word.c_str());
    EXPECT_FALSE(line_.Run(static_cast<int>(argv.size()), argv.data()));
  }
  std::string Refusal(const std::vector<std::string>& words) {
    try {
      Read(words);
    } catch (const UsageError& error) {
      return error.what();
    }
    return "";
  }

 private:
  CommandLine line_{"a program", "its end"};
  Verb verb_ = line_.program().AddVerb("go", "Goes.");
};

/// Options of each type.
struct GoOptions {
  double speed = 0.5;
  int count = 3;
  bool quick = false;
  std::string gait = "trot";
  double gain = 1.0;

  OptionFields Fields() {
    return {{"speed_m_s", &speed, "m/s", 0.0, 2.0, "Speed."},
            {"count", &count, "1", 1, 9, "How many."},
            {"quick", &quick, "", 0.0, 0.0, "Whether it hurries."},
            {"gait", &gait, "", 0.0, 0.0, "Gait.", {"trot", "walk"}},
            {.key = "gain",
             .target = &gain,
             .unit = "1/s",
             .lowest = 0.0,
             .highest = 10.0,
             .meaning = "Gain.",
             .advanced = true}};
  }
};

TEST(CliFlags, NumbersAndTextsAreReadIntoTheirTargets) {
  GoProgram program;
  double speed = 0.0;
  std::optional<double> far;
  std::optional<int> steps;
  std::string name = "usual";
  AddNumber(program.verb(), "--speed", "m/s", speed, "Speed.");
  AddNumber(program.verb(), "--far", "m", far, "How far.");
  AddWholeNumber(program.verb(), "--steps", 1, steps, "How many.");
  AddText(program.verb(), "--name", "NAME", name, "Name.");
  program.Read({"--speed", "-0.25", "--steps=4"});
  EXPECT_EQ(speed, -0.25);
  EXPECT_EQ(steps, 4);
  EXPECT_FALSE(far) << "not given";
  EXPECT_EQ(name, "usual");
}

TEST(CliFlags, ValuesThatDoNotFitAreRefusedWithTheFlag) {
  GoProgram program;
  double speed = 0.0;
  int count = 0;
  std::string name;
  AddNumber(program.verb(), "--speed", "m/s", speed, "Speed.");
  AddWholeNumber(program.verb(), "--count", 2, count, "How many.");
  AddText(program.verb(), "--name", "NAME", name, "Name.");
  for (const auto& [words, why] : std::vector<std::pair<std::vector<std::string>, std::string>>{
           {{"--speed", "fast"}, "'fast' is not a finite number"},
           {{"--speed", "inf"}, "'inf' is not a finite number"},
           {{"--count", "1"}, "1 is too small; accepted: 2 or more"},
           {{"--count", "2.5"}, "'2.5' is not a whole number"},
           {{"--count", "3000000000"}, "3000000000 is too large; accepted: 2 to 2147483647"},
           {{"--name", ""}, "it is empty"}}) {
    const std::string refusal = program.Refusal(words);
    EXPECT_NE(refusal.find(why), std::string::npos) << refusal;
    EXPECT_NE(refusal.find(words[0]), std::string::npos) << refusal;
  }
}

TEST(CliFlags, AFieldGivesItsFlagUnitRangeDefaultAndMeaning) {
  GoProgram program;
  GoOptions options;
  const Flag speed = AddField(program.verb(), "--speed", options.Fields(), "speed_m_s");
  const Flag gait = AddField(program.verb(), "--gait", options.Fields(), "gait");
  const Flag count = AddField(program.verb(), "--count", options.Fields(), "count");
  EXPECT_EQ(speed.type(), "m/s");
  EXPECT_EQ(speed.description(), "Speed. From 0 to 2; default 0.5.");
  EXPECT_EQ(gait.type(), "trot|walk");
  EXPECT_EQ(gait.description(), "Gait. Default trot.");
  EXPECT_EQ(count.type(), "NUMBER");
  program.Read({"--speed", "1.25", "--gait", "walk"});
  EXPECT_EQ(options.speed, 1.25);
  EXPECT_EQ(options.gait, "walk");
  EXPECT_TRUE(speed.given());
  EXPECT_FALSE(count.given());
  EXPECT_THROW(AddField(program.verb(), "--x", options.Fields(), "no_such_key"), InvalidArgument);
}

TEST(CliFlags, AFieldsRangeIsThatOfItsFlag) {
  GoProgram program;
  GoOptions options;
  AddField(program.verb(), "--speed", options.Fields(), "speed_m_s");
  const std::string refusal = program.Refusal({"--speed", "3"});
  EXPECT_NE(refusal.find("0 to 2"), std::string::npos) << refusal;
  EXPECT_EQ(options.speed, 0.5);
}

TEST(CliFlags, SetsGoToTheFieldsInTheirOrder) {
  GoOptions options;
  ApplySets("--set", {"speed_m_s=1.5", "quick=true", "gait=walk"}, options.Fields());
  EXPECT_EQ(options.speed, 1.5);
  EXPECT_TRUE(options.quick);
  EXPECT_EQ(options.gait, "walk");
}

std::string RefusalOfSets(const std::vector<std::string>& sets, const OptionFields& fields) {
  try {
    ApplySets("--set", sets, fields);
  } catch (const InvalidArgument& error) {
    return error.what();
  }
  return "nothing was refused";
}

TEST(CliFlags, SetsThatDoNotFitAreRefused) {
  GoOptions options;
  const OptionFields fields = options.Fields();
  EXPECT_EQ(RefusalOfSets({"speed_m_s"}, fields), "--set: 'speed_m_s' has no '='; key=value is needed");
  EXPECT_EQ(RefusalOfSets({"count=2", "count=3"}, fields), "--set: 'count' is given twice; leave one of them out");
  EXPECT_NE(RefusalOfSets({"cuont=2"}, fields).find("'count'"), std::string::npos) << "the nearest key";
  EXPECT_NE(RefusalOfSets({"count=99"}, fields).find("1 to 9"), std::string::npos);
}

TEST(CliFlags, WhatAFieldAcceptsIsSaidByItsKind) {
  GoOptions options;
  std::vector<std::string> accepted;
  for (const OptionField& field : options.Fields()) accepted.push_back(AcceptedOf(field));
  EXPECT_EQ(accepted, (std::vector<std::string>{"0 to 2", "1 to 9", "true, false", "trot, walk", "0 to 10"}));
  std::string any;
  EXPECT_EQ(AcceptedOf({"name", &any, "", 0.0, 0.0, "Name."}), "text");
}

TEST(CliFlags, BasicOptionsComeFirstAndAdvancedOnesOnlyWhereAllAreAskedFor) {
  GoOptions options;
  OptionFields fields = options.Fields();
  std::rotate(fields.begin(), fields.end() - 1, fields.end());  // the advanced one first
  const OptionFields basics = BasicsFirst(fields, false), all = BasicsFirst(fields, true);
  EXPECT_EQ(basics.size(), 4U);
  ASSERT_EQ(all.size(), 5U);
  EXPECT_EQ(all.back().key, "gain");
  for (std::size_t k = 0; k < basics.size(); ++k) EXPECT_EQ(basics[k].key, all[k].key) << "else the order is kept";
}

TEST(CliFlags, ListingOptionsEndsTheProgramWithThoseOfTheVerb) {
  const auto listed = [](const std::string& flag, const std::vector<std::string>& before = {}) -> std::size_t {
    GoProgram program;
    GoOptions options;
    bool json = false;
    std::vector<std::string> sets;
    program.verb().AddSwitch("--json", json, "As JSON.");
    AddOptionFlags(program.verb(), options.Fields(), sets, json);
    std::vector<std::string> words = before;
    words.push_back(flag);
    try {
      program.Read(words);
    } catch (const ListedOptions& asked) {
      EXPECT_EQ(asked.as_json(), !before.empty());
      return asked.fields().size();
    }
    return 0;
  };
  EXPECT_EQ(listed("--list-options"), 4U);
  EXPECT_EQ(listed("--list-options=all"), 5U);
  GoProgram program;
  GoOptions options;
  bool json = false;
  std::vector<std::string> sets;
  AddOptionFlags(program.verb(), options.Fields(), sets, json);
  EXPECT_NE(program.Refusal({"--list-options=some"}).find("'some' is not accepted"), std::string::npos);
}

}  // namespace
}  // namespace gaitwright::cli
