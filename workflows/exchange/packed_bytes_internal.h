// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace gaitwright {

/// Unpacks frames of LZ4 or zstd. @param compression  "lz4", "zstd", or "" for bytes that are not packed.
/// @param size  of the unpacked bytes. @throws InvalidArgument for another compression, for damaged bytes and for
/// another size.
std::string Unpacked(std::string_view bytes, const std::string& compression, std::size_t size);

/// Unpacks frames of zstd with an unknown size. @throws InvalidArgument for damaged bytes and for more than `most`.
std::string UnpackedZstd(std::string_view bytes, std::size_t most);

/// Whether the bytes begin as a frame of zstd.
bool IsZstd(std::string_view bytes);

/// Packs bytes as one frame of zstd, so that the same bytes give the same frame.
std::string PackedZstd(std::string_view bytes);

}  // namespace gaitwright
