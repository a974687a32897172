// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ompl/datastructures/NearestNeighbors.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

#include "kinematics/spatial/pose.h"

namespace gaitwright {

/// Nearest neighbours by cells of the plane. Uses no random numbers, so equal elements in equal order give equal
/// answers. The distance of two elements must not be less than their distance in plan view. Of equally far elements,
/// the one added first comes first.
template <class T>
class GridNeighbours : public ompl::NearestNeighbors<T> {
 public:
  using PlaceOf = std::function<Vector2(const T&)>;

  GridNeighbours(const Eigen::AlignedBox2d& extent, double cell_m, PlaceOf place_of)
      : low_(extent.min()),
        cell_m_(cell_m),
        columns_(1 + static_cast<int>(extent.sizes().x() / cell_m)),
        rows_(1 + static_cast<int>(extent.sizes().y() / cell_m)),
        place_of_(std::move(place_of)),
        cells_(static_cast<std::size_t>(columns_ * rows_)) {}

  bool reportsSortedResults() const override { return true; }
  void clear() override {
    for (auto& cell : cells_) cell.clear();
    elements_.clear();
  }
  void add(const T& data) override {
    cells_[static_cast<std::size_t>(CellOf(data))].push_back(elements_.size());
    elements_.push_back(data);
  }
  bool remove(const T& data) override {
    const auto found = std::find(elements_.begin(), elements_.end(), data);
    if (found == elements_.end()) return false;
    std::vector<T> left = elements_;
    left.erase(left.begin() + (found - elements_.begin()));
    clear();
    for (const T& element : left) add(element);
    return true;
  }
  T nearest(const T& data) const override {
    std::vector<T> one;
    nearestK(data, 1, one);
    return one.at(0);
  }
  void nearestK(const T& data, std::size_t k, std::vector<T>& neighbours) const override {
    Collect(data, std::min(k, elements_.size()), std::numeric_limits<double>::infinity());
    Copy(neighbours);
  }
  void nearestR(const T& data, double radius, std::vector<T>& neighbours) const override {
    Collect(data, elements_.size(), radius);
    Copy(neighbours);
  }
  std::size_t size() const override { return elements_.size(); }
  void list(std::vector<T>& data) const override { data = elements_; }

 private:
  int CellOf(const T& data) const {
    const Vector2 at = (place_of_(data) - low_) / cell_m_;
    return std::clamp(static_cast<int>(at.y()), 0, rows_ - 1) * columns_ +
           std::clamp(static_cast<int>(at.x()), 0, columns_ - 1);
  }

  /// Puts the nearest k within a radius into found_. Searches growing rings of cells until no nearer element can be
  /// outside.
  void Collect(const T& data, std::size_t k, double radius) const {
    found_.clear();
    const int cell = CellOf(data), column = cell % columns_, row = cell / columns_;
    const int last = std::max(std::max(column, columns_ - 1 - column), std::max(row, rows_ - 1 - row));
    for (int ring = 0; ring <= last; ++ring) {
      const double beyond = (ring - 1) * cell_m_;  // all elements of this ring are at least this far
      if (beyond > radius) break;
      if (found_.size() >= k) {
        std::nth_element(found_.begin(), found_.begin() + static_cast<std::ptrdiff_t>(k - 1), found_.end());
        if (found_[k - 1].first < beyond) break;
      }
      AddRing(data, column, row, ring);
    }
    std::sort(found_.begin(), found_.end());
    if (found_.size() > k) found_.resize(k);
    while (!found_.empty() && found_.back().first > radius) found_.pop_back();
  }
  void AddRing(const T& data, int column, int row, int ring) const {
    for (int r = std::max(row - ring, 0); r <= std::min(row + ring, rows_ - 1); ++r) {
      const bool edge = r == row - ring || r == row + ring;
      const int stride = edge || ring == 0 ? 1 : 2 * ring;
      for (int c = column - ring; c <= column + ring; c += stride) {
        if (c < 0 || c >= columns_) continue;
        for (const std::size_t i : cells_[static_cast<std::size_t>(r * columns_ + c)])
          found_.emplace_back(this->distFun_(data, elements_[i]), i);
      }
    }
  }
  void Copy(std::vector<T>& neighbours) const {
    neighbours.clear();
    for (const auto& [distance, i] : found_) neighbours.push_back(elements_[i]);
  }

  Vector2 low_;
  double cell_m_;
  int columns_, rows_;
  PlaceOf place_of_;
  std::vector<std::vector<std::size_t>> cells_;
  std::vector<T> elements_;
  mutable std::vector<std::pair<double, std::size_t>> found_;
};

}  // namespace gaitwright
