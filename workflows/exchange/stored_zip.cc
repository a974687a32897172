// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/exchange/stored_zip.h"

#include <fmt/format.h>
#include <minizip/zip.h>

#include <algorithm>
#include <set>
#include <stdexcept>

#include "kinematics/base/result.h"

namespace gaitwright {
namespace {

constexpr uLong kFirstDay = (1UL << 21U) | (1UL << 16U);  // 1980-01-01 00:00 in MS-DOS format

/// A file in memory for minizip.
struct MemoryFile {
  std::string bytes;
  std::size_t at = 0;

  static MemoryFile& Of(voidpf opaque) { return *static_cast<MemoryFile*>(opaque); }

  static voidpf Open(voidpf opaque, const void* /*name*/, int /*mode*/) { return opaque; }
  static int Close(voidpf /*opaque*/, voidpf /*stream*/) { return 0; }
  static int Error(voidpf /*opaque*/, voidpf /*stream*/) { return 0; }

  static uLong Read(voidpf opaque, voidpf /*stream*/, void* to, uLong size) {
    MemoryFile& file = Of(opaque);
    const std::size_t count = std::min<std::size_t>(size, file.bytes.size() - std::min(file.at, file.bytes.size()));
    file.bytes.copy(static_cast<char*>(to), count, file.at);
    file.at += count;
    return count;
  }

  static uLong Write(voidpf opaque, voidpf /*stream*/, const void* from, uLong size) {
    MemoryFile& file = Of(opaque);
    file.bytes.resize(std::max<std::size_t>(file.bytes.size(), file.at + size));
    std::copy_n(static_cast<const char*>(from), size, file.bytes.begin() + static_cast<std::ptrdiff_t>(file.at));
    file.at += size;
    return size;
  }

  static ZPOS64_T Tell(voidpf opaque, voidpf /*stream*/) { return Of(opaque).at; }

  static long Seek(voidpf opaque, voidpf /*stream*/, ZPOS64_T offset, int origin) {
    MemoryFile& file = Of(opaque);
    const std::size_t from = origin == ZLIB_FILEFUNC_SEEK_SET   ? 0
                             : origin == ZLIB_FILEFUNC_SEEK_CUR ? file.at
                                                                : file.bytes.size();
    file.at = from + static_cast<std::size_t>(offset);
    return file.at <= file.bytes.size() ? 0 : -1;
  }
};

void Check(int status, const std::string& what) {
  if (status != ZIP_OK) throw std::runtime_error(fmt::format("minizip cannot write '{}' ({})", what, status));
}

void AddEntry(zipFile zip, const ZipEntry& entry) {
  zip_fileinfo info{};
  info.dosDate = kFirstDay;
  Check(zipOpenNewFileInZip64(zip, entry.name.c_str(), &info, nullptr, 0, nullptr, 0, nullptr, 0, 0,
                              entry.bytes.size() > 0xf0000000U ? 1 : 0),
        entry.name);
  constexpr std::size_t kMost = 1U << 30U;  // bytes per call
  for (std::size_t at = 0; at < entry.bytes.size(); at += kMost) {
    const std::size_t count = std::min(kMost, entry.bytes.size() - at);
    Check(zipWriteInFileInZip(zip, entry.bytes.data() + at, static_cast<unsigned>(count)), entry.name);
  }
  Check(zipCloseFileInZip(zip), entry.name);
}

}  // namespace

std::string StoredZip(const std::vector<ZipEntry>& entries) {
  std::set<std::string> names;
  for (const ZipEntry& entry : entries) {
    if (entry.name.empty() || !names.insert(entry.name).second) {
      throw InvalidArgument(fmt::format("the name '{}' of a file in an archive is empty or a duplicate", entry.name));
    }
  }
  MemoryFile file;
  zlib_filefunc64_def functions{MemoryFile::Open, MemoryFile::Read,  MemoryFile::Write, MemoryFile::Tell,
                                MemoryFile::Seek, MemoryFile::Close, MemoryFile::Error, &file};
  const zipFile zip = zipOpen2_64("", APPEND_STATUS_CREATE, nullptr, &functions);
  if (zip == nullptr) throw std::runtime_error("minizip cannot begin an archive");
  for (const ZipEntry& entry : entries) AddEntry(zip, entry);
  Check(zipClose(zip, nullptr), "the archive");
  return std::move(file.bytes);
}

}  // namespace gaitwright
