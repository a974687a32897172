// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <charconv>
#include <sstream>

#include "kinematics/base/text.h"
#include "kinematics/model/mesh_parts.h"

namespace gaitwright {
namespace {

/// Index of the vertex of a corner such as `3/1/2` or `-1//4`.
int VertexOf(const std::string& corner, std::size_t vertices, const std::string& place) {
  const std::string word = corner.substr(0, corner.find('/'));
  long long index = 0;
  const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), index);
  const auto count = static_cast<long long>(vertices);
  const bool is_number = error == std::errc{} && stop == word.data() + word.size();
  if (is_number && index >= 1 && index <= count) return static_cast<int>(index - 1);
  if (is_number && index <= -1 && index >= -count) return static_cast<int>(count + index);
  throw InvalidArgument(
      fmt::format("{}: face corner '{}' refers to a vertex that does not exist; the lines before it define {} vertices",
                  place, Shortened(corner), vertices));
}

void TakeLine(const std::string& line, const std::string& place, Mesh& mesh) {
  std::istringstream words(line);
  std::string word;
  words >> word;
  if (word == "v") {
    Vector3 vertex;
    for (double& c : vertex) {
      std::string number;
      words >> number;
      c = MeshNumber(number, place + ": a coordinate");
    }
    mesh.vertices.push_back(vertex);
  } else if (word == "f") {
    std::vector<int> corners;
    for (std::string corner; words >> corner && corners.size() <= kMostFaceCorners;)
      corners.push_back(VertexOf(corner, mesh.vertices.size(), place));
    if (corners.size() > 2) AddFace(corners, mesh);
  }
  CheckMeshSize(mesh.vertices.size(), mesh.triangles.size());
}

}  // namespace

Mesh ParseObj(const std::string& text) {
  Mesh mesh;
  std::istringstream stream(text);
  std::string line;
  for (int number = 1; std::getline(stream, line); ++number) {
    const int first = number;
    for (std::string next; line.ends_with('\\') && std::getline(stream, next); ++number) {
      line.back() = ' ';
      line += next;
    }
    TakeLine(line, fmt::format("line {}", first), mesh);
  }
  return mesh;
}

}  // namespace gaitwright
