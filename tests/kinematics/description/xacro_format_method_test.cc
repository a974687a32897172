// SPDX-License-Identifier: BSD-3-Clause
// The expected values are those of Python 3.11.
#include <gtest/gtest.h>

#include "tests/kinematics/description/xacro_files.h"

namespace gaitwright {
namespace {

TEST(XacroFormatMethod, FieldsTakeArgumentsByOrderPlaceAndName) {
  EXPECT_EQ(ValueOfXacro("'{}_{}'.format('left', 'hip')"), "left_hip");
  EXPECT_EQ(ValueOfXacro("'{1}{0}{1}'.format('a', 'b')"), "bab");
  EXPECT_EQ(ValueOfXacro("'{side}_{0}_{n:02d}'.format('leg', side='l', n=3)"), "l_leg_03");
  EXPECT_EQ(ValueOfXacro("'{{{}}}'.format(1)"), "{1}");
  EXPECT_EQ(ValueOfXacro("'{}'.format(-0.0)"), "-0.0");
}

TEST(XacroFormatMethod, NumbersArePrintedAsTheirTypesSay) {
  for (const auto& [expression, printed] :
       {std::pair("'{:.2f}'.format(1.125)", "1.12"), std::pair("'{:+.3f}'.format(2.5)", "+2.500"),
        std::pair("'[{: d}]'.format(7)", "[ 7]"), std::pair("'{:05d}'.format(-42)", "-0042"),
        std::pair("'{:x}{:X}'.format(255, 255)", "ffFF"), std::pair("'{:x}'.format(-255)", "-ff"),
        std::pair("'{:.3g}'.format(0.00012345)", "0.000123"), std::pair("'{:10.3e}'.format(-1234.5)", "-1.234e+03"),
        std::pair("'{:d}'.format(9223372036854775807)", "9223372036854775807")})
    EXPECT_EQ(ValueOfXacro(expression), printed) << expression;
}

TEST(XacroFormatMethod, FieldsAreFilledToTheirWidth) {
  for (const auto& [expression, printed] :
       {std::pair("'[{:>4}|{:<4}|{:^4}]'.format('ab', 'cd', 'ef')", "[  ab|cd  | ef ]"),
        std::pair("'{:*^7}'.format('ab')", "**ab***"), std::pair("'{:.2}'.format('abcdef')", "ab"),
        std::pair("'{:=+6d}'.format(12)", "+   12"), std::pair("'[{:6}]'.format(1.5)", "[   1.5]")})
    EXPECT_EQ(ValueOfXacro(expression), printed) << expression;
}

TEST(XacroFormatMethod, WhatIsNotSupportedIsRefusedWithTheForms) {
  for (const auto& [expression, code, part] : {std::tuple("'{a}'.format(b=1)", "xacro_type", "a=VALUE"),
                                               std::tuple("'{}'.format()", "xacro_type", "argument 0"),
                                               std::tuple("'{} {0}'.format(1)", "xacro_type", "mixed"),
                                               std::tuple("'{0.x}'.format(1)", "xacro_type", "{name}"),
                                               std::tuple("'{'.format(1)", "xacro_type", "written twice"),
                                               std::tuple("'{:,}'.format(1)", "xacro_type", "':,'"),
                                               std::tuple("'{:d}'.format(1.5)", "xacro_type", "whole number"),
                                               std::tuple("'{:.2d}'.format(1)", "xacro_type", "no precision"),
                                               std::tuple("'{:f}'.format('a')", "xacro_type", "the text 'a'"),
                                               std::tuple("'{:100d}'.format(1)", "xacro_limit", "two digits")}) {
    const std::string message = ValueOfXacro(expression);
    EXPECT_TRUE(message.starts_with(code)) << expression << ": " << message;
    EXPECT_NE(message.find(part), std::string::npos) << expression << ": " << message;
  }
}

}  // namespace
}  // namespace gaitwright
