// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/description/mjcf_attributes_internal.h"
#include "tests/kinematics/description/mjcf_texts.h"

namespace gaitwright {
namespace {

using AttributeValues = MjcfAttributes::Values;

MjcfAttributes Attributes(AttributeValues values) { return {"model.xml, line 3: geom 'g'", std::move(values)}; }

TEST(MjcfAttributes, WhatIsNotThereIsTheFallback) {
  const MjcfAttributes none = Attributes({});
  EXPECT_FALSE(none.Has("a"));
  EXPECT_EQ(none.Text("a"), "");
  EXPECT_EQ(none.Name("a"), "");
  EXPECT_TRUE(none.Numbers("a", 3, 3).empty());
  EXPECT_EQ(none.Number("a", 2.5), 2.5);
  EXPECT_EQ(none.Three("a", {1, 2, 3}), Vector3(1, 2, 3));
  EXPECT_EQ(none.Choice("a", {"b", "c"}, "other"), "other");
  EXPECT_TRUE(none.Flag("a", true));
  EXPECT_FALSE(none.Flag("a", false));
}

TEST(MjcfAttributes, NumbersStandBetweenAnyBlanks) {
  const MjcfAttributes some = Attributes({{"v", " 1\t-2.5e-1\n +3 "}, {"n", "1e9"}});
  EXPECT_EQ(some.Numbers("v", 3, 3), (std::vector<double>{1.0, -0.25, 3.0}));
  EXPECT_EQ(some.Numbers("v", 1, 3).size(), 3U);
  EXPECT_EQ(some.Three("v", Vector3::Zero()), Vector3(1.0, -0.25, 3.0));
  EXPECT_EQ(some.Number("n", 0.0), 1e9);
}

TEST(MjcfAttributes, RefusesWordsThatAreNoNumbersAndWrongCounts) {
  for (const char* text : {"a", "1a", "1,2", "nan", "inf", "-inf", "0x10", "1e10", "-1.1e9", "--1", "+", ""}) {
    const Failure failure = MjcfFailureOf([&] { Attributes({{"k", text}}).Number("k", 0.0); });
    EXPECT_EQ(failure.code, FailureCode::kMjcfNumber) << text;
    EXPECT_EQ(failure.kind, FailureKind::kBadInput);
    ExpectSays(failure.message, {"model.xml, line 3: geom 'g'", "'k'"});
  }
  ExpectSays(MjcfFailureOf([] {
               Attributes({{"k", "1 2"}}).Three("k", Vector3::Zero());
             }).message,
             {"'1 2'", "2 numbers", "3 are needed"});
  ExpectSays(MjcfFailureOf([] { Attributes({{"k", "1 2 3"}}).Numbers("k", 1, 2); }).message, {"1 to 2"});
}

TEST(MjcfAttributes, NamesArePlainTextOfOneLine) {
  EXPECT_EQ(Attributes({{"n", " a 'b' \xC3\xA9"}}).Name("n"), " a 'b' \xC3\xA9");
  EXPECT_EQ(Attributes({{"n", std::string(500, 'a')}}).Name("n").size(), 500U);
  for (const std::string& name : {std::string(501, 'a'), std::string("a\nb"), std::string("a\tb"), std::string("\x01"),
                                  std::string("\xC3"), std::string("\xFF\xFE")})
    EXPECT_EQ(MjcfFailureOf([&] { Attributes({{"n", name}}).Name("n"); }).code, FailureCode::kMjcfName);
}

TEST(MjcfAttributes, ChoicesAreExact) {
  const MjcfAttributes some = Attributes({{"a", "box"}, {"b", "Box"}, {"c", " true"}, {"d", "true"}});
  EXPECT_EQ(some.Choice("a", {"sphere", "box"}, "sphere"), "box");
  EXPECT_TRUE(some.Flag("d", false));
  for (const char* key : {"b", "c"}) {
    const Failure failure = MjcfFailureOf([&] { some.Choice(key, {"box", "true"}, "box"); });
    EXPECT_EQ(failure.code, FailureCode::kMjcfChoice);
    ExpectSays(failure.message, {"'box', 'true'"});
  }
}

struct LimitCase {
  const char *flag, *range;
  bool autolimits, limited;
};

// MuJoCo XML reference, joint/limited.
TEST(MjcfAttributes, ARangeCountsAsFlagAndCompilerSay) {
  const LimitCase cases[] = {
      {"true", "-1 1", false, true},  {"true", "-1 1", true, true}, {"false", "-1 1", true, false},
      {"auto", "-1 1", false, false}, {"auto", "-1 1", true, true}, {"auto", "0 0", true, false},
      {"", "-1 1", true, true},       {"", "-1 1", false, false},   {"", "", true, false},
      {"false", "2 1", true, false},  {"", "2 1", false, false}};
  for (const LimitCase& one : cases) {
    AttributeValues values;
    if (*one.flag != '\0') values["limited"] = one.flag;
    if (*one.range != '\0') values["range"] = one.range;
    EXPECT_EQ(Attributes(values).IsLimited("limited", "range", one.autolimits), one.limited)
        << one.flag << ", " << one.range << ", " << one.autolimits;
  }
  for (const AttributeValues& wrong : {AttributeValues{{"limited", "true"}},
                                       {{"limited", "true"}, {"range", "0 0"}},
                                       {{"range", "2 1"}},
                                       {{"range", "1 1"}}})
    EXPECT_EQ(MjcfFailureOf([&] { Attributes(wrong).IsLimited("limited", "range", true); }).code,
              FailureCode::kMjcfRange);
}

TEST(MjcfAttributes, AnElementsValuesComeOverThoseOfItsClass) {
  AttributeValues values = {{"mass", "1"}, {"size", "1 2 3"}, {"quat", "1 0 0 0"}, {"rgba", "1 1 1 1"}};
  MergeMjcfValues(values, {{"mass", "2"}, {"size", "9"}, {"rgba", "0 0"}});
  EXPECT_EQ(Attributes(values).Number("mass", 0.0), 2.0);
  EXPECT_EQ(Attributes(values).Three("size", Vector3::Zero()), Vector3(9, 2, 3)) << "numbers left out stay";
  EXPECT_EQ(values["rgba"], "0 0") << "not so for other attributes";
  EXPECT_TRUE(values.contains("quat"));
  MergeMjcfValues(values, {{"euler", "0 0 90"}});
  EXPECT_FALSE(values.contains("quat")) << "one orientation replaces another";
  EXPECT_EQ(values["euler"], "0 0 90");
  const AttributeValues before = values;
  MergeMjcfValues(values, {});
  EXPECT_EQ(values, before);
}

}  // namespace
}  // namespace gaitwright
