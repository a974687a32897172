// SPDX-License-Identifier: BSD-3-Clause
// What single words and their neighbours in a clause say.
#pragma once

#include <cstddef>
#include <string>

#include "workflows/words/clause.h"

namespace gaitwright::words {

/// Whether an action greets somebody, who may be named.
bool IsGreeting(const std::string& action);

/// Whether an action may be counted: "two squats".
bool IsCounted(const std::string& action);

/// "turn left 90", "R 90": whether a number without a unit is one of degrees.
bool IsAngle(double number);

/// The right of the left, and the other way round; what is no side stays.
std::string Other(const std::string& side);

/// "greet the visitors"; "wave the flag" is something else.
bool Greets(const std::string& text, const Item& verb);

/// "for the guest", "to our visitors": whether the item `at` is whom it is done for.
bool IsAddressed(const std::string& text, const Clause& clause, std::size_t at);

/// "to the left", "向左": where to; "on the left" is where an arm is.
bool SaysWhereTo(const std::string& side);

/// "raise your left hand with the right", "用右手举起左手", "wave with your right hand to the left": whether the second
/// of two sides, the item `at`, is not one more limb, but that of what moves the first, or where to.
bool IsMeans(const std::string& text, const Clause& clause, std::size_t first_begin, std::size_t at);

/// "three steps of 20 cm": whether the amount `at` is that of each step.
bool IsOfSteps(const std::string& text, const Clause& clause, std::size_t at);

/// "go back", and others of that kind.
bool GoesBack(const std::string& word);

/// A lone 点 nods with a head only.
bool NodsInVain(const std::string& text, const Clause& clause);

}  // namespace gaitwright::words
