// SPDX-License-Identifier: BSD-3-Clause
#include "tests/architecture/function_sizes.h"

#include <gtest/gtest.h>

#include "tests/architecture/rules_table.h"

namespace gaitwright::architecture {
namespace {

constexpr const char* kSource = R"(namespace a {
/// A word.
template <class T>
T First(const std::map<std::string, int>& of, T t = {1, 2},
        int more = 0) {
  for (int i = 0; i < 3; ++i) {
    Call(i, [&](int a, int b, int c) {
      return a;
    });
  }
  return t;
}

struct Thing {
  explicit Thing(int n)
      : n_(n) {
    Fill();
  }
  int operator()(int a, int b) const {
    return a + b;
  }
  int One() const { return 1; }
};

void Second() {
  const auto add = [](int a) {
    return a;
  };
}

void Declared(int a, int b, int c);
}  // namespace a
)";

TEST(FunctionSizes, HaveTheNameLinesAndParametersOfEachFunction) {
  const std::vector<FunctionSize> functions = FunctionsOf(kSource);
  ASSERT_EQ(functions.size(), 4U);
  EXPECT_EQ(functions[0].name, "First");
  EXPECT_EQ(functions[0].line, 4);
  EXPECT_EQ(functions[0].lines, 9);
  EXPECT_EQ(functions[0].parameters, 3);
  EXPECT_EQ(functions[1].name, "Thing");
  EXPECT_EQ(functions[1].parameters, 1);
  EXPECT_EQ(functions[2].name, "operator");
  EXPECT_EQ(functions[2].parameters, 2);
  EXPECT_EQ(functions[2].lines, 3);
  EXPECT_EQ(functions[3].name, "Second");
  EXPECT_EQ(functions[3].parameters, 0);
}

std::string FunctionOfLines(const std::string& signature, int lines) {
  std::string text = signature + " {\n";
  for (int i = 0; i < lines - 2; ++i) text += "  Call();\n";
  return text + "}\n";
}

TEST(FunctionSizes, LongFunctionsAndManyParametersAreBreaches) {
  EXPECT_TRUE(FunctionBreaches("planning/a.cc", FunctionOfLines("void Short()", kLongestFunction)).empty());
  EXPECT_EQ(FunctionBreaches("planning/a.cc", FunctionOfLines("void Long()", kLongestFunction + 1)).size(), 1U);
  EXPECT_TRUE(FunctionBreaches("planning/a.cc", FunctionOfLines("OptionFields A::Fields()", 200)).empty());
  EXPECT_TRUE(FunctionBreaches("planning/a.cc", FunctionOfLines("void Six(A a, B b, C c, D d, E e, F f)", 5)).empty());
  EXPECT_EQ(
      FunctionBreaches("planning/a.cc", FunctionOfLines("void Seven(A a, B b, C c, D d, E e, F f, G g)", 5)).size(),
      1U);
}

}  // namespace
}  // namespace gaitwright::architecture
