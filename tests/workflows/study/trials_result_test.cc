// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/study/trials_result.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace gaitwright {
namespace {

using Json = nlohmann::ordered_json;

Json Good() {
  return {{"n", 20},
          {"survived", 19},
          {"passed", 17},
          {"survival", 0.95},
          {"survival_low", 0.7639},
          {"survival_high", 0.9911},
          {"metrics", {{"goal_error_m", {{"p95", 0.1}}}}},
          {"causes", {{"tipped over", 1}}},
          {"worst", {{{"seed", 7}, {"cause", "tipped"}, {"reason", "tipped at 2 s"}}, {{"seed", 9}, {"cause", ""}}}},
          {"controller", "stabilised"},
          {"disturbances", "friction: 0.5\n"},
          {"options", {{"state", "true"}, {"play.friction", "0.4"}}},
          {"plan_hash", "p"},
          {"whole_plan_hash", "w"},
          {"robot_hash", "r"}};
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
  EXPECT_EQ(read->options, (OptionTexts{{"state", "true"}, {"play.friction", "0.4"}})) << "in their order";
  EXPECT_EQ(read->controller, "stabilised");
  EXPECT_EQ(read->disturbances, "friction: 0.5\n");
  ASSERT_EQ(read->causes.size(), 1U);
  EXPECT_EQ(read->causes[0].name, "tipped over");
  EXPECT_EQ(read->causes[0].count, 1);
  ASSERT_EQ(read->worst.size(), 2U);
  EXPECT_EQ(read->worst[0].seed, 7U);
  EXPECT_EQ(read->worst[0].words, "tipped at 2 s");
  EXPECT_EQ(read->worst[1].words, "");
  const auto listed = TrialsResultFromJson(With("causes", {{{"cause", "slipped"}, {"count", 1}}}).dump(), "t");
  ASSERT_TRUE(listed) << listed.failure().message;
  EXPECT_EQ(listed->causes[0].name, "slipped");
}

TEST(TrialsResults, ThatSayNonsenseAreRefused) {
  for (const char* key : {"n", "survived", "passed", "survival", "survival_low", "survival_high", "plan_hash",
                          "whole_plan_hash", "robot_hash", "options"}) {
    Json json = Good();
    json.erase(key);
    ExpectNo(json, "'" + std::string(key) + "'");
  }
  ExpectNo(With("n", 0), "'n'");
  ExpectNo(With("n", 20.5), "'n'");
  ExpectNo(With("n", 1e300), "'n'");
  ExpectNo(With("survived", 21), "no more survivors");
  ExpectNo(With("survived", -1), "'survived'");
  ExpectNo(With("survival", 0.5), "19 of 20");
  ExpectNo(With("survival_low", 0.96), "19 of 20");
  ExpectNo(With("survival_high", 1.5), "'survival_high'");
  ExpectNo(With("survival_high", nullptr), "'survival_high'");
  ExpectNo(With("plan_hash", 3), "'plan_hash'");
  ExpectNo(With("plan_hash", ""), "is empty");
  ExpectNo(With("passed", 20), "20 trials passed every gate, where 19 survived");
  ExpectNo(With("whole_plan_hash", ""), "is empty");
  ExpectNo(With("options", "many"), "'options'");
  ExpectNo(With("options", {{"play.friction", 0.4}}), "play.friction");
  ExpectNo(With("causes", "many"), "'causes'");
  ExpectNo(With("causes", {{"tipped", -1}}), "tipped");
  ExpectNo(With("causes", {{{"count", 1}}}), "name and count");
  ExpectNo(With("causes", {{"tipped", 21}}), "21 of 20");
  ExpectNo(With("survival_low", 0.5), "19 of 20");
  ExpectNo(With("worst", {{{"number", 1}}}), "'seed'");
  ExpectNo(With("worst", {{{"seed", -1}}}), "seed");
  ExpectNo(With("worst", 3), "'worst'");
  ExpectNo(Json::array(), "no object");
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
