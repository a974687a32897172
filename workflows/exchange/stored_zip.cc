// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/exchange/stored_zip.h"

#include <fmt/format.h>
#include <minizip/zip.h>

#include <algorithm>
#include <set>
#include <stdexcept>

#include "kinematics/base/result.h"
#include "workflows/exchange/zip_memory_internal.h"

namespace gaitwright {
namespace {

constexpr uLong kFirstDay = (1UL << 21U) | (1UL << 16U);  // 1980-01-01 00:00 in MS-DOS format

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
  std::string bytes;
  ZipMemory file(bytes);
  zlib_filefunc64_def functions = file.Functions();
  const zipFile zip = zipOpen2_64("", APPEND_STATUS_CREATE, nullptr, &functions);
  if (zip == nullptr) throw std::runtime_error("minizip cannot begin an archive");
  for (const ZipEntry& entry : entries) AddEntry(zip, entry);
  Check(zipClose(zip, nullptr), "the archive");
  return bytes;
}

}  // namespace gaitwright
