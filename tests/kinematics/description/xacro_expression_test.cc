// SPDX-License-Identifier: BSD-3-Clause
// The expected values are those of Python 3.11.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "tests/kinematics/description/xacro_files.h"

namespace gaitwright {
namespace {

struct KnownValue {
  const char *expression, *printed;
};

void ExpectValues(const std::vector<KnownValue>& rows) {
  for (const KnownValue& row : rows) EXPECT_EQ(ValueOfXacro(row.expression), row.printed) << row.expression;
}

TEST(XacroExpression, ComputesNumbersAsPythonDoes) {
  ExpectValues({{"1 + 2", "3"},
                {"1 + 2.0", "3.0"},
                {"0.1 + 0.2", "0.30000000000000004"},
                {"1/2", "0.5"},
                {"4/2", "2.0"},
                {"7 // 2", "3"},
                {"-7 // 2", "-4"},
                {"-7 % 3", "2"},
                {"7 % -3", "-2"},
                {"7.5 % 2", "1.5"},
                {"1.5 // 0.1", "14.0"},
                {"2 ** 10", "1024"},
                {"-2 ** 2", "-4"},
                {"2 ** -1", "0.5"},
                {"2 ** 3 ** 2", "512"},
                {"0.5 ** 2", "0.25"},
                {"- - 3", "3"},
                {"-(1 + 2) * 3", "-9"},
                {"2 - 3 - 4", "-5"},
                {"8 / 4 / 2", "1.0"},
                {"1e-5", "1e-05"},
                {"1e16", "1e+16"},
                {"123456789.125", "123456789.125"},
                {"0.0001", "0.0001"},
                {".5", "0.5"},
                {"2.", "2.0"},
                {"1_000", "1000"},
                {"0x1F", "31"},
                {"-0.0", "-0.0"},
                {"True + 1", "2"}});
}

TEST(XacroExpression, ComparesAndDecides) {
  ExpectValues({{"1 < 2", "True"},
                {"2 <= 1", "False"},
                {"1 < 2 < 3", "True"},
                {"1 < 3 < 2", "False"},
                {"1 == 1.0", "True"},
                {"'1' == 1", "False"},
                {"'a' != 'b'", "True"},
                {"'abc' < 'abd'", "True"},
                {"True and False", "False"},
                {"0 or 'left'", "left"},
                {"'' or 5", "5"},
                {"not 0", "True"},
                {"not 1 == 2", "True"},
                {"1 if 2 > 1 else 3", "1"},
                {"'a' if False else 'b' if False else 'c'", "c"},
                {"undefined if False else 2", "2"},
                {"False and undefined", "False"},
                {"'ro' in 'front'", "True"},
                {"2 not in [1, 2]", "False"},
                {"'k' in {'k': 1}", "True"},
                {"None is None", "True"},
                {"[1, 2] == [1, 2.0]", "True"},
                {"true", "True"}});
}

TEST(XacroExpression, CallsFunctions) {
  ExpectValues({{"sin(pi/2)", "1.0"},
                {"cos(0)", "1.0"},
                {"atan2(1, 1) * 4 == pi", "True"},
                {"sqrt(2)", "1.4142135623730951"},
                {"math.sqrt(16)", "4.0"},
                {"math.pi", "3.141592653589793"},
                {"radians(180)", "3.141592653589793"},
                {"degrees(pi)", "180.0"},
                {"e", "2.718281828459045"},
                {"exp(0)", "1.0"},
                {"log(8, 2)", "3.0"},
                {"abs(-3)", "3"},
                {"abs(-3.5)", "3.5"},
                {"fabs(-3)", "3.0"},
                {"pow(2, 3)", "8.0"},
                {"min(3, 1, 2)", "1"},
                {"max([1, 5, 2])", "5"},
                {"floor(2.7)", "2"},
                {"ceil(2.1)", "3"},
                {"round(2.5)", "2"},
                {"round(3.5)", "4"},
                {"round(2.675, 2)", "2.67"},
                {"int('12')", "12"},
                {"int(-2.7)", "-2"},
                {"float('1e3')", "1000.0"},
                {"str(1.5) + 'm'", "1.5m"},
                {"bool('')", "False"},
                {"len('abcd')", "4"},
                {"sum([1, 2, 3])", "6"},
                {"sorted([3, 1, 2])", "[1, 2, 3]"},
                {"list(range(1, 6, 2))", "[1, 3, 5]"},
                {"any([0, 1])", "True"},
                {"all([0, 1])", "False"}});
}

TEST(XacroExpression, HasTextsListsAndDictionaries) {
  ExpectValues({{"'a' + \"b\"", "ab"},
                {"'ab' * 2", "abab"},
                {"'it\\'s'", "it's"},
                {"'a' 'b'", "ab"},
                {"'%s_%02d' % ('leg', 3)", "leg_03"},
                {"'%.3f' % pi", "3.142"},
                {"'front_left'.upper()", "FRONT_LEFT"},
                {"'front_left'.split('_')[1]", "left"},
                {"'-'.join(['a', 'b'])", "a-b"},
                {"'left'.startswith('le')", "True"},
                {"'a_b'.replace('_', ' ')", "a b"},
                {"'front'[0]", "f"},
                {"'front'[-1]", "t"},
                {"'front'[1:3]", "ro"},
                {"[1, 2.5, 'x', True, None]", "[1, 2.5, 'x', True, None]"},
                {"[[1, 2], [3, 4]][1][0]", "3"},
                {"[1, 2] + [3]", "[1, 2, 3]"},
                {"(1, 2)[1]", "2"},
                {"{'a': 1, 'b': [2]}", "{'a': 1, 'b': [2]}"},
                {"{'a': {'b': 7}}['a']['b']", "7"},
                {"{'a': {'b': 7}}.a.b", "7"},
                {"dict(a=1, b=2).b", "2"},
                {"dict(a=1).get('z', 5)", "5"},
                {"[k for k in {'x': 1, 'y': 2}]", "['x', 'y']"},
                {"[i * i for i in range(4) if i % 2]", "[1, 9]"},
                {"sum(x for x in [1, 2])", "3"},
                {"'}' + '{'", "}{"}});
}

TEST(XacroExpression, NumbersReadBackExactly) {
  for (const char* number : {"0.1", "1.0000000000000002", "2.2250738585072014e-308", "1.7976931348623157e308", "5e-324",
                             "123456.78901234567", "9007199254740993.0"}) {
    const std::string printed = ValueOfXacro(number);
    EXPECT_EQ(std::strtod(printed.c_str(), nullptr), std::strtod(number, nullptr)) << printed;
  }
}

TEST(XacroExpression, RefusesWhatHasNoValueByNameAndLine) {
  const std::vector<std::pair<std::string, std::vector<std::string>>> rows = {
      {"1 +", {"xacro_syntax", "robot.xacro:1", "'1 +'", "ends too early"}},
      {"1 2", {"xacro_syntax", "unexpected '2' at character 3"}},
      {"(1", {"xacro_syntax", "')' is needed"}},
      {"a && b", {"xacro_syntax", "write 'and'"}},
      {"!a", {"xacro_syntax", "write 'not'"}},
      {"'abc", {"xacro_syntax", "no closing '"}},
      {"1.2.3", {"xacro_syntax", "'1.2.3' at character 1 is not a number"}},
      {"lambda x: x", {"xacro_syntax", "'lambda'", "cannot be defined"}},
      {"1 / 0", {"xacro_number", "divides by zero"}},
      {"5 % 0", {"xacro_number", "divides by zero"}},
      {"sqrt(-1)", {"xacro_number", "sqrt()", "-1"}},
      {"log(0)", {"xacro_number", "log()"}},
      {"acos(2)", {"xacro_number", "acos()", "2"}},
      {"10 ** 30", {"xacro_number", "10 ** 30", "64 bits"}},
      {"9223372036854775807 + 1", {"xacro_number", "64 bits"}},
      {"'a' + 1", {"xacro_type", "'+'", "text", "number", "the text is 'a'"}},
      {"'a' < 1", {"xacro_type", "'<'", "float()"}},
      {"-'a'", {"xacro_type", "needs a number", "'a'"}},
      {"int('2.5')", {"xacro_type", "int('2.5')"}},
      {"[1, 2][2]", {"xacro_index", "index 2 is outside a list of size 2"}},
      {"{'mass': 1}['masse']", {"unknown_key", "'masse'", "'mass'"}},
      {"{'mass': 1}.mas", {"unknown_key", "'mas'", "'mass'"}},
      {"sine(1)", {"unknown_function", "'sine'", "'sin'"}},
      {"'a'.uper()", {"unknown_function", "'uper'", "'upper'"}},
      {"sin(1, 2)", {"xacro_type", "sin() takes 1 arguments, not 2"}},
      {"'{a}'.format(b=1)", {"xacro_type", "field 'a'", "'b'", "a=VALUE"}},
      {"'a'.upper(b=1)", {"xacro_syntax", "no argument with the name 'b'"}},
      {"sin(x=1)", {"xacro_syntax", "no argument with the name 'x'"}},
      {"leg", {"unknown_property", "'leg' is not defined"}},
      {"math.foo", {"unknown_property", "'math.foo'"}},
      {"'%d %d' % 1", {"xacro_type", "more conversions"}},
      {"'%q' % 1", {"xacro_type", "'%q'"}}};
  for (const auto& [expression, parts] : rows) {
    const std::string message = ValueOfXacro(expression);
    for (const std::string& part : parts)
      EXPECT_NE(message.find(part), std::string::npos) << expression << " gives '" << message << "', without " << part;
  }
}

TEST(XacroExpression, FormatsOfTextsMakeNames) {
  EXPECT_EQ(ValueOfXacro("'{}_{}'.format('left', 'hip')"), "left_hip");
  EXPECT_EQ(ValueOfXacro("'{side}_{0}_{n:02d}'.format('leg', side='l', n=3)"), "l_leg_03");
  EXPECT_EQ(ValueOfXacro("'%s_%d' % ('leg', 2)"), "leg_2");
  EXPECT_EQ(InnerXacro("<a b=\"x_${'{:.2f}'.format(0.125 + 1)}\"/>"), "<a b=\"x_1.12\"/>");
}

TEST(XacroExpression, TextsHoldSeveralExpressionsAndEscapes) {
  EXPECT_EQ(InnerXacro("<a b='${1}_${\"x\"} ${2.0}'/>"), "<a b=\"1_x 2.0\"/>");
  EXPECT_EQ(InnerXacro("<a b='$${x}'/>"), "<a b=\"${x}\"/>");
  EXPECT_EQ(InnerXacro("<a b='$$${x} $$(arg y)'/>"), "<a b=\"$${x} $(arg y)\"/>");
  EXPECT_EQ(InnerXacro("<a b='5$ and $x'/>"), "<a b=\"5$ and $x\"/>");
  EXPECT_EQ(InnerXacro("<a>${1 + 1} kg</a>"), "<a>2 kg</a>");
  EXPECT_EQ(InnerXacro("<a b=\"${{'k': 3}['k']}\"/>"), "<a b=\"3\"/>");
  EXPECT_NE(InnerXacro("<a b='${1'/>").find("'${1' has no closing '}'"), std::string::npos);
}

}  // namespace
}  // namespace gaitwright
