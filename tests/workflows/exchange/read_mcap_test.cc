// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "kinematics/base/result.h"
#include "tests/workflows/exchange/mcap_bytes.h"
#include "workflows/exchange/crc32_internal.h"
#include "workflows/exchange/packed_bytes_internal.h"

namespace gaitwright {
namespace {

using namespace synthetic;

/// Two topics with a message each.
std::string TwoTopics() {
  return SchemaRecord(5, "a_msgs/msg/A") + ChannelRecord(2, 5, "/a") + MessageRecord(2, 10, "first") +
         ChannelRecord(3, 0, "/b", "json") + MessageRecord(3, 5, "{}");
}

const std::vector<SeenMessage> kTwoMessages = {{{"/a", "a_msgs/msg/A", "cdr"}, 10, "first"},
                                               {{"/b", "", "json"}, 5, "{}"}};

std::string ReasonNoMcap(const std::string& bytes) {
  return WhatOf<InvalidArgument>([&] { MessagesIn(bytes); });
}

TEST(ReadMcap, PassesMessagesOutsideAndInsideOfChunks) {
  bool ended = false;
  EXPECT_EQ(MessagesIn(McapHead() + TwoTopics() + McapTail(), &ended), kTwoMessages);
  EXPECT_TRUE(ended);
  const std::string records = TwoTopics();
  for (const std::string kind : {"", "zstd"}) {
    const std::string packed = kind.empty() ? records : PackedZstd(records);
    const std::string chunk = ChunkRecord(packed, records.size(), kind, Crc32(records));
    EXPECT_EQ(MessagesIn(McapHead() + chunk + McapTail()), kTwoMessages) << kind;
  }
}

/// Names end up in messages, plans and JSON, which are UTF-8.
TEST(ReadMcap, NamesOfTopicsAreUtf8WhateverTheirBytes) {
  const std::string records = ChannelRecord(1, 0, "\xa1joints") + MessageRecord(1, 5, "x");
  const std::vector<SeenMessage> seen = MessagesIn(McapHead() + records + McapTail());
  ASSERT_EQ(seen.size(), 1U);
  EXPECT_EQ(seen.front().topic.name, "\u00a1joints");
}

TEST(ReadMcap, SkipsRecordsThatItDoesNotNeed) {
  std::string others;
  for (const int code : {7, 8, 9, 10, 11, 12, 13, 14, 0x90}) others += McapRecord(code, "whatever");
  EXPECT_EQ(MessagesIn(McapHead() + others + TwoTopics() + others + McapTail()), kTwoMessages);
}

TEST(ReadMcap, AChunkHoldsMessagesOnly) {
  const std::string far = LittleEndian(std::uint64_t{1} << 40U, 8);
  const std::string records =
      McapRecord(2, far + far + LittleEndian(1, 4)) + McapRecord(15, LittleEndian(1, 4)) + TwoTopics();
  EXPECT_EQ(MessagesIn(McapHead() + ChunkRecord(records, records.size(), "") + McapTail()), kTwoMessages)
      << "a footer and a data end have no meaning there";
}

TEST(ReadMcap, ReadsAFileThatWasNotEnded) {
  const std::string whole = McapHead() + TwoTopics();
  bool ended = true;
  EXPECT_EQ(MessagesIn(whole, &ended), kTwoMessages);
  EXPECT_FALSE(ended);
  EXPECT_EQ(MessagesIn(whole + MessageRecord(2, 20, "second").substr(0, 25), &ended), kTwoMessages);
  EXPECT_FALSE(ended);
  EXPECT_EQ(MessagesIn(whole + "\x05", &ended), kTwoMessages);
}

TEST(ReadMcap, RefusesOtherAndDamagedFiles) {
  EXPECT_NE(ReasonNoMcap("#ROSBAG V2.0\n").find("is not an MCAP file"), std::string::npos);
  EXPECT_NE(ReasonNoMcap(kMagicOfMcap + TwoTopics()).find("at byte 8: the first record is not a header"),
            std::string::npos);
  EXPECT_NE(ReasonNoMcap(kMagicOfMcap).find("is not a header"), std::string::npos);
  const std::string head = McapHead();
  EXPECT_EQ(ReasonNoMcap(head + MessageRecord(9, 1, "")),
            "the message at byte " + std::to_string(head.size()) + " is of channel 9, which no record describes");
  EXPECT_NE(ReasonNoMcap(head + McapRecord(3, LittleEndian(1, 2) + LittleEndian(99, 4) + "abc")).find("does not fit"),
            std::string::npos);
  EXPECT_NE(ReasonNoMcap(head + TwoTopics() + MessageRecord(2, ~std::uint64_t{0}, "")).find("too large"),
            std::string::npos);
  std::string tail = McapTail();
  tail.back() = 'x';
  EXPECT_NE(ReasonNoMcap(head + tail).find("does not end with its magic bytes"), std::string::npos);
}

TEST(ReadMcap, ChecksCrcs) {
  const std::string records = TwoTopics(), data = McapHead() + records;
  const std::string at = std::to_string(McapHead().size());
  EXPECT_EQ(ReasonNoMcap(McapHead() + ChunkRecord(records, records.size(), "", 1)),
            "the chunk at byte " + at + " is damaged: its CRC is another");
  const auto ended = [&](std::uint32_t crc, std::uint32_t summary_crc) {
    return data + McapRecord(15, LittleEndian(crc, 4)) +
           McapRecord(2, LittleEndian(0, 8) + LittleEndian(0, 8) + LittleEndian(summary_crc, 4)) + kMagicOfMcap;
  };
  EXPECT_EQ(MessagesIn(ended(Crc32(data), 0)), kTwoMessages);
  EXPECT_NE(ReasonNoMcap(ended(Crc32(data) + 1, 0)).find("the data section"), std::string::npos);
  EXPECT_NE(ReasonNoMcap(ended(0, 12345)).find("the summary"), std::string::npos);
}

TEST(ReadMcap, RefusesBadChunks) {
  const std::string records = TwoTopics();
  const auto why = [](const std::string& chunk) { return ReasonNoMcap(McapHead() + chunk); };
  EXPECT_NE(why(ChunkRecord(records, records.size() + 1, "")).find("but says that it has"), std::string::npos);
  EXPECT_NE(why(ChunkRecord(records, records.size(), "lzma")).find("'lzma'; accepted: none, 'lz4', 'zstd'"),
            std::string::npos);
  const std::string cut = records.substr(0, records.size() - 1);
  EXPECT_NE(why(ChunkRecord(cut, cut.size(), "")).find("is cut off"), std::string::npos);
  const std::string nested = ChunkRecord(records, records.size(), "");
  EXPECT_NE(why(ChunkRecord(nested, nested.size(), "")).find("a chunk holds a chunk"), std::string::npos);
  EXPECT_NE(why(ChunkRecord("", std::size_t{1} << 40U, "zstd")).find("too large"), std::string::npos);
}

}  // namespace
}  // namespace gaitwright
