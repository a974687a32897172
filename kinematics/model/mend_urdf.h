// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/model/finding.h"

namespace gaitwright {

/// A URDF with repairs of errors that have one clear meaning.
struct MendedUrdf {
  std::string text;               ///< the given text if nothing was repaired
  std::vector<Finding> findings;  ///< one for each thing that was mended
};

/// Mends what people's URDFs have and CheckUrdf would refuse:
/// - another encoding than UTF-8, a prefix of the namespace before element names;
/// - numbers with a decimal comma or with commas between them, a mesh scale of one number;
/// - a joint of type `floating` or `planar` at the root, which is the free base itself: fixed;
/// - limits that are not given: none; effort and speed that are not given: unknown (0);
/// - shapes of size 0: of 0.1 mm; visual shapes that cannot be shown: left out;
/// - an <inertial> without mass or without inertia; one tensor that is missing is 0, that of the link's shapes then;
/// - joints of one name, links that are given twice alike, links that no joint holds.
/// Inertias that no body has are mended where the shapes are known, see MendInertia.
MendedUrdf MendUrdf(const std::string& urdf_text);

}  // namespace gaitwright
