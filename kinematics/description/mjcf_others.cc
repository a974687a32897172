// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "kinematics/base/nearest_name.h"
#include "kinematics/description/mjcf_others_internal.h"

namespace gaitwright {
namespace {

using tinyxml2::XMLElement;

const std::vector<std::string> kMjcfSections = {"compiler",  "option",   "size",   "visual",   "statistic",  "default",
                                                "extension", "custom",   "asset",  "contact",  "deformable", "equality",
                                                "tendon",    "actuator", "sensor", "keyframe", "worldbody"};

/// Known attributes by element: attributes that are read, and attributes that are not needed here.
const std::map<std::string, std::vector<std::string>> kMjcfAttributes = {
    {"body",
     {"name", "childclass", "mocap", "pos", "quat", "axisangle", "xyaxes", "zaxis", "euler", "gravcomp", "sleep",
      "user"}},
    {"inertial", {"pos", "quat", "axisangle", "xyaxes", "zaxis", "euler", "mass", "diaginertia", "fullinertia"}},
    {"joint",
     {"name",
      "class",
      "type",
      "group",
      "pos",
      "axis",
      "springdamper",
      "limited",
      "actuatorfrclimited",
      "solreflimit",
      "solimplimit",
      "solreffriction",
      "solimpfriction",
      "stiffness",
      "range",
      "actuatorfrcrange",
      "actuatorgravcomp",
      "margin",
      "ref",
      "springref",
      "armature",
      "damping",
      "frictionloss",
      "user"}},
    {"geom", {"name",     "class",    "type", "contype",    "conaffinity",  "condim", "group",  "priority", "size",
              "material", "friction", "mass", "density",    "shellinertia", "solmix", "solref", "solimp",   "margin",
              "gap",      "fromto",   "pos",  "quat",       "axisangle",    "xyaxes", "zaxis",  "euler",    "hfield",
              "mesh",     "fitscale", "rgba", "fluidshape", "fluidcoef",    "user"}},
    {"compiler",
     {"autolimits",    "boundmass",  "boundinertia", "settotalmass",     "balanceinertia",  "strippath",
      "coordinate",    "angle",      "fitaabb",      "eulerseq",         "meshdir",         "texturedir",
      "discardvisual", "convexhull", "usethread",    "fusestatic",       "inertiafromgeom", "inertiagrouprange",
      "saveinertial",  "assetdir",   "alignfree",    "exactmeshinertia", "conflict"}}};

/// Adds notes for unknown attributes, which may be misspelt.
void NoteUnknownMjcfAttributes(MjcfContext& context, const XMLElement& element) {
  const auto known = kMjcfAttributes.find(element.Name());
  if (known == kMjcfAttributes.end()) return;
  for (const auto* a = element.FirstAttribute(); a != nullptr; a = a->Next()) {
    if (context.has_many_notes()) return;
    if (std::find(known->second.begin(), known->second.end(), a->Name()) != known->second.end()) continue;
    const std::string name = ShownMjcf(a->Name());
    context.Note(context.document.Owner(element),
                 fmt::format("the attribute '{}' is unknown{}; it is ignored", name, NearestHint(name, known->second)));
  }
}

void NoteUnknownMjcfAttributesBelow(MjcfContext& context, const XMLElement& parent) {
  for (const XMLElement* child : context.document.Children(parent)) {
    NoteUnknownMjcfAttributes(context, *child);
    const std::string tag = child->Name();
    if (tag == "body" || tag == "frame" || tag == "default") NoteUnknownMjcfAttributesBelow(context, *child);
  }
}

void NoteMjcfOption(MjcfContext& context, const XMLElement& option) {
  const MjcfAttributes attributes = context.defaults.Of(option, "option");
  const Vector3 gravity = attributes.Three("gravity", Vector3(0.0, 0.0, -kGravity));
  constexpr double kGravityAlike = 0.02;
  if ((gravity - Vector3(0.0, 0.0, -kGravity)).norm() > kGravityAlike)
    context.Note(attributes.owner(),
                 fmt::format("gravity is '{}'; 0 0 -{} is used", attributes.Text("gravity"), kGravity));
  if (!attributes.Three("wind", Vector3::Zero()).isZero(0.0)) context.Note(attributes.owner(), "wind is ignored");
  for (const char* key : {"density", "viscosity"}) {
    if (attributes.Number(key, 0.0) != 0.0)
      context.Note(attributes.owner(), fmt::format("'{}' of the medium is ignored", key));
  }
  for (const XMLElement* flag : context.document.Children(option)) {
    if (std::string_view(flag->Name()) != "flag") continue;
    for (const char* key : {"constraint", "equality", "frictionloss", "limit", "contact", "passive", "spring", "damper",
                            "gravity", "clampctrl", "actuation"}) {
      const char* text = flag->Attribute(key);
      if (text != nullptr && std::string_view(text) == "disable")
        context.Note(context.document.Owner(*flag),
                     fmt::format("'{}' is disabled in the file, but is active in simulations here", key));
    }
  }
}

std::string MjcfPairText(const XMLElement& element, const char* first, const char* second) {
  const char* one = element.Attribute(first);
  const char* two = element.Attribute(second);
  return fmt::format("'{}' and '{}'", one == nullptr ? "" : ShownMjcf(one), two == nullptr ? "" : ShownMjcf(two));
}

void NoteMjcfContacts(MjcfContext& context) {
  for (const XMLElement* element : context.document.InSections("contact")) {
    const std::string tag = element->Name();
    const bool is_exclude = tag == "exclude";
    context.Note(context.document.Owner(*element),
                 is_exclude
                     ? fmt::format("bodies {} may touch each other here", MjcfPairText(*element, "body1", "body2"))
                     : fmt::format("contact settings of {} are ignored", MjcfPairText(*element, "geom1", "geom2")));
  }
}

}  // namespace

void MjcfContext::Note(const std::string& owner, const std::string& what) {
  if (has_many_notes()) return;
  notes.push_back(notes.size() < kMostMjcfNotes ? owner + ": " + what : "further notes are not listed");
}

void NoteMjcfOthers(MjcfContext& context) {
  for (const XMLElement* section : context.document.Children(context.document.root())) {
    const std::string tag = section->Name();
    if (!context.has_many_notes() && std::find(kMjcfSections.begin(), kMjcfSections.end(), tag) == kMjcfSections.end())
      context.Note(context.document.Owner(*section),
                   fmt::format("this section is unknown{}; it is ignored", NearestHint(tag, kMjcfSections)));
    if (tag == "option") NoteMjcfOption(context, *section);
    if (tag == "compiler") NoteUnknownMjcfAttributes(context, *section);
    if (tag == "worldbody" || tag == "default") NoteUnknownMjcfAttributesBelow(context, *section);
  }
  NoteMjcfContacts(context);
  for (const char* kind : {"tendon", "deformable"}) {
    for (const XMLElement* element : context.document.InSections(kind))
      context.Note(context.document.Owner(*element), fmt::format("a {} is left out", kind));
  }
}

}  // namespace gaitwright
