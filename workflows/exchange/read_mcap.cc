// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cstdint>
#include <map>
#include <utility>

#include "kinematics/base/result.h"
#include "workflows/exchange/cdr_internal.h"
#include "workflows/exchange/crc32_internal.h"
#include "workflows/exchange/mcap_file_internal.h"
#include "workflows/exchange/mcap_records_internal.h"
#include "workflows/exchange/packed_bytes_internal.h"

namespace gaitwright {
namespace {

constexpr std::size_t kMostChunk = std::size_t{256} << 20U;   // unpacked bytes of one chunk
constexpr std::size_t kMostUnpacked = std::size_t{4} << 30U;  // of all chunks together

/// Reads the fields of a record.
class RecordFields {
 public:
  /// @param at  place of the record's contents in the file or chunk, for messages.
  RecordFields(const char* record, std::string_view bytes, std::size_t at) : record_(record), bytes_(bytes), at_(at) {}

  std::uint64_t Whole(std::size_t size) {
    const std::string_view part = Bytes(size);
    std::uint64_t value = 0;
    for (std::size_t i = size; i-- > 0;) value = value << 8U | static_cast<unsigned char>(part[i]);
    return value;
  }
  std::string_view Bytes(std::uint64_t size) {
    if (size > bytes_.size() - next_) {
      throw InvalidArgument(fmt::format("the {} record at byte {} is too short: a field of {} bytes does not fit",
                                        record_, at_ + next_, size));
    }
    next_ += size;
    return bytes_.substr(next_ - size, size);
  }
  std::string Text() { return RecordedText(Bytes(Whole(4))); }
  std::string_view Rest() { return Bytes(bytes_.size() - next_); }

 private:
  const char* record_;
  std::string_view bytes_;
  std::size_t at_, next_ = 0;
};

class McapReader {
 public:
  McapReader(std::string_view bytes, const TakeMessage& take) : bytes_(bytes), take_(take) {}

  bool Run() {
    if (!bytes_.starts_with(kMcapMagic)) throw InvalidArgument("it is not an MCAP file: its first bytes are others");
    const Walk walk = ReadRecords(bytes_, kMcapMagic.size(), false);
    if (!header_) throw InvalidArgument("at byte 8: the first record is not a header");
    if (!walk.ended) return false;
    if (bytes_.substr(walk.next) != kMcapMagic)
      throw InvalidArgument(fmt::format("at byte {}: the file does not end with its magic bytes", walk.next));
    return true;
  }

 private:
  struct Walk {
    bool ended = false;    ///< by a footer
    std::size_t next = 0;  ///< place behind the last record
  };

  /// Reads records to the end, or to the footer. Records that are cut off end a file, but not a chunk.
  Walk ReadRecords(std::string_view bytes, std::size_t at, bool in_chunk) {
    constexpr std::size_t kHead = 9;
    while (at < bytes.size()) {
      const std::string_view rest = bytes.substr(at);
      std::uint64_t size = 0;
      const bool has_head = rest.size() >= kHead;
      if (has_head) size = RecordFields("first", rest.substr(1), at).Whole(8);
      if (!has_head || size > rest.size() - kHead) {
        if (!in_chunk) return {false, at};
        throw InvalidArgument(fmt::format("the chunk at byte {}: its record at byte {} is cut off", chunk_at_, at));
      }
      const McapOpcode code{static_cast<unsigned char>(rest[0])};
      ReadRecord(code, rest.substr(kHead, size), at, in_chunk);
      at += kHead + size;
      if (code == McapOpcode::kFooter && !in_chunk) return {true, at};
    }
    return {false, at};
  }

  void ReadRecord(McapOpcode code, std::string_view content, std::size_t at, bool in_chunk) {
    const std::size_t place = at + 9;
    if (!in_chunk && !header_ && code != McapOpcode::kHeader)
      throw InvalidArgument(fmt::format("at byte {}: the first record is not a header", at));
    const bool of_messages = code == McapOpcode::kSchema || code == McapOpcode::kChannel ||
                             code == McapOpcode::kMessage || code == McapOpcode::kChunk;
    if (in_chunk && !of_messages) return;
    switch (code) {
      case McapOpcode::kHeader:
        header_ = true;
        return;
      case McapOpcode::kSchema:
        return TakeSchema({"schema", content, place});
      case McapOpcode::kChannel:
        return TakeChannel({"channel", content, place});
      case McapOpcode::kMessage:
        return PassMessage({"message", content, place}, at);
      case McapOpcode::kChunk:
        if (in_chunk) throw InvalidArgument(fmt::format("at byte {}: a chunk holds a chunk", chunk_at_));
        return TakeChunk({"chunk", content, place}, at);
      case McapOpcode::kDataEnd:
        return CheckCrc({"data end", content, place}, "data section", bytes_.substr(0, at), at);
      case McapOpcode::kFooter:
        return CheckFooter({"footer", content, place}, place);
      default:
        return;  // indexes, attachments, metadata, statistics, and records of later versions
    }
  }

  void TakeSchema(RecordFields fields) {
    const auto id = fields.Whole(2);
    types_[id] = fields.Text();
  }

  void TakeChannel(RecordFields fields) {
    const auto id = fields.Whole(2), schema = fields.Whole(2);
    RecordedTopic topic;
    topic.name = fields.Text();
    topic.encoding = fields.Text();
    if (const auto type = types_.find(schema); type != types_.end()) topic.type = type->second;
    topics_.insert_or_assign(id, std::move(topic));
  }

  void PassMessage(RecordFields fields, std::size_t at) {
    const auto id = fields.Whole(2);
    fields.Whole(4);
    const auto log_time = fields.Whole(8);
    fields.Whole(8);
    const auto topic = topics_.find(id);
    if (topic == topics_.end())
      throw InvalidArgument(fmt::format("the message at byte {} is of channel {}, which no record describes", at, id));
    if (log_time > std::uint64_t{kLatestRecordedNs})
      throw InvalidArgument(
          fmt::format("the message at byte {} has a time of {} ns, which is too large", at, log_time));
    take_({topic->second, static_cast<std::int64_t>(log_time), fields.Rest()});
  }

  void TakeChunk(RecordFields fields, std::size_t at) {
    fields.Bytes(16);
    const auto size = fields.Whole(8), crc = fields.Whole(4);
    const std::string compression = fields.Text();
    const std::string_view packed = fields.Bytes(fields.Whole(8));
    unpacked_ += size <= kMostChunk ? size : 0;
    if (size > kMostChunk || unpacked_ > kMostUnpacked) {
      throw InvalidArgument(
          fmt::format("the chunk at byte {} is too large: at most {} bytes in a chunk, and {} in all, are unpacked", at,
                      kMostChunk, kMostUnpacked));
    }
    std::string records;
    try {
      records = Unpacked(packed, compression, size);
    } catch (const InvalidArgument& error) {
      throw InvalidArgument(fmt::format("the chunk at byte {}: {}", at, error.what()));
    }
    if (crc != 0 && crc != Crc32(records))
      throw InvalidArgument(fmt::format("the chunk at byte {} is damaged: its CRC is another", at));
    chunk_at_ = at;
    ReadRecords(records, 0, true);
  }

  static void CheckCrc(RecordFields fields, const char* what, std::string_view bytes, std::size_t at) {
    const auto crc = fields.Whole(4);
    if (crc != 0 && crc != Crc32(bytes))
      throw InvalidArgument(fmt::format("the {} that ends at byte {} is damaged: its CRC is another", what, at));
  }

  /// The CRC of the summary includes the fields of the footer before it.
  void CheckFooter(RecordFields fields, std::size_t place) {
    const auto start = fields.Whole(8);
    fields.Whole(8);
    const std::size_t from = start != 0 ? start : place - 9, to = place + 16;
    if (from >= to) throw InvalidArgument(fmt::format("the footer at byte {}: its summary is behind it", place - 9));
    CheckCrc(fields, "summary", bytes_.substr(from, to - from), to);
  }

  const std::string_view bytes_;
  const TakeMessage& take_;
  std::map<std::uint64_t, std::string> types_;  ///< names of schemas
  std::map<std::uint64_t, RecordedTopic> topics_;
  std::size_t chunk_at_ = 0, unpacked_ = 0;
  bool header_ = false;
};

}  // namespace

bool ReadMcap(const std::string& bytes, const TakeMessage& take) { return McapReader(bytes, take).Run(); }

}  // namespace gaitwright
