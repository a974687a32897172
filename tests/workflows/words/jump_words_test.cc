// SPDX-License-Identifier: BSD-3-Clause
// Jumps and flips in words: their directions, turns, places and levels, and what must not be taken for one.
#include <gtest/gtest.h>

#include "planning/tasks/task_plan.h"
#include "tests/workflows/words/corpus.h"
#include "workflows/words/jump_words_internal.h"
#include "workflows/words/understand.h"

namespace gaitwright {
namespace {

/// The tasks of an instruction to A1 or NAO as texts, or the code of the refusal.
std::string JumpsIn(const std::string& text, const std::string& robot = "a1") {
  TaskScope scope = CorpusScope(robot);
  scope.places.push_back({"block", 0});
  const auto understood = words::Understand(text, scope);
  if (const auto* refusal = std::get_if<words::Refusal>(&understood))
    return "refused: " + FailureCodeName(refusal->code);
  std::string tasks;
  for (const Task& task : std::get<TaskPlan>(understood).tasks) tasks += (tasks.empty() ? "" : "; ") + TaskText(task);
  return tasks;
}

struct JumpCase {
  const char *text, *tasks;
};
void PrintTo(const JumpCase& jump, std::ostream* out) { *out << jump.text; }

class JumpsInWords : public testing::TestWithParam<JumpCase> {};

TEST_P(JumpsInWords, AreUnderstood) { EXPECT_EQ(JumpsIn(GetParam().text), GetParam().tasks) << GetParam().text; }

INSTANTIATE_TEST_SUITE_P(
    English, JumpsInWords,
    testing::ValuesIn(std::vector<JumpCase>{
        {"jump", "jump"},
        {"Please jump up and down.", "jump"},
        {"jump into the air", "jump"},
        {"jump three times", "jump, 3 times"},
        {"do three jumps", "jump, 3 times"},
        {"hop twice", "jump, 2 times"},
        {"jump forward", "jump forward"},
        {"jump backward 20 cm", "jump backward, 0.2 m"},
        {"jump back 20 cm", "jump backward, 0.2 m"},
        {"leap 0.4 m", "jump, 0.4 m"},
        {"jump 30 cm to the left", "jump left, 0.3 m"},
        {"jump three times, 20 cm each", "jump, 0.2 m, 3 times"},
        {"walk forward 1 m, jump 0.4 m forward, turn left, then sit",
         "walk forward, 1 m; jump forward, 0.4 m; turn left; sit"},
        {"jump with a quarter turn to the left", "jump, 90 degrees, turning left"},
        {"jump with a 60 degree turn to the right", "jump, 60 degrees, turning right"},
        {"jump with a half turn", "jump, 180 degrees, turning left"},
        {"jump 30 cm forward with a quarter turn to the right", "jump forward, 90 degrees, 0.3 m, turning right"},
        {"jump 20 cm to the left with a quarter turn to the left", "jump left, 90 degrees, 0.2 m, turning left"},
        {"jump and turn around in the air", "jump, 180 degrees, turning left"},
        {"jump and turn left by 90 degrees in the air", "jump, 90 degrees, turning left"},
        {"jump while turning right by 45 degrees", "jump, 45 degrees, turning right"},
        {"jump with a turn to the left", "jump, turning left"},
        {"jump, then turn left", "jump; turn left"},
        {"jump to the red marker", "jump, to red marker"},
        {"jump onto the block", "jump, to block"},
        {"jump up onto the block, then jump down", "jump, to block; jump, down"},
        {"jump backward to the door", "jump backward, to door"},
        {"do a backflip", "flip backward"},
        {"do two back flips", "flip backward, 2 times"},
        {"do a barrel roll", "flip right"},
        {"do a barrel roll to the left", "flip left"},
        {"walk one metre, do a backflip, and lie down", "walk forward, 1 m; flip backward; lie down"},
    }));

INSTANTIATE_TEST_SUITE_P(Chinese, JumpsInWords,
                         testing::ValuesIn(std::vector<JumpCase>{
                             {"跳一下", "jump"},
                             {"原地跳三下", "jump, 3 times"},
                             {"跳两次", "jump, 2 times"},
                             {"往前跳0.4米", "jump forward, 0.4 m"},
                             {"向左跳20厘米", "jump left, 0.2 m"},
                             {"向后跳", "jump backward"},
                             {"跳到门那里", "jump, to 门"},
                             {"跳下来", "jump, down"},
                             {"跳起来向左转90度", "jump, 90 degrees, turning left"},
                             {"空中转身", "jump, 180 degrees, turning left"},
                             {"先走一米，再往前跳30厘米，然后坐下", "walk forward, 1 m; jump forward, 0.3 m; sit"},
                             {"来个后空翻", "flip backward"},
                             {"做两个后空翻", "flip backward, 2 times"},
                             {"做一个侧空翻", "flip right"},
                             {"向左侧空翻", "flip left"},
                         }));

/// A word that a jump cannot have is refused, never left out.
class NoJumps : public testing::TestWithParam<JumpCase> {};

TEST_P(NoJumps, AreRefused) {
  EXPECT_EQ(JumpsIn(GetParam().text).substr(0, 9 + std::string(GetParam().tasks).size()),
            std::string("refused: ") + GetParam().tasks)
      << GetParam().text;
}

INSTANTIATE_TEST_SUITE_P(Words, NoJumps,
                         testing::ValuesIn(std::vector<JumpCase>{
                             {"jump for joy", "unknown"},
                             {"jump for joy at 5", ""},
                             {"jump over the fence", "unknown"},
                             {"jump over the block", "unknown"},
                             {"jump off the block", "unknown"},
                             {"jump to the moon", "place"},
                             {"jump out of the way", "unknown"},
                             {"jump 20 cm high", "unknown"},
                             {"jump high", "unknown"},
                             {"jump up 30 cm", "unknown"},
                             {"jump at 2 m/s", "unknown"},
                             {"jump for 3 seconds", "unknown"},
                             {"jump 3", "ambiguous"},
                             {"jump with a 90 degree turn", "ambiguous"},
                             {"jump to the left with a quarter turn", "ambiguous"},
                             {"jump with a 270 degree turn to the left", "range"},
                             {"jump on one leg", "unknown"},
                             {"jump down the stairs", "unknown"},
                             {"turn left in the air", "unknown"},
                             {"don't jump", "unknown"},
                             {"skip", "unknown"},
                             {"dance", "unknown"},
                             {"gallop", "unknown"},
                             {"do a somersault", "unknown"},
                             {"roll over", "unknown"},
                             {"do a flip", "ambiguous"},
                             {"backflip to the left", "ambiguous"},
                             {"do a front flip", "cannot"},
                             {"跳舞", "unknown"},
                             {"跳个舞", "unknown"},
                             {"跳绳", "unknown"},
                             {"跳过栏杆", "unknown"},
                             {"跳20厘米高", "unknown"},
                             {"翻个跟头", "unknown"},
                             {"做个空翻", "ambiguous"},
                         }));

/// Words that mean other actions keep their meaning.
TEST(JumpWords, OtherActionsKeepTheirWords) {
  EXPECT_EQ(JumpsIn("hop on one foot", "nao"), "balance left");
  EXPECT_EQ(JumpsIn("bound forward 1 m"), "walk forward, 1 m, bound");
  EXPECT_EQ(JumpsIn("hop over to the door"), "walk forward, to door");
  EXPECT_EQ(JumpsIn("turn around"), "turn left, 180 degrees");
}

TEST(JumpWords, ARobotWithoutAFlipIsRefused) {
  EXPECT_EQ(JumpsIn("do a backflip", "nao"), "refused: cannot");
  EXPECT_EQ(JumpsIn("jump", "nao"), "jump") << "whether motors allow it is found by planning";
}

TEST(JumpWords, ATurnIsAddedToTheJumpBeforeItOnly) {
  const std::string text = "turn left";
  words::Draft turn, jump;
  turn.action = "turn";
  turn.parameters = {{"direction", std::string("left")}};
  turn.said = {{"direction", {5, 9}}};
  turn.words = {0, 9};
  jump.action = "jump";
  std::vector<words::Draft> drafts = {jump};
  words::Clause clause;
  EXPECT_FALSE(words::JoinsJump(text, clause, turn, drafts)) << "it comes after the jump";
  clause.is_meanwhile = true;
  EXPECT_TRUE(words::JoinsJump(text, clause, turn, drafts));
  EXPECT_EQ(drafts[0].parameters.at("turn"), TaskValue(std::string("left")));
  turn.aloft = true;
  drafts.clear();
  EXPECT_THROW(words::JoinsJump(text, clause, turn, drafts), words::Refused);
}

}  // namespace
}  // namespace gaitwright
