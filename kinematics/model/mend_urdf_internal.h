// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tinyxml2.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "kinematics/model/finding.h"

namespace gaitwright {

/// So many numbers, written with a decimal comma or with commas between them, as XML has them; nothing where the text
/// has no comma, or commas that cannot be told.
std::optional<std::string> WithoutCommas(const std::string& text, std::size_t count);

/// Mends the numbers of an element of a link or a joint and of all in it. @param part  whose element it is.
/// @return whether any was.
bool MendNumbers(tinyxml2::XMLElement& element, const std::string& part, std::vector<Finding>& findings);

/// Mends masses and shapes of a link, likewise.
bool MendLink(tinyxml2::XMLElement& link, const std::string& part, std::vector<Finding>& findings);

/// Mends type and limits of a joint, likewise. @param at_root  whether its parent link is the root.
bool MendJoint(tinyxml2::XMLElement& joint, const std::string& part, bool at_root, std::vector<Finding>& findings);

}  // namespace gaitwright
