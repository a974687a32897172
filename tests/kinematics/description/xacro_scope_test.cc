// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/description/xacro_scope_internal.h"
#include "tests/kinematics/description/xacro_values.h"

namespace gaitwright {
namespace {

using ParameterKind = XacroParameter::Kind;

/// A global scope with a namespace 'arm', which contains a namespace 'hand', and the scope of a macro in it.
class XacroScopeTest : public testing::Test {
 protected:
  XacroScopeTest() {
    local_.parent = &globals_;
    globals_.properties["mass"] = {WholeValue(1)};
    globals_.properties["length"] = {WholeValue(2)};
    local_.properties["mass"] = {WholeValue(3)};
    auto arm = std::make_unique<XacroScope>(), hand = std::make_unique<XacroScope>();
    arm->parent = &globals_;
    hand->parent = arm.get();
    arm->properties["mass"] = {WholeValue(4)};
    hand->properties["mass"] = {WholeValue(5)};
    hand->macros["grip"] = std::make_shared<XacroMacro>();
    arm->namespaces["hand"] = std::move(hand);
    globals_.namespaces["arm"] = std::move(arm);
  }

  std::string Found(XacroScope& scope, const std::string& name) {
    const auto [property, owner] = scope.FindProperty(name, budget_);
    return property == nullptr ? "none" : ReprOf(property->value);
  }

  XacroBudget budget_;
  XacroScope globals_, local_;
};

TEST_F(XacroScopeTest, TheInnermostPropertyIsFound) {
  EXPECT_EQ(Found(local_, "mass"), "3");
  EXPECT_EQ(Found(globals_, "mass"), "1");
  EXPECT_EQ(Found(local_, "length"), "2");
  EXPECT_EQ(local_.FindProperty("length", budget_).second, &globals_);
  EXPECT_EQ(local_.FindProperty("mass", budget_).second, &local_);
  EXPECT_EQ(Found(local_, "width"), "none");
}

TEST_F(XacroScopeTest, ADottedNameLeadsThroughNamespacesFromAnyScopeBelow) {
  for (XacroScope* scope : {&globals_, &local_}) {
    EXPECT_EQ(Found(*scope, "arm.mass"), "4");
    EXPECT_EQ(Found(*scope, "arm.hand.mass"), "5");
    EXPECT_EQ(Found(*scope, "arm.leg.mass"), "none");
    EXPECT_EQ(Found(*scope, "leg.mass"), "none");
    EXPECT_EQ(Found(*scope, "arm.length"), "none") << "a namespace does not lend what is outside of it";
  }
}

TEST_F(XacroScopeTest, APropertyWhoseNameHasADotHidesTheNamespace) {
  globals_.properties["arm.mass"] = {WholeValue(9)};
  EXPECT_EQ(Found(local_, "arm.mass"), "9");
}

TEST_F(XacroScopeTest, AMacroIsExpandedWhereItIsCalledOrInItsNamespace) {
  globals_.macros["leg"] = std::make_shared<XacroMacro>(XacroMacro{"leg", {}, nullptr, false});
  const auto [leg, seen] = local_.FindMacro("leg", budget_);
  ASSERT_NE(leg, nullptr);
  EXPECT_EQ(seen, &local_);
  const auto [grip, inside] = local_.FindMacro("arm.hand.grip", budget_);
  ASSERT_NE(grip, nullptr);
  EXPECT_EQ(inside, globals_.namespaces["arm"]->namespaces["hand"].get());
  EXPECT_EQ(local_.FindMacro("grip", budget_).first, nullptr);
  EXPECT_EQ(local_.FindMacro("arm.grip", budget_).first, nullptr);
}

TEST_F(XacroScopeTest, BlocksAreLookedForUpward) {
  globals_.blocks["origin"] = {nullptr, true, false};
  local_.blocks["origin"] = {nullptr, false, true};
  globals_.blocks["axis"] = {};
  EXPECT_TRUE(local_.FindBlock("origin", budget_)->expanded);
  EXPECT_FALSE(globals_.FindBlock("origin", budget_)->expanded);
  EXPECT_NE(local_.FindBlock("axis", budget_), nullptr);
  EXPECT_EQ(local_.FindBlock("arm.axis", budget_), nullptr);
}

TEST_F(XacroScopeTest, NamesForMessagesHaveTheirNamespaceBeforeThem) {
  EXPECT_EQ(local_.PropertyNames(), (std::vector<std::string>{"mass", "length", "mass", "arm.mass"}));
  for (int i = 0; i < 2000; ++i) local_.blocks["b" + std::to_string(i)] = {};
  EXPECT_EQ(local_.BlockNames().size(), 1000U);
}

TEST(XacroParameters, KindsAndDefaultsAreRead) {
  const std::vector<XacroParameter> all = ParseXacroParameters("  a b:=1 c=2 *origin\n**content d:=^ e:=^|7 f:= g ");
  ASSERT_EQ(all.size(), 9U);
  const std::vector<std::string> names = {"a", "b", "c", "origin", "content", "d", "e", "f", "g"};
  for (std::size_t i = 0; i < all.size(); ++i) EXPECT_EQ(all[i].name, names[i]);
  EXPECT_EQ(all[0].default_text, std::nullopt);
  EXPECT_EQ(all[1].default_text, "1");
  EXPECT_EQ(all[2].default_text, "2");
  EXPECT_EQ(all[3].kind, ParameterKind::kBlock);
  EXPECT_EQ(all[4].kind, ParameterKind::kContent);
  EXPECT_TRUE(all[5].forwarded);
  EXPECT_EQ(all[5].default_text, std::nullopt);
  EXPECT_TRUE(all[6].forwarded);
  EXPECT_EQ(all[6].default_text, "7");
  EXPECT_EQ(all[7].default_text, "");
  EXPECT_EQ(all[8].default_text, std::nullopt);
  EXPECT_TRUE(ParseXacroParameters(" \n\t").empty());
}

TEST(XacroParameters, BlanksInQuotesAndExpressionsBelongToTheDefault) {
  const std::vector<XacroParameter> all =
      ParseXacroParameters("a:='0 0 1' b:=${1 + 2}x${ 'p q' } c:=$(arg n) d:=\"x y\"z");
  ASSERT_EQ(all.size(), 4U);
  EXPECT_EQ(all[0].default_text, "'0 0 1'");
  EXPECT_EQ(all[1].default_text, "${1 + 2}x${ 'p q' }");
  EXPECT_EQ(all[2].default_text, "$(arg n)");
  EXPECT_EQ(all[3].default_text, "\"x y\"z");
}

TEST(XacroParameters, RefusesListsThatAreNotUnderstood) {
  for (const char* text : {"a a", "a *a", "*", "**", ":=1", "a:1", "a:", "*b:=1", "a:='open", "a:=${1", "a:=$(arg x"}) {
    const XacroProblem problem = ProblemOf([&] { ParseXacroParameters(text); });
    EXPECT_EQ(problem.code, FailureCode::kXacroSyntax) << text;
    EXPECT_TRUE(problem.message.starts_with("params: ")) << problem.message;
  }
}

}  // namespace
}  // namespace gaitwright
