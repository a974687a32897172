// SPDX-License-Identifier: BSD-3-Clause
// Meanings of single words and their neighbours in a clause.
#pragma once

#include <cstddef>
#include <string>

#include "workflows/words/clause.h"

namespace gaitwright::words {

/// Whether an action greets a person, who may be named.
bool IsGreeting(const std::string& action);

/// Whether an action may be counted: "two squats".
bool IsCounted(const std::string& action);

/// "turn left 90", "R 90": whether a number without a unit is in degrees.
bool IsAngle(double number);

/// The opposite side; other texts are returned unchanged.
std::string Other(const std::string& side);

/// Whether a verb greets: "greet the visitors", but not "wave the flag".
bool Greets(const std::string& text, const Item& verb);

/// "for the guest", "to our visitors": whether the item `at` is the person who is addressed.
bool IsAddressed(const std::string& text, const Clause& clause, std::size_t at);

/// Whether a side is a direction: "to the left", "向左"; "on the left" is not.
bool SaysWhereTo(const std::string& side);

/// "raise your left hand with the right", "用右手举起左手", "wave with your right hand to the left": whether the second
/// of two sides, the item `at`, is not another limb but the limb that moves the first one, or a direction.
bool IsMeans(const std::string& text, const Clause& clause, std::size_t first_begin, std::size_t at);

/// "three steps of 20 cm": whether the amount `at` is the length of each step.
bool IsOfSteps(const std::string& text, const Clause& clause, std::size_t at);

/// Whether a verb means going back: "go back" and similar.
bool GoesBack(const std::string& word);

/// Whether a clause has 点 without 头 (head), which is not a nod.
bool NodsInVain(const std::string& text, const Clause& clause);

}  // namespace gaitwright::words
