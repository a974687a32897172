// SPDX-License-Identifier: BSD-3-Clause
#include "planning/terrain/write_png.h"

#include "tests/planning/terrain/made_png.h"
#include "tests/planning/terrain/terrain_files.h"

namespace gaitwright {
namespace {

GreyImage ReadBack(const GreyImage& image) {
  const Result<std::string> bytes = WriteGreyPng(image);
  EXPECT_TRUE(bytes.ok()) << bytes.failure().message;
  if (!bytes.ok()) return {};
  const Result<GreyImage> read = ReadGreyPng(terrain_files::Written("written.png", *bytes));
  EXPECT_TRUE(read.ok()) << read.failure().message;
  return read.ok() ? *read : GreyImage{};
}

TEST(WriteGreyPng, PicturesOfBothDepthsAreReadBack) {
  const GreyImage wide{3, 2, 65535, {0, 1, 255, 256, 40000, 65535}}, narrow{2, 3, 255, {0, 1, 127, 128, 254, 255}};
  for (const GreyImage& image : {wide, narrow}) {
    const GreyImage read = ReadBack(image);
    EXPECT_EQ(read.columns, image.columns);
    EXPECT_EQ(read.rows, image.rows);
    EXPECT_EQ(read.full, image.full);
    EXPECT_EQ(read.values, image.values);
    EXPECT_EQ(*WriteGreyPng(image), *WriteGreyPng(image)) << "the same bytes again";
  }
}

TEST(WriteGreyPng, IsWhatTheSpecificationSays) {
  const GreyImage image{2, 1, 65535, {0x0102, 0xfffe}};
  const std::string made = made_png::Png(2, 1, 16, 0, "\x01\x02\xff\xfe"), written = *WriteGreyPng(image);
  EXPECT_EQ(written.substr(0, 33), made.substr(0, 33)) << "signature and header";
  const Result<GreyImage> read = ReadGreyPng(terrain_files::Written("made.png", made));
  ASSERT_TRUE(read.ok());
  EXPECT_EQ(read->values, image.values);
}

TEST(WriteGreyPng, RefusesWhatIsNoPicture) {
  EXPECT_THROW((void)WriteGreyPng({2, 2, 255, {1, 2, 3}}), InvalidArgument);
  EXPECT_THROW((void)WriteGreyPng({0, 0, 255, {}}), InvalidArgument);
  EXPECT_THROW((void)WriteGreyPng({-1, -1, 255, {1}}), InvalidArgument);
  EXPECT_THROW((void)WriteGreyPng({1, 1, 1000, {1}}), InvalidArgument);
}

}  // namespace
}  // namespace gaitwright
