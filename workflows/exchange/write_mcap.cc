// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "kinematics/base/result.h"
#include "workflows/exchange/crc32_internal.h"
#include "workflows/exchange/mcap_file_internal.h"
#include "workflows/exchange/mcap_records_internal.h"
#include "workflows/exchange/packed_bytes_internal.h"

namespace gaitwright {
namespace {

constexpr std::size_t kChunkBytes = std::size_t{1} << 20U;

/// Writes the fields of a record.
class RecordBytes {
 public:
  RecordBytes& Whole(std::uint64_t value, int size) {
    for (int i = 0; i < size; ++i) bytes_ += static_cast<char>(value >> (8U * static_cast<unsigned>(i)) & 0xffU);
    return *this;
  }
  RecordBytes& Raw(std::string_view bytes) {
    bytes_ += bytes;
    return *this;
  }
  RecordBytes& Text(std::string_view text) { return Whole(text.size(), 4).Raw(text); }
  const std::string& bytes() const { return bytes_; }

  std::string Record(McapOpcode code) const {
    RecordBytes record;
    record.Whole(static_cast<unsigned char>(code), 1).Whole(bytes_.size(), 8).Raw(bytes_);
    return record.bytes_;
  }

 private:
  std::string bytes_;
};

}  // namespace

McapWriter::McapWriter() {
  file_ = kMcapMagic;
  file_ += RecordBytes().Text("ros2").Text("gaitwright").Record(McapOpcode::kHeader);
}

int McapWriter::AddTopic(const RecordedTopic& topic, const std::string& schema) {
  const std::uint64_t id = streams_.size() + 1;
  RecordBytes qos;  // players expect the key; an empty value means the default
  qos.Text("offered_qos_profiles").Text("");
  Stream stream;
  stream.schema = RecordBytes().Whole(id, 2).Text(topic.type).Text("ros2msg").Text(schema).Record(McapOpcode::kSchema);
  stream.channel = RecordBytes()
                       .Whole(id, 2)
                       .Whole(id, 2)
                       .Text(topic.name)
                       .Text(topic.encoding)
                       .Text(qos.bytes())
                       .Record(McapOpcode::kChannel);
  chunk_ += stream.schema + stream.channel;
  streams_.push_back(std::move(stream));
  return static_cast<int>(id) - 1;
}

void McapWriter::Add(int topic, std::int64_t time_ns, std::string_view data) {
  if (time_ns < 0) throw InvalidArgument(fmt::format("a message at {} ns: an MCAP file has no times below 0", time_ns));
  Stream& stream = streams_.at(static_cast<std::size_t>(topic));
  const auto time = static_cast<std::uint64_t>(time_ns);
  const bool first = std::all_of(streams_.begin(), streams_.end(), [](const Stream& s) { return s.index.empty(); });
  chunk_start_ns_ = first ? time : std::min(chunk_start_ns_, time);
  chunk_end_ns_ = first ? time : std::max(chunk_end_ns_, time);
  start_ns_ = messages_ == 0 ? time : std::min(start_ns_, time);
  end_ns_ = std::max(end_ns_, time);
  stream.index.emplace_back(time, chunk_.size());
  chunk_ += RecordBytes()
                .Whole(static_cast<std::uint64_t>(topic) + 1, 2)
                .Whole(stream.messages, 4)
                .Whole(time, 8)
                .Whole(time, 8)
                .Raw(data)
                .Record(McapOpcode::kMessage);
  ++stream.messages;
  ++messages_;
  if (chunk_.size() >= kChunkBytes) EndChunk();
}

void McapWriter::EndChunk() {
  if (chunk_.empty()) return;
  const std::string packed = PackedZstd(chunk_);
  const std::uint64_t at = file_.size();
  file_ += RecordBytes()
               .Whole(chunk_start_ns_, 8)
               .Whole(chunk_end_ns_, 8)
               .Whole(chunk_.size(), 8)
               .Whole(Crc32(chunk_), 4)
               .Text("zstd")
               .Whole(packed.size(), 8)
               .Raw(packed)
               .Record(McapOpcode::kChunk);
  const std::uint64_t indexes_at = file_.size();
  RecordBytes offsets;
  for (std::size_t i = 0; i < streams_.size(); ++i) {
    if (streams_[i].index.empty()) continue;
    RecordBytes entries;
    for (const auto& [time, place] : streams_[i].index) entries.Whole(time, 8).Whole(place, 8);
    offsets.Whole(i + 1, 2).Whole(file_.size(), 8);
    file_ += RecordBytes().Whole(i + 1, 2).Text(entries.bytes()).Record(McapOpcode::kMessageIndex);
    streams_[i].index.clear();
  }
  chunk_indexes_ += RecordBytes()
                        .Whole(chunk_start_ns_, 8)
                        .Whole(chunk_end_ns_, 8)
                        .Whole(at, 8)
                        .Whole(indexes_at - at, 8)
                        .Text(offsets.bytes())
                        .Whole(file_.size() - indexes_at, 8)
                        .Text("zstd")
                        .Whole(packed.size(), 8)
                        .Whole(chunk_.size(), 8)
                        .Record(McapOpcode::kChunkIndex);
  ++chunks_;
  chunk_.clear();
  chunk_start_ns_ = chunk_end_ns_ = 0;
}

std::string McapWriter::Statistics() const {
  RecordBytes counts;
  for (std::size_t i = 0; i < streams_.size(); ++i) counts.Whole(i + 1, 2).Whole(streams_[i].messages, 8);
  return RecordBytes()
      .Whole(messages_, 8)
      .Whole(streams_.size(), 2)
      .Whole(streams_.size(), 4)
      .Whole(0, 4)
      .Whole(0, 4)
      .Whole(chunks_, 4)
      .Whole(start_ns_, 8)
      .Whole(end_ns_, 8)
      .Text(counts.bytes())
      .Record(McapOpcode::kStatistics);
}

std::string McapWriter::Summary(std::size_t at) const {
  std::vector<std::pair<McapOpcode, std::string>> groups = {{McapOpcode::kSchema, ""},
                                                            {McapOpcode::kChannel, ""},
                                                            {McapOpcode::kStatistics, Statistics()},
                                                            {McapOpcode::kChunkIndex, chunk_indexes_}};
  for (const Stream& stream : streams_) {
    groups[0].second += stream.schema;
    groups[1].second += stream.channel;
  }
  std::string summary, offsets;
  for (const auto& [code, records] : groups) {
    if (records.empty()) continue;
    offsets += RecordBytes()
                   .Whole(static_cast<unsigned char>(code), 1)
                   .Whole(at + summary.size(), 8)
                   .Whole(records.size(), 8)
                   .Record(McapOpcode::kSummaryOffset);
    summary += records;
  }
  const std::size_t offsets_at = at + summary.size();
  summary += offsets;
  // The CRC includes the head of the footer and its fields so far.
  const std::string footer = RecordBytes().Whole(at, 8).Whole(offsets_at, 8).Whole(0, 4).Record(McapOpcode::kFooter);
  summary += footer.substr(0, footer.size() - 4);
  return summary + RecordBytes().Whole(Crc32(summary), 4).bytes();
}

std::string McapWriter::Finish() {
  EndChunk();
  file_ += RecordBytes().Whole(Crc32(file_), 4).Record(McapOpcode::kDataEnd);
  file_ += Summary(file_.size());
  file_ += kMcapMagic;
  return std::move(file_);
}

}  // namespace gaitwright
