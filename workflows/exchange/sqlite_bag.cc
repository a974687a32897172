// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <sqlite3.h>

#include <map>
#include <memory>
#include <new>

#include "kinematics/base/result.h"
#include "workflows/exchange/cdr_internal.h"
#include "workflows/exchange/sqlite_bag_internal.h"

namespace gaitwright {
namespace {

using Database = std::unique_ptr<sqlite3, int (*)(sqlite3*)>;

/// A query and its rows.
class Query {
 public:
  Query(sqlite3* database, const char* text) : database_(database) {
    sqlite3_stmt* statement = nullptr;
    Check(sqlite3_prepare_v2(database, text, -1, &statement, nullptr));
    statement_.reset(statement);
  }

  /// Moves to the next row. @return false behind the last one.
  bool Next() {
    const int status = sqlite3_step(statement_.get());
    if (status != SQLITE_ROW && status != SQLITE_DONE) Check(status);
    return status == SQLITE_ROW;
  }
  std::int64_t Whole(int column) const { return sqlite3_column_int64(statement_.get(), column); }
  std::string_view Bytes(int column) const {
    const void* const bytes = sqlite3_column_blob(statement_.get(), column);
    const auto size = static_cast<std::size_t>(sqlite3_column_bytes(statement_.get(), column));
    return bytes == nullptr ? std::string_view() : std::string_view(static_cast<const char*>(bytes), size);
  }

 private:
  void Check(int status) const {
    if (status != SQLITE_OK) {
      throw InvalidArgument(
          fmt::format("it is a database of SQLite, but not a readable bag of ROS 2 ({})", sqlite3_errmsg(database_)));
    }
  }

  sqlite3* database_;
  std::unique_ptr<sqlite3_stmt, int (*)(sqlite3_stmt*)> statement_{nullptr, sqlite3_finalize};
};

/// Opens a database in memory, for reading only. Nothing that the file itself defines is run.
Database OpenedInMemory(std::string& bytes) {
  sqlite3* raw = nullptr;
  const int status = sqlite3_open_v2(":memory:", &raw, SQLITE_OPEN_READWRITE, nullptr);
  Database database(raw, sqlite3_close);
  if (status != SQLITE_OK) throw std::bad_alloc();
  sqlite3_db_config(raw, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
  sqlite3_db_config(raw, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
  sqlite3_db_config(raw, SQLITE_DBCONFIG_ENABLE_VIEW, 0, nullptr);
  sqlite3_db_config(raw, SQLITE_DBCONFIG_ENABLE_TRIGGER, 0, nullptr);
  const auto size = static_cast<sqlite3_int64>(bytes.size());
  if (sqlite3_deserialize(raw, "main", reinterpret_cast<unsigned char*>(bytes.data()), size, size,
                          SQLITE_DESERIALIZE_READONLY) != SQLITE_OK)
    throw InvalidArgument("it is a damaged database of SQLite");
  return database;
}

}  // namespace

void ReadSqliteBag(const std::string& bytes, const TakeMessage& take) {
  constexpr std::size_t kHead = 100, kWriteVersion = 18, kReadVersion = 19;
  if (bytes.size() < kHead || !bytes.starts_with(kSqliteMagic))
    throw InvalidArgument("it is not a database of SQLite, or is cut off");
  std::string copy = bytes;
  // A write-ahead log, which a closed bag has no more, cannot be used in memory.
  copy[kWriteVersion] = copy[kReadVersion] = 1;
  const Database database = OpenedInMemory(copy);
  std::map<std::int64_t, RecordedTopic> topics;
  for (Query query(database.get(), "SELECT id, name, type, serialization_format FROM topics"); query.Next();) {
    topics[query.Whole(0)] = {RecordedText(query.Bytes(1)), RecordedText(query.Bytes(2)), RecordedText(query.Bytes(3))};
  }
  Query query(database.get(), "SELECT id, topic_id, timestamp, data FROM messages ORDER BY id");
  while (query.Next()) {
    const auto topic = topics.find(query.Whole(1));
    if (topic == topics.end())
      throw InvalidArgument(
          fmt::format("message {} is of topic {}, which is not listed", query.Whole(0), query.Whole(1)));
    if (query.Whole(2) < 0 || query.Whole(2) > kLatestRecordedNs)
      throw InvalidArgument(fmt::format("message {} has the time {} ns", query.Whole(0), query.Whole(2)));
    take({topic->second, query.Whole(2), query.Bytes(3)});
  }
}

}  // namespace gaitwright
