// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "kinematics/base/result.h"
#include "kinematics/base/strict_yaml_internal.h"

namespace gaitwright {
namespace {

std::string ReasonRefused(const std::string& text) {
  try {
    LoadYaml(text);
  } catch (const InvalidArgument& error) {
    return error.what();
  }
  return "";
}

void ExpectReason(const std::string& text, const std::string& part) {
  EXPECT_NE(ReasonRefused(text).find(part), std::string::npos) << ReasonRefused(text);
}

TEST(LoadYaml, TakesWhatIsWithinTheBounds) {
  EXPECT_TRUE(LoadYaml("").IsNull());
  EXPECT_EQ(LoadYaml("a: &x [1, 2]\nb: *x\n")["b"][1].Scalar(), "2");
  EXPECT_THROW(LoadYaml("a: [1"), YAML::Exception);
}

TEST(LoadYaml, AliasesThatRepeatOneAnotherWithoutEndAreRefused) {
  std::string bomb = "a: &a [x,x,x,x,x,x,x,x,x,x]\n";
  for (char c = 'b'; c < 'k'; ++c) {
    const std::string before = std::string("*") + static_cast<char>(c - 1);
    bomb += std::string(1, c) + ": &" + c + " [" + before;
    for (int i = 0; i < 9; ++i) bomb += ", " + before;
    bomb += "]\n";
  }
  ExpectReason(bomb, "line 6: more than 1000000 values");
  ExpectReason("a: &x [*x]\n", "line 1: an alias refers to a node that contains it");
}

TEST(LoadYaml, DepthLengthAndDocumentsAreBounded) {
  ExpectReason(std::string(33, '[') + std::string(33, ']'), "lists and maps are nested more than 32 levels deep");
  EXPECT_EQ(ReasonRefused(std::string(32, '[') + std::string(32, ']')), "");
  ExpectReason("a: " + std::string(70000, 'x'), "a text has 70000 bytes; at most 65536");
  ExpectReason("a: 1\n---\nb: 2\n", "a second YAML document begins; exactly one is accepted");
  ExpectReason("a: \"\\0\"", "0x00");
  ExpectReason(std::string((16U << 20U) + 1U, ' '), "at most 16777216 are read");
}

TEST(LoadYaml, BoundsMayBeOthers) {
  EXPECT_NO_THROW(LoadYaml("[1, 2, 3]", {.bytes = 9, .values = 4}));
  EXPECT_THROW(LoadYaml("[1, 2, 3]", {.bytes = 8}), InvalidArgument);
  EXPECT_THROW(LoadYaml("[1, 2, 3]", {.values = 3}), InvalidArgument);
}

TEST(StrictYaml, TextIsPlainText) {
  EXPECT_THROW(TextOf(LoadYaml("\"a\\ab\""), "'name'"), InvalidArgument);
  EXPECT_EQ(TextOf(LoadYaml("\"caf\\u00e9\""), "'name'"), "caf\xc3\xa9");
}

}  // namespace
}  // namespace gaitwright
