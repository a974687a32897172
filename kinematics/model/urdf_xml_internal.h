// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tinyxml2.h>

#include <string>
#include <vector>

#include "kinematics/base/result.h"

namespace gaitwright {

/// Ends the reading of a URDF with a Failure that CheckUrdf catches.
[[noreturn]] void Refuse(FailureCode code, const std::string& message, std::vector<Suggestion> suggestions = {});

/// The attribute's text. Refuses, naming the owner, where there is none.
std::string Attribute(const tinyxml2::XMLElement& element, const char* name, const std::string& owner);

/// The numbers of a text. Refuses one that is not finite, one whose size is over `largest`, and another count of them.
std::vector<double> Numbers(const std::string& text, std::size_t count, const std::string& owner,
                            double largest = 1e12);

/// The number of an attribute, likewise.
double Number(const tinyxml2::XMLElement& element, const char* name, const std::string& owner, double largest = 1e12);

/// Refuses an <origin> in `parent` whose numbers are none.
void CheckOrigin(const tinyxml2::XMLElement& parent, const std::string& owner);

/// Refuses an impossible mass or geometry of a link, and where `strict` an impossible inertia or one without mass.
void CheckLink(const tinyxml2::XMLElement& link, bool strict, const std::string& owner);

/// Refuses a joint's axis, limits and dynamics that are missing or wrong, and where `strict` a position range of 0 to
/// 0.
void CheckMotion(const tinyxml2::XMLElement& joint, const std::string& type, bool strict, const std::string& owner);

/// Refuses what joints mimic wrongly: no such joint, a fixed one, themselves, in a circle, with numbers that are none.
void CheckMimics(const tinyxml2::XMLElement& robot);

/// Longest that a robot's parts and distances may be [m]; heaviest that a link may be [kg, kg m^2].
inline constexpr double kLongest = 1e3, kHeaviest = 1e6;

}  // namespace gaitwright
