// SPDX-License-Identifier: BSD-3-Clause
// Reads plots: the number of marks of a class, and their places.
#pragma once

#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "kinematics/spatial/pose.h"

namespace gaitwright::svg_marks {

/// Number of occurrences of a part in a text.
inline int Count(const std::string& text, const std::string& part) {
  int count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size())) ++count;
  return count;
}

/// The corners of all paths of a class, in pixels, path by path. Paths of the legend are included.
inline std::vector<std::vector<Vector2>> Paths(const std::string& svg, const std::string& css) {
  std::vector<std::vector<Vector2>> paths;
  const std::string begins = "<path d=\"", ends = "\" class=\"" + css + "\"/>";
  for (std::size_t end = svg.find(ends); end != std::string::npos; end = svg.find(ends, end + 1)) {
    const std::size_t begin = svg.rfind(begins, end) + begins.size();
    std::istringstream numbers(svg.substr(begin, end - begin));
    paths.emplace_back();
    for (char letter = 0; numbers >> letter && letter != 'Z';) {
      Vector2& point = paths.back().emplace_back();
      numbers >> point.x() >> point.y();
    }
  }
  return paths;
}

/// A rectangle in pixels.
struct Box {
  double left, top, right, bottom;
};

/// The rectangles of a class.
inline std::vector<Box> Boxes(const std::string& svg, const std::string& css) {
  std::vector<Box> boxes;
  const std::regex rect("<rect x=\"([-0-9.]+)\" y=\"([-0-9.]+)\" width=\"([-0-9.]+)\" height=\"([-0-9.]+)\" class=\"" +
                        css + "\"/>");
  for (std::sregex_iterator it(svg.begin(), svg.end(), rect), end; it != end; ++it) {
    const double x = std::stod((*it)[1]), y = std::stod((*it)[2]);
    boxes.push_back({x, y, x + std::stod((*it)[3]), y + std::stod((*it)[4])});
  }
  return boxes;
}

/// The middles of the dots of an ink.
inline std::vector<Vector2> Dots(const std::string& svg, const std::string& ink) {
  std::vector<Vector2> dots;
  const std::regex circle("<circle cx=\"([-0-9.]+)\" cy=\"([-0-9.]+)\" r=\"[-0-9.]+\" class=\"" + ink + " dot\"/>");
  for (std::sregex_iterator it(svg.begin(), svg.end(), circle), end; it != end; ++it)
    dots.emplace_back(std::stod((*it)[1]), std::stod((*it)[2]));
  return dots;
}

}  // namespace gaitwright::svg_marks
