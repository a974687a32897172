// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace gaitwright {

/// A stream of messages of a recording.
struct RecordedTopic {
  std::string name;      ///< "/joint_states"
  std::string type;      ///< "sensor_msgs/msg/JointState"
  std::string encoding;  ///< of the messages: "cdr"

  bool operator==(const RecordedTopic&) const = default;
};

/// A message of a recording; it lasts as long as the call that passes it.
struct RecordedMessage {
  const RecordedTopic& topic;
  std::int64_t log_time_ns = 0;
  std::string_view data;
};

/// Latest time of a message, a hundred years after 1970.
inline constexpr std::int64_t kLatestRecordedNs = 4'000'000'000'000'000'000;

using TakeMessage = std::function<void(const RecordedMessage&)>;

/// Passes all messages of an MCAP file to `take` in their order in the file. https://mcap.dev/spec
/// Records outside and inside of chunks are read, packed as lz4 or zstd or not; indexes, attachments and metadata are
/// skipped. A file that was not ended (no data end or footer) is read up to its last whole record outside of chunks.
/// CRCs that are not 0 are checked. @throws InvalidArgument with the place `at byte N`.
/// @return false if the file was not ended.
bool ReadMcap(const std::string& bytes, const TakeMessage& take);

/// Writes an MCAP file with the profile of ROS 2: chunks packed by zstd, with message indexes and a summary, so that
/// players need not read the whole file. The same calls give the same bytes.
class McapWriter {
 public:
  McapWriter();

  /// @param schema  text of the message's definition, "ros2msg". @return the number of the topic, for Add.
  int AddTopic(const RecordedTopic& topic, const std::string& schema);
  void Add(int topic, std::int64_t time_ns, std::string_view data);
  /// The file. @pre called once, at the end.
  std::string Finish();

 private:
  struct Stream {
    std::string schema, channel;  ///< records
    std::uint64_t messages = 0;
    std::vector<std::pair<std::uint64_t, std::uint64_t>> index;  ///< of the chunk: time and place
  };

  void EndChunk();
  /// Records and footer, for a summary that begins at this place of the file.
  std::string Summary(std::size_t at) const;
  std::string Statistics() const;

  std::string file_, chunk_, chunk_indexes_;
  std::vector<Stream> streams_;
  std::uint64_t chunk_start_ns_ = 0, chunk_end_ns_ = 0, start_ns_ = 0, end_ns_ = 0;
  std::uint64_t messages_ = 0;
  std::uint32_t chunks_ = 0;
};

}  // namespace gaitwright
