// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "kinematics/base/result.h"
#include "planning/plan/json_part_internal.h"
#include "planning/plan/plan_json.h"

namespace gaitwright {
namespace {

std::string ReasonRefused(const std::string& text) {
  try {
    ParseJsonOnce(text);
  } catch (const InvalidArgument& error) {
    return error.what();
  }
  return "";
}

TEST(JsonBounds, DepthAndKeysAreBounded) {
  EXPECT_EQ(ReasonRefused(std::string(64, '[') + std::string(64, ']')), "");
  EXPECT_NE(ReasonRefused(std::string(65, '[') + std::string(65, ']')).find("more than 64 levels"), std::string::npos);
  std::string object = "{\"k0\":0";
  for (int i = 1; i <= 5000; ++i) object += ",\"k" + std::to_string(i) + "\":0";
  EXPECT_NE(ReasonRefused(object + "}").find("more than 5000 keys"), std::string::npos);
  EXPECT_NE(ReasonRefused("[{\"a\":1},{\"a\":1,\"a\":2}]").find("'a' appears twice in one object"), std::string::npos);
}

TEST(JsonBounds, NumbersAndTextsStaySensible) {
  const JsonPart::Json json = ParseJsonOnce("{\"far\":1e300,\"list\":[1,-1e13],\"text\":\"a\\u0000b\"}");
  const JsonPart whole(json);
  EXPECT_THROW(whole.At("far").Number(), InvalidArgument);
  EXPECT_THROW(whole.At("list").Numbers(), InvalidArgument);
  EXPECT_THROW(whole.At("text").Text(), InvalidArgument);
  EXPECT_EQ(whole.At("list").List()[0].NumberIn(0.0, 1.0), 1.0);
  EXPECT_THROW(whole.At("list").List()[0].NumberIn(2.0, 3.0), InvalidArgument);
}

TEST(JsonBounds, ADeepPlanIsRefusedWithTheReason) {
  const auto plan = PlanFromJson("{\"format\":" + std::string(100000, '['), "some.json");
  ASSERT_FALSE(plan);
  EXPECT_NE(plan.failure().message.find("more than 64 levels"), std::string::npos) << plan.failure().message;
}

}  // namespace
}  // namespace gaitwright
