// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "kinematics/collision/convex_distance_internal.h"
#include "kinematics/model/shape_support.h"

namespace gaitwright {
namespace {

constexpr double kExact = 1e-10;  // [m] at which a distance is final

/// A point of the set of differences b - a, with the points that make it.
struct Difference {
  Vector3 w = Vector3::Zero(), p_WA = w, p_WB = w;
};

/// A shape without the ball by which spheres and capsules are round: a point, a segment, or the shape itself.
struct Core {
  const Shape& shape;
  const Pose& X_WS;

  double ball_m() const { return IsRound() ? shape.size.x() : 0.0; }
  bool IsRound() const { return shape.type == ShapeType::kSphere || shape.type == ShapeType::kCapsule; }
  Vector3 Farthest(const Vector3& along_W) const {
    if (shape.type == ShapeType::kSphere) return X_WS.translation();
    const Vector3 along_S = X_WS.linear().transpose() * along_W;
    if (shape.type == ShapeType::kCapsule)
      return X_WS * Vector3(0.0, 0.0, std::copysign(0.5 * shape.size.y(), along_S.z()));
    return X_WS * SupportPoint(shape, along_S);
  }
};

/// The differences of two cores, by their extreme points.
struct Differences {
  Core A, B;

  Difference Farthest(const Vector3& along_W) const {
    const Vector3 p_WA = A.Farthest(-along_W), p_WB = B.Farthest(along_W);
    return {p_WB - p_WA, p_WA, p_WB};
  }
};

/// Up to four differences, with weights of their point that is nearest to the origin.
struct Simplex {
  std::array<Difference, 4> of;
  std::array<double, 4> weight{};
  int size = 0;

  Vector3 Point() const {
    Vector3 sum = Vector3::Zero();
    for (std::size_t i = 0; i < Count(); ++i) sum += weight[i] * of[i].w;
    return sum;
  }
  std::size_t Count() const { return static_cast<std::size_t>(size); }
};

/// The point of the affine hull of some corners (bits of `subset`) that is nearest to the origin. @return false if it
/// is not inside the corners, or if the corners are not independent.
bool NearestOfSubset(const Simplex& simplex, unsigned subset, Simplex& result) {
  constexpr double kDependent = 1e-14;
  result.size = 0;
  for (std::size_t i = 0; i < simplex.Count(); ++i) {
    if (subset & (1U << i)) result.of[static_cast<std::size_t>(result.size++)] = simplex.of[i];
  }
  const int edges = result.size - 1;
  Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 3> E(3, edges);
  for (int i = 0; i < edges; ++i) E.col(i) = result.of[static_cast<std::size_t>(i) + 1].w - result.of[0].w;
  result.weight = {1.0, 0.0, 0.0, 0.0};
  if (edges == 0) return true;
  const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 3, 3> square = E.transpose() * E;
  if (square.determinant() <= kDependent * square.diagonal().prod()) return false;
  const Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 3, 1> weights =
      -square.ldlt().solve(E.transpose() * result.of[0].w);
  for (int i = 0; i < edges; ++i) {
    if (weights[i] <= 0.0) return false;
    result.weight[static_cast<std::size_t>(i) + 1] = weights[i];
    result.weight[0] -= weights[i];
  }
  return result.weight[0] > 0.0;
}

/// The corners between which the nearest point to the origin is. The last corner is one of them, unless rounding
/// hides it.
Simplex NearestOf(const Simplex& simplex) {
  Simplex best, candidate;
  double nearest = std::numeric_limits<double>::infinity();
  const unsigned last = 1U << (simplex.size - 1);
  for (unsigned subset = last; subset < 2 * last; ++subset) {
    if (!NearestOfSubset(simplex, subset, candidate)) continue;
    const double distance = candidate.Point().squaredNorm();
    if (distance < nearest) nearest = distance, best = candidate;
  }
  return best;
}

/// The simplex that contains the point of the differences nearest to the origin. It may have four corners; then the
/// origin is inside.
Simplex Gilbert(const Differences& differences, const Vector3& towards_W) {
  constexpr int kMost = 100;
  Simplex simplex;
  simplex.of[0] = differences.Farthest(-towards_W);
  simplex.weight[0] = 1.0;
  simplex.size = 1;
  for (int i = 0; i < kMost && simplex.size < 4; ++i) {
    const Vector3 v = simplex.Point();
    const double distance = v.norm();
    if (distance < kExact) break;
    const Difference next = differences.Farthest(-v);
    if (distance - v.dot(next.w) / distance <= 0.1 * kExact) break;
    Simplex larger = simplex;
    larger.of[larger.Count()] = next;
    ++larger.size;
    const Simplex nearest = NearestOf(larger);
    if (nearest.Point().norm() >= distance) break;  // by rounding
    simplex = nearest;
  }
  return simplex;
}

/// A triangle of the polytope, with its outward normal and its distance from the origin.
struct PolytopeFacet {
  std::array<std::size_t, 3> corner;
  Vector3 n;
  double height;
};

/// The expanding polytope inside the differences, around the origin.
class Polytope {
 public:
  explicit Polytope(const Differences& differences) : differences_(differences) {}

  /// Starts from a simplex that contains the origin. @return false if all differences are in a plane; `flat_n` is then
  /// a normal of it.
  bool Start(const Simplex& simplex, Vector3& flat_n);
  /// The facet that is nearest to the origin when the polytope has grown as far as it can.
  const PolytopeFacet& Grow();
  /// Corners of the facet that contains the point nearest to the origin, of all facets in the plane of one.
  Simplex NearestCorners(const PolytopeFacet& of) const;

 private:
  /// Adds a corner away from the others along either sense of a direction.
  bool AddAlong(const Vector3& direction) {
    constexpr double kFlat = 1e-9;  // [m]
    for (const double sign : {1.0, -1.0}) {
      const Difference next = differences_.Farthest(sign * direction);
      if (std::abs((next.w - corners_.front().w).dot(direction)) < kFlat) continue;
      corners_.push_back(next);
      return true;
    }
    return false;
  }
  void AddFacet(std::size_t a, std::size_t b, std::size_t c) {
    PolytopeFacet facet{{a, b, c}, Vector3::Zero(), std::numeric_limits<double>::infinity()};
    const Vector3 &w = corners_[a].w, normal = (corners_[b].w - w).cross(corners_[c].w - w);
    if (normal.norm() > 1e-18) {  // a facet without area is never the nearest
      facet.n = normal.normalized();
      facet.height = facet.n.dot(w);
    }
    facets_.push_back(facet);
  }
  void Replace(const Difference& next);

  const Differences& differences_;
  std::vector<Difference> corners_;
  std::vector<PolytopeFacet> facets_;
};

bool Polytope::Start(const Simplex& simplex, Vector3& flat_n) {
  corners_.assign(simplex.of.begin(), simplex.of.begin() + simplex.size);
  const auto edge = [&](std::size_t i) -> Vector3 { return corners_[i].w - corners_[0].w; };
  flat_n = Vector3::UnitZ();
  for (Eigen::Index axis = 0; corners_.size() < 2 && axis < 3; ++axis) AddAlong(Vector3::Unit(axis));
  if (corners_.size() < 2) return false;
  if (corners_.size() == 2) {
    const Vector3 along = edge(1).normalized();
    Eigen::Index least = 0;
    along.cwiseAbs().minCoeff(&least);
    const Vector3 perpendicular = along.cross(Vector3::Unit(least)).normalized();
    flat_n = perpendicular;
    if (!AddAlong(perpendicular) && !AddAlong(along.cross(perpendicular))) return false;
  }
  if (corners_.size() == 3) {
    flat_n = edge(1).cross(edge(2)).normalized();
    if (!AddAlong(flat_n)) return false;
  }
  if (edge(1).cross(edge(2)).dot(edge(3)) > 0.0) std::swap(corners_[1], corners_[2]);
  AddFacet(0, 1, 2);
  AddFacet(0, 2, 3);
  AddFacet(0, 3, 1);
  AddFacet(1, 3, 2);
  return true;
}

/// Replaces the facets that see a new corner by those that connect their border to it.
void Polytope::Replace(const Difference& next) {
  constexpr double kInside = 1e-14;
  std::vector<std::pair<std::size_t, std::size_t>> border;
  const auto sees = [&](const PolytopeFacet& facet) {
    if (facet.n.dot(next.w - corners_[facet.corner[0]].w) <= kInside) return false;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::pair<std::size_t, std::size_t> edge{facet.corner[i], facet.corner[(i + 1) % 3]};
      const auto twin = std::find(border.begin(), border.end(), std::pair(edge.second, edge.first));
      if (twin != border.end())
        border.erase(twin);
      else
        border.push_back(edge);
    }
    return true;
  };
  std::erase_if(facets_, sees);
  corners_.push_back(next);
  for (const auto& edge : border) AddFacet(edge.first, edge.second, corners_.size() - 1);
}

const PolytopeFacet& Polytope::Grow() {
  constexpr int kMost = 200;
  const auto nearest = [&]() -> const PolytopeFacet& {
    return *std::min_element(facets_.begin(), facets_.end(),
                             [](const PolytopeFacet& a, const PolytopeFacet& b) { return a.height < b.height; });
  };
  for (int i = 0; i < kMost; ++i) {
    const PolytopeFacet& facet = nearest();
    const Difference next = differences_.Farthest(facet.n);
    if (next.w.dot(facet.n) - facet.height <= kExact) break;
    Replace(next);
  }
  return nearest();
}

Simplex Polytope::NearestCorners(const PolytopeFacet& of) const {
  constexpr double kParallel = 1e-9;
  Simplex best, candidate;
  candidate.size = 3;
  double inside = -std::numeric_limits<double>::infinity();
  for (const PolytopeFacet& facet : facets_) {
    if (facet.height > of.height + kExact || facet.n.dot(of.n) < 1.0 - kParallel) continue;
    const Vector3 at = facet.height * facet.n;
    double area = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
      candidate.of[i] = corners_[facet.corner[i]];
      const Vector3 &next = corners_[facet.corner[(i + 1) % 3]].w, &last = corners_[facet.corner[(i + 2) % 3]].w;
      candidate.weight[i] = facet.n.dot((next - at).cross(last - at));
      area += candidate.weight[i];
    }
    const double least = *std::min_element(candidate.weight.begin(), candidate.weight.begin() + 3) / area;
    if (least <= inside) continue;
    inside = least;
    best = candidate;
  }
  double sum = 0.0;
  for (double& weight : best.weight) sum += weight = std::max(0.0, weight);
  for (double& weight : best.weight) weight /= sum;
  return best;
}

/// Witness points for weights of differences.
void SetWitnesses(const std::array<Difference, 4>& of, const std::array<double, 4>& weight, ConvexDistance& result) {
  result.p_WA = result.p_WB = Vector3::Zero();
  for (std::size_t i = 0; i < 4; ++i) {
    if (weight[i] == 0.0) continue;
    result.p_WA += weight[i] * of[i].p_WA;
    result.p_WB += weight[i] * of[i].p_WB;
  }
}

/// Cores that overlap.
ConvexDistance Overlapping(const Differences& differences, const Simplex& simplex) {
  ConvexDistance result;
  Polytope polytope(differences);
  if (!polytope.Start(simplex, result.n_W)) {
    SetWitnesses(simplex.of, simplex.weight, result);
    return result;
  }
  const PolytopeFacet& facet = polytope.Grow();
  result.distance_m = -facet.height;
  result.n_W = -facet.n;
  const Simplex nearest = polytope.NearestCorners(facet);
  SetWitnesses(nearest.of, nearest.weight, result);
  return result;
}

}  // namespace

ConvexDistance DistanceOf(const Shape& A, const Pose& X_WA, const Shape& B, const Pose& X_WB) {
  const Differences differences{{A, X_WA}, {B, X_WB}};
  const Vector3 apart_W = X_WB.translation() - X_WA.translation();
  const Simplex simplex = Gilbert(differences, apart_W);
  ConvexDistance result;
  const Vector3 v = simplex.Point();
  if (simplex.size == 4 || v.norm() < kExact) {
    result = Overlapping(differences, simplex);
  } else {
    result.distance_m = v.norm();
    result.n_W = v / result.distance_m;
    SetWitnesses(simplex.of, simplex.weight, result);
  }
  const double ball_a = differences.A.ball_m(), ball_b = differences.B.ball_m();
  result.distance_m -= ball_a + ball_b;
  result.p_WA += ball_a * result.n_W;
  result.p_WB -= ball_b * result.n_W;
  return result;
}

}  // namespace gaitwright
