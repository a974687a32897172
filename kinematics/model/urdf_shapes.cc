// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/urdf_shapes.h"

#include <cstring>

#include "kinematics/model/urdf_pose_internal.h"
#include "kinematics/model/urdf_xml_internal.h"

namespace gaitwright {
namespace {

using tinyxml2::XMLElement;

Vector3 Three(const XMLElement& element, const char* name, const Vector3& fallback) {
  if (element.Attribute(name) == nullptr) return fallback;
  const std::vector<double> numbers = Numbers(element.Attribute(name), 3, name);
  return {numbers[0], numbers[1], numbers[2]};
}

Pose Origin(const XMLElement& parent) {
  const XMLElement* origin = parent.FirstChildElement("origin");
  if (origin == nullptr) return Pose::Identity();
  const Vector3 xyz = Three(*origin, "xyz", Vector3::Zero()), rpy = Three(*origin, "rpy", Vector3::Zero());
  urdf::Pose pose;
  pose.position = urdf::Vector3(xyz.x(), xyz.y(), xyz.z());
  pose.rotation.setFromRPY(rpy.x(), rpy.y(), rpy.z());
  return FromUrdf(pose);
}

Shape ReadShape(const XMLElement& element, const std::string& link, double scale) {
  const XMLElement& geometry = *element.FirstChildElement("geometry")->FirstChildElement();
  const std::string type = geometry.Name();
  Shape shape;
  shape.link = link;
  shape.X_BS = Origin(element);
  if (type == "box") {
    shape.size = Three(geometry, "size", Vector3::Zero());
  } else if (type == "mesh") {
    shape.type = ShapeType::kMesh;
    shape.size = Three(geometry, "scale", Vector3::Ones());
    shape.mesh_file = Attribute(geometry, "filename", link);
  } else {
    shape.type = type == "sphere" ? ShapeType::kSphere : type == "capsule" ? ShapeType::kCapsule : ShapeType::kCylinder;
    shape.size.x() = Number(geometry, "radius", link);
    if (type != "sphere") shape.size.y() = Number(geometry, "length", link);
  }
  shape.size *= scale;
  shape.X_BS.translation() *= scale;
  return shape;
}

/// Removes all elements of a kind from a link and returns their shapes.
std::vector<Shape> TakeShapes(XMLElement& link, const char* kind, double scale) {
  std::vector<Shape> shapes;
  while (XMLElement* element = link.FirstChildElement(kind)) {
    shapes.push_back(ReadShape(*element, link.Attribute("name"), scale));
    link.DeleteChild(element);
  }
  return shapes;
}

}  // namespace

UrdfParts SplitUrdf(const std::string& urdf_text, double scale) {
  tinyxml2::XMLDocument document;
  document.Parse(urdf_text.c_str(), urdf_text.size());
  UrdfParts parts;
  XMLElement* robot = document.RootElement();
  for (XMLElement* link = robot->FirstChildElement("link"); link != nullptr; link = link->NextSiblingElement("link")) {
    for (const char* kind : {"collision", "visual"}) {
      std::vector<Shape>& all = std::strcmp(kind, "visual") == 0 ? parts.visual : parts.collision;
      for (Shape& shape : TakeShapes(*link, kind, scale)) all.push_back(std::move(shape));
    }
  }
  tinyxml2::XMLPrinter printer;
  document.Print(&printer);
  parts.tree_text = printer.CStr();
  return parts;
}

}  // namespace gaitwright
