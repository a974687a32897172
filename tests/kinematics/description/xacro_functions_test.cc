// SPDX-License-Identifier: BSD-3-Clause
// The expected values are those of Python 3.11.
#include <cmath>
#include <limits>

#include "tests/kinematics/description/xacro_values.h"

namespace gaitwright {
namespace {

XacroValue ResultOf(const std::string& name, const std::vector<XacroValue>& arguments) {
  XacroBudget budget;
  std::optional<XacroValue> value = CallXacroFunction(name, arguments, budget);
  EXPECT_TRUE(value.has_value()) << name;
  return value.value_or(XacroValue{});
}

std::string ReprOfCall(const std::string& name, const std::vector<XacroValue>& arguments) {
  return ReprOf(ResultOf(name, arguments));
}

double NumberOfCall(const std::string& name, double x) { return XacroNumber(ResultOf(name, {RealValue(x)})).value(); }

FailureCode CodeOfCall(const std::string& name, const std::vector<XacroValue>& arguments) {
  return ProblemOf([&] { ResultOf(name, arguments); }).code;
}

TEST(XacroFunctions, InversesUndoTheirFunctions) {
  const std::vector<std::pair<std::string, std::string>> pairs = {{"sin", "asin"},        {"cos", "acos"},
                                                                  {"tan", "atan"},        {"exp", "log"},
                                                                  {"radians", "degrees"}, {"degrees", "radians"}};
  for (const auto& [function, inverse] : pairs) {
    for (const double x : {0.1, 0.7, 1.3})
      EXPECT_NEAR(NumberOfCall(inverse, NumberOfCall(function, x)), x, 1e-14) << function;
  }
  for (const double x : {-1.2, 0.4, 2.0}) {
    const double s = NumberOfCall("sinh", x), c = NumberOfCall("cosh", x);
    EXPECT_NEAR(c * c - s * s, 1.0, 1e-12);
    EXPECT_NEAR(NumberOfCall("tanh", x), s / c, 1e-15);
  }
  EXPECT_EQ(ReprOfCall("log2", {WholeValue(8)}), "3.0");
  EXPECT_EQ(ReprOfCall("log10", {RealValue(0.001)}), "-3.0");
  EXPECT_EQ(ReprOfCall("hypot", {WholeValue(3), WholeValue(-4)}), "5.0");
  EXPECT_EQ(ReprOfCall("copysign", {WholeValue(3), RealValue(-0.0)}), "-3.0");
  EXPECT_EQ(ReprOfCall("fmod", {WholeValue(-7), WholeValue(3)}), "-1.0");
  EXPECT_EQ(ReprOfCall("atan2", {RealValue(-0.0), WholeValue(-1)}), "-3.141592653589793");
}

TEST(XacroFunctions, RefusesNumbersWithoutAValueButLetsInfinityThrough) {
  const std::vector<std::pair<std::string, double>> rows = {{"sqrt", -1.0}, {"asin", 1.5},   {"acos", -2.0},
                                                            {"log", 0.0},   {"log10", -1.0}, {"log2", 0.0},
                                                            {"exp", 1e4},   {"cosh", 1e4}};
  for (const auto& [name, x] : rows) {
    const XacroProblem problem = ProblemOf([&, &function = name, y = x] { ResultOf(function, {RealValue(y)}); });
    EXPECT_EQ(problem.code, FailureCode::kXacroNumber) << name;
    EXPECT_TRUE(problem.message.starts_with(name + "(): ")) << problem.message;
  }
  EXPECT_EQ(CodeOfCall("pow", {WholeValue(0), WholeValue(-1)}), FailureCode::kXacroNumber);
  EXPECT_EQ(CodeOfCall("fmod", {WholeValue(1), WholeValue(0)}), FailureCode::kXacroNumber);
  EXPECT_EQ(CodeOfCall("log", {WholeValue(8), WholeValue(1)}), FailureCode::kXacroNumber);
  EXPECT_EQ(ReprOfCall("exp", {RealValue(std::numeric_limits<double>::infinity())}), "inf");
}

TEST(XacroFunctions, RoundingMakesWholeNumbers) {
  const std::vector<std::pair<double, std::vector<std::string>>> rows = {// floor, ceil, trunc, int, round
                                                                         {2.5, {"2", "3", "2", "2", "2"}},
                                                                         {-2.5, {"-3", "-2", "-2", "-2", "-2"}},
                                                                         {-0.4, {"-1", "0", "0", "0", "0"}},
                                                                         {3.5, {"3", "4", "3", "3", "4"}}};
  for (const auto& [x, expected] : rows) {
    const char* const names[] = {"floor", "ceil", "trunc", "int", "round"};
    for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(ReprOfCall(names[i], {RealValue(x)}), expected[i]) << names[i] << x;
  }
  for (const char* name : {"floor", "int", "round"})
    EXPECT_EQ(CodeOfCall(name, {RealValue(1e19)}), FailureCode::kXacroNumber) << name;
  EXPECT_EQ(CodeOfCall("ceil", {RealValue(std::nan(""))}), FailureCode::kXacroNumber);
}

TEST(XacroFunctions, RoundingKeepsWholeNumbersExactly) {
  for (const std::int64_t number : {std::int64_t{9007199254740993}, std::numeric_limits<std::int64_t>::max()}) {
    for (const char* name : {"floor", "ceil", "trunc", "int", "abs", "round"})
      EXPECT_EQ(ReprOfCall(name, {WholeValue(number)}), std::to_string(number)) << name;
    EXPECT_EQ(ReprOfCall("round", {WholeValue(number), WholeValue(2)}), std::to_string(number));
  }
}

TEST(XacroFunctions, RoundToDigitsIsExactAndKeepsTheKind) {
  EXPECT_EQ(ReprOfCall("round", {RealValue(2.675), WholeValue(2)}), "2.67");
  EXPECT_EQ(ReprOfCall("round", {RealValue(0.5), WholeValue(0)}), "0.0");
  EXPECT_EQ(ReprOfCall("round", {RealValue(1234.5), WholeValue(-2)}), "1200.0");
  EXPECT_EQ(ReprOfCall("round", {WholeValue(25), WholeValue(-1)}), "20");
  EXPECT_EQ(ReprOfCall("round", {WholeValue(35), WholeValue(-1)}), "40");
  EXPECT_EQ(ReprOfCall("round", {RealValue(1.5), {}}), "2");
  EXPECT_EQ(CodeOfCall("round", {RealValue(1.5), RealValue(1.0)}), FailureCode::kXacroType);
}

TEST(XacroFunctions, ConversionsReadTextsAndRefuseOthers) {
  EXPECT_EQ(ReprOfCall("int", {TextValue(" -7 ")}), "-7");
  EXPECT_EQ(ReprOfCall("float", {TextValue("7")}), "7.0");
  EXPECT_EQ(ReprOfCall("str", {ListValue({TextValue("a")})}), "\"['a']\"");
  EXPECT_EQ(ReprOfCall("bool", {TextValue("False")}), "True");
  const std::vector<std::pair<std::string, std::string>> empty = {
      {"int", "0"}, {"float", "0.0"}, {"str", "''"}, {"bool", "False"}, {"list", "[]"}};
  for (const auto& [name, repr] : empty) EXPECT_EQ(ReprOfCall(name, {}), repr) << name;
  EXPECT_EQ(CodeOfCall("int", {TextValue("7.0")}), FailureCode::kXacroType);
  EXPECT_EQ(CodeOfCall("float", {TextValue("7m")}), FailureCode::kXacroType);
  EXPECT_EQ(CodeOfCall("int", {ListValue({})}), FailureCode::kXacroType);
}

TEST(XacroFunctions, ExtremesAreTheFirstOfEquals) {
  EXPECT_EQ(ReprOfCall("min", {RealValue(1.0), WholeValue(1), WholeValue(2)}), "1.0");
  EXPECT_EQ(ReprOfCall("max", {WholeValue(1), {true}}), "1");
  EXPECT_EQ(ReprOfCall("max", {ListValue({TextValue("b"), TextValue("ab")})}), "'b'");
  EXPECT_EQ(ReprOfCall("min", {TextValue("cab")}), "'a'");
  EXPECT_EQ(CodeOfCall("min", {ListValue({})}), FailureCode::kXacroType);
  EXPECT_EQ(CodeOfCall("min", {WholeValue(1)}), FailureCode::kXacroType);
  EXPECT_EQ(CodeOfCall("max", {WholeValue(1), TextValue("a")}), FailureCode::kXacroType);
}

TEST(XacroFunctions, ListsAreMadeCountedAndSorted) {
  const XacroValue range = ResultOf("range", {WholeValue(5), WholeValue(-1), WholeValue(-2)});
  EXPECT_EQ(ReprOf(range), "[5, 3, 1]");
  EXPECT_EQ(ReprOfCall("range", {WholeValue(2), WholeValue(2)}), "[]");
  EXPECT_EQ(ReprOfCall("range", {WholeValue(std::numeric_limits<std::int64_t>::max() - 1),
                                 WholeValue(std::numeric_limits<std::int64_t>::max()), WholeValue(2)}),
            "[9223372036854775806]");
  EXPECT_EQ(ReprOfCall("sorted", {range}), "[1, 3, 5]");
  EXPECT_EQ(ReprOfCall("sum", {range}), "9");
  EXPECT_EQ(ReprOfCall("sum", {range, RealValue(0.5)}), "9.5");
  EXPECT_EQ(ReprOfCall("enumerate", {TextValue("ab")}), "[[0, 'a'], [1, 'b']]");
  EXPECT_EQ(ReprOfCall("tuple", {DictValue({{TextValue("k"), {}}})}), "['k']");
  EXPECT_EQ(ReprOfCall("len", {DictValue({{TextValue("k"), {}}})}), "1");
  EXPECT_EQ(ReprOfCall("any", {ListValue({})}), "False");
  EXPECT_EQ(ReprOfCall("all", {ListValue({})}), "True");
  // Equal items keep their order.
  EXPECT_EQ(ReprOfCall("sorted", {ListValue({WholeValue(2), RealValue(1.0), WholeValue(1), {true}})}),
            "[1.0, 1, True, 2]");
  EXPECT_EQ(CodeOfCall("sorted", {ListValue({WholeValue(1), TextValue("a")})}), FailureCode::kXacroType);
  EXPECT_EQ(CodeOfCall("range", {WholeValue(1), WholeValue(2), WholeValue(0)}), FailureCode::kXacroType);
  EXPECT_EQ(CodeOfCall("range", {RealValue(3.0)}), FailureCode::kXacroType);
  EXPECT_EQ(CodeOfCall("range", {WholeValue(1000000000)}), FailureCode::kXacroLimit);
  EXPECT_EQ(CodeOfCall("len", {WholeValue(3)}), FailureCode::kXacroType);
}

TEST(XacroFunctions, EachRefusesOtherNumbersOfArguments) {
  XacroBudget budget;
  EXPECT_FALSE(CallXacroFunction("sine", {}, budget).has_value());
  const std::vector<std::string> names = XacroFunctionNames();
  EXPECT_GE(names.size(), 40U);
  for (const std::string& name : names)
    EXPECT_EQ(CodeOfCall(name, std::vector<XacroValue>(101, WholeValue(1))), FailureCode::kXacroType) << name;
  EXPECT_EQ(CodeOfCall("atan2", {WholeValue(1)}), FailureCode::kXacroType);
  EXPECT_EQ(CodeOfCall("sin", {TextValue("0")}), FailureCode::kXacroType);
}

}  // namespace
}  // namespace gaitwright
