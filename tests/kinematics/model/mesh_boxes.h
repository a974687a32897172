// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <sstream>
#include <string>
#include <vector>

#include "kinematics/dynamics/dynamics.h"
#include "kinematics/model/robot_model.h"
#include "kinematics/model/shape_support.h"

namespace gaitwright {

/// Triangles of a box, as indices of its BoxCorners.
inline std::vector<std::array<int, 3>> BoxTriangles() {
  return {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
          {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
}

inline std::string BinaryStl(const Vector3& half) {
  const auto corners = BoxCorners(2.0 * half);
  std::string bytes(80, '\0');
  const auto append = [&bytes](const auto& value) {
    char raw[sizeof(value)];
    std::memcpy(raw, &value, sizeof(value));
    bytes.append(raw, sizeof(value));
  };
  append(static_cast<std::uint32_t>(BoxTriangles().size()));
  for (const auto& triangle : BoxTriangles()) {
    for (int i = 0; i < 3; ++i) append(0.0F);
    for (const int corner : triangle) {
      for (int k = 0; k < 3; ++k) append(static_cast<float>(corners[static_cast<std::size_t>(corner)][k]));
    }
    append(std::uint16_t{0});
  }
  return bytes;
}

inline std::string TextStl(const Vector3& half) {
  const auto corners = BoxCorners(2.0 * half);
  std::ostringstream text;
  text << "solid box\n";
  for (const auto& triangle : BoxTriangles()) {
    text << "facet normal 0 0 0\nouter loop\n";
    for (const int corner : triangle)
      text << "vertex " << corners[static_cast<std::size_t>(corner)].transpose() << "\n";
    text << "endloop\nendfacet\n";
  }
  text << "endsolid box\n";
  return text.str();
}

inline std::string Obj(const Vector3& half) {
  std::ostringstream text;
  for (const Vector3& corner : BoxCorners(2.0 * half)) text << "v " << corner.transpose() << "\n";
  for (const auto& t : BoxTriangles()) text << "f " << t[0] + 1 << " " << t[1] + 1 << " " << t[2] + 1 << "\n";
  return text.str();
}

/// The box as Collada with z up, as in most files of robots, and a unit.
inline std::string Collada(const Vector3& half, double metres) {
  std::ostringstream text;
  text << "<?xml version=\"1.0\"?><COLLADA xmlns=\"http://www.collada.org/2005/11/COLLADASchema\" version=\"1.4.1\">"
       << "<asset><unit name=\"u\" meter=\"" << metres << "\"/><up_axis>Z_UP</up_axis></asset>"
       << "<library_geometries><geometry id=\"g\"><mesh><source id=\"p\"><float_array id=\"a\" count=\"24\">";
  for (const Vector3& corner : BoxCorners(2.0 * half)) text << corner.transpose() << " ";
  text << "</float_array><technique_common><accessor source=\"#a\" count=\"8\" stride=\"3\"><param name=\"X\" "
          "type=\"float\"/><param name=\"Y\" type=\"float\"/><param name=\"Z\" type=\"float\"/></accessor>"
          "</technique_common></source><vertices id=\"v\"><input semantic=\"POSITION\" source=\"#p\"/></vertices>"
          "<triangles count=\"12\"><input semantic=\"VERTEX\" source=\"#v\" offset=\"0\"/><p>";
  for (const auto& t : BoxTriangles()) text << t[0] << " " << t[1] << " " << t[2] << " ";
  text << "</p></triangles></mesh></geometry></library_geometries><library_visual_scenes><visual_scene id=\"s\">"
          "<node id=\"n\"><instance_geometry url=\"#g\"/></node></visual_scene></library_visual_scenes>"
          "<scene><instance_visual_scene url=\"#s\"/></scene></COLLADA>";
  return text.str();
}

/// Height of the lowest vertex of a mesh in W, by comparing all vertices.
inline double LowestVertex(const DynamicsScratch& scratch, const Shape& shape) {
  double lowest = 1e9;
  for (const Vector3& v : shape.vertices) {
    lowest = std::min(lowest, (FramePose(scratch, shape.body, shape.X_BS) * v).z());
  }
  return lowest;
}

}  // namespace gaitwright
