// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <lz4frame.h>
#include <zstd.h>

#include <cstdint>

#include "kinematics/base/result.h"
#include "tests/workflows/exchange/mcap_bytes.h"
#include "workflows/exchange/crc32_internal.h"
#include "workflows/exchange/packed_bytes_internal.h"

namespace gaitwright {
namespace {

using synthetic::WhatOf;

std::string ByLz4(const std::string& bytes) {
  std::string packed(LZ4F_compressFrameBound(bytes.size(), nullptr), '\0');
  packed.resize(LZ4F_compressFrame(packed.data(), packed.size(), bytes.data(), bytes.size(), nullptr));
  return packed;
}

/// Three megabytes that pack well, and do not repeat exactly.
std::string ManyBytes() {
  std::string bytes;
  for (std::int64_t i = 0; bytes.size() < 3'000'000; ++i) bytes += std::to_string(i * i) + ",";
  return bytes;
}

TEST(PackedBytes, UnpackWhatOthersPacked) {
  const std::string bytes = ManyBytes();
  EXPECT_TRUE(Unpacked(bytes, "", bytes.size()) == bytes);
  EXPECT_TRUE(Unpacked(ByLz4(bytes), "lz4", bytes.size()) == bytes);
  EXPECT_TRUE(Unpacked(PackedZstd(bytes), "zstd", bytes.size()) == bytes);
  EXPECT_LT(PackedZstd(bytes).size(), bytes.size() / 2);
  EXPECT_TRUE(UnpackedZstd(PackedZstd(bytes) + PackedZstd("more"), 1U << 30U) == bytes + "more") << "two frames";
  EXPECT_EQ(Unpacked(ByLz4(""), "lz4", 0), "");
}

TEST(PackedBytes, RefuseOtherSizesAndDamage) {
  const std::string bytes = ManyBytes();
  for (const std::string kind : {"lz4", "zstd"}) {
    SCOPED_TRACE(kind);
    const std::string packed = kind == "lz4" ? ByLz4(bytes) : PackedZstd(bytes);
    const auto why = [&](const std::string& from, std::size_t size) {
      return WhatOf<InvalidArgument>([&] { Unpacked(from, kind, size); });
    };
    EXPECT_NE(why(packed, bytes.size() - 1).find("more than"), std::string::npos);
    EXPECT_NE(why(packed, bytes.size() + 1).find("but says that it has"), std::string::npos);
    EXPECT_NE(why(packed.substr(0, packed.size() / 2), bytes.size()).find("cut off"), std::string::npos);
    EXPECT_NE(why("no frame at all", 15).find("are damaged"), std::string::npos);
  }
  EXPECT_NE(WhatOf<InvalidArgument>([&] { Unpacked(bytes, "bz2", 1); }).find("'bz2'"), std::string::npos);
  EXPECT_THROW(UnpackedZstd(PackedZstd(bytes), bytes.size() - 1), InvalidArgument);
}

TEST(Crc32, IsThatOfTheStandard) {
  EXPECT_EQ(Crc32("123456789"), 0xcbf43926U) << "the check value of CRC-32 in catalogues";
  EXPECT_EQ(Crc32("6789", Crc32("12345")), 0xcbf43926U);
  EXPECT_EQ(Crc32(""), 0U);
}

}  // namespace
}  // namespace gaitwright
