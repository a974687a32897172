// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

namespace gaitwright {

/// A URDF with another root link, from which the joints on the way to the former one are turned over.
struct RerootedUrdf {
  std::string text;
  std::string root;    ///< the link that is the root now
  std::string former;  ///< the end of a limb, which was
};

/// A URDF whose root link is the end of a limb, such as a foot, with the body that its limbs go out from as root;
/// nothing where it is not so. The root link is such an end where the tree does not part for three moving joints or
/// more, and the link where it parts (of a single chain its heaviest) has another limb of as many moving joints that
/// ends in a link of the same mass, within a fifth. Names and positions of joints stay what they are; of a link on the
/// way the frame is that of the joint which was after it.
/// @param urdf_text  that CheckUrdf accepts.
std::optional<RerootedUrdf> RerootFromLimbEnd(const std::string& urdf_text);

}  // namespace gaitwright
