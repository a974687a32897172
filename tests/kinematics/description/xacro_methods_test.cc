// SPDX-License-Identifier: BSD-3-Clause
// Known answers are those of Python 3.11.
#include <limits>
#include <tuple>

#include "tests/kinematics/description/xacro_values.h"

namespace gaitwright {
namespace {

void ExpectPart(const std::string& message, const std::string& part) {
  EXPECT_NE(message.find(part), std::string::npos) << "'" << message << "' should say '" << part << "'";
}

std::string ReprOfMethod(const XacroValue& object, const std::string& name,
                         const std::vector<XacroValue>& arguments = {}) {
  XacroBudget budget;
  return ReprOf(CallXacroMethod(object, name, arguments, budget));
}

FailureCode CodeOfMethod(const XacroValue& object, const std::string& name,
                         const std::vector<XacroValue>& arguments = {}) {
  return ProblemOf([&] { ReprOfMethod(object, name, arguments); }).code;
}

TEST(XacroTextMethods, ChangeTheCaseOfAsciiLetters) {
  const XacroValue text = TextValue("fRONT left2x_y");
  EXPECT_EQ(ReprOfMethod(text, "lower"), "'front left2x_y'");
  EXPECT_EQ(ReprOfMethod(text, "upper"), "'FRONT LEFT2X_Y'");
  EXPECT_EQ(ReprOfMethod(text, "capitalize"), "'Front left2x_y'");
  EXPECT_EQ(ReprOfMethod(text, "title"), "'Front Left2X_Y'");
  EXPECT_EQ(ReprOfMethod(TextValue("1a"), "capitalize"), "'1a'");
  EXPECT_EQ(ReprOfMethod(TextValue("\xC3\xA4"), "upper"), "'\xC3\xA4'");
}

TEST(XacroTextMethods, StripTakesASetOfCharactersFromTheEnds) {
  EXPECT_EQ(ReprOfMethod(TextValue(" \ta b\n"), "strip"), "'a b'");
  EXPECT_EQ(ReprOfMethod(TextValue("xyaxy"), "strip", {TextValue("yx")}), "'a'");
  EXPECT_EQ(ReprOfMethod(TextValue("xyaxy"), "lstrip", {TextValue("yx")}), "'axy'");
  EXPECT_EQ(ReprOfMethod(TextValue("xyaxy"), "rstrip", {TextValue("yx")}), "'xya'");
  for (const char* method : {"strip", "lstrip", "rstrip"}) {
    EXPECT_EQ(ReprOfMethod(TextValue("   "), method), "''") << method;
    EXPECT_EQ(ReprOfMethod(TextValue(""), method), "''") << method;
  }
}

TEST(XacroTextMethods, SplitAndJoinUndoEachOther) {
  for (const char* text : {"a_b_c", "_a__b_", "", "_", "abc"}) {
    XacroBudget budget;
    const XacroValue parts = CallXacroMethod(TextValue(text), "split", {TextValue("_")}, budget);
    EXPECT_EQ(ReprOfMethod(TextValue("_"), "join", {parts}), ReprOf(TextValue(text)));
  }
  EXPECT_EQ(ReprOfMethod(TextValue("_a__b"), "split", {TextValue("_")}), "['', 'a', '', 'b']");
  EXPECT_EQ(ReprOfMethod(TextValue("  0 1\t2\n"), "split"), "['0', '1', '2']");
  EXPECT_EQ(ReprOfMethod(TextValue(" "), "split"), "[]");
  EXPECT_EQ(ReprOfMethod(TextValue(""), "split", {TextValue(",")}), "['']");
  EXPECT_EQ(ReprOfMethod(TextValue("-"), "join", {TextValue("abc")}), "'a-b-c'");
}

TEST(XacroTextMethods, SplitAndReplaceEndAfterTheNumberThatIsGiven) {
  const XacroValue name = TextValue("front_left_hip_joint");
  EXPECT_EQ(ReprOfMethod(name, "split", {TextValue("_"), WholeValue(1)}), "['front', 'left_hip_joint']");
  EXPECT_EQ(ReprOfMethod(name, "split", {TextValue("_"), WholeValue(0)}), "['front_left_hip_joint']");
  EXPECT_EQ(ReprOfMethod(name, "split", {TextValue("_"), WholeValue(-1)}), "['front', 'left', 'hip', 'joint']");
  EXPECT_EQ(ReprOfMethod(name, "replace", {TextValue("_"), TextValue("/"), WholeValue(2)}), "'front/left/hip_joint'");
  EXPECT_EQ(ReprOfMethod(name, "replace", {TextValue("_"), TextValue(""), WholeValue(0)}), ReprOf(name));
  EXPECT_EQ(CodeOfMethod(name, "split", {TextValue("_"), TextValue("1")}), FailureCode::kXacroType);
}

TEST(XacroTextMethods, ReplaceDoesNotReadWhatItWrote) {
  EXPECT_EQ(ReprOfMethod(TextValue("aaa"), "replace", {TextValue("aa"), TextValue("a")}), "'aa'");
  EXPECT_EQ(ReprOfMethod(TextValue("aba"), "replace", {TextValue("a"), TextValue("aa")}), "'aabaa'");
  EXPECT_EQ(ReprOfMethod(TextValue("abc"), "replace", {TextValue("x"), TextValue("y")}), "'abc'");
}

TEST(XacroTextMethods, FindAndCountGoFromTheLeft) {
  EXPECT_EQ(ReprOfMethod(TextValue("left_left"), "find", {TextValue("ft")}), "2");
  EXPECT_EQ(ReprOfMethod(TextValue("left"), "find", {TextValue("right")}), "-1");
  EXPECT_EQ(ReprOfMethod(TextValue("left"), "find", {TextValue("")}), "0");
  EXPECT_EQ(ReprOfMethod(TextValue("aaaa"), "count", {TextValue("aa")}), "2");
  EXPECT_EQ(ReprOfMethod(TextValue("abc"), "count", {TextValue("")}), "4");
  EXPECT_EQ(ReprOfMethod(TextValue("left"), "startswith", {TextValue("")}), "True");
  EXPECT_EQ(ReprOfMethod(TextValue("left"), "endswith", {TextValue("eft")}), "True");
  EXPECT_EQ(ReprOfMethod(TextValue("left"), "endswith", {TextValue("aleft")}), "False");
  EXPECT_EQ(ReprOfMethod(TextValue("012"), "isdigit"), "True");
  EXPECT_EQ(ReprOfMethod(TextValue(""), "isdigit"), "False");
  EXPECT_EQ(ReprOfMethod(TextValue("-1"), "isdigit"), "False");
}

TEST(XacroTextMethods, RefuseArgumentsThatTheyDoNotTake) {
  const XacroValue text = TextValue("a");
  const std::vector<std::pair<std::string, std::vector<XacroValue>>> rows = {
      {"split", {TextValue("")}},
      {"split", {WholeValue(1)}},
      {"join", {}},
      {"join", {ListValue({WholeValue(1)})}},
      {"replace", {TextValue("a")}},
      {"replace", {TextValue(""), TextValue("b")}},
      {"find", {}},
      {"upper", {text}},
      {"isdigit", {text}},
      {"startswith", {text, WholeValue(1)}},
      {"find", {text, WholeValue(1)}},
      {"strip", {text, text}},
      {"split", {text, WholeValue(1), WholeValue(1)}}};
  for (const auto& [name, arguments] : rows)
    EXPECT_EQ(CodeOfMethod(text, name, arguments), FailureCode::kXacroType) << name << " of " << arguments.size();
}

TEST(XacroTextMethods, FormatFillsFieldsByPlaceAndByName) {
  const auto filled = [](const std::string& format, const XacroArguments& arguments) {
    XacroBudget budget;
    return ReprOf(FormatXacroText(format, arguments, budget));
  };
  const std::vector<XacroValue> two = {TextValue("left"), WholeValue(2)};
  EXPECT_EQ(filled("{}_{}", {two, {}}), "'left_2'");
  EXPECT_EQ(filled("{1}{0}{1}", {two, {}}), "'2left2'");
  EXPECT_EQ(filled("{}_{side}", {two, {{"side", TextValue("r")}}}), "'left_r'");
  EXPECT_EQ(filled("{{{}}}", {two, {}}), "'{left}'");
  EXPECT_EQ(filled("none", {two, {}}), "'none'");
  EXPECT_EQ(ReprOfMethod(TextValue("{}"), "format", {RealValue(1.0)}), "'1.0'");
}

TEST(XacroTextMethods, FormatPrintsNumbersAsPythonDoes) {
  const auto filled = [](const std::string& format, const XacroValue& value) {
    return ReprOfMethod(TextValue(format), "format", {value});
  };
  EXPECT_EQ(filled("{:.3f}|", RealValue(0.12349)), "'0.123|'");
  EXPECT_EQ(filled("{:03d}", WholeValue(7)), "'007'");
  EXPECT_EQ(filled("{:+05.1f}", RealValue(-1.25)), "'-01.2'");
  EXPECT_EQ(filled("{:+d}", WholeValue(3)), "'+3'");
  EXPECT_EQ(filled("{: g}", RealValue(0.5)), "' 0.5'");
  EXPECT_EQ(filled("{:.2e}", WholeValue(1234)), "'1.23e+03'");
  EXPECT_EQ(filled("{:x}{{", WholeValue(255)), "'ff{'");
  EXPECT_EQ(filled("{:X}", WholeValue(-255)), "'-FF'");
  EXPECT_EQ(filled("{:*^7}", RealValue(0.5)), "'**0.5**'");
  EXPECT_EQ(filled("{:5}", WholeValue(42)), "'   42'");
  EXPECT_EQ(filled("{:5}|", TextValue("ab")), "'ab   |'");
  EXPECT_EQ(filled("{:>5s}", TextValue("ab")), "'   ab'");
  EXPECT_EQ(filled("{:.1}", TextValue("ab")), "'a'");
  EXPECT_EQ(filled("{}", {}), "'None'");
  EXPECT_EQ(filled("{:f}", {true}), "'1.000000'");
  EXPECT_EQ(filled("{:d}", WholeValue(std::numeric_limits<std::int64_t>::min())), "'-9223372036854775808'");
}

TEST(XacroTextMethods, FormatRefusesWhatItDoesNotKnow) {
  const auto message = [](const std::string& format, const std::vector<XacroValue>& arguments) {
    return ProblemOf([&] { ReprOfMethod(TextValue(format), "format", arguments); }).message;
  };
  const std::vector<std::tuple<std::string, XacroValue, std::string>> rows = {
      {"{}{}", WholeValue(1), "argument 1"},
      {"{3}", WholeValue(1), "argument 3"},
      {"{}{0}", WholeValue(1), "mixed"},
      {"{a}", WholeValue(1), "field 'a'"},
      {"{", WholeValue(1), "single"},
      {"}", WholeValue(1), "single"},
      {"{:{}}", WholeValue(1), "nested"},
      {"{0.x}", WholeValue(1), "'{0.x}'"},
      {"{!r}", WholeValue(1), "'{!r}'"},
      {"{:,}", WholeValue(1), "':,'"},
      {"{:.f}", WholeValue(1), "':.f'"},
      {"{:123d}", WholeValue(1), "two digits"},
      {"{:d}", RealValue(1.5), "not 1.5"},
      {"{:.2d}", WholeValue(1), "no precision"},
      {"{:.2}", RealValue(1.5), "needs a type"},
      {"{:d}", TextValue("a"), "the text 'a'"},
      {"{:s}", WholeValue(1), "does not fit"},
      {"{:5}", ListValue({}), "does not fit"},
      {"{99999999999999999999}", WholeValue(1), "99999999999999999999"}};
  for (const auto& [format, value, part] : rows) ExpectPart(message(format, {value}), part);
}

TEST(XacroDictMethods, GiveKeysValuesAndPairsInTheirOrder) {
  const XacroValue dict = DictValue({{TextValue("b"), WholeValue(2)}, {TextValue("a"), ListValue({})}});
  EXPECT_EQ(ReprOfMethod(dict, "keys"), "['b', 'a']");
  EXPECT_EQ(ReprOfMethod(dict, "values"), "[2, []]");
  EXPECT_EQ(ReprOfMethod(dict, "items"), "[['b', 2], ['a', []]]");
  EXPECT_EQ(ReprOfMethod(dict, "get", {TextValue("b")}), "2");
  EXPECT_EQ(ReprOfMethod(dict, "get", {TextValue("c")}), "None");
  EXPECT_EQ(ReprOfMethod(dict, "get", {TextValue("c"), RealValue(0.5)}), "0.5");
  EXPECT_EQ(CodeOfMethod(dict, "get"), FailureCode::kXacroType);
  EXPECT_EQ(CodeOfMethod(dict, "keys", {TextValue("b")}), FailureCode::kXacroType);
}

TEST(XacroListMethods, PopTakesTheItemFromAllCopies) {
  const std::vector<XacroValue> copies(2, ListValue({WholeValue(1), WholeValue(2), WholeValue(3), WholeValue(4)}));
  const XacroValue &list = copies[0], &copy = copies[1];
  EXPECT_EQ(ReprOfMethod(list, "pop"), "4");
  EXPECT_EQ(ReprOfMethod(copy, "pop", {WholeValue(0)}), "1");
  EXPECT_EQ(ReprOfMethod(list, "pop", {WholeValue(-2)}), "2");
  EXPECT_EQ(ReprOf(list), "[3]");
  EXPECT_EQ(ReprOf(copy), "[3]");
  EXPECT_EQ(CodeOfMethod(list, "pop", {WholeValue(1)}), FailureCode::kXacroIndex);
  EXPECT_EQ(CodeOfMethod(list, "pop", {WholeValue(-2)}), FailureCode::kXacroIndex);
  EXPECT_EQ(CodeOfMethod(list, "pop", {TextValue("0")}), FailureCode::kXacroType);
  EXPECT_EQ(ReprOfMethod(list, "pop"), "3");
  EXPECT_EQ(CodeOfMethod(list, "pop"), FailureCode::kXacroIndex);
}

TEST(XacroListMethods, IndexAndCountCompareByValue) {
  const XacroValue list = ListValue({TextValue("1"), RealValue(1.0), {true}, WholeValue(2)});
  EXPECT_EQ(ReprOfMethod(list, "index", {WholeValue(1)}), "1");
  EXPECT_EQ(ReprOfMethod(list, "count", {WholeValue(1)}), "2");
  EXPECT_EQ(ReprOfMethod(list, "count", {{}}), "0");
  EXPECT_EQ(CodeOfMethod(list, "index", {WholeValue(3)}), FailureCode::kXacroType);
  EXPECT_EQ(CodeOfMethod(list, "count"), FailureCode::kXacroType);
}

TEST(XacroMethods, UnknownOnesAreRefusedWithTheNearest) {
  const XacroProblem text = ProblemOf([] { ReprOfMethod(TextValue("a"), "upr"); });
  EXPECT_EQ(text.code, FailureCode::kUnknownFunction);
  EXPECT_NE(text.message.find("'upper'"), std::string::npos) << text.message;
  EXPECT_EQ(CodeOfMethod(ListValue({}), "append"), FailureCode::kUnknownFunction);
  EXPECT_EQ(CodeOfMethod(DictValue({}), "pop"), FailureCode::kUnknownFunction);
  EXPECT_EQ(CodeOfMethod(WholeValue(1), "upper"), FailureCode::kXacroType);
  EXPECT_EQ(CodeOfMethod({}, "get"), FailureCode::kXacroType);
}

}  // namespace
}  // namespace gaitwright
