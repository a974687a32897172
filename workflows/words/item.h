// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "kinematics/base/failure_code.h"
#include "planning/tasks/task_plan.h"

namespace gaitwright::words {

/// What a word or a group of words of an instruction stands for. lexicon.cc has their names, in this order.
enum class Meaning {
  kAction,     ///< something to do: `name` is the action, `parameters` what the word says of it
  kRaise,      ///< "lift", "put up": of an arm or a foot
  kLower,      ///< "lower", "put down"
  kPut,        ///< "put": with up or down
  kDirection,  ///< forward, backward
  kSide,       ///< left, right: of a way or of a limb
  kSideways,   ///< to one of the sides, which has to be said
  kBoth,       ///< both limbs
  kArm,        ///< an arm, a hand
  kFoot,       ///< a foot, a leg
  kPlural,     ///< arms, hands
  kPart,       ///< another part of the body; `name` is head, body, legs or belly
  kUp,         ///< up; `name` "way" where a robot may go so
  kDown,       ///< down; the same
  kNumber,     ///< a number alone
  kAmount,     ///< a number with its unit; `name` is the quantity: m, s, deg, steps, treads, times, m/s
  kUnit,       ///< a unit, before numbers are put to it
  kOrdinal,    ///< first, second, last: which of several
  kPlace,      ///< a place that is known
  kStairs,     ///< the stairs; `value` 1 up them, -1 down them, 2 to their next step
  kTo,         ///< "to", before a place
  kAt,         ///< "at", before whom to wave to
  kPace,       ///< slowly, fast
  kGait,       ///< the name of a gait
  kLow,        ///< crouched
  kEach,       ///< "each", of a step's length
  kHold,       ///< "hold it", of what was said last
  kThen,       ///< goes on to the next task
  kBreak,      ///< a comma, a full stop
  kWhile,      ///< at the same time
  kBefore,     ///< "before": what follows is done after what comes then
  kAfter,      ///< "after": what follows is done first
  kNo,         ///< what follows is meant in place of what was said last; `name` "no" where it denies that alone too
  kNot,        ///< "not": what follows is not meant; `name` "oh" where it corrects what was said: "啊不是"
  kForbid,     ///< "don't": what follows is not to be done; `name` "needless" where nobody need have asked for it,
               ///< "no" where it corrects when nothing follows
  kDrop,       ///< what was said last is not to be done; only if it is the action `name`, where one is given
  kFirst,      ///< said last: before what was said before it
  kAgain,      ///< the same once more
  kAside,      ///< "because": what follows asks for nothing
  kSubject,    ///< "I", "妈妈": somebody else, of whom something may be told
  kPolite,     ///< says nothing, and is no part of what is not understood
  kFiller,     ///< says nothing
  kElsewhere,  ///< an action that no robot here has; `name` is the nearest, if any; "recover" is what a
               ///< controller does
  kUnknown,    ///< what the instruction may not have in it: a condition, an adverb that says more than how
};

/// What more the word of an action says, as its `value`: that a place follows, that it is done beside something, that
/// it goes back as far as it came. Of stairs, up or down them, or up or down on whatever there is.
constexpr double kToPlace = 1.0, kBeside = 2.0, kReturns = 3.0;
constexpr double kUpStairs = 4.0, kDownStairs = 5.0, kUpwards = 6.0, kDownwards = 7.0;

/// A piece of an instruction with its meaning.
struct Item {
  Meaning meaning = Meaning::kUnknown;
  std::string name;
  double value = 0.0;                           ///< of a number, an amount, an ordinal; of an action, see above
  std::map<std::string, TaskValue> parameters;  ///< of an action
  std::size_t begin = 0, end = 0;               ///< bytes of the text

  /// Whether it means that.
  bool Is(Meaning other) const { return meaning == other; }
  /// Whether it is a verb that says up or down.
  bool GoesUpOrDown() const { return Is(Meaning::kAction) && value >= kUpStairs; }
  bool SaysNothing() const { return Is(Meaning::kPolite) || Is(Meaning::kFiller); }
  /// Whether something is done by it: a clause has one.
  bool IsVerb() const {
    return Is(Meaning::kAction) || Is(Meaning::kRaise) || Is(Meaning::kLower) || Is(Meaning::kElsewhere);
  }
};

/// A part of an instruction that is not accepted, and why: unknown, cannot, range, ambiguous, place, empty.
struct Refusal {
  FailureCode code = FailureCode::kInternal;
  std::string part, why;
  std::string nearest;   ///< an action that could be meant, or ""
  std::string say = {};  ///< what to say instead, where that is known
};

}  // namespace gaitwright::words
