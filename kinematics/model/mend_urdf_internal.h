// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tinyxml2.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "kinematics/model/finding.h"

namespace gaitwright {

/// Text of `count` numbers, given with decimal commas or with commas between them, without the commas. Nothing if the
/// text has no comma, or if the meaning of the commas is unclear.
std::optional<std::string> WithoutCommas(const std::string& text, std::size_t count);

/// Repairs the numbers of an element of a link or a joint and of its child elements.
/// @param part  the link or joint, for findings.
/// @return whether something was repaired.
bool MendNumbers(tinyxml2::XMLElement& element, const RobotPart& part, std::vector<Finding>& findings);

/// Repairs numbers, masses and shapes of a link. @return whether something was repaired.
bool MendLink(tinyxml2::XMLElement& link, const RobotPart& part, std::vector<Finding>& findings);

/// Repairs numbers, type and limits of a joint. @param at_root  whether its parent link is the root.
/// @return whether something was repaired.
bool MendJoint(tinyxml2::XMLElement& joint, const RobotPart& part, bool at_root, std::vector<Finding>& findings);

}  // namespace gaitwright
