// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <lz4frame.h>
#include <zstd.h>

#include <algorithm>
#include <memory>
#include <stdexcept>

#include "kinematics/base/result.h"
#include "workflows/exchange/packed_bytes_internal.h"

namespace gaitwright {
namespace {

constexpr std::size_t kPart = std::size_t{1} << 20U;  // bytes that are unpacked at once

[[noreturn]] void RefusePacked(const char* compression, const std::string& why) {
  throw InvalidArgument(fmt::format("its {} data are damaged ({})", compression, why));
}

/// Grows with what was unpacked, so that a false size does not reserve memory.
/// @param unpack  unpacks from the place `in` on, writes at most `room` bytes to `to`, and moves `in`; false if no more
///                bytes are needed.
template <class Unpack>
std::string UnpackedInParts(std::string_view bytes, std::size_t most, const char* compression, const Unpack& unpack) {
  std::string all;
  std::size_t in = 0;
  for (bool more = true; more;) {
    const std::size_t had = all.size(), room = std::min(kPart, most - had + 1), from = in;
    all.resize(had + room);
    std::size_t written = room;
    more = unpack(all.data() + had, written, in);
    all.resize(had + written);
    if (all.size() > most) RefusePacked(compression, fmt::format("more than {} bytes when unpacked", most));
    if (more && in == from && written == 0) RefusePacked(compression, "they are cut off");
    if (!more && in < bytes.size()) more = true;  // another frame follows
  }
  return all;
}

std::string UnpackedLz4(std::string_view bytes, std::size_t most) {
  LZ4F_dctx* raw = nullptr;
  if (LZ4F_isError(LZ4F_createDecompressionContext(&raw, LZ4F_VERSION)) != 0) throw std::bad_alloc();
  const std::unique_ptr<LZ4F_dctx, LZ4F_errorCode_t (*)(LZ4F_dctx*)> context(raw, LZ4F_freeDecompressionContext);
  return UnpackedInParts(bytes, most, "lz4", [&](char* to, std::size_t& written, std::size_t& in) {
    std::size_t read = bytes.size() - in;
    const std::size_t left = LZ4F_decompress(context.get(), to, &written, bytes.data() + in, &read, nullptr);
    if (LZ4F_isError(left) != 0) RefusePacked("lz4", LZ4F_getErrorName(left));
    in += read;
    return left != 0;
  });
}

}  // namespace

std::string UnpackedZstd(std::string_view bytes, std::size_t most) {
  const std::unique_ptr<ZSTD_DStream, std::size_t (*)(ZSTD_DStream*)> stream(ZSTD_createDStream(), ZSTD_freeDStream);
  if (stream == nullptr) throw std::bad_alloc();
  return UnpackedInParts(bytes, most, "zstd", [&](char* to, std::size_t& written, std::size_t& in) {
    ZSTD_inBuffer source{bytes.data(), bytes.size(), in};
    ZSTD_outBuffer target{to, written, 0};
    const std::size_t left = ZSTD_decompressStream(stream.get(), &target, &source);
    if (ZSTD_isError(left) != 0) RefusePacked("zstd", ZSTD_getErrorName(left));
    in = source.pos;
    written = target.pos;
    return left != 0;
  });
}

bool IsZstd(std::string_view bytes) { return bytes.starts_with("\x28\xb5\x2f\xfd"); }

std::string Unpacked(std::string_view bytes, const std::string& compression, std::size_t size) {
  std::string all;
  if (compression.empty()) {
    all = bytes;
  } else if (compression == "zstd") {
    all = UnpackedZstd(bytes, size);
  } else if (compression == "lz4") {
    all = UnpackedLz4(bytes, size);
  } else {
    throw InvalidArgument(fmt::format("its compression is '{}'; accepted: none, 'lz4', 'zstd'", compression));
  }
  if (all.size() != size)
    throw InvalidArgument(fmt::format("it has {} bytes when unpacked, but says that it has {}", all.size(), size));
  return all;
}

std::string PackedZstd(std::string_view bytes) {
  std::string packed(ZSTD_compressBound(bytes.size()), '\0');
  const std::size_t size = ZSTD_compress(packed.data(), packed.size(), bytes.data(), bytes.size(), 3);
  if (ZSTD_isError(size) != 0)
    throw std::runtime_error(fmt::format("zstd cannot pack {} bytes ({})", bytes.size(), ZSTD_getErrorName(size)));
  packed.resize(size);
  return packed;
}

}  // namespace gaitwright
