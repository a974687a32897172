// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "kinematics/base/result.h"
#include "planning/plan/json_part_internal.h"

namespace gaitwright {
namespace {

using Json = JsonPart::Json;

/// The refusal when a text is read; "none" if it is accepted.
std::string RefusalOfReading(const std::string& text, const std::function<void(const JsonPart&)>& read) {
  const Json json = ParseJsonOnce(text);
  try {
    read(JsonPart(json));
  } catch (const InvalidArgument& refusal) {
    return refusal.what();
  }
  return "none";
}

TEST(JsonPartObject, HasAllRequiredKeysAndNoUnknownOnes) {
  const auto read = [](const JsonPart& part) { part.Object({"mass", "length"}, {"colour"}); };
  EXPECT_EQ(RefusalOfReading(R"({"mass": 1, "length": 2})", read), "none");
  EXPECT_EQ(RefusalOfReading(R"({"mass": 1, "length": 2, "colour": 3})", read), "none");
  EXPECT_EQ(RefusalOfReading(R"({"mass": 1})", read), "it lacks 'length'");
  const std::string unknown = RefusalOfReading(R"({"mass": 1, "lenght": 2})", read);
  EXPECT_NE(unknown.find("unknown key 'lenght'"), std::string::npos);
  EXPECT_NE(unknown.find("'length'"), std::string::npos) << "the nearest: " << unknown;
  EXPECT_NE(RefusalOfReading("[1]", read).find("a list of 1"), std::string::npos);
}

TEST(JsonPartPlace, IsNamedByKeysAndIndicesFromTheTop) {
  const auto read = [](const JsonPart& part) {
    for (const JsonPart& foot : part.At("feet").List()) (void)foot.At("pose").At("x").Number();
  };
  const std::string refusal = RefusalOfReading(R"({"feet": [{"pose": {"x": 1}}, {"pose": {"x": "far"}}]})", read);
  EXPECT_EQ(refusal, "'feet[1].pose.x' is 'far'; a number is needed");
  EXPECT_EQ(RefusalOfReading(R"({"feet": [{"pose": {}}]})", read), "'feet[0].pose' lacks 'x'");
}

struct KindCase {
  const char* name;
  std::function<void(const JsonPart&)> read;
  std::vector<std::string> accepted, refused;
};

class JsonPartKinds : public testing::TestWithParam<KindCase> {};

TEST_P(JsonPartKinds, TakeTheirOwnKindAndNoOther) {
  for (const std::string& text : GetParam().accepted)
    EXPECT_EQ(RefusalOfReading(text, GetParam().read), "none") << text;
  for (const std::string& text : GetParam().refused) EXPECT_NE(RefusalOfReading(text, GetParam().read), "none") << text;
}

INSTANTIATE_TEST_SUITE_P(
    Readers, JsonPartKinds,
    testing::Values(
        KindCase{"Number",
                 [](const JsonPart& p) { (void)p.Number(); },
                 {"1", "-2.5", "1e12", "0"},
                 {"\"1\"", "null", "true", "[1]", "{}", "1.1e12", "-1e13"}},
        KindCase{"NumberIn",
                 [](const JsonPart& p) { (void)p.NumberIn(-1.0, 2.0); },
                 {"-1", "2", "0.5"},
                 {"-1.001", "2.001", "\"0\""}},
        KindCase{"NumberFrom", [](const JsonPart& p) { (void)p.NumberFrom(0.0); }, {"0", "9"}, {"-1e-9"}},
        KindCase{"Whole",
                 [](const JsonPart& p) { (void)p.Whole(0, 7); },
                 {"0", "7"},
                 {"-1", "8", "1.0", "1.5", "99999999999999", "\"3\""}},
        KindCase{"Natural",
                 [](const JsonPart& p) { (void)p.Natural(); },
                 {"0", "18446744073709551615"},
                 {"-1", "1.0", "null"}},
        KindCase{"Truth", [](const JsonPart& p) { (void)p.Truth(); }, {"true", "false"}, {"0", "1", "\"true\""}},
        KindCase{"Text", [](const JsonPart& p) { (void)p.Text(); }, {"\"\"", "\"a\""}, {"1", "null", "\"a\\u0000b\""}},
        KindCase{"Numbers",
                 [](const JsonPart& p) { (void)p.Numbers(); },
                 {"[]", "[1, 2.5]"},
                 {"1", "[1, null]", "[[1]]", "[1, 1e13]", "{}"}},
        KindCase{"Vector", [](const JsonPart& p) { (void)p.Vector(3); }, {"[1, 2, 3]"}, {"[1, 2]", "[1, 2, 3, 4]"}},
        KindCase{"List", [](const JsonPart& p) { (void)p.List(); }, {"[]", "[1, \"a\"]"}, {"{}", "1", "\"[]\""}},
        KindCase{"Choice",
                 [](const JsonPart& p) {
                   (void)p.Choice({"red", "blue"});
                 },
                 {"\"red\"", "\"blue\""},
                 {"\"Red\"", "\"\"", "0"}}),
    [](const auto& kind) { return std::string(kind.param.name); });

TEST(JsonPartValues, AreThoseThatAreWritten) {
  const Json json = ParseJsonOnce(R"({"n": -2.5, "w": 7, "t": "word", "b": true, "v": [1, 2], "c": "blue"})");
  const JsonPart part(json);
  EXPECT_EQ(part.At("n").Number(), -2.5);
  EXPECT_EQ(part.At("w").Whole(0, 9), 7);
  EXPECT_EQ(part.At("w").Natural(), 7U);
  EXPECT_EQ(part.At("t").Text(), "word");
  EXPECT_TRUE(part.At("b").Truth());
  EXPECT_EQ(part.At("v").Numbers(), (std::vector<double>{1.0, 2.0}));
  EXPECT_EQ(part.At("c").Choice({"red", "blue"}), 1);
  EXPECT_TRUE(part.Has("n"));
  EXPECT_FALSE(part.Has("m"));
}

TEST(JsonPartPose, IsPlaceAndUnitQuaternionWithWLast) {
  const Json json = ParseJsonOnce("[1, 2, 3, 0, 0, 0.7071067811865476, 0.7071067811865476]");
  const Pose X = JsonPart(json).ToPose();
  EXPECT_LT((X.translation() - Vector3(1.0, 2.0, 3.0)).norm(), 1e-12);
  EXPECT_LT((X.linear() * Vector3::UnitX() - Vector3::UnitY()).norm(), 1e-12) << "a quarter turn about z";
  const auto read = [](const JsonPart& part) { (void)part.ToPose(); };
  EXPECT_NE(RefusalOfReading("[0, 0, 0, 0, 0, 0, 1.001]", read), "none");
  EXPECT_NE(RefusalOfReading("[0, 0, 0, 0, 0, 0, 0]", read), "none");
  EXPECT_NE(RefusalOfReading("[0, 0, 0, 1]", read), "none");
  EXPECT_EQ(RefusalOfReading("[0, 0, 0, 0, 0, 0, -1]", read), "none") << "the other sign is the same rotation";
}

TEST(ParseJsonOnce, RefusesAKeyThatStandsTwiceInOneObject) {
  EXPECT_THROW((void)ParseJsonOnce(R"({"a": 1, "a": 2})"), InvalidArgument);
  EXPECT_NO_THROW((void)ParseJsonOnce(R"({"a": {"a": 1}, "b": {"a": 2}})"));
}

TEST(ParseJsonOnce, ReadsAsDeepAsTheBoundAndNoDeeper) {
  const auto nested = [](std::size_t depth) { return std::string(depth, '[') + std::string(depth, ']'); };
  EXPECT_NO_THROW((void)ParseJsonOnce(nested(kDeepestJson)));
  EXPECT_THROW((void)ParseJsonOnce(nested(kDeepestJson + 1)), InvalidArgument);
}

TEST(ReasonNoJson, NamesThePlaceOfTheSyntaxError) {
  EXPECT_EQ(ReasonNoJson(""), "it is empty");
  const std::string cut = ReasonNoJson(R"({"mass": 1, "len)");
  EXPECT_NE(cut.find("cut short at byte 16"), std::string::npos) << cut;
  EXPECT_NE(cut.find("'mass'"), std::string::npos) << cut;
  const std::string broken = ReasonNoJson(R"({"mass": 1; "length": 2})");
  EXPECT_NE(broken.find("syntax error at byte 11"), std::string::npos) << broken;
  for (const std::string word : {"NaN", "-Infinity", "1e999"}) {
    const std::string why = ReasonNoJson(R"({"mass": )" + word + "}");
    EXPECT_NE(why.find("'mass' contains " + word), std::string::npos) << why;
  }
}

// 30 bytes end inside of the tenth three-byte character.
TEST(JsonPartPlace, ALongTextIsCutBetweenCharacters) {
  std::string text = "a", shown = "a";
  for (int i = 0; i < 20; ++i) text += "\u932f";
  for (int i = 0; i < 9; ++i) shown += "\u932f";
  EXPECT_EQ(RefusalOfReading("[\"" + text + "\"]", [](const JsonPart& part) { (void)part.List()[0].Number(); }),
            "'[0]' is '" + shown + "...'; a number is needed");
}

}  // namespace
}  // namespace gaitwright
