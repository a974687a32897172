// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/model/finding.h"

namespace gaitwright {

/// A URDF with repairs of errors that have one clear meaning.
struct MendedUrdf {
  std::string text;               ///< the given text if nothing was repaired
  std::vector<Finding> findings;  ///< one for each repair
};

/// Repairs common errors of URDFs that CheckUrdf would refuse:
/// - an encoding other than UTF-8, or a namespace prefix before element names: read;
/// - numbers with a decimal comma or with commas between them, a mesh scale of one number: corrected;
/// - a joint of type `floating` or `planar` at the root, which is the floating base itself: fixed;
/// - missing position limits: unlimited; missing effort and speed limits: unknown;
/// - shapes of size 0: 0.1 mm; visual shapes that cannot be drawn: left out;
/// - an <inertial> without mass or inertia: 0; a zero inertia is later replaced by that of the link's shapes;
/// - joints of the same name: renamed; links that are given twice identically, or that no joint names: left out.
/// Inertias that are not physical are repaired later, when the shapes are known; see MendInertia.
MendedUrdf MendUrdf(const std::string& urdf_text);

}  // namespace gaitwright
