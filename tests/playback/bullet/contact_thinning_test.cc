// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <limits>

#include "playback/bullet/contact_thinning_internal.h"

namespace gaitwright::bullet {
namespace {

/// A lattice of 7 by 5 points, 0.02 m apart, over a ground given as a function.
template <typename Ground>
std::vector<Gap> Lattice(const Ground& ground) {
  std::vector<Gap> points;
  for (int i = -3; i <= 3; ++i) {
    for (int k = -2; k <= 2; ++k) {
      const Vector2 place(0.02 * i, 0.02 * k);
      points.push_back({place, -ground(place)});
    }
  }
  return points;
}

int Count(const std::vector<bool>& kept) { return static_cast<int>(std::count(kept.begin(), kept.end(), true)); }

/// Gap of the lower hull of the kept points at a place: the best over all their triangles.
double HullGap(const std::vector<Gap>& points, const std::vector<bool>& kept, const Vector2& place) {
  double lowest = std::numeric_limits<double>::infinity();
  const std::size_t n = points.size();
  for (std::size_t a = 0; a < n; ++a) {
    for (std::size_t b = a; b < n; ++b) {
      for (std::size_t c = b; c < n; ++c) {
        if (!kept[a] || !kept[b] || !kept[c]) continue;
        Matrix3 places;
        places.col(0) << points[a].place, 1.0;
        places.col(1) << points[b].place, 1.0;
        places.col(2) << points[c].place, 1.0;
        const Vector3 shares = places.colPivHouseholderQr().solve(Vector3(place.x(), place.y(), 1.0));
        if (shares.minCoeff() < -1e-9 || (places * shares - Vector3(place.x(), place.y(), 1.0)).norm() > 1e-9) continue;
        lowest = std::min(lowest, shares.dot(Vector3(points[a].gap_m, points[b].gap_m, points[c].gap_m)));
      }
    }
  }
  return lowest;
}

TEST(HoldingPoints, OfASoleOnAPlaneAreItsCorners) {
  const std::vector<Gap> points = Lattice([](const Vector2&) { return 1e-4; });
  const std::vector<bool> kept = HoldingPoints(points);
  EXPECT_EQ(Count(kept), 4);
  for (std::size_t k = 0; k < points.size(); ++k)
    EXPECT_EQ(kept[k], std::abs(points[k].place.x()) > 0.05 && std::abs(points[k].place.y()) > 0.03) << k;
}

TEST(HoldingPoints, OverAHollowAreItsCorners) {
  const auto hollow = [](const Vector2& p) { return p.squaredNorm(); };
  const std::vector<bool> kept = HoldingPoints(Lattice(hollow));
  EXPECT_EQ(Count(kept), 4);
}

TEST(HoldingPoints, IncludeTheTopOfABump) {
  const std::vector<Gap> points = Lattice([](const Vector2& p) { return -p.squaredNorm(); });
  EXPECT_TRUE(HoldingPoints(points)[points.size() / 2]);
}

TEST(HoldingPoints, HoldEveryOtherToAHundredthOfAMillimetre) {
  const std::vector<Gap> points = Lattice(
      [](const Vector2& p) { return 1e-3 * std::sin(70.0 * p.x() + 1.0) * std::cos(50.0 * p.y()) + 0.02 * p.x(); });
  const std::vector<bool> kept = HoldingPoints(points);
  EXPECT_LT(Count(kept), static_cast<int>(points.size()));
  for (const Gap& point : points) EXPECT_GE(point.gap_m, HullGap(points, kept, point.place) - 2e-5);
}

TEST(HoldingPoints, AreAllWhereThereAreFew) {
  EXPECT_EQ(Count(HoldingPoints({})), 0);
  EXPECT_EQ(Count(HoldingPoints({{Vector2::Zero(), 0.1}})), 1);
  EXPECT_EQ(Count(HoldingPoints({{Vector2::Zero(), 0.0}, {Vector2::UnitX(), 0.0}})), 2);
}

}  // namespace
}  // namespace gaitwright::bullet
