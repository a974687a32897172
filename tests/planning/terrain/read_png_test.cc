// SPDX-License-Identifier: BSD-3-Clause
#include "planning/terrain/read_png.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/planning/terrain/made_png.h"
#include "tests/planning/terrain/terrain_files.h"

namespace gaitwright {
namespace {

Result<GreyImage> ReadBytesAsPng(const std::string& bytes) {
  return ReadGreyPng(terrain_files::Written("read_png_test.png", bytes));
}

std::string ReasonNoGrey(const std::string& bytes) {
  const Result<GreyImage> image = ReadBytesAsPng(bytes);
  if (image.ok()) return "";
  EXPECT_EQ(image.failure().kind, FailureKind::kBadInput);
  EXPECT_EQ(image.failure().code, FailureCode::kTerrainFile);
  return image.failure().message;
}

TEST(ReadGreyPng, OfEightBitsHasItsValuesRowByRowFromTheTop) {
  const auto image = ReadBytesAsPng(made_png::Png(3, 2, 8, 0, std::string("\x01\x02\x03\xfd\xfe\xff", 6)));
  ASSERT_TRUE(image.ok()) << image.failure().message;
  EXPECT_EQ(image->columns, 3);
  EXPECT_EQ(image->rows, 2);
  EXPECT_EQ(image->full, 255);
  EXPECT_EQ(image->values, (std::vector<std::uint16_t>{1, 2, 3, 253, 254, 255}));
}

TEST(ReadGreyPng, OfSixteenBitsHasTheHighByteFirst) {
  const auto image = ReadBytesAsPng(made_png::Png(2, 1, 16, 0, std::string("\x12\x34\xff\xff", 4)));
  ASSERT_TRUE(image.ok()) << image.failure().message;
  EXPECT_EQ(image->full, 65535);
  EXPECT_EQ(image->values, (std::vector<std::uint16_t>{0x1234, 0xffff}));
}

TEST(ReadGreyPng, APointAloneIsAPicture) {
  const auto image = ReadBytesAsPng(made_png::Png(1, 1, 8, 0, std::string("\x80", 1)));
  ASSERT_TRUE(image.ok()) << image.failure().message;
  EXPECT_EQ(image->values, std::vector<std::uint16_t>{128});
}

TEST(ReadGreyPng, OtherKindsOfPicturesAreRefusedForWhatTheyAre) {
  EXPECT_NE(ReasonNoGrey(made_png::Png(1, 1, 8, 2, "abc")).find("in colour"), std::string::npos);
  EXPECT_NE(ReasonNoGrey(made_png::Png(1, 1, 8, 4, "ab")).find("has transparency"), std::string::npos);
  EXPECT_NE(ReasonNoGrey(made_png::Png(8, 1, 1, 0, "a")).find("has 1 bits per point; accepted: 8 or 16"),
            std::string::npos);
  EXPECT_NE(ReasonNoGrey(made_png::Png(2, 1, 4, 0, "a")).find("has 4 bits"), std::string::npos);
}

TEST(ReadGreyPng, WhatIsCutShortAnywhereIsRefused) {
  const std::string whole = made_png::Png(4, 4, 8, 0, std::string(16, 'x'));
  ASSERT_EQ(ReasonNoGrey(whole), "");
  for (std::size_t length = 0; length + 12 < whole.size(); length += 5)
    EXPECT_NE(ReasonNoGrey(whole.substr(0, length)), "") << length << " of " << whole.size() << " bytes";
}

TEST(ReadGreyPng, AByteThatIsNotAsItWasIsFoundByItsChecksum) {
  const std::string whole = made_png::Png(4, 4, 8, 0, std::string(16, 'x'));
  for (const std::size_t at : {std::size_t{1}, std::size_t{20}, whole.find('x')}) {
    std::string changed = whole;
    changed[at] = static_cast<char>(changed[at] ^ 1);
    EXPECT_NE(ReasonNoGrey(changed), "") << at;
  }
}

TEST(ReadGreyPng, AFileThatDoesNotExistOrIsNoPngIsNamed) {
  const Result<GreyImage> none = ReadGreyPng(terrain_files::Folder() + "nowhere.png");
  ASSERT_FALSE(none.ok());
  EXPECT_NE(none.failure().message.find("nowhere.png"), std::string::npos);
  EXPECT_NE(ReasonNoGrey("just text").find("is not a readable PNG"), std::string::npos);
  EXPECT_NE(ReasonNoGrey(""), "");
}

}  // namespace
}  // namespace gaitwright
