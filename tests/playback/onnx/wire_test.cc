// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <limits>

#include "kinematics/base/result.h"
#include "playback/onnx/half_internal.h"
#include "playback/onnx/wire_internal.h"
#include "tests/playback/onnx/written_network.h"

namespace gaitwright::onnx {
namespace {

TEST(WireTest, ReadsTheExamplesOfTheSpecification) {
  const std::string message("\x08\x96\x01", 3);  // field 1: 150
  const std::vector<WireField> fields = FieldsOf(message);
  ASSERT_EQ(fields.size(), 1U);
  EXPECT_EQ(fields[0].number, 1);
  EXPECT_EQ(fields[0].Whole(), 150);
  const std::string text("\x12\x07\x74\x65\x73\x74\x69\x6e\x67", 9);  // field 2: "testing"
  EXPECT_EQ(BytesOf(FieldsOf(text).front()), "testing");
}

TEST(WireTest, ReadsNegativeNumbersAndFloats) {
  EXPECT_EQ(FieldsOf(written::WholeField(3, -7)).front().Whole(), -7);
  EXPECT_EQ(FieldsOf(written::FloatField(5, -0.25F)).front().Float(), -0.25F);
}

TEST(WireTest, ReadsListsPackedAndNot) {
  std::vector<std::int64_t> list;
  for (const std::string& message : {written::WholeField(1, 5), written::BytesField(1, std::string("\x01\x96\x01", 3))})
    AddWholes(FieldsOf(message).front(), list);
  EXPECT_EQ(list, (std::vector<std::int64_t>{5, 1, 150}));
}

TEST(WireTest, RefusesTruncatedMessages) {
  EXPECT_THROW(FieldsOf(std::string("\x08\x96", 2)), InvalidArgument);
  EXPECT_THROW(FieldsOf(std::string("\x12\x07\x74", 3)), InvalidArgument);
  EXPECT_THROW(FieldsOf(std::string("\x0b", 1)), InvalidArgument);  // a group
  EXPECT_THROW(FieldsOf(std::string(11, '\xff')), InvalidArgument);
  EXPECT_THROW((void)BytesOf(FieldsOf(written::WholeField(1, 5)).front()), InvalidArgument);
}

TEST(WireTest, HalfPrecisionFollowsIeee754) {
  EXPECT_EQ(FloatFromHalf(0x3c00), 1.0F);
  EXPECT_EQ(FloatFromHalf(0xc000), -2.0F);
  EXPECT_EQ(FloatFromHalf(0x0001), 5.9604645e-08F);
  EXPECT_EQ(FloatFromHalf(0x7bff), 65504.0F);
  EXPECT_EQ(FloatFromHalf(0x7c00), std::numeric_limits<float>::infinity());
}

}  // namespace
}  // namespace gaitwright::onnx
