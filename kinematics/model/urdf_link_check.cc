// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <sstream>

#include "kinematics/base/text.h"
#include "kinematics/model/mend_inertia.h"
#include "kinematics/model/urdf_xml_internal.h"
#include "kinematics/spatial/symmetric_matrix.h"

namespace gaitwright {
namespace {

using tinyxml2::XMLElement;

constexpr std::size_t kLongestAttribute = 1000;  // [byte]

void CheckInertial(const XMLElement& link, bool strict, const std::string& owner) {
  const XMLElement* inertial = link.FirstChildElement("inertial");
  if (inertial == nullptr) return;
  CheckOrigin(*inertial, owner);
  const XMLElement* mass = inertial->FirstChildElement("mass");
  const XMLElement* inertia = inertial->FirstChildElement("inertia");
  if (mass == nullptr || inertia == nullptr) {
    Refuse(FailureCode::kUrdfMissing, fmt::format("{}: <inertial> needs <mass> and <inertia>", owner));
  }
  const double m = Number(*mass, "value", owner, kHeaviest);
  if (m < 0.0)
    Refuse(FailureCode::kNegativeMass, fmt::format("{}: its mass is {} kg; zero or more is accepted", owner, m));
  const auto I = [&](const char* name) { return Number(*inertia, name, owner, kHeaviest); };
  const Matrix3 tensor = SymmetricMatrix(I("ixx"), I("ixy"), I("ixz"), I("iyy"), I("iyz"), I("izz"));
  constexpr double kRounding = 1e-9;  // [kg m^2]
  if (strict && m == 0.0 && tensor.cwiseAbs().maxCoeff() > kRounding)
    Refuse(FailureCode::kNoMass,
           fmt::format("{}: its mass is 0 but its inertia is not; give its mass, or make all moments 0", owner));
  const std::string broken = tensor.isZero(0.0) ? "" : BrokenInertiaLaw(tensor, m);
  if (strict && !broken.empty())
    Refuse(FailureCode::kImpossibleInertia, fmt::format("{}: its inertia {}", owner, broken));
}

void CheckMesh(const XMLElement& mesh, const std::string& owner) {
  if (Attribute(mesh, "filename", owner).empty()) {
    Refuse(FailureCode::kUrdfMissing, fmt::format("{}: <mesh> has an empty 'filename'", owner));
  }
  if (mesh.Attribute("scale") == nullptr) return;
  for (const double s : Numbers(mesh.Attribute("scale"), 3, owner + ", mesh scale", kHeaviest)) {
    if (s == 0.0) Refuse(FailureCode::kUrdfGeometry, fmt::format("{}: its mesh has scale 0", owner));
  }
}

void CheckShape(const XMLElement& shape, const std::string& owner) {
  const std::string type = shape.Name();
  std::vector<double> sizes;
  if (type == "box") {
    sizes = Numbers(Attribute(shape, "size", owner), 3, owner + ", box size", kLongest);
  } else if (type == "sphere") {
    sizes = {Number(shape, "radius", owner, kLongest)};
  } else if (type == "cylinder" || type == "capsule") {
    sizes = {Number(shape, "radius", owner, kLongest), Number(shape, "length", owner, kLongest)};
  } else if (type == "mesh") {
    CheckMesh(shape, owner);
  } else {
    Refuse(FailureCode::kUrdfGeometry,
           fmt::format("{}: geometry '{}' is not known; supported: 'box', 'cylinder', 'sphere', "
                       "'capsule', 'mesh'",
                       owner, type));
  }
  for (const double size : sizes) {
    if (size <= 0.0)
      Refuse(FailureCode::kUrdfGeometry,
             fmt::format("{}: a {} has the size {}; it must be positive", owner, type, size));
  }
}

}  // namespace

void Refuse(FailureCode code, const std::string& message, std::vector<Suggestion> suggestions,
            std::optional<RobotPart> part) {
  throw Failure{FailureKind::kBadInput, code, "LoadRobot", message, std::move(suggestions), {}, std::move(part)};
}

std::string Attribute(const XMLElement& element, const char* name, const std::string& owner) {
  const char* text = element.Attribute(name);
  if (text == nullptr)
    Refuse(FailureCode::kUrdfMissing, fmt::format("{}: <{}> has no '{}'", owner, element.Name(), name));
  if (std::strlen(text) > kLongestAttribute) {
    Refuse(FailureCode::kLongText, fmt::format("{}: '{}' of <{}> has {} bytes; at most {} are read", owner, name,
                                               element.Name(), std::strlen(text), kLongestAttribute));
  }
  if (!IsPlainText(text)) {
    Refuse(FailureCode::kNotText, fmt::format("{}: '{}' of <{}> is not valid UTF-8 or contains a control character",
                                              owner, name, element.Name()));
  }
  return text;
}

std::vector<double> Numbers(const std::string& text, std::size_t count, const std::string& owner, double largest) {
  std::istringstream words(text);
  std::vector<double> numbers;
  for (std::string word; words >> word;) {
    double value = 0.0;
    const char* begin = word.data() + (word.front() == '+' ? 1 : 0);
    const auto [end, error] = std::from_chars(begin, word.data() + word.size(), value);
    if (error != std::errc{} || end != word.data() + word.size() || !std::isfinite(value)) {
      Refuse(FailureCode::kUrdfNumber, fmt::format("{}: '{}' is not a finite number", owner, word));
    }
    if (std::abs(value) > largest) {
      Refuse(FailureCode::kUrdfNumber,
             fmt::format("{}: {} is too large; at most {} is accepted", owner, word, largest));
    }
    numbers.push_back(value);
  }
  if (numbers.size() != count) {
    Refuse(FailureCode::kUrdfNumber,
           fmt::format("{}: '{}' has {} numbers; {} are needed", owner, text, numbers.size(), count));
  }
  return numbers;
}

double Number(const XMLElement& element, const char* name, const std::string& owner, double largest) {
  return Numbers(Attribute(element, name, owner), 1, fmt::format("{}, {} {}", owner, element.Name(), name), largest)
      .front();
}

void CheckOrigin(const XMLElement& parent, const std::string& owner) {
  const XMLElement* origin = parent.FirstChildElement("origin");
  if (origin == nullptr) return;
  for (const char* name : {"xyz", "rpy"}) {
    if (origin->Attribute(name) != nullptr) Numbers(origin->Attribute(name), 3, owner + ", origin " + name, kLongest);
  }
}

void CheckLink(const XMLElement& link, bool strict, const std::string& owner) {
  CheckInertial(link, strict, owner);
  for (const char* kind : {"visual", "collision"}) {
    for (const XMLElement* e = link.FirstChildElement(kind); e != nullptr; e = e->NextSiblingElement(kind)) {
      CheckOrigin(*e, owner);
      const XMLElement* geometry = e->FirstChildElement("geometry");
      const XMLElement* shape = geometry == nullptr ? nullptr : geometry->FirstChildElement();
      if (shape == nullptr) Refuse(FailureCode::kUrdfMissing, fmt::format("{}: <{}> has no geometry", owner, kind));
      CheckShape(*shape, owner);
    }
  }
}

}  // namespace gaitwright
