// SPDX-License-Identifier: BSD-3-Clause
#include "planning/terrain/flat_pieces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <utility>

#include "kinematics/spatial/convex_hull.h"

namespace gaitwright {
namespace {

constexpr double kSamePoint = 1e-5;                          // [m]
constexpr double kSamePlane = 1e-3;                          // [m]
constexpr double kSameSlope = 0.5 * std::numbers::pi / 180;  // [rad]
constexpr double kConvex = 1e-4;                             // share of its convex hull that a piece may lack

using Edge = std::pair<int, int>;
using Loop = std::vector<int>;  // indices of points, counter-clockwise

/// The mesh with coinciding points merged, and its triangles that face up.
struct Surface {
  std::vector<Vector3> points;
  std::vector<std::array<int, 3>> corners;  // by triangle
  std::vector<Vector3> normals;             // by triangle; zero for a triangle without area
  std::vector<char> up;                     // by triangle
  std::map<Edge, std::vector<int>> beside;  // upward triangles by edge, lower point index first
};

Edge Undirected(int a, int b) { return {std::min(a, b), std::max(a, b)}; }

Surface MakeSurface(const Mesh& mesh, double steepest_rad) {
  Surface surface;
  std::map<std::array<long long, 3>, int> known;
  std::vector<int> number;
  for (const Vector3& v : mesh.vertices) {
    const std::array<long long, 3> cell = {std::llround(v.x() / kSamePoint), std::llround(v.y() / kSamePoint),
                                           std::llround(v.z() / kSamePoint)};
    const auto [at, is_new] = known.emplace(cell, static_cast<int>(surface.points.size()));
    if (is_new) surface.points.push_back(v);
    number.push_back(at->second);
  }
  for (const Eigen::Vector3i& t : mesh.triangles) {
    std::array<int, 3> c{};
    for (int i = 0; i < 3; ++i) c[static_cast<std::size_t>(i)] = number[static_cast<std::size_t>(t[i])];
    const auto point = [&](std::size_t i) { return surface.points[static_cast<std::size_t>(c[i])]; };
    const Vector3 normal = (point(1) - point(0)).cross(point(2) - point(0));
    const bool up = normal.norm() > 0.0 && normal.z() >= std::cos(steepest_rad) * normal.norm();
    const int triangle = static_cast<int>(surface.corners.size());
    surface.corners.push_back(c);
    surface.normals.emplace_back(up ? normal.normalized() : Vector3(Vector3::Zero()));
    surface.up.push_back(up ? 1 : 0);
    for (std::size_t i = 0; up && i < 3; ++i) surface.beside[Undirected(c[i], c[(i + 1) % 3])].push_back(triangle);
  }
  return surface;
}

/// The connected triangles in the plane of the first triangle.
std::vector<int> GrowRegion(const Surface& surface, int first, std::vector<char>& taken) {
  const Vector3 normal = surface.normals[static_cast<std::size_t>(first)];
  const Vector3 origin = surface.points[static_cast<std::size_t>(surface.corners[static_cast<std::size_t>(first)][0])];
  const auto belongs = [&](int triangle) {
    const auto t = static_cast<std::size_t>(triangle);
    if (taken[t] != 0 || surface.normals[t].dot(normal) < std::cos(kSameSlope)) return false;
    return std::all_of(surface.corners[t].begin(), surface.corners[t].end(), [&](int corner) {
      return std::abs(normal.dot(surface.points[static_cast<std::size_t>(corner)] - origin)) <= kSamePlane;
    });
  };
  std::vector<int> region = {first};
  taken[static_cast<std::size_t>(first)] = 1;
  for (std::size_t k = 0; k < region.size(); ++k) {
    const std::array<int, 3>& c = surface.corners[static_cast<std::size_t>(region[k])];
    for (std::size_t i = 0; i < 3; ++i) {
      for (const int next : surface.beside.at(Undirected(c[i], c[(i + 1) % 3]))) {
        if (!belongs(next)) continue;
        taken[static_cast<std::size_t>(next)] = 1;
        region.push_back(next);
      }
    }
  }
  return region;
}

/// A loop of points, and the triangles inside it.
struct Piece {
  Loop loop;
  std::vector<int> triangles;
};

/// Splits one region into convex pieces, in the plane's own coordinates.
class Splitter {
 public:
  Splitter(const Surface& surface, const std::vector<int>& region) : surface_(surface) {
    const Vector3 z = surface.normals[static_cast<std::size_t>(region[0])];
    const Vector3 x = Vector3::UnitY().cross(z).normalized(), y = z.cross(x);
    for (const int triangle : region) {
      const std::array<int, 3>& c = surface.corners[static_cast<std::size_t>(triangle)];
      for (const int corner : c) {
        const Vector3& p = surface.points[static_cast<std::size_t>(corner)];
        flat_[corner] = Vector2(x.dot(p), y.dot(p));
      }
      pieces_.push_back({{c[0], c[1], c[2]}, {triangle}});
    }
  }

  std::vector<FlatPiece> Split() {
    if (AreAllConvex()) return {WholeRegion()};
    Join();
    std::vector<FlatPiece> made;
    for (const Piece& piece : pieces_) {
      if (!piece.loop.empty()) made.push_back(Finished(piece.loop, piece.triangles));
    }
    return made;
  }

 private:
  std::vector<Vector2> Flat(const Loop& loop) const {
    std::vector<Vector2> outline;
    for (const int corner : loop) outline.push_back(flat_.at(corner));
    return outline;
  }

  /// Whether all triangles together fill their convex hull.
  bool AreAllConvex() const {
    double area = 0.0;
    std::vector<Vector2> points;
    for (const Piece& piece : pieces_) area += Area(Flat(piece.loop));
    for (const auto& [corner, p] : flat_) points.push_back(p);
    const double hull = Area(ConvexHull(points));
    return std::abs(hull - area) <= kConvex * hull;
  }

  FlatPiece WholeRegion() const {
    Loop corners;
    std::vector<int> triangles;
    for (const auto& [corner, p] : flat_) corners.push_back(corner);
    for (const Piece& piece : pieces_) triangles.push_back(piece.triangles[0]);
    return Finished(corners, triangles);
  }

  /// The hull of some points, in space.
  FlatPiece Finished(const Loop& points, const std::vector<int>& triangles) const {
    FlatPiece made;
    made.triangles = triangles;
    for (const Vector2& p : ConvexHull(Flat(points))) {
      const int corner = *std::find_if(points.begin(), points.end(), [&](int c) { return flat_.at(c) == p; });
      made.corners.push_back(surface_.points[static_cast<std::size_t>(corner)]);
    }
    return made;
  }

  /// Adds or removes the edges of a piece.
  void Register(std::size_t piece, bool is_there) {
    const Loop& loop = pieces_[piece].loop;
    for (std::size_t s = 0; s < loop.size(); ++s) {
      std::set<std::size_t>& owners = owners_[{loop[s], loop[(s + 1) % loop.size()]}];
      if (is_there) {
        owners.insert(piece);
      } else {
        owners.erase(piece);
      }
    }
  }

  /// The pieces that share an edge with this one, in the opposite direction.
  std::set<std::size_t> Neighbours(std::size_t piece) const {
    std::set<std::size_t> neighbours;
    const Loop& loop = pieces_[piece].loop;
    for (std::size_t s = 0; s < loop.size(); ++s) {
      const auto beyond = owners_.find({loop[(s + 1) % loop.size()], loop[s]});
      if (beyond != owners_.end()) neighbours.insert(beyond->second.begin(), beyond->second.end());
    }
    neighbours.erase(piece);
    return neighbours;
  }

  /// Joins neighbours as long as two of them form a convex piece.
  void Join() {
    for (std::size_t i = 0; i < pieces_.size(); ++i) Register(i, true);
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      for (bool joined = true; joined;) {
        joined = false;
        for (const std::size_t j : Neighbours(i)) {
          const std::optional<Loop> both = Joined(pieces_[i].loop, pieces_[j].loop);
          if (!both) continue;
          for (const std::size_t former : {i, j}) Register(former, false);
          pieces_[i].loop = *both;
          Register(i, true);
          pieces_[i].triangles.insert(pieces_[i].triangles.end(), pieces_[j].triangles.begin(),
                                      pieces_[j].triangles.end());
          pieces_[j].loop.clear();
          joined = true;
          break;
        }
      }
    }
  }

  /// The loop around two pieces with a common edge; nothing if they share no edge or the result is not convex.
  std::optional<Loop> Joined(const Loop& a, const Loop& b) const {
    for (std::size_t i = 0; i < a.size(); ++i) {
      const int from = a[i], to = a[(i + 1) % a.size()];
      const auto at = std::find(b.begin(), b.end(), from);
      if (at == b.end()) continue;
      const auto k = static_cast<std::size_t>(at - b.begin());
      if (b[(k + b.size() - 1) % b.size()] != to) continue;
      Loop both;
      for (std::size_t s = 1; s <= a.size(); ++s) both.push_back(a[(i + s) % a.size()]);
      for (std::size_t s = 1; s + 1 < b.size(); ++s) both.push_back(b[(k + s) % b.size()]);
      DropSpurs(both);
      if (both.size() >= 3 && ShareOfHull(Flat(both)) >= 1.0 - kConvex) return both;
      return std::nullopt;
    }
    return std::nullopt;
  }

  /// Removes edges that are passed forward and backward; they occur in loops that shared several edges.
  static void DropSpurs(Loop& loop) {
    for (std::size_t i = 0; loop.size() > 2 && i < loop.size();) {
      const std::size_t n = loop.size();
      if (loop[(i + n - 1) % n] != loop[(i + 1) % n]) {
        ++i;
        continue;
      }
      const std::size_t next = (i + 1) % n;
      loop.erase(loop.begin() + static_cast<std::ptrdiff_t>(std::max(i, next)));
      loop.erase(loop.begin() + static_cast<std::ptrdiff_t>(std::min(i, next)));
      i = 0;
    }
  }

  const Surface& surface_;
  std::map<int, Vector2> flat_;
  std::vector<Piece> pieces_;
  std::map<Edge, std::set<std::size_t>> owners_;  // by edge, from its first point to its second
};

}  // namespace

std::vector<FlatPiece> FlatPieces(const Mesh& mesh, double steepest_rad) {
  const Surface surface = MakeSurface(mesh, steepest_rad);
  std::vector<char> taken(surface.up.size(), 0);
  std::vector<FlatPiece> pieces;
  for (std::size_t t = 0; t < surface.up.size(); ++t) {
    if (surface.up[t] == 0 || taken[t] != 0) continue;
    const std::vector<int> region = GrowRegion(surface, static_cast<int>(t), taken);
    for (FlatPiece& piece : Splitter(surface, region).Split()) pieces.push_back(std::move(piece));
  }
  return pieces;
}

}  // namespace gaitwright
