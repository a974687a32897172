// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/words/draft.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "workflows/words/phrases.h"

namespace gaitwright::words {
namespace {

[[noreturn]] void RefuseAmbiguous(const std::string& part, const std::string& why) {
  throw Refused{{FailureCode::kAmbiguous, part, why, ""}};
}

bool IsWay(const std::string& action) {
  return action == "walk" || action == "turn" || action == "jump" || action == "flip";
}
bool HasArms(const std::string& action) { return action == "wave" || action == "raise_arm" || action == "lower_arm"; }

}  // namespace

std::string TextOf(const std::string& text, const Span& span) { return text.substr(span.begin, span.end - span.begin); }

Span SpanOf(const Draft& draft, const std::string& key) {
  const auto said = draft.said.find(key);
  return said == draft.said.end() ? draft.words : said->second;
}

bool IsDoneWith(const std::string& action, const std::string& part) {
  static const std::map<std::string, std::set<std::string>> kParts = {
      {"arm", {"", "wave", "raise_arm", "lower_arm"}},
      {"foot", {"", "balance"}},
      {"head", {"nod", "bow", "brace"}},
      {"body",
       {"walk", "turn", "jump", "flip", "stand", "stand_up", "lie_down", "sit", "squat", "bow", "nod", "balance",
        "brace"}},
      {"legs", {"stand", "stand_up", "lie_down", "sit", "squat", "bow", "balance", "brace"}},
      {"belly", {"lie_down", "sit", "squat", "brace"}}};
  return kParts.at(part).contains(action);
}

void SettleSide(const std::string& text, Draft& draft) {
  if (IsWay(draft.action) && draft.side) {
    const auto said = draft.said.find("direction");
    const bool other = said != draft.said.end() && draft.parameters["direction"] != TaskValue(*draft.side);
    const bool forward = other && draft.parameters["direction"] == TaskValue(std::string("forward"));
    if (other && !(draft.action == "turn" && forward)) {
      const Span &a = said->second, &b = *draft.side_said;
      RefuseAmbiguous(TextOf(text, {std::min(a.begin, b.begin), std::max(a.end, b.end)}),
                      "gives two directions at once");
    }
    draft.parameters["direction"] = *draft.side;
    draft.said["direction"] = *draft.side_said;
    draft.side.reset();
  }
  if (HasArms(draft.action) && draft.side && draft.side_said) {
    if (SaysWhereTo(TextOf(text, *draft.side_said)))
      throw Refused{{FailureCode::kAmbiguous, TextOf(text, *draft.side_said),
                     "is a direction; it does not name the arm", "", "which arm: 'with the left hand'"}};
  }
  const bool limbs = HasArms(draft.action) || draft.action == "balance";
  if (!limbs) return;
  if (draft.side) {
    draft.parameters["side"] = *draft.side;
    draft.said["side"] = draft.side_said.value_or(draft.words);
  } else if (draft.plural) {
    draft.parameters["side"] = std::string("both");
    draft.said["side"] = draft.words;
  }
  draft.side.reset();
  draft.plural = false;
}

void Merge(const std::string& text, const Draft& said, bool over, Draft& into) {
  if (said.action.empty() && !said.part.empty() && !IsDoneWith(into.action, said.part))
    throw Refused{{FailureCode::kUnknown, TextOf(text, said.words),
                   "is not a part of the robot's body for '" + into.action + "'", ""}};
  const bool on_stairs = into.stairs != 0 || said.parameters.contains("to") || said.parameters.contains("steps");
  const bool elsewhere = over && (said.said.contains("to") || said.said.contains("distance_m"));
  if (elsewhere || (said.stairs != 0 && on_stairs)) into.stairs = said.stairs;
  for (const auto& [key, value] : said.parameters) {
    std::string to = key;
    if (key == "distance_m" && into.action == "squat") to = "depth_m";
    if (key == "step_length_m" && into.action == "jump") to = "distance_m";  // "jump three times, 20 cm each"
    const bool extent = std::find(ExtentKeys().begin(), ExtentKeys().end(), to) != ExtentKeys().end();
    if (over && extent) {
      for (const std::string& other : ExtentKeys()) {
        into.parameters.erase(other);
        into.said.erase(other);
      }
    }
    const auto there = into.said.find(to);
    if (!over && there != into.said.end() && into.parameters[to] != value && to != "pace")
      RefuseAmbiguous(TextOf(text, {there->second.begin, SpanOf(said, key).end}), "gives two values at once");
    into.parameters[to] = value;
    into.said[to] = SpanOf(said, key);
  }
  if (!said.last_key.empty()) {
    into.last_key = said.last_key;
    into.last_unit = said.last_unit;
    into.bare.reset();
  }
  if (said.bare && over && !into.last_key.empty()) {
    const double value = said.bare->value * into.last_unit;
    const bool count = FindParameter(into.last_key)->kind == ParameterRule::Kind::kCount;
    into.parameters[into.last_key] = count ? TaskValue(static_cast<int>(std::lround(value))) : TaskValue(value);
    into.said[into.last_key] = {said.bare->begin, said.bare->end};
  } else if (said.bare) {
    into.bare = said.bare;
  }
  if (said.sideways) into.sideways = said.sideways;
  if (said.side || said.plural) {
    Draft sided = said;
    sided.action = into.action;
    sided.parameters.clear();
    sided.said.clear();
    SettleSide(text, sided);
    for (const auto& [key, value] : sided.parameters) {
      into.parameters[key] = value;
      into.said[key] = sided.said[key];
    }
    if (sided.side) {
      into.side = sided.side;
      into.side_said = sided.side_said;
    }
  }
  into.words.end = std::max(into.words.end, said.words.end);
}

}  // namespace gaitwright::words
