// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/numerics/affine_vector.h"

#include <gtest/gtest.h>

#include "tests/optimisation/numerics/derivative_check.h"

namespace gaitwright {
namespace {

const VectorX kTen = VectorX::LinSpaced(10, 1.0, 10.0);

TEST(AffineVector, IsItsConstantAndItsPartsOfTheUnknowns) {
  const AffineVector v{{0.5, 0.0, -0.5}, {{1, 2.0}, {6, -1.0}}};
  EXPECT_LT((v.At(kTen) - Vector3(0.5 + 4.0 - 7.0, 6.0 - 8.0, -0.5 + 8.0 - 9.0)).norm(), 1e-12);
  EXPECT_LT((AffineVector::Unknown(3).At(kTen) - Vector3(4.0, 5.0, 6.0)).norm(), 1e-12);
}

TEST(AffineVector, SumsAreSumsOfValuesAndNameEachUnknownOnce) {
  AffineVector sum{{1.0, 2.0, 3.0}, {{6, 0.5}}};
  const AffineVector other{{0.1, 0.2, 0.3}, {{0, 1.5}, {6, 2.0}}};
  const Vector3 expected = sum.At(kTen) - 3.0 * other.At(kTen);
  sum.Add(-3.0, other);
  EXPECT_LT((sum.At(kTen) - expected).norm(), 1e-12);
  ASSERT_EQ(sum.parts.size(), 2U);
  EXPECT_EQ(sum.parts[0].start, 0);
  EXPECT_EQ(sum.parts[1].start, 6);
}

TEST(SeenUnknowns, GivesEachItsPlaceOnce) {
  SeenUnknowns seen;
  const AffineVector first = seen.See(AffineVector{{}, {{3, 1.0}, {6, 2.0}}}),
                     again = seen.See(AffineVector{{}, {{6, 4.0}}});
  EXPECT_EQ(seen.See(1, 2), 6);
  EXPECT_EQ(seen.variables(), (std::vector<int>{3, 4, 5, 6, 7, 8, 1, 2}));
  EXPECT_EQ(first.parts[1].start, again.parts[0].start);
}

TEST(AffineRows, AreDirectionsOfTheVectorWithTheirDerivative) {
  SeenUnknowns seen;
  const AffineVector v{{1.0, 0.0, 0.0}, {{2, 2.0}, {7, -0.5}}};
  MatrixX directions(2, 3);
  directions << 1.0, 2.0, 3.0, 0.0, -1.0, 0.5;
  const VectorFunction rows = AffineRows(v, directions, Vector2(0.25, 0.5), seen);
  VectorX own(6), value;
  for (Eigen::Index i = 0; i < 6; ++i) own[i] = kTen[seen.variables()[static_cast<std::size_t>(i)]];
  rows(own, value, nullptr);
  EXPECT_LT((value - (directions * v.At(kTen) - Vector2(0.25, 0.5))).norm(), 1e-12);
  ExpectDerivative(rows, own);
}

}  // namespace
}  // namespace gaitwright
