// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "kinematics/base/file.h"
#include "kinematics/base/result.h"
#include "tests/scratch_folder.h"
#include "tests/workflows/exchange/mcap_bytes.h"
#include "tests/workflows/exchange/sqlite_bytes.h"
#include "workflows/exchange/sqlite_bag_internal.h"

namespace gaitwright {
namespace {

using namespace synthetic;

std::vector<SeenMessage> MessagesOfBag(const std::string& bytes) {
  std::vector<SeenMessage> seen;
  ReadSqliteBag(bytes, [&](const RecordedMessage& message) {
    seen.push_back({message.topic, message.log_time_ns, std::string(message.data)});
  });
  return seen;
}

const char* const kTopicRows =
    "INSERT INTO topics VALUES(3, '/a', 'a_msgs/msg/A', 'cdr', '');"
    "INSERT INTO messages VALUES(2, 3, 20, x'000102');"
    "INSERT INTO messages VALUES(1, 3, 10, x'ff');";

TEST(SqliteBag, PassesMessagesInTheirOrder) {
  const RecordedTopic topic{"/a", "a_msgs/msg/A", "cdr"};
  const std::vector<SeenMessage> messages = {{topic, 10, "\xff"}, {topic, 20, std::string("\0\1\2", 3)}};
  EXPECT_EQ(MessagesOfBag(SqliteBytes(std::string(kBagTables) + kTopicRows)), messages);
  EXPECT_EQ(MessagesOfBag(SqliteBytes(std::string("PRAGMA journal_mode=WAL;") + kBagTables + kTopicRows)), messages)
      << "ROS 2 writes with a write-ahead log";
}

TEST(SqliteBag, RefusesOtherDatabases) {
  const auto why = [](const std::string& bytes) { return WhatOf<InvalidArgument>([&] { MessagesOfBag(bytes); }); };
  EXPECT_NE(why("SQLite").find("is not a database of SQLite"), std::string::npos);
  EXPECT_NE(why(SqliteBytes("CREATE TABLE other(id INTEGER);")).find("no such table: topics"), std::string::npos);
  EXPECT_NE(why(SqliteBytes(std::string(kBagTables) + "INSERT INTO messages VALUES(1, 9, 10, x'ff');"))
                .find("message 1 is of topic 9, which is not listed"),
            std::string::npos);
  EXPECT_NE(why(SqliteBytes(std::string(kBagTables) + "INSERT INTO topics VALUES(3, '/a', 'a', 'cdr', '');" +
                            "INSERT INTO messages VALUES(1, 3, -10, x'ff');"))
                .find("the time -10 ns"),
            std::string::npos);
  std::string damaged = SqliteBytes(std::string(kBagTables) + kTopicRows);
  damaged.resize(damaged.size() / 2);
  EXPECT_NE(why(damaged), "nothing was thrown");
}

TEST(SqliteBag, RunsNothingOfTheFile) {
  const std::string view =
      "CREATE TABLE topics(id, name, type, serialization_format);"
      "CREATE VIEW messages AS WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n) SELECT i AS id, 1 AS "
      "topic_id, i AS timestamp, x'00' AS data FROM n;";
  EXPECT_NE(WhatOf<InvalidArgument>([&] { MessagesOfBag(SqliteBytes(view)); }).find("not a readable bag"),
            std::string::npos)
      << "a view without end";
}

}  // namespace
}  // namespace gaitwright
