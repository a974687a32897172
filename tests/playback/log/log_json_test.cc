// SPDX-License-Identifier: BSD-3-Clause
#include "playback/log/log_json.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/scratch_folder.h"

namespace gaitwright {
namespace {

PlaybackLog Example() {
  PlaybackLog log;
  log.robot = "a \"quoted\" robot";
  log.program_version = "1.2.3";
  log.robot_hash = "0123456789abcdef";
  log.plan_hash = "fedcba9876543210";
  log.controller = "joint-pd";
  log.start_s = 0.1;
  log.total_mass_kg = 13.741;
  log.friction = 0.8;
  log.options = {{"step_s", "0.001"}, {"actuation", "implicit-pd"}};
  log.saturated_s = Vector2(0.1, 1.0 / 3.0);
  log.stances = {{1, 0.1, 0.7, Vector3(1.0 / 3.0, 2.0, 3.0), 0.2, 1e-7, 55.5, 2e-6, 0.3}};
  log.body_contacts = {{0.55, "trunk"}};
  log.pushes = {{Vector3(1.0, -2.0, 0.5), 0.25, 0.125, "robot"}};
  std::srand(1);
  for (int k = 0; k < 3; ++k) {
    LogSample sample;
    sample.time_s = 0.1 + 0.005 * (k + 1);
    sample.q = VectorX::Random(9);
    sample.q.segment<4>(3).normalize();
    sample.v = VectorX::Random(8);
    sample.tau = 1e-300 * VectorX::Random(2);
    sample.tau_peak = VectorX::Random(2).cwiseAbs();
    sample.effort_use = Vector2(1.0 / 3.0, 1.0);
    sample.wrenches = {{Vector3::Random(), Vector3::Random()}, {Vector3::Random(), Vector3::Zero()}};
    sample.contact = 3;
    log.samples.push_back(sample);
  }
  return log;
}

std::string Why(const std::string& text) {
  const auto result = LogFromJson(text, "some.json");
  EXPECT_FALSE(result.ok());
  return result.ok() ? "" : result.failure().message;
}

std::string Replaced(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

TEST(LogJson, ReadsBackExactlyWhatItWrote) {
  const PlaybackLog log = Example();
  const std::string text = LogToJson(log);
  const PlaybackLog back = LogFromJson(text, "x").value();
  EXPECT_EQ(LogToJson(back), text);
  EXPECT_EQ(back.program_version, log.program_version);
  EXPECT_EQ(back.robot, log.robot);
  EXPECT_EQ(back.options, log.options);
  EXPECT_EQ(back.body_contacts, log.body_contacts);
  EXPECT_EQ(back.pushes, log.pushes);
  EXPECT_EQ(back.saturated_s, log.saturated_s);
  ASSERT_EQ(back.samples.size(), 3U);
  EXPECT_EQ(back.samples[2].q, log.samples[2].q);
  EXPECT_EQ(back.samples[2].tau, log.samples[2].tau);
  EXPECT_EQ(back.samples[2].effort_use, log.samples[2].effort_use);
  EXPECT_EQ(back.samples[2].wrenches, log.samples[2].wrenches);
  EXPECT_EQ(back.samples[2].contact, log.samples[2].contact);
  EXPECT_EQ(back.stances[0].p_touchdown_W, log.stances[0].p_touchdown_W);
  EXPECT_EQ(back.stances[0].friction_use_max, log.stances[0].friction_use_max);
}

TEST(LogJson, KeepsWhatTheControllerTookForTrueWhereThereIsAny) {
  PlaybackLog log = Example();
  EXPECT_EQ(LogToJson(log).find("\"estimate\""), std::string::npos);
  EXPECT_FALSE(LogFromJson(LogToJson(log), "x").value().samples[1].estimate.has_value());
  for (LogSample& sample : log.samples) {
    sample.estimate = BaseEstimate{Vector3::Random(), Quaternion::UnitRandom(), Vector3::Random(), Vector3::Random()};
  }
  const std::string text = LogToJson(log);
  const PlaybackLog back = LogFromJson(text, "x").value();
  EXPECT_EQ(LogToJson(back), text);
  EXPECT_EQ(back.samples[2].estimate->p_WB, log.samples[2].estimate->p_WB);
  EXPECT_EQ(back.samples[2].estimate->R_WB.coeffs(), log.samples[2].estimate->R_WB.coeffs());
  EXPECT_EQ(back.samples[2].estimate->v_WB, log.samples[2].estimate->v_WB);
  EXPECT_EQ(back.samples[2].estimate->w_WB, log.samples[2].estimate->w_WB);
  const std::size_t rows = text.find("\"estimate\"");
  std::string other = text;
  other.replace(text.find('[', rows) + 1, 0, "\n[1,2],");
  EXPECT_NE(Why(other).find("'estimate' has 4 rows; 3 are needed"), std::string::npos);
  log.samples[0].estimate->R_WB.coeffs() *= 2.0;
  EXPECT_NE(Why(LogToJson(log)).find("row 0 of 'estimate' has a quaternion of length 2"), std::string::npos);
}

TEST(LogJson, SavesAndLoads) {
  const auto path = ScratchFolder() / "log_test" / "log.json";
  ASSERT_TRUE(SaveLog(Example(), path.string()).ok());
  EXPECT_EQ(LogToJson(LoadLog(path.string()).value()), LogToJson(Example()));
  std::filesystem::remove_all(path.parent_path());
  EXPECT_FALSE(LoadLog(path.string()).ok());
}

TEST(LogJson, AnEmptyLogIsALog) {
  PlaybackLog log;
  log.saturated_s = Vector2::Zero();
  EXPECT_TRUE(LogFromJson(LogToJson(log), "x").ok());
}

TEST(LogJson, RefusesWithTheReason) {
  const std::string text = LogToJson(Example());
  EXPECT_NE(Why(text.substr(0, text.size() / 2)).find("cut short"), std::string::npos);
  EXPECT_NE(Why("").find("cut short"), std::string::npos);
  EXPECT_NE(Why("[1,2]").find("not a playback log"), std::string::npos);
  EXPECT_NE(Why(Replaced(text, "gaitwright-playback-log", "something-else")).find("not a playback log"),
            std::string::npos);
  EXPECT_NE(Why(Replaced(text, "\"schema\":5", "\"schema\":4")).find("schema 4; this program reads schema 5"),
            std::string::npos);
  EXPECT_NE(Why(Replaced(text, "\"controller\"", "\"kontroller\"")).find("controller"), std::string::npos);
  EXPECT_NE(Why(Replaced(text, "\"contact\": [3,3,3]", "\"contact\": [3,3]")).find("'contact' has 2"),
            std::string::npos);
  EXPECT_NE(Why(Replaced(text, "\"saturated_s\":[0.1,", "\"saturated_s\":[")).find("have inconsistent sizes"),
            std::string::npos);
  EXPECT_NE(Why(Replaced(text, "\"tau_nm\": [\n[", "\"tau_nm\": [\n[7,")).find("of 'tau_nm' has"), std::string::npos);
}

/// Values that no playback can have measured.
TEST(LogJson, ValuesThatCannotBeAreRefused) {
  const std::string text = LogToJson(Example());
  const auto expect = [&](const std::string& from, const std::string& to, const std::string& part) {
    const std::string why = Why(Replaced(text, from, to));
    EXPECT_NE(why.find(part), std::string::npos) << why;
  };
  expect("\"total_mass_kg\":13.741", "\"total_mass_kg\":-1", "'total_mass_kg' is -1; accepted: 0 to");
  const auto instead = [&](const std::string& key, const std::string& value) {
    nlohmann::json log = nlohmann::json::parse(text);
    log[key] = nlohmann::json::parse(value);
    const std::string why = Why(log.dump());
    EXPECT_NE(why.find("'" + key + "' is not a"), std::string::npos) << why;
  };
  for (const char* list : {"stances", "body_contacts", "pushes", "q", "time_s"}) {
    instead(list, "null");
    instead(list, "{}");
  }
  instead("options", "\"x\"");
  instead("options", "null");
  expect("\"step_s\":0.001", "\"step_s\":0", "'step_s' is 0");
  expect("\"contact\": [3,3,3]", "\"contact\": [3,4,3]", "row 1 of 'contact' is 4, which names a foot ");
  expect("\"contact\": [3,3,3]", "\"contact\": [3,-1,3]", "a whole number, 0 or more, is needed");
  expect("\"foot\":1", "\"foot\":2", "'stances, foot' is 2; accepted: 0 to 1");
  expect("\"foot\":1", "\"foot\":1e300", "a whole number is needed");
  expect("\"touchdown_s\":0.1", "\"touchdown_s\":0.8", "'stances, liftoff_s' is 0.7; accepted: 0.8 to");
  expect("\"effort_use\": [\n[0.3333333333333333,1]", "\"effort_use\": [\n[0.3333333333333333,1.5]",
         "'effort_use' is 1.5; accepted: 0 to 1");
  expect("\"for_s\":0.125", "\"for_s\":-1", "'pushes, for_s' is -1; accepted: 0 to");
  expect("\"peak_normal_n\":55.5", "\"peak_normal_n\":1e300", "accepted: -1000000000000 to");
  PlaybackLog backward = Example();
  std::swap(backward.samples[0].time_s, backward.samples[1].time_s);
  EXPECT_NE(Why(LogToJson(backward)).find("row 1 of 'time_s' is 0.105, which is not after"), std::string::npos);
  PlaybackLog stretched = Example();
  stretched.samples[2].q *= 2.0;
  EXPECT_NE(Why(LogToJson(stretched)).find("row 2 of 'q' has a quaternion of length 2"), std::string::npos);
}

}  // namespace
}  // namespace gaitwright
