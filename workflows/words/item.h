// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "kinematics/base/failure_code.h"
#include "planning/tasks/task_plan.h"

namespace gaitwright::words {

/// Meaning of a word or a group of words of an instruction. lexicon.cc has the names, in this order.
enum class Meaning {
  kAction,     ///< an action: `name` is the action, `parameters` are those that the word implies
  kRaise,      ///< "lift", "put up": for an arm or a foot
  kLower,      ///< "lower", "put down"
  kPut,        ///< "put", with up or down
  kDirection,  ///< forward, backward
  kSide,       ///< left, right: of a direction or a limb
  kSideways,   ///< "sideways", which needs a side
  kBoth,       ///< both limbs
  kArm,        ///< an arm, a hand
  kFoot,       ///< a foot, a leg
  kPlural,     ///< arms, hands
  kPart,       ///< another part of the body; `name` is head, body, legs or belly
  kUp,         ///< up; `name` "way" if it can be a direction of walking
  kDown,       ///< down; `name` as for kUp
  kNumber,     ///< a number without a unit
  kAmount,     ///< a number with its unit; `name` is the quantity: m, s, deg, steps, treads, times, m/s
  kUnit,       ///< a unit, before it is joined with a number
  kOrdinal,    ///< first, second, last: one of several
  kPlace,      ///< a known place
  kStairs,     ///< the stairs; `value` 1 up, -1 down, 2 to the next step
  kTo,         ///< "to", before a place
  kAt,         ///< "at", before a person to wave to
  kPace,       ///< slowly, fast
  kGait,       ///< the name of a gait
  kLow,        ///< crouched
  kEach,       ///< "each", for the length of a step
  kHold,       ///< "hold it", for the last request
  kThen,       ///< begins the next task
  kBreak,      ///< a comma, a full stop
  kWhile,      ///< at the same time
  kBefore,     ///< "before": the following action is done after the one behind it
  kAfter,      ///< "after": the following action is done first
  kNo,         ///< the following words replace the last request; `name` "no" if it can also only deny
  kNot,        ///< "not": the following words are denied; `name` "oh" if it corrects: "啊不是"
  kForbid,     ///< "don't": forbids the following action; `name` "needless" if it need not have been requested,
               ///< "no" if it corrects when nothing follows
  kDrop,       ///< cancels the last request; if `name` is set, only if it is this action
  kFirst,      ///< at the end of a clause: done before the previous request
  kAgain,      ///< repeats the last request
  kAside,      ///< "because": the following words request nothing
  kSubject,    ///< "I", "妈妈": another person, who may do something
  kPolite,     ///< no meaning; not included in a part that is not understood
  kFiller,     ///< no meaning
  kElsewhere,  ///< an action that no robot has; `name` is the nearest one, if any; the controller does "recover"
  kUnknown,    ///< words that are not accepted: a condition, an adverb that describes more than the manner
};

/// Additional meanings of an action word, as its `value`: a place follows; it is done at the same time as another
/// action; it goes back by the same distance. For stairs: up or down stairs, or up or down in general.
constexpr double kToPlace = 1.0, kBeside = 2.0, kReturns = 3.0;
constexpr double kUpStairs = 4.0, kDownStairs = 5.0, kUpwards = 6.0, kDownwards = 7.0;

/// A piece of an instruction with its meaning.
struct Item {
  Meaning meaning = Meaning::kUnknown;
  std::string name;
  double value = 0.0;                           ///< of a number, an amount or an ordinal; for an action, see above
  std::map<std::string, TaskValue> parameters;  ///< parameters of an action
  std::size_t begin = 0, end = 0;               ///< bytes of the text

  /// Whether it has this meaning.
  bool Is(Meaning other) const { return meaning == other; }
  /// Whether it is a verb that means up or down.
  bool GoesUpOrDown() const { return Is(Meaning::kAction) && value >= kUpStairs; }
  bool SaysNothing() const { return Is(Meaning::kPolite) || Is(Meaning::kFiller); }
  /// Whether it is a verb; each clause has one.
  bool IsVerb() const {
    return Is(Meaning::kAction) || Is(Meaning::kRaise) || Is(Meaning::kLower) || Is(Meaning::kElsewhere);
  }
};

/// A part of an instruction that is not accepted, and why: unknown, cannot, range, ambiguous, place, empty.
struct Refusal {
  FailureCode code = FailureCode::kInternal;
  std::string part, why;
  std::string nearest;   ///< a similar action, or ""
  std::string say = {};  ///< what to say instead, if known
  /// `why` is a sentence of its own; otherwise it continues a sentence that begins with the part.
  bool is_sentence = false;
};

}  // namespace gaitwright::words
