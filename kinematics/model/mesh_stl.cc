// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <sstream>

#include "kinematics/base/text.h"
#include "kinematics/model/mesh_parts.h"

namespace gaitwright {
namespace {

constexpr std::size_t kHead = 84, kFacet = 50;  // bytes of a binary STL's header and of each triangle

/// Reads a number of a binary STL, low byte first.
std::uint32_t Word(const std::string& bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i)
    value |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[at + i])) << (8 * i);
  return value;
}

double Coordinate(const std::string& bytes, std::size_t at, std::size_t triangle) {
  const std::uint32_t word = Word(bytes, at);
  float value = 0.0F;
  std::memcpy(&value, &word, sizeof(value));
  if (!std::isfinite(value) || std::abs(value) > 1e12F)
    throw InvalidArgument(fmt::format("triangle {} has the coordinate {}; accepted: -1e12 to 1e12", triangle, value));
  return static_cast<double>(value);
}

void AddTriangle(const std::vector<Vector3>& corners, Mesh& mesh) {
  CheckMeshSize(mesh.vertices.size() + 3, mesh.triangles.size() + 1);
  const auto first = static_cast<int>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), corners.begin(), corners.end());
  mesh.triangles.emplace_back(first, first + 1, first + 2);
}

Mesh ParseBinary(const std::string& bytes, std::size_t count) {
  Mesh mesh;
  CheckMeshSize(3 * count, count);
  for (std::size_t t = 0; t < count; ++t) {
    std::vector<Vector3> corners;
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const std::size_t at = kHead + kFacet * t + 12 * (corner + 1);  // after the normal
      corners.emplace_back(Coordinate(bytes, at, t + 1), Coordinate(bytes, at + 4, t + 1),
                           Coordinate(bytes, at + 8, t + 1));
    }
    AddTriangle(corners, mesh);
  }
  return mesh;
}

/// Reads one line of a text STL. @return whether the line ends a facet.
bool TakeLine(const std::string& line, const std::string& place, std::vector<Vector3>& corners) {
  std::istringstream words(line);
  std::string word;
  words >> word;
  if (word == "vertex") {
    Vector3 corner;
    for (double& c : corner) {
      std::string number;
      words >> number;
      c = MeshNumber(number, place + ": a coordinate");
    }
    corners.push_back(corner);
    return false;
  }
  for (const char* known : {"", "solid", "facet", "outer", "endloop", "endfacet", "endsolid"}) {
    if (word == known) return word == "endfacet";
  }
  throw InvalidArgument(fmt::format("{}: '{}' is not an STL keyword", place, Shortened(word)));
}

Mesh ParseText(const std::string& text) {
  Mesh mesh;
  std::istringstream stream(text);
  std::string line;
  std::vector<Vector3> corners;
  for (int number = 1; std::getline(stream, line); ++number) {
    const std::string place = fmt::format("line {}", number);
    if (!TakeLine(line, place, corners)) {
      if (corners.size() > 3)
        throw InvalidArgument(place + ": this is the fourth vertex of a facet; a facet has three");
      continue;
    }
    if (corners.size() != 3)
      throw InvalidArgument(fmt::format("{}: a facet has {} vertices; three are needed", place, corners.size()));
    AddTriangle(corners, mesh);
    corners.clear();
  }
  if (!corners.empty()) throw InvalidArgument("the file ends within a facet");
  return mesh;
}

}  // namespace

Mesh ParseStl(const std::string& bytes) {
  const std::size_t count = bytes.size() >= kHead ? Word(bytes, kHead - 4) : 0;
  if (bytes.size() >= kHead && bytes.size() == kHead + kFacet * count) return ParseBinary(bytes, count);
  if (Trimmed(bytes.substr(0, kHead)).starts_with("solid")) return ParseText(bytes);
  throw InvalidArgument(fmt::format("its header announces {} triangles, which need {} bytes; the file has {}", count,
                                    kHead + kFacet * count, bytes.size()));
}

}  // namespace gaitwright
