// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/base/hash.h"

#include <fmt/format.h>

namespace gaitwright {

std::uint64_t Fnv1a(std::string_view bytes) {
  std::uint64_t hash = 14695981039346656037ULL;
  for (const char byte : bytes) {
    hash ^= static_cast<unsigned char>(byte);
    hash *= 1099511628211ULL;
  }
  return hash;
}

std::string HexHash(std::string_view bytes) { return fmt::format("{:016x}", Fnv1a(bytes)); }

}  // namespace gaitwright
