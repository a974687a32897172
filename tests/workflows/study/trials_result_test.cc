// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/study/trials_result.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "workflows/walk/walk.h"

namespace gaitwright {
namespace {

using Json = nlohmann::ordered_json;

/// Twenty trials: the first fell, and two of the others failed a gate.
Json Rows() {
  Json rows = Json::array();
  for (int i = 0; i < 20; ++i)
    rows.push_back(
        {i, i > 0, i > 2, i == 0 ? "a foot slid" : (i > 2 ? "" : "goal_error_m"), "log" + std::to_string(i)});
  return rows;
}

Json Options() {
  PlayRequest request;
  Json options;
  for (const auto& [key, text] : TextsOf(request.Fields())) options[key] = text;
  options["play.friction"] = "0.4";
  return options;
}

Json Good() {
  return {{"n", 20},
          {"survived", 19},
          {"passed", 17},
          {"survival", 0.95},
          {"survival_low", 0.7639},
          {"survival_high", 0.9911},
          {"metrics", {{"goal_error_m", {{"p95", 0.1}}}}},
          {"causes", {{"a foot slid", 1}}},
          {"worst", {{{"seed", 7}, {"cause", "tipped"}, {"reason", "tipped at 2 s"}}, {{"seed", 9}, {"cause", ""}}}},
          {"controller", "stabilised"},
          {"disturbances", "friction: 0.5\n"},
          {"options", Options()},
          {"plan_hash", "p"},
          {"whole_plan_hash", "w"},
          {"robot_hash", "r"},
          {"trials", {{"columns", {"seed", "survived", "passed", "cause", "log_hash"}}, {"rows", Rows()}}}};
}

void ExpectNo(const Json& json, const std::string& part) {
  const auto read = TrialsResultFromJson(json.dump(), "trials.json");
  ASSERT_FALSE(read) << part;
  EXPECT_EQ(read.failure().kind, FailureKind::kBadInput);
  EXPECT_NE(read.failure().message.find("'trials.json'"), std::string::npos) << read.failure().message;
  EXPECT_NE(read.failure().message.find(part), std::string::npos) << read.failure().message;
}

Json With(const char* key, const Json& value) {
  Json json = Good();
  json[key] = value;
  return json;
}

/// A valid result with another value in one cell of its rows.
Json WithCell(std::size_t row, std::size_t column, const Json& value) {
  Json json = Good();
  json["trials"]["rows"][row][column] = value;
  return json;
}

TEST(TrialsResults, AreReadWithCausesAndWorst) {
  const auto read = TrialsResultFromJson(Good().dump(), "trials.json");
  ASSERT_TRUE(read) << read.failure().message;
  EXPECT_EQ(read->n, 20);
  EXPECT_EQ(read->survived, 19);
  EXPECT_EQ(read->survival_low, 0.7639);
  EXPECT_EQ(read->passed, 17);
  EXPECT_EQ(read->pass_share(), WilsonInterval(17, 20));
  EXPECT_EQ(read->plan_hash, "p");
  EXPECT_EQ(read->whole_plan_hash, "w");
  PlayRequest usual;
  OptionTexts options = TextsOf(usual.Fields());
  for (auto& [key, text] : options) text = key == "play.friction" ? "0.4" : text;
  EXPECT_EQ(read->options, options) << "in their order";
  EXPECT_EQ(read->controller, "stabilised");
  EXPECT_EQ(read->disturbances, "friction: 0.5\n");
  ASSERT_EQ(read->causes.size(), 1U);
  EXPECT_EQ(read->causes[0].name, "a foot slid");
  EXPECT_EQ(read->causes[0].count, 1);
  ASSERT_EQ(read->worst.size(), 2U);
  EXPECT_EQ(read->worst[0].seed, 7U);
  EXPECT_EQ(read->worst[0].words, "tipped at 2 s");
  EXPECT_EQ(read->worst[1].words, "");
  EXPECT_EQ(read->different, 20);
}

TEST(TrialsResults, CountEachLogOnce) {
  Json json = Good();
  for (std::size_t i = 5; i < 20; ++i) json["trials"]["rows"][i][4] = "log5";
  json["trials"]["rows"][1][4] = "log2";
  const auto read = TrialsResultFromJson(json.dump(), "trials.json");
  ASSERT_TRUE(read) << read.failure().message;
  EXPECT_EQ(read->different, 5) << "0, 2, 3, 4, 5";
  EXPECT_EQ(read->different_survived, 4);
  EXPECT_EQ(read->different_passed, 3);
}

TEST(TrialsResults, ThatContradictTheirRowsAreRefused) {
  ExpectNo(WithCell(4, 1, false), "passed every gate but did not survive");
  ExpectNo(WithCell(1, 1, false), "19 of 20 trials survived, but 18 of its rows did");
  ExpectNo(WithCell(1, 2, true), "17 of 20 trials passed every gate, but 18 of its rows did");
  ExpectNo(WithCell(0, 3, "the base tilted"), "1 of 20 trials fell as 'a foot slid', but 0 of its rows did");
  ExpectNo(WithCell(0, 1, 1), "neither true nor false");
  ExpectNo(WithCell(0, 4, ""), "is empty");
  ExpectNo(With("causes", {{"foo", 1}}), "'foo', which is not a cause of falls");
  ExpectNo(With("causes", Json::object()), "causes of 0 falls, but 1 trials fell");
  ExpectNo(With("causes", {{"a foot slid", 21}}), "21 of 20 trials fell as 'a foot slid', but 1 of its rows did");
  ExpectNo(With("n", 500), "there were 500 trials, but has rows of 20");
  Json json = Good();
  json["trials"]["rows"].erase(7);
  ExpectNo(json, "has rows of 19");
  json = Good();
  json["trials"]["rows"][7].erase(4);
  ExpectNo(json, "has 4 values for 5 columns");
  json = Good();
  json["trials"]["columns"][4] = "hash";
  ExpectNo(json, "lacks the column 'log_hash'");
}

TEST(TrialsResults, ThatDoNotSayWhatTheyWerePlayedUnderAreRefused) {
  ExpectNo(With("options", Json::object()), "'options' lacks '");
  Json json = Good();
  json["options"].erase("play.mass_scale");
  ExpectNo(json, "lacks 'play.mass_scale'");
  json["options"] = Options();
  json["options"]["play.of_tomorrow"] = "1";
  EXPECT_TRUE(TrialsResultFromJson(json.dump(), "t")) << "one that is not known is told as such";
  ExpectNo(With("disturbances", "{}"), "contains no disturbances");
  ExpectNo(With("disturbances", ""), "contains no disturbances");
  ExpectNo(With("disturbances", "frction: 0.5\n"), "'friction'");
}

TEST(TrialsResults, AnotherFileOfOursIsCalledByItsName) {
  ExpectNo(Json{{"format", "gaitwright-motion-plan"}}, "is a gaitwright-motion-plan; a result of 'gaitwright trials'");
}

TEST(TrialsResults, ThatSayNonsenseAreRefused) {
  for (const char* key : {"n", "survived", "passed", "survival", "survival_low", "survival_high", "plan_hash",
                          "whole_plan_hash", "robot_hash", "options", "disturbances", "causes", "trials"}) {
    Json json = Good();
    json.erase(key);
    ExpectNo(json, "'" + std::string(key) + "'");
  }
  ExpectNo(With("n", 0), "'n'");
  ExpectNo(With("n", 20.5), "'n'");
  ExpectNo(With("n", 1e300), "'n'");
  ExpectNo(With("survived", 21), "21 of 20 trials survived, but 19 of its rows did");
  ExpectNo(With("survived", -1), "'survived'");
  ExpectNo(With("survival", 0.5), "19 of 20");
  ExpectNo(With("survival_low", 0.96), "19 of 20");
  ExpectNo(With("survival_high", 1.5), "'survival_high'");
  ExpectNo(With("survival_high", nullptr), "'survival_high'");
  ExpectNo(With("plan_hash", 3), "'plan_hash'");
  ExpectNo(With("plan_hash", ""), "is empty");
  ExpectNo(With("passed", 20), "20 of 20 trials passed every gate, but 17 of its rows did");
  ExpectNo(With("whole_plan_hash", ""), "is empty");
  ExpectNo(With("options", "many"), "'options'");
  Json options = Options();
  options["play.friction"] = 0.4;
  ExpectNo(With("options", options), "play.friction");
  ExpectNo(With("causes", "many"), "'causes'");
  ExpectNo(With("causes", {{"a foot slid", -1}}), "a foot slid");
  ExpectNo(With("survival_low", 0.5), "19 of 20");
  ExpectNo(With("worst", {{{"number", 1}}}), "'seed'");
  ExpectNo(With("worst", {{{"seed", -1}}}), "seed");
  ExpectNo(With("worst", 3), "'worst'");
  ExpectNo(Json::array(), "not an object");
}

TEST(TrialsResults, ThatAreNoJsonAreRefused) {
  const std::string text = Good().dump();
  for (const std::string& bad : {std::string(), text.substr(0, text.size() / 2), std::string("n=1")}) {
    const auto read = TrialsResultFromJson(bad, "trials.json");
    ASSERT_FALSE(read);
    EXPECT_FALSE(read.failure().message.empty());
  }
  EXPECT_FALSE(LoadTrialsResult("/nowhere/trials.json"));
}

}  // namespace
}  // namespace gaitwright
