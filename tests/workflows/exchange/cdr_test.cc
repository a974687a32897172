// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "kinematics/base/result.h"
#include "tests/workflows/exchange/mcap_bytes.h"
#include "workflows/exchange/cdr_internal.h"

namespace gaitwright {
namespace {

using synthetic::WhatOf;

std::string Bytes(std::initializer_list<int> values) {
  std::string bytes;
  for (const int value : values) bytes += static_cast<char>(value);
  return bytes;
}

/// A text "ab", an empty list, the number 1, and the list {2}.
const std::string kLittle = Bytes({0, 1, 0, 0, 3,    0,    0, 0, 'a', 'b', 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
                                   0, 0, 0, 0, 0xf0, 0x3f, 1, 0, 0,   0,   0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0x40});
const std::string kBig = Bytes({0, 0, 0, 0, 0, 0, 0, 3, 'a', 'b', 0, 0, 0, 0, 0,    0, 0, 0, 0, 0, 0x3f, 0xf0,
                                0, 0, 0, 0, 0, 0, 0, 0, 0,   1,   0, 0, 0, 0, 0x40, 0, 0, 0, 0, 0, 0,    0});

TEST(Cdr, ReadsBothByteOrdersWithTheirPadding) {
  for (const std::string& bytes : {kLittle, kBig}) {
    CdrReader cdr(bytes);
    EXPECT_EQ(cdr.Text(), "ab");
    EXPECT_TRUE(cdr.Numbers().empty());
    EXPECT_EQ(cdr.Number(), 1.0);
    EXPECT_EQ(cdr.Numbers(), std::vector<double>{2.0});
  }
}

TEST(Cdr, TextsAreUtf8WhateverTheirBytes) {
  EXPECT_EQ(CdrReader(Bytes({0, 1, 0, 0, 3, 0, 0, 0, 0xa1, 'j', 0})).Text(), "\u00a1j");
  EXPECT_EQ(CdrReader(Bytes({0, 1, 0, 0, 3, 0, 0, 0, 0xc2, 0xa1, 0})).Text(), "\u00a1");
}

TEST(Cdr, WritesLittleEndian) {
  CdrWriter cdr;
  cdr.Text("ab");
  cdr.Numbers(nullptr, 0);
  cdr.Number(1.0);
  const double two = 2.0;
  cdr.Numbers(&two, 1);
  EXPECT_EQ(cdr.Take(), kLittle);
  CdrWriter whole;
  whole.Int32(-2);
  whole.Texts({"x", ""});
  const std::string bytes = whole.Take();
  CdrReader again(bytes);
  EXPECT_EQ(again.Int32(), -2);
  EXPECT_EQ(again.Texts(), (std::vector<std::string>{"x", ""}));
}

TEST(Cdr, RefusesWhatIsTooShort) {
  EXPECT_NE(WhatOf<InvalidArgument>([] { CdrReader(Bytes({0, 1})); }).find("has 2 bytes"), std::string::npos);
  EXPECT_NE(WhatOf<InvalidArgument>([] { CdrReader(Bytes({0, 3, 0, 0})); }).find("0x0003"), std::string::npos);
  for (std::size_t size = 4; size < kLittle.size(); ++size) {
    const std::string cut = kLittle.substr(0, size);
    EXPECT_THROW(
        {
          CdrReader cdr(cut);
          cdr.Text();
          cdr.Numbers();
          cdr.Number();
          cdr.Numbers();
        },
        InvalidArgument)
        << size;
  }
  EXPECT_EQ(WhatOf<InvalidArgument>([] {
              CdrReader(Bytes({0, 1, 0, 0, 5, 0, 0, 0, 'a'})).Text();
            }),
            "the list of 5 elements at byte 4 is longer than the message");
  EXPECT_NE(WhatOf<InvalidArgument>([] {
              CdrReader(Bytes({0, 1, 0, 0, 1, 0, 0, 0, 'a'})).Text();
            }).find("a zero"),
            std::string::npos);
}

}  // namespace
}  // namespace gaitwright
