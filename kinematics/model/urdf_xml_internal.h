// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tinyxml2.h>

#include <optional>
#include <string>
#include <vector>

#include "kinematics/base/result.h"

namespace gaitwright {

/// Stops reading a URDF by throwing a Failure, which CheckUrdf catches.
[[noreturn]] void Refuse(FailureCode code, const std::string& message, std::vector<Suggestion> suggestions = {},
                         std::optional<RobotPart> part = {});

/// Runs a check of a link or joint. A failure that names no part gets this one.
template <class Check>
void CheckPart(const RobotPart& part, const Check& check) {
  try {
    check();
  } catch (Failure& failure) {
    if (!failure.part) failure.part = part;
    throw;
  }
}

/// The text of an attribute. Refuses a missing attribute; the message names the owner.
std::string Attribute(const tinyxml2::XMLElement& element, const char* name, const std::string& owner);

/// The numbers of a text. Refuses a number that is not finite or whose magnitude is above `largest`, and a wrong count.
std::vector<double> Numbers(const std::string& text, std::size_t count, const std::string& owner,
                            double largest = 1e12);

/// The number of an attribute, with the same checks as in Numbers.
double Number(const tinyxml2::XMLElement& element, const char* name, const std::string& owner, double largest = 1e12);

/// Refuses an <origin> in `parent` with invalid numbers.
void CheckOrigin(const tinyxml2::XMLElement& parent, const std::string& owner);

/// Refuses an impossible mass or geometry of a link, and where `strict` an impossible inertia or one without mass.
void CheckLink(const tinyxml2::XMLElement& link, bool strict, const std::string& owner);

/// Refuses a joint's axis, limits and dynamics that are missing or wrong, and where `strict` a position range of 0 to
/// 0.
void CheckMotion(const tinyxml2::XMLElement& joint, const std::string& type, bool strict, const std::string& owner);

/// Refuses a mimic of an unknown or fixed joint, of the joint itself, in a cycle, or with invalid numbers.
void CheckMimics(const tinyxml2::XMLElement& robot);

/// Largest size of a robot's parts and distances [m]; largest mass and inertia of a link [kg, kg m^2].
inline constexpr double kLongest = 1e3, kHeaviest = 1e6;

}  // namespace gaitwright
