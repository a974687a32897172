// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

namespace gaitwright {

/// A URDF with another root link. The joints between the old and the new root are reversed.
struct RerootedUrdf {
  std::string text;
  std::string root;    ///< the new root link
  std::string former;  ///< the old root link, the end of a limb
};

/// If the root link of a URDF is the end of a limb, such as a foot, makes the body that carries the limbs the root.
/// Nothing for other URDFs. The root link is the end of a limb if two conditions hold. The tree has no branch for three
/// moving joints or more. The link of the first branch (for a single chain, the heaviest link) carries another limb
/// with the same number of moving joints, whose end has the same mass within 20 %. Names and positions of joints do not
/// change. A link between the old and the new root gets the frame of the joint that was below it.
/// @param urdf_text  must be accepted by CheckUrdf.
std::optional<RerootedUrdf> RerootFromLimbEnd(const std::string& urdf_text);

}  // namespace gaitwright
