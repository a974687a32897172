// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tinyxml2.h>

#include <map>
#include <set>
#include <string>

#include "kinematics/description/mjcf_attributes_internal.h"
#include "kinematics/description/mjcf_document_internal.h"

namespace gaitwright {

/// The classes of <default>. A class has all that the class around it has before it; what is written for one kind of
/// actuator holds for all of them, as in MuJoCo.
class MjcfDefaults {
 public:
  /// Throws a Failure on a class without a name, or with the name of another one.
  explicit MjcfDefaults(const MjcfDocument& document);

  /// The attributes of an element over those of its class: of its own `class`, else of `childclass`, else of the
  /// outermost class. Throws a Failure on an unknown class.
  /// @param kind  under which <default> has them: "joint", "geom", "mesh", "equality", "actuator".
  MjcfAttributes Of(const tinyxml2::XMLElement& element, const std::string& kind,
                    const std::string& childclass = "") const;

  /// Refuses a `childclass` that does not exist. @return it, or `inherited` where the element has none.
  std::string ChildClass(const tinyxml2::XMLElement& element, const std::string& inherited) const;

 private:
  using Class = std::map<std::string, MjcfAttributes::Values>;  // by kind of element

  void Read(const tinyxml2::XMLElement& section, const std::string& name);
  const Class& Named(const std::string& name, const tinyxml2::XMLElement& element) const;

  const MjcfDocument& document_;
  std::map<std::string, Class> classes_;
  std::set<std::string> outermost_;  // other names of the outermost class, "main"
};

/// Whether it is the tag of an actuator, such as "motor".
bool IsMjcfActuator(const std::string& tag);

}  // namespace gaitwright
