// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "workflows/exchange/zip_memory_internal.h"

namespace gaitwright {

zlib_filefunc64_def ZipMemory::Functions() {
  zlib_filefunc64_def functions{};
  functions.zopen64_file = [](voidpf opaque, const void* /*name*/, int /*mode*/) { return opaque; };
  functions.zread_file = Read;
  functions.zwrite_file = Write;
  functions.ztell64_file = [](voidpf opaque, voidpf /*stream*/) -> ZPOS64_T { return Of(opaque).at_; };
  functions.zseek64_file = Seek;
  functions.zclose_file = [](voidpf /*opaque*/, voidpf /*stream*/) { return 0; };
  functions.zerror_file = [](voidpf /*opaque*/, voidpf /*stream*/) { return 0; };
  functions.opaque = this;
  return functions;
}

uLong ZipMemory::Read(voidpf opaque, voidpf /*stream*/, void* to, uLong size) {
  ZipMemory& file = Of(opaque);
  const std::size_t count = std::min<std::size_t>(size, file.bytes().size() - file.at_);
  file.bytes().copy(static_cast<char*>(to), count, file.at_);
  file.at_ += count;
  return count;
}

uLong ZipMemory::Write(voidpf opaque, voidpf /*stream*/, const void* from, uLong size) {
  ZipMemory& file = Of(opaque);
  if (file.written_ == nullptr) return 0;
  std::string& bytes = *file.written_;
  bytes.resize(std::max<std::size_t>(bytes.size(), file.at_ + size));
  std::copy_n(static_cast<const char*>(from), size, bytes.begin() + static_cast<std::ptrdiff_t>(file.at_));
  file.at_ += size;
  return size;
}

long ZipMemory::Seek(voidpf opaque, voidpf /*stream*/, ZPOS64_T offset, int origin) {
  ZipMemory& file = Of(opaque);
  const std::size_t size = file.bytes().size();
  const std::size_t from = origin == ZLIB_FILEFUNC_SEEK_SET ? 0 : origin == ZLIB_FILEFUNC_SEEK_CUR ? file.at_ : size;
  if (offset > size - from) return -1;
  file.at_ = from + static_cast<std::size_t>(offset);
  return 0;
}

}  // namespace gaitwright
