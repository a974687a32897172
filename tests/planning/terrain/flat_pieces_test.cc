// SPDX-License-Identifier: BSD-3-Clause
#include "planning/terrain/flat_pieces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "kinematics/spatial/convex_hull.h"
#include "kinematics/stability/polygon.h"

namespace gaitwright {
namespace {

/// Adds a rectangle of two triangles with separate corners that rises along x.
void AddFlatRectangle(Mesh& mesh, const Vector2& low, const Vector2& high, double height_m, double rise_m = 0.0) {
  const int first = static_cast<int>(mesh.vertices.size());
  mesh.vertices.emplace_back(low.x(), low.y(), height_m);
  mesh.vertices.emplace_back(high.x(), low.y(), height_m + rise_m);
  mesh.vertices.emplace_back(high.x(), high.y(), height_m + rise_m);
  mesh.vertices.emplace_back(low.x(), high.y(), height_m);
  mesh.triangles.emplace_back(first, first + 1, first + 2);
  mesh.triangles.emplace_back(first, first + 2, first + 3);
}

Polygon PlanOfPiece(const FlatPiece& piece) {
  Polygon plan;
  for (const Vector3& corner : piece.corners) plan.emplace_back(corner.head<2>());
  return plan;
}

double AreaOfAll(const std::vector<FlatPiece>& pieces) {
  double area = 0.0;
  for (const FlatPiece& piece : pieces) area += Area(PlanOfPiece(piece));
  return area;
}

constexpr double kSteep = 0.6;  // [rad]

TEST(FlatPiecesOfMesh, TwoTrianglesOfARectangleAreOnePiece) {
  Mesh mesh;
  AddFlatRectangle(mesh, {0.0, 0.0}, {2.0, 1.0}, 0.3);
  const std::vector<FlatPiece> pieces = FlatPieces(mesh, kSteep);
  ASSERT_EQ(pieces.size(), 1U);
  EXPECT_EQ(pieces[0].corners.size(), 4U);
  EXPECT_EQ(pieces[0].triangles.size(), 2U);
  EXPECT_NEAR(Area(PlanOfPiece(pieces[0])), 2.0, 1e-12) << "counter-clockwise from above";
  for (const Vector3& corner : pieces[0].corners) EXPECT_EQ(corner.z(), 0.3);
}

TEST(FlatPiecesOfMesh, NeighboursInOnePlaneAreJoinedThoughTheirCornersAreTheirOwn) {
  Mesh mesh;
  AddFlatRectangle(mesh, {0.0, 0.0}, {1.0, 1.0}, 0.0);
  AddFlatRectangle(mesh, {1.0, 0.0}, {2.0, 1.0}, 0.0);
  const std::vector<FlatPiece> pieces = FlatPieces(mesh, kSteep);
  ASSERT_EQ(pieces.size(), 1U);
  EXPECT_EQ(pieces[0].corners.size(), 4U) << "no corners in the middle of an edge";
  EXPECT_NEAR(AreaOfAll(pieces), 2.0, 1e-12);
}

TEST(FlatPiecesOfMesh, AStepOrAGapPartsThem) {
  for (const double height_m : {0.0, 0.05}) {
    Mesh mesh;
    AddFlatRectangle(mesh, {0.0, 0.0}, {1.0, 1.0}, 0.0);
    AddFlatRectangle(mesh, {height_m > 0.0 ? 1.0 : 1.01, 0.0}, {2.0, 1.0}, height_m);
    EXPECT_EQ(FlatPieces(mesh, kSteep).size(), 2U) << height_m;
  }
}

TEST(FlatPiecesOfMesh, ASlopeIsAPieceOfItsOwnUntilItIsTooSteep) {
  Mesh mesh;
  AddFlatRectangle(mesh, {0.0, 0.0}, {1.0, 1.0}, 0.0);
  AddFlatRectangle(mesh, {1.0, 0.0}, {2.0, 1.0}, 0.0, std::tan(0.3));
  EXPECT_EQ(FlatPieces(mesh, 0.31).size(), 2U);
  const std::vector<FlatPiece> level = FlatPieces(mesh, 0.29);
  ASSERT_EQ(level.size(), 1U);
  for (const Vector3& corner : level[0].corners) EXPECT_EQ(corner.z(), 0.0);
}

TEST(FlatPiecesOfMesh, WhatFacesDownOrHasNoAreaIsNone) {
  Mesh mesh;
  AddFlatRectangle(mesh, {0.0, 0.0}, {1.0, 1.0}, 0.0);
  for (Eigen::Vector3i& triangle : mesh.triangles) std::swap(triangle[0], triangle[1]);
  EXPECT_TRUE(FlatPieces(mesh, kSteep).empty());
  mesh.triangles = {{0, 1, 1}};
  EXPECT_TRUE(FlatPieces(mesh, kSteep).empty());
  EXPECT_TRUE(FlatPieces({}, kSteep).empty());
}

TEST(FlatPiecesOfMesh, AnLIsCutIntoConvexPiecesThatFillIt) {
  Mesh mesh;
  AddFlatRectangle(mesh, {0.0, 0.0}, {1.0, 1.0}, 0.2);
  AddFlatRectangle(mesh, {1.0, 0.0}, {2.0, 1.0}, 0.2);
  AddFlatRectangle(mesh, {0.0, 1.0}, {1.0, 2.0}, 0.2);
  const std::vector<FlatPiece> pieces = FlatPieces(mesh, kSteep);
  EXPECT_GE(pieces.size(), 2U);
  EXPECT_LE(pieces.size(), 3U);
  EXPECT_NEAR(AreaOfAll(pieces), 3.0, 1e-9);
  std::multiset<int> triangles;
  for (const FlatPiece& piece : pieces) {
    EXPECT_NEAR(ShareOfHull(PlanOfPiece(piece)), 1.0, 1e-9) << "convex";
    triangles.insert(piece.triangles.begin(), piece.triangles.end());
  }
  EXPECT_EQ(triangles, (std::multiset<int>{0, 1, 2, 3, 4, 5})) << "each triangle once";
}

TEST(FlatPiecesOfMesh, ARingAroundAHoleLeavesTheHoleOpen) {
  Mesh mesh;
  for (int column = 0; column < 3; ++column) {
    for (int row = 0; row < 3; ++row) {
      const Vector2 low(column, row);
      if (column != 1 || row != 1) AddFlatRectangle(mesh, low, low + Vector2::Ones(), 0.0);
    }
  }
  const std::vector<FlatPiece> pieces = FlatPieces(mesh, kSteep);
  EXPECT_NEAR(AreaOfAll(pieces), 8.0, 1e-9);
  for (const FlatPiece& piece : pieces)
    EXPECT_LE(SignedDistance(PlanOfPiece(piece), {1.5, 1.5}), 1e-9) << "nothing covers the middle of the hole";
}

TEST(FlatPiecesOfMesh, DoNotDependOnWhereTheMeshIsNorOnTheOrderOfItsTriangles) {
  Mesh mesh;
  AddFlatRectangle(mesh, {0.0, 0.0}, {1.0, 1.0}, 0.0);
  AddFlatRectangle(mesh, {1.0, 0.0}, {2.0, 1.0}, 0.0);
  AddFlatRectangle(mesh, {2.0, 0.0}, {3.0, 1.0}, 0.0, 0.2);
  Mesh moved = mesh;
  std::reverse(moved.triangles.begin(), moved.triangles.end());
  for (Vector3& vertex : moved.vertices) vertex += Vector3(-7.0, 3.0, 1.5);
  const std::vector<FlatPiece> here = FlatPieces(mesh, kSteep), there = FlatPieces(moved, kSteep);
  ASSERT_EQ(here.size(), 2U);
  ASSERT_EQ(there.size(), 2U);
  EXPECT_NEAR(AreaOfAll(here), AreaOfAll(there), 1e-9);
}

}  // namespace
}  // namespace gaitwright
