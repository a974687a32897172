// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tinyxml2.h>

#include <map>
#include <set>
#include <string>

#include "kinematics/description/mjcf_attributes_internal.h"
#include "kinematics/description/mjcf_document_internal.h"

namespace gaitwright {

/// The classes of <default>. A class starts with the attributes that the class around it has before it. Attributes for
/// one kind of actuator apply to all kinds, as in MuJoCo.
class MjcfDefaults {
 public:
  /// Throws a Failure for a class without a name or with the name of another class.
  explicit MjcfDefaults(const MjcfDocument& document);

  /// The attributes of an element, completed by those of its class: its own `class`, else `childclass`, else the
  /// outermost class. Throws a Failure for an unknown class.
  /// @param kind  kind of the element in <default>: "joint", "geom", "mesh", "equality", "actuator".
  MjcfAttributes Of(const tinyxml2::XMLElement& element, const std::string& kind,
                    const std::string& childclass = "") const;

  /// The `childclass` of an element, or `inherited` if it has none. Refuses a `childclass` that does not exist.
  std::string ChildClass(const tinyxml2::XMLElement& element, const std::string& inherited) const;

 private:
  using Class = std::map<std::string, MjcfAttributes::Values>;  // by kind of element

  void Read(const tinyxml2::XMLElement& section, const std::string& name);
  const Class& Named(const std::string& name, const tinyxml2::XMLElement& element) const;

  const MjcfDocument& document_;
  std::map<std::string, Class> classes_;
  std::set<std::string> outermost_;  // other names of the outermost class, "main"
};

/// Whether a tag is that of an actuator, such as "motor".
bool IsMjcfActuator(const std::string& tag);

}  // namespace gaitwright
