// SPDX-License-Identifier: BSD-3-Clause
// The base of a walk is removed and derived again from its feet.
#include "workflows/exchange/derive_base.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/playback/played.h"

namespace gaitwright {
namespace {

EvenMotion WithoutBase(const synthetic::Played& walker, bool contacts) {
  EvenMotion motion;
  const WholeBodyTrajectory& body = walker.plan.whole_body;
  motion.step_s = body.step_s;
  motion.q = body.q;
  motion.v = body.v;
  motion.a = body.a;
  for (std::size_t k = 0; k < motion.q.size(); ++k) {
    motion.q[k].head<7>() << 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0;
    motion.v[k].head<6>().setZero();
    motion.a[k].head<6>().setZero();
    if (contacts) motion.contact.push_back(walker.log.samples[k].contact);
  }
  return motion;
}

/// Distance of the derived base from the plan's base, both relative to their start.
double FarthestBase(const synthetic::Played& walker, const EvenMotion& motion) {
  double farthest = 0.0;
  const std::vector<VectorX>& q = walker.plan.whole_body.q;
  for (std::size_t k = 0; k < q.size(); ++k) {
    const Vector3 moved = motion.q[k].head<3>() - motion.q[0].head<3>(), planned = q[k].head<3>() - q[0].head<3>();
    farthest = std::max(farthest, (moved - planned).norm());
  }
  return farthest;
}

TEST(DeriveBase, OfAWalkIsThePlannedOneByItsContacts) {
  const synthetic::Played walker = synthetic::Walked(4, {.count = 4});
  EvenMotion motion = WithoutBase(walker, true);
  std::vector<DerivedPart> derived;
  DeriveBase(walker.model, walker.plan.terrain, {}, false, motion, derived);
  EXPECT_LT(FarthestBase(walker, motion), 0.01) << "of 0.2 m of travel";
  EXPECT_NEAR(motion.q[0][2], synthetic::kHeight, 1e-3) << "its lowest feet are on the ground";
  for (const VectorX& q : motion.q) EXPECT_NEAR(q.segment<4>(3).norm(), 1.0, 1e-9);
  for (const VectorX& q : motion.q) EXPECT_GT(std::abs(q[6]), 0.999) << "it stays upright";
  ASSERT_EQ(derived.size(), 1U);
  EXPECT_EQ(derived[0].what, "pose of the base");
}

TEST(DeriveBase, WithoutContactsItsLowFeetAreTakenToStand) {
  const synthetic::Played walker = synthetic::Walked(4, {.count = 4});
  EvenMotion motion = WithoutBase(walker, false);
  std::vector<DerivedPart> derived;
  DeriveBase(walker.model, walker.plan.terrain, {}, false, motion, derived);
  EXPECT_LT(FarthestBase(walker, motion), 0.03);
  EXPECT_NEAR(motion.q.back()[2], synthetic::kHeight, 0.01);
}

/// The derived speeds are the derivatives of the positions.
TEST(DeriveBase, SpeedsAreTheDifferencesOfPositions) {
  const synthetic::Played walker = synthetic::Walked(4, {.count = 2});
  EvenMotion motion = WithoutBase(walker, true);
  std::vector<DerivedPart> derived;
  DeriveBase(walker.model, walker.plan.terrain, {}, false, motion, derived);
  double fastest = 0.0;
  for (std::size_t k = 1; k + 1 < motion.q.size(); ++k) {
    const Vector3 difference = (motion.q[k + 1].head<3>() - motion.q[k - 1].head<3>()) / (2.0 * motion.step_s);
    EXPECT_LT((motion.v[k].head<3>() - difference).norm(), 5e-3) << k;
    fastest = std::max(fastest, difference.norm());
  }
  EXPECT_GT(fastest, 0.05);
}

TEST(DeriveBase, AGivenRotationIsKept) {
  const synthetic::Played walker = synthetic::Walked(4, {.count = 2});
  EvenMotion motion = WithoutBase(walker, true);
  std::vector<DerivedPart> derived;
  DeriveBase(walker.model, walker.plan.terrain, {}, true, motion, derived);
  for (const VectorX& q : motion.q) EXPECT_LT((q.segment<4>(3) - Eigen::Vector4d(0, 0, 0, 1)).norm(), 1e-9);
  EXPECT_LT(FarthestBase(walker, motion), 0.01);
  EXPECT_EQ(derived.at(0).what, "position of the base");
}

TEST(DeriveBase, ALiftRaisesEveryRowAlike) {
  const synthetic::Played walker = synthetic::Walked(4, {.count = 2});
  EvenMotion as_is = WithoutBase(walker, true), lifted = as_is;
  std::vector<DerivedPart> derived;
  DeriveBase(walker.model, walker.plan.terrain, {}, false, as_is, derived);
  ImportOptions options;
  options.lift_m = 0.125;
  DeriveBase(walker.model, walker.plan.terrain, options, false, lifted, derived);
  for (std::size_t k = 0; k < as_is.q.size(); ++k)
    EXPECT_LT((lifted.q[k] - as_is.q[k] - 0.125 * VectorX::Unit(as_is.q[k].size(), 2)).norm(), 1e-12);
}

}  // namespace
}  // namespace gaitwright
