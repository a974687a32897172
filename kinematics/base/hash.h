// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace gaitwright {

/// 64-bit FNV-1a hash of the bytes. http://www.isthe.com/chongo/tech/comp/fnv/
std::uint64_t Fnv1a(std::string_view bytes);

/// The hash as 16 lower-case hexadecimal digits.
std::string HexHash(std::string_view bytes);

}  // namespace gaitwright
