// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <map>

#include "kinematics/base/result.h"
#include "tests/workflows/exchange/mcap_bytes.h"
#include "workflows/exchange/crc32_internal.h"

namespace gaitwright {
namespace {

using namespace synthetic;

const RecordedTopic kOne{"/one", "a_msgs/msg/A", "cdr"}, kTwo{"/two", "b_msgs/msg/B", "cdr"};

std::uint64_t WholeAt(const std::string& bytes, std::size_t at, int size) {
  std::uint64_t value = 0;
  for (int i = size; i-- > 0;) value = value << 8 | static_cast<unsigned char>(bytes[at + static_cast<std::size_t>(i)]);
  return value;
}

/// A file with several chunks, and its messages.
std::string ManyMessages(std::vector<SeenMessage>& messages) {
  McapWriter writer;
  const int one = writer.AddTopic(kOne, "float64 a\n"), two = writer.AddTopic(kTwo, "float64 b\n");
  for (int k = 0; k < 4000; ++k) {
    const SeenMessage message{k % 3 == 0 ? kTwo : kOne, 1000 * k, std::string(1000, static_cast<char>(k))};
    writer.Add(k % 3 == 0 ? two : one, message.log_time_ns, message.data);
    messages.push_back(message);
  }
  return writer.Finish();
}

/// Records by code: place and size with the head.
std::multimap<int, std::pair<std::size_t, std::size_t>> RecordsOf(const std::string& file) {
  std::multimap<int, std::pair<std::size_t, std::size_t>> records;
  for (std::size_t at = 8; at + 8 < file.size();) {
    const std::size_t size = 9 + WholeAt(file, at + 1, 8);
    records.emplace(static_cast<unsigned char>(file[at]), std::pair(at, size));
    at += size;
  }
  return records;
}

TEST(WriteMcap, ReadsBack) {
  std::vector<SeenMessage> messages, again;
  const std::string file = ManyMessages(messages);
  bool ended = false;
  EXPECT_TRUE(MessagesIn(file, &ended) == messages);
  EXPECT_TRUE(ended);
  EXPECT_TRUE(ManyMessages(again) == file) << "the same bytes";
  EXPECT_TRUE(MessagesIn(McapWriter().Finish()).empty());
}

TEST(WriteMcap, IndexesPointToTheirRecords) {
  std::vector<SeenMessage> messages;
  const std::string file = ManyMessages(messages);
  const auto records = RecordsOf(file);
  ASSERT_GT(records.count(6), 2U) << "several chunks";
  EXPECT_EQ(records.count(8), records.count(6));
  EXPECT_EQ(records.count(7), 2 * records.count(6)) << "an index for each topic in a chunk";
  for (auto [index, end] = records.equal_range(8); index != end; ++index) {
    const std::size_t at = index->second.first + 9;
    const std::size_t chunk = WholeAt(file, at + 16, 8);
    EXPECT_EQ(file[chunk], 6);
    EXPECT_EQ(WholeAt(file, at + 24, 8), 9 + WholeAt(file, chunk + 1, 8));
    ASSERT_EQ(WholeAt(file, at + 32, 4), 20U);
    for (const std::size_t entry : {at + 36, at + 46}) {
      const std::size_t place = WholeAt(file, entry + 2, 8);
      EXPECT_EQ(file[place], 7);
      EXPECT_EQ(WholeAt(file, place + 9, 2), WholeAt(file, entry, 2)) << "of its topic";
    }
  }
  for (auto [offset, end] = records.equal_range(14); offset != end; ++offset) {
    const std::size_t at = offset->second.first + 9;
    EXPECT_EQ(file[WholeAt(file, at + 1, 8)], file[at]);
  }
}

TEST(WriteMcap, CountsMessagesAndSumsBytes) {
  std::vector<SeenMessage> messages;
  const std::string file = ManyMessages(messages);
  const auto records = RecordsOf(file);
  const std::size_t statistics = records.find(11)->second.first + 9;
  EXPECT_EQ(WholeAt(file, statistics, 8), messages.size());
  EXPECT_EQ(WholeAt(file, statistics + 34, 8), 3999000U) << "the last time";
  const std::size_t footer = records.find(2)->second.first, end = records.find(15)->second.first;
  const std::size_t summary = WholeAt(file, footer + 9, 8);
  EXPECT_EQ(summary, end + 13);
  EXPECT_EQ(WholeAt(file, footer + 25, 4), Crc32(std::string_view(file).substr(summary, footer + 25 - summary)));
  EXPECT_EQ(WholeAt(file, end + 9, 4), Crc32(std::string_view(file).substr(0, end)));
}

TEST(WriteMcap, RefusesTimesBelowZero) {
  McapWriter writer;
  const int one = writer.AddTopic(kOne, "");
  EXPECT_THROW(writer.Add(one, -1, ""), InvalidArgument);
}

}  // namespace
}  // namespace gaitwright
