// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <minizip/ioapi.h>

#include <cstddef>
#include <string>
#include <string_view>

namespace gaitwright {

/// An archive in memory, through which minizip reads and writes. It reads `read`, unless it writes: then it reads what
/// was written. It must outlive the handle that minizip makes from Functions().
class ZipMemory {
 public:
  explicit ZipMemory(std::string_view read) : read_(read) {}
  explicit ZipMemory(std::string& written) : written_(&written) {}

  /// Callbacks for unzOpen2_64 and zipOpen2_64.
  zlib_filefunc64_def Functions();

 private:
  static ZipMemory& Of(voidpf opaque) { return *static_cast<ZipMemory*>(opaque); }
  static uLong Read(voidpf opaque, voidpf stream, void* to, uLong size);
  static uLong Write(voidpf opaque, voidpf stream, const void* from, uLong size);
  static long Seek(voidpf opaque, voidpf stream, ZPOS64_T offset, int origin);

  std::string_view bytes() const { return written_ == nullptr ? read_ : std::string_view(*written_); }

  std::string_view read_;
  std::string* written_ = nullptr;
  std::size_t at_ = 0;
};

}  // namespace gaitwright
