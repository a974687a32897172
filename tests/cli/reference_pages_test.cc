// SPDX-License-Identifier: BSD-3-Clause
// Pages of a made-up program's flags and options.
#include "cli/reference_pages.h"

#include <gtest/gtest.h>

#include "cli/command_line.h"
#include "cli/flags.h"
#include "cli/program.h"

namespace gaitwright::cli {
namespace {

/// Two verbs that share an option, and a sub-verb of the second one.
class ReferredProgram {
 public:
  ReferredProgram() {
    walk.SetGroup("Ground | more");
    AddText(walk, "--terrain", "NAME", text_, "Ground *of* the <walk>; default flat.");
    walk.SetGroup("Options");
    AddCommon(walk, common_, {"walk --terrain stairs"});
    AddOptionFlags(walk, fields_, common_.sets, common_.json);
    AddCommon(show, common_, {"robots show a1"});
    AddOptionFlags(show, fields_, common_.sets, common_.json);
  }

  CommandLine line{"a program", "its end"};
  Verb walk = line.program().AddVerb("walk", "Walks");
  Verb robots = line.program().AddVerb("robots", "Robots");
  Verb show = robots.AddVerb("show", "Shows one");

 private:
  std::string text_;
  double gain_ = 1.5;
  Common common_;
  OptionFields fields_ = {{"a.gain", &gain_, "N m", 0.0, 3.0, "How hard | it pulls.", {}}};
};

int CountIn(const std::string& text, const std::string& part) {
  int count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

TEST(ReferencePages, EveryVerbHasItsHeadingBeforeThoseBelowIt) {
  const ReferredProgram program;
  const std::string page = VerbsPage(program.line.program());
  const std::size_t walk = page.find("\n## walk\n"), robots = page.find("\n## robots\n"),
                    show = page.find("\n## robots show\n"), common = page.find("\n## Flags of every verb\n");
  ASSERT_NE(common, std::string::npos) << page;
  EXPECT_LT(walk, robots);
  EXPECT_LT(robots, show);
  EXPECT_LT(show, common);
  EXPECT_EQ(CountIn(page, "`--quiet`"), 1) << "the page lists the common flags once";
}

TEST(ReferencePages, CellsOfATableStayCells) {
  const ReferredProgram program;
  const std::string page = VerbsPage(program.line.program());
  EXPECT_NE(page.find("| `--terrain` | NAME | Ground \\*of\\* the \\<walk>; default flat. |\n"), std::string::npos)
      << page;
}

TEST(ReferencePages, ExamplesAreCommandsAsTheyAreTyped) {
  const ReferredProgram program;
  const std::string page = VerbsPage(program.line.program());
  EXPECT_NE(page.find("```text\ngaitwright walk --terrain stairs\n```"), std::string::npos) << page;
}

TEST(ReferencePages, AnOptionOfTwoVerbsIsOneLineThatNamesBoth) {
  const ReferredProgram program;
  const std::string page = OptionsPage(program.line.program());
  EXPECT_EQ(CountIn(page, "| `a.gain` |"), 1) << page;
  EXPECT_NE(page.find("\n## a\n"), std::string::npos);
  EXPECT_NE(page.find("| `a.gain` | `1.5` | N m | 0 to 3 | "), std::string::npos) << page;
  EXPECT_NE(page.find("How hard \\| it pulls. | walk, robots show |\n"), std::string::npos) << page;
}

}  // namespace
}  // namespace gaitwright::cli
