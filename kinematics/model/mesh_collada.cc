// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <tinyxml2.h>

#include <charconv>
#include <cstring>
#include <map>
#include <numbers>
#include <set>
#include <sstream>

#include "kinematics/base/text.h"
#include "kinematics/model/mesh_parts.h"

namespace gaitwright {
namespace {

using tinyxml2::XMLElement;

constexpr int kMostNodes = 10000;          // nodes in a scene; each instance of a node counts
constexpr int kLargestNumber = 100000000;  // largest count or index

[[noreturn]] void Refuse(const XMLElement& at, const std::string& why) {
  throw InvalidArgument(fmt::format("line {}: <{}> {}", at.GetLineNum(), at.Name(), why));
}

std::string Text(const XMLElement& element, const char* name) {
  const char* text = element.Attribute(name);
  return text == nullptr ? "" : text;
}

/// Calls `take` for each word of an element.
template <class Take>
void ForEachWord(const XMLElement& element, Take take) {
  const char* text = element.GetText();
  std::istringstream words(text == nullptr ? "" : text);
  for (std::string word; words >> word;) take(word);
}

std::vector<double> NumbersIn(const XMLElement& element) {
  std::vector<double> numbers;
  ForEachWord(element, [&](const std::string& word) {
    numbers.push_back(MeshNumber(word, fmt::format("line {}: a number of <{}>", element.GetLineNum(), element.Name())));
  });
  return numbers;
}

int Whole(const XMLElement& element, const std::string& word) {
  int value = 0;
  const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc{} || stop != word.data() + word.size() || value < 0 || value > kLargestNumber)
    Refuse(element, fmt::format("holds '{}'; a whole number from 0 to {} is needed", Shortened(word), kLargestNumber));
  return value;
}

std::vector<int> Wholes(const XMLElement& element) {
  std::vector<int> numbers;
  ForEachWord(element, [&](const std::string& word) { numbers.push_back(Whole(element, word)); });
  return numbers;
}

int WholeAttribute(const XMLElement& element, const char* name, int fallback) {
  const std::string text = Text(element, name);
  return text.empty() ? fallback : Whole(element, text);
}

template <class Each>
void ForEachChild(const XMLElement& parent, const char* name, Each each) {
  for (const XMLElement* child = parent.FirstChildElement(name); child != nullptr;
       child = child->NextSiblingElement(name))
    each(*child);
}

const XMLElement& Needed(const XMLElement& parent, const char* name) {
  const XMLElement* child = parent.FirstChildElement(name);
  if (child == nullptr) Refuse(parent, fmt::format("lacks <{}>", name));
  return *child;
}

/// The value of a map for a reference `#ID`.
template <class Value>
const Value& Named(const std::map<std::string, Value>& all, const XMLElement& at, const char* attribute) {
  const std::string url = Text(at, attribute);
  const auto found = all.find(url.starts_with('#') ? url.substr(1) : "");
  if (found == all.end()) Refuse(at, fmt::format("refers to '{}', which does not exist", Shortened(url)));
  return found->second;
}

/// Points of a <source> with three numbers each.
std::vector<Vector3> Points(const XMLElement& source) {
  const XMLElement& array = Needed(source, "float_array");
  const XMLElement& accessor = Needed(Needed(source, "technique_common"), "accessor");
  const std::vector<double> numbers = NumbersIn(array);
  const auto count = static_cast<std::size_t>(WholeAttribute(accessor, "count", 0));
  const auto stride = static_cast<std::size_t>(WholeAttribute(accessor, "stride", 1));
  const auto offset = static_cast<std::size_t>(WholeAttribute(accessor, "offset", 0));
  if (stride < 3) Refuse(accessor, fmt::format("has the stride {}; points have three numbers or more", stride));
  if (offset + count * stride > numbers.size())
    Refuse(accessor, fmt::format("needs {} numbers; the array has {}", offset + count * stride, numbers.size()));
  CheckMeshSize(count, 0);
  std::vector<Vector3> points;
  for (std::size_t i = offset; points.size() < count; i += stride)
    points.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2]);
  return points;
}

/// The count of numbers for a corner, and the position of the point's index among them.
struct CornerLayout {
  int stride = 1, position = -1;
};

CornerLayout LayoutOf(const XMLElement& primitive) {
  CornerLayout layout;
  ForEachChild(primitive, "input", [&](const XMLElement& input) {
    const int offset = WholeAttribute(input, "offset", 0);
    if (offset > 31) Refuse(input, fmt::format("has the offset {}; at most 31 is accepted", offset));
    layout.stride = std::max(layout.stride, offset + 1);
    if (Text(input, "semantic") == "VERTEX") layout.position = offset;
  });
  if (layout.position < 0) Refuse(primitive, "has no input VERTEX");
  return layout;
}

/// The indices of the corners' points in a <p>.
std::vector<int> Corners(const XMLElement& p, const CornerLayout& layout, std::size_t points) {
  const std::vector<int> numbers = Wholes(p);
  const auto stride = static_cast<std::size_t>(layout.stride);
  if (numbers.size() % stride != 0)
    Refuse(p, fmt::format("has {} numbers; a multiple of {}, the numbers for each corner, is needed", numbers.size(),
                          stride));
  std::vector<int> corners;
  for (std::size_t i = static_cast<std::size_t>(layout.position); i < numbers.size(); i += stride) {
    if (static_cast<std::size_t>(numbers[i]) >= points)
      Refuse(p, fmt::format("refers to point {}, counted from 0; the mesh has {} points", numbers[i], points));
    corners.push_back(numbers[i]);
  }
  return corners;
}

/// Calls `add` for each face of a <p>, according to the kind of its primitive.
template <class Add>
void Faces(const XMLElement& primitive, const std::vector<int>& corners, Add add) {
  const std::string kind = primitive.Name();
  if (kind == "polygons") return add(corners);
  if (kind == "polylist") {
    std::size_t at = 0;
    for (const int count : Wholes(Needed(primitive, "vcount"))) {
      if (at + static_cast<std::size_t>(count) > corners.size())
        Refuse(primitive, fmt::format("has {} corners, fewer than its <vcount> needs", corners.size()));
      const auto first = corners.begin() + static_cast<std::ptrdiff_t>(at);
      add({first, first + count});
      at += static_cast<std::size_t>(count);
    }
    return;
  }
  const bool strip = kind == "tristrips", fan = kind == "trifans";
  for (std::size_t i = 2; i < corners.size(); i += strip || fan ? 1 : 3) {
    const int first = fan ? corners[0] : corners[i - 2];
    if (strip && i % 2 != 0) {
      add({corners[i - 1], first, corners[i]});
    } else {
      add({first, corners[i - 1], corners[i]});
    }
  }
}

/// The faces of a <geometry> in its own frame.
Mesh GeometryOf(const XMLElement& geometry) {
  Mesh mesh;
  const XMLElement* own = geometry.FirstChildElement("mesh");
  if (own == nullptr) return mesh;
  std::map<std::string, const XMLElement*> sources;
  ForEachChild(*own, "source", [&](const XMLElement& source) { sources[Text(source, "id")] = &source; });
  const XMLElement& vertices = Needed(*own, "vertices");
  ForEachChild(vertices, "input", [&](const XMLElement& input) {
    if (Text(input, "semantic") == "POSITION") mesh.vertices = Points(*Named(sources, input, "source"));
  });
  for (const char* kind : {"triangles", "polylist", "polygons", "tristrips", "trifans"}) {
    ForEachChild(*own, kind, [&](const XMLElement& primitive) {
      const CornerLayout layout = LayoutOf(primitive);
      ForEachChild(primitive, "p", [&](const XMLElement& p) {
        Faces(primitive, Corners(p, layout, mesh.vertices.size()), [&](const std::vector<int>& face) {
          if (face.size() > 2) AddFace(face, mesh);
          CheckMeshSize(mesh.vertices.size(), mesh.triangles.size());
        });
      });
    });
  }
  return mesh;
}

using Transform = Eigen::Affine3d;

/// The transform of one element of a <node>; identity for an element that is not a transform.
Transform TransformOf(const XMLElement& element) {
  const std::string kind = element.Name();
  Transform made = Transform::Identity();
  const auto numbers = [&](std::size_t count) {
    std::vector<double> all = NumbersIn(element);
    if (all.size() != count) Refuse(element, fmt::format("has {} numbers; {} are needed", all.size(), count));
    return all;
  };
  if (kind == "matrix") {
    const std::vector<double> m = numbers(16);
    made.matrix() = Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(m.data());
    made.makeAffine();
  } else if (kind == "translate") {
    const std::vector<double> t = numbers(3);
    made.translation() = Vector3(t[0], t[1], t[2]);
  } else if (kind == "rotate") {
    const std::vector<double> r = numbers(4);
    const Vector3 axis(r[0], r[1], r[2]);
    if (axis.norm() > 0.0) made.rotate(Eigen::AngleAxisd(r[3] * std::numbers::pi / 180.0, axis.normalized()));
  } else if (kind == "scale") {
    const std::vector<double> s = numbers(3);
    made.scale(Vector3(s[0], s[1], s[2]));
  } else if (kind == "lookat" || kind == "skew" || kind == "instance_controller") {
    Refuse(element, "is not supported; apply it to the points and export again");
  }
  return made;
}

/// Builds the mesh of the scene of a Collada file.
class SceneReader {
 public:
  explicit SceneReader(const XMLElement& root) : root_(root) {
    for (const char* library : {"library_geometries", "library_nodes", "library_visual_scenes"}) {
      ForEachChild(root, library, [&](const XMLElement& all) { NoteNamed(all); });
    }
  }

  Mesh Read() {
    Transform unit = Transform::Identity();
    const XMLElement* asset = root_.FirstChildElement("asset");
    const XMLElement* said = asset == nullptr ? nullptr : asset->FirstChildElement("unit");
    if (said != nullptr && said->Attribute("meter") != nullptr) {
      const double meter = MeshNumber(Text(*said, "meter"), fmt::format("line {}: the unit", said->GetLineNum()));
      if (!(meter > 0.0)) Refuse(*said, fmt::format("has the attribute meter='{}'; it must be above 0", meter));
      unit.scale(meter);
    }
    unit = unit * UpAxis(asset == nullptr ? nullptr : asset->FirstChildElement("up_axis"));
    const XMLElement* shown = Needed(root_, "scene").FirstChildElement("instance_visual_scene");
    if (shown == nullptr) Refuse(root_, "has no <instance_visual_scene>");
    ForEachChild(*Named(scenes_, *shown, "url"), "node", [&](const XMLElement& node) { Visit(node, unit); });
    return std::move(mesh_);
  }

 private:
  /// Rotation from the file's axes to axes with z up, as in Gazebo. Right, up and out are x, y and z for Y_UP; -y, x
  /// and z for X_UP; x, z and -y for Z_UP. The default is z up.
  static Transform UpAxis(const XMLElement* said) {
    Transform turned = Transform::Identity();
    const std::string axis = said == nullptr || said->GetText() == nullptr ? "" : Trimmed(said->GetText());
    if (axis == "Y_UP") turned.linear() << 1, 0, 0, 0, 0, -1, 0, 1, 0;
    if (axis == "X_UP") turned.linear() << 0, -1, 0, 0, 0, -1, 1, 0, 0;
    return turned;
  }

  void NoteNamed(const XMLElement& library) {
    ForEachChild(library, "geometry", [&](const XMLElement& e) { geometries_[Text(e, "id")] = &e; });
    ForEachChild(library, "visual_scene", [&](const XMLElement& e) { scenes_[Text(e, "id")] = &e; });
    ForEachChild(library, "visual_scene", [&](const XMLElement& e) { NoteNodes(e); });
    NoteNodes(library);
  }
  void NoteNodes(const XMLElement& parent) {
    ForEachChild(parent, "node", [&](const XMLElement& node) {
      if (!Text(node, "id").empty()) nodes_[Text(node, "id")] = &node;
      NoteNodes(node);
    });
  }

  void Visit(const XMLElement& node, const Transform& above) {
    if (++visited_ > kMostNodes) Refuse(node, fmt::format("exceeds the limit of {} nodes in a scene", kMostNodes));
    if (!open_.insert(&node).second) Refuse(node, fmt::format("'{}' contains itself", Shortened(Text(node, "id"))));
    Transform here = above;
    for (const XMLElement* e = node.FirstChildElement(); e != nullptr; e = e->NextSiblingElement())
      here = here * TransformOf(*e);
    ForEachChild(node, "instance_geometry",
                 [&](const XMLElement& shown) { Add(*Named(geometries_, shown, "url"), here); });
    ForEachChild(node, "node", [&](const XMLElement& child) { Visit(child, here); });
    ForEachChild(node, "instance_node", [&](const XMLElement& shown) { Visit(*Named(nodes_, shown, "url"), here); });
    open_.erase(&node);
  }

  void Add(const XMLElement& geometry, const Transform& X) {
    auto known = made_.find(&geometry);
    if (known == made_.end()) known = made_.emplace(&geometry, GeometryOf(geometry)).first;
    const Mesh& part = known->second;
    CheckMeshSize(mesh_.vertices.size() + part.vertices.size(), mesh_.triangles.size() + part.triangles.size());
    const auto base = static_cast<int>(mesh_.vertices.size());
    for (const Vector3& v : part.vertices) mesh_.vertices.emplace_back(X * v);
    for (const Eigen::Vector3i& t : part.triangles) mesh_.triangles.push_back(t + Eigen::Vector3i::Constant(base));
  }

  const XMLElement& root_;
  std::map<std::string, const XMLElement*> geometries_, scenes_, nodes_;
  std::map<const XMLElement*, Mesh> made_;
  std::set<const XMLElement*> open_;
  int visited_ = 0;
  Mesh mesh_;
};

}  // namespace

Mesh ParseCollada(const std::string& text) {
  tinyxml2::XMLDocument document;
  if (document.Parse(text.c_str(), text.size()) != tinyxml2::XML_SUCCESS) {
    throw InvalidArgument(fmt::format("it is not XML: line {}: {}", document.ErrorLineNum(), document.ErrorName()));
  }
  const XMLElement* root = document.RootElement();
  if (root == nullptr || std::strcmp(root->Name(), "COLLADA") != 0)
    throw InvalidArgument("its root element is not <COLLADA>");
  return SceneReader(*root).Read();
}

}  // namespace gaitwright
