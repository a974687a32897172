// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/grade/mark_apart.h"

#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>

#include "tests/workflows/grade/made_class.h"

namespace gaitwright {
namespace {

RubricPart Part() {
  RubricPart part = PartOf("{name: p, kind: answers, file: f, points: 3, reference: dcm}\n");
  part.judge_s = 1.0;
  return part;
}

TEST(MarkApart, TheMarkIsTheSame) {
  const RubricPart part = Part();
  PartMark made = MarkOf(part, {1.0 / 3.0});
  made.pages = {{"a \"title\"", "<html>\n"}};
  const PartMark mark = MarkApart(part, [&] { return made; });
  EXPECT_EQ(mark.points, made.points);
  EXPECT_EQ(mark.checks[0].value, made.checks[0].value);
  EXPECT_EQ(mark.reasons, made.reasons);
  EXPECT_EQ(mark.pages[0].title, "a \"title\"");
  EXPECT_EQ(mark.pages[0].html, "<html>\n");
  const PartMark none = MarkApart(part, [&] { return MarkOf(part, {std::nullopt}); });
  EXPECT_FALSE(none.checks[0].value);
}

/// Numbers of the children of this process; those of other tests may be among them.
std::string Children() {
  const std::string self = std::to_string(getpid());
  std::ifstream list("/proc/self/task/" + self + "/children");
  return {std::istreambuf_iterator<char>(list), {}};
}

TEST(MarkApart, WhatEndsTheCopyCostsThePoints) {
  const std::string before = Children();
  ExpectNothing(MarkApart(Part(), []() -> PartMark { std::abort(); }),
                {"could not be marked: the marking process crashed"});
  ExpectNothing(MarkApart(Part(),
                          []() -> PartMark {
                            for (volatile bool on = true; on;) {
                            }
                            return {};
                          }),
                {"could not be marked: marking took more than 1 s"});
  ExpectNothing(MarkApart(Part(), []() -> PartMark { throw std::bad_alloc(); }), {"ran out of memory"});
  EXPECT_EQ(Children(), before) << "a copy was left behind";
}

}  // namespace
}  // namespace gaitwright
