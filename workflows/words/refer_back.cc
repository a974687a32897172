// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/words/refer_back.h"

#include <algorithm>

#include "workflows/words/says_more.h"

namespace gaitwright::words {
namespace {

TaskValue Word(const char* word) { return std::string(word); }

/// "lower it", "the other one": relative to the arm that was moved last.
void TakeLastSide(const std::string& text, const std::vector<Draft>& before, Draft& said) {
  const auto side = said.parameters.find("side");
  if (side == said.parameters.end() || (side->second != Word("same") && side->second != Word("other"))) return;
  const auto draft = std::find_if(before.rbegin(), before.rend(), [](const Draft& of_arm) {
    return of_arm.action == "raise_arm" || of_arm.action == "wave" || of_arm.action == "lower_arm";
  });
  if (draft == before.rend())
    throw Refused{{FailureCode::kAmbiguous, TextOf(text, said.words), "does not name the arm", ""}};
  const TaskValue last = draft->parameters.at("side");
  const TaskValue opposite = last == Word("left") ? Word("right") : Word("left");
  side->second = side->second == Word("other") ? opposite : last;
}

/// "on the left foot for five seconds, then on the right foot for another five".
void TakeLastUnit(const std::string& text, const Draft& last, Draft& said) {
  if (!said.bare || last.action != said.action || last.last_key.empty()) return;
  Draft number;
  number.bare = said.bare;
  said.bare.reset();
  said.last_key = last.last_key;
  said.last_unit = last.last_unit;
  Merge(text, number, true, said);
}

/// The distance of the previous walk, in the opposite direction.
void TakeDistanceBack(const Draft& walk, Draft& said) {
  if (!said.returns || SaysHowFar(said) || walk.action != "walk") return;
  for (const std::string& key : ExtentKeys()) {
    if (key != "to" && walk.parameters.contains(key)) said.parameters[key] = walk.parameters.at(key);
  }
  const TaskValue went = walk.parameters.at("direction");
  said.parameters["direction"] = went == Word("forward")    ? Word("backward")
                                 : went == Word("backward") ? Word("forward")
                                 : went == Word("left")     ? Word("right")
                                                            : Word("left");
}

}  // namespace

void ReferBack(const std::string& text, const std::vector<Draft>& before, Draft& said) {
  TakeLastSide(text, before, said);
  if (before.empty()) return;
  TakeLastUnit(text, before.back(), said);
  TakeDistanceBack(before.back(), said);
}

}  // namespace gaitwright::words
