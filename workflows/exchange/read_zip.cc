// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <minizip/unzip.h>

#include <algorithm>
#include <array>
#include <memory>
#include <set>
#include <utility>

#include "kinematics/base/result.h"
#include "workflows/exchange/read_zip_internal.h"

namespace gaitwright {
namespace {

/// Bytes in memory that minizip reads.
struct ArchiveBytes {
  const std::string& bytes;
  std::size_t at = 0;

  static ArchiveBytes& Of(voidpf opaque) { return *static_cast<ArchiveBytes*>(opaque); }

  static voidpf Open(voidpf opaque, const void* /*name*/, int /*mode*/) { return opaque; }
  static int Close(voidpf /*opaque*/, voidpf /*stream*/) { return 0; }
  static int Error(voidpf /*opaque*/, voidpf /*stream*/) { return 0; }
  static uLong Write(voidpf /*opaque*/, voidpf /*stream*/, const void* /*from*/, uLong /*size*/) { return 0; }

  static uLong Read(voidpf opaque, voidpf /*stream*/, void* to, uLong size) {
    ArchiveBytes& file = Of(opaque);
    const std::size_t count = std::min<std::size_t>(size, file.bytes.size() - file.at);
    file.bytes.copy(static_cast<char*>(to), count, file.at);
    file.at += count;
    return count;
  }

  static ZPOS64_T Tell(voidpf opaque, voidpf /*stream*/) { return Of(opaque).at; }

  static long Seek(voidpf opaque, voidpf /*stream*/, ZPOS64_T offset, int origin) {
    ArchiveBytes& file = Of(opaque);
    const std::size_t from = origin == ZLIB_FILEFUNC_SEEK_SET   ? 0
                             : origin == ZLIB_FILEFUNC_SEEK_CUR ? file.at
                                                                : file.bytes.size();
    if (offset > file.bytes.size() - from) return -1;
    file.at = from + static_cast<std::size_t>(offset);
    return 0;
  }
};

void CheckUnzipped(int status, const std::string& what) {
  if (status < 0) throw InvalidArgument(fmt::format("{} of the archive is damaged ({})", what, status));
}

ZipEntry ReadEntry(unzFile zip, std::size_t most_bytes) {
  std::array<char, 512> name{};
  unz_file_info64 info{};
  CheckUnzipped(unzGetCurrentFileInfo64(zip, &info, name.data(), name.size() - 1, nullptr, 0, nullptr, 0), "a file");
  ZipEntry entry{name.data(), {}};
  const std::string called = fmt::format("file '{}'", entry.name);
  if ((info.flag & 1U) != 0) throw InvalidArgument(called + " of the archive is encrypted");
  CheckUnzipped(unzOpenCurrentFile(zip), called);
  std::array<char, 1U << 16U> part{};
  for (;;) {
    const int count = unzReadCurrentFile(zip, part.data(), static_cast<unsigned>(part.size()));
    CheckUnzipped(count, called);
    if (count == 0) break;
    if (entry.bytes.size() + static_cast<std::size_t>(count) > most_bytes)
      throw InvalidArgument(fmt::format("the archive is too large: its files have more than {} bytes", most_bytes));
    entry.bytes.append(part.data(), static_cast<std::size_t>(count));
  }
  CheckUnzipped(unzCloseCurrentFile(zip), called);
  return entry;
}

}  // namespace

std::vector<ZipEntry> ReadZip(const std::string& bytes, std::size_t most_bytes) {
  constexpr std::size_t kMostFiles = 1000;
  ArchiveBytes file{bytes};
  zlib_filefunc64_def functions{ArchiveBytes::Open, ArchiveBytes::Read,  ArchiveBytes::Write, ArchiveBytes::Tell,
                                ArchiveBytes::Seek, ArchiveBytes::Close, ArchiveBytes::Error, &file};
  const std::unique_ptr<void, int (*)(unzFile)> zip(unzOpen2_64("", &functions), unzClose);
  if (zip == nullptr) throw InvalidArgument("it is not a ZIP archive, or is cut off");
  std::vector<ZipEntry> entries;
  std::set<std::string> names;
  std::size_t left = most_bytes;
  for (int status = unzGoToFirstFile(zip.get()); status != UNZ_END_OF_LIST_OF_FILE;
       status = unzGoToNextFile(zip.get())) {
    CheckUnzipped(status, "the list of files");
    if (entries.size() == kMostFiles)
      throw InvalidArgument(fmt::format("the archive has more than {} files", kMostFiles));
    entries.push_back(ReadEntry(zip.get(), left));
    left -= entries.back().bytes.size();
    if (!names.insert(entries.back().name).second)
      throw InvalidArgument(fmt::format("the archive has two files '{}'", entries.back().name));
  }
  return entries;
}

}  // namespace gaitwright
