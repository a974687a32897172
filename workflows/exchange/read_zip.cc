// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <minizip/unzip.h>

#include <array>
#include <memory>
#include <set>
#include <string_view>
#include <utility>

#include "kinematics/base/result.h"
#include "workflows/exchange/read_zip_internal.h"
#include "workflows/exchange/zip_memory_internal.h"

namespace gaitwright {
namespace {

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
  ZipMemory file{std::string_view(bytes)};
  zlib_filefunc64_def functions = file.Functions();
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
