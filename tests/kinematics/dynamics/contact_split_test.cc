// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/dynamics/contact_split.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "kinematics/base/result.h"
#include "tests/kinematics/drawn.h"

namespace gaitwright {
namespace {

std::vector<ContactPoint> Rectangle(double half_x, double half_y) {
  std::vector<ContactPoint> contacts;
  for (const double x : {-half_x, half_x}) {
    for (const double y : {-half_y, half_y}) contacts.push_back({Vector3(x, y, 0.0), Vector3::UnitZ(), 0.6, 1.0});
  }
  return contacts;
}

double ConeViolation(const ContactPoint& contact, const Vector3& force) {
  return force.head<2>().norm() - contact.friction * force.z();
}

TEST(ContactSplit, GivesAWrenchThatTheConesAllow) {
  const auto contacts = Rectangle(0.2, 0.1);
  ContactSplit split;
  ContactSplitter().Solve(contacts, {Vector3(0.05, 0.02, 0.3), Vector3(10.0, -5.0, 100.0), Vector3(1.0, 2.0, 0.5)},
                          split);
  EXPECT_LT(split.residual_force_W.norm(), 1e-5);
  EXPECT_LT(split.residual_moment_W.norm(), 1e-5);
  for (std::size_t i = 0; i < contacts.size(); ++i) EXPECT_LE(ConeViolation(contacts[i], split.force_W[i]), 1e-9);
}

TEST(ContactSplit, StaysInsideTheConesWhenAskedForTooMuch) {
  const auto contacts = Rectangle(0.2, 0.1);
  ContactSplit split;
  ContactSplitter().Solve(contacts, {Vector3::Zero(), Vector3(100.0, 0.0, 100.0), Vector3::Zero()}, split);
  EXPECT_GT(split.residual_force_W.norm(), 1.0);
  for (std::size_t i = 0; i < contacts.size(); ++i) EXPECT_LE(ConeViolation(contacts[i], split.force_W[i]), 1e-9);
}

TEST(ContactSplit, TwoPointsCannotHoldTheMomentAboutTheirLine) {
  const std::vector<ContactPoint> contacts = {{Vector3(0.2, 0.0, 0.0), Vector3::UnitZ(), 0.6, 1.0},
                                              {Vector3(-0.2, 0.0, 0.0), Vector3::UnitZ(), 0.6, 1.0}};
  ContactSplit split;
  ContactSplitter().Solve(contacts, {Vector3::Zero(), Vector3(0.0, 0.0, 100.0), Vector3(3.0, 2.0, 0.0)}, split);
  EXPECT_NEAR(split.residual_moment_W.x(), 3.0, 1e-3);
  EXPECT_NEAR(split.residual_moment_W.y(), 0.0, 1e-3);
  EXPECT_LT(split.residual_force_W.norm(), 1e-3);
}

TEST(ContactSplit, AReluctantFootTakesLittle) {
  auto contacts = Rectangle(0.2, 0.1);
  contacts[3].reluctance = 1e5;
  ContactSplit split;
  ContactSplitter().Solve(contacts, {Vector3(-0.05, -0.02, 0.0), Vector3(0.0, 0.0, 100.0), Vector3::Zero()}, split);
  EXPECT_LT(split.force_W[3].norm(), 0.1);
  EXPECT_LT(split.residual_moment_W.norm(), 1e-4);
}

TEST(ContactSplit, IsContinuousWhereACornerLetsGo) {
  const auto contacts = Rectangle(0.2, 0.1);
  ContactSplitter splitter;
  ContactSplit split;
  std::vector<Vector3> last;
  double largest = 0.0;
  for (int i = 0; i <= 180; ++i) {
    splitter.Solve(contacts, {Vector3(0.001 * i, 0.0005 * i, 0.0), Vector3(5.0, 0.0, 100.0), Vector3::Zero()}, split);
    for (std::size_t c = 0; c < last.size(); ++c) largest = std::max(largest, (split.force_W[c] - last[c]).norm());
    last = split.force_W;
  }
  EXPECT_LT(largest, 1.5);  // [N] for a millimetre
  EXPECT_NEAR(last[0].norm(), 0.0, 1.0);
}

/// An independent solution of the same problem: the forces in their cones that are nearest to the wrench, by projected
/// gradient with momentum (Beck and Teboulle, SIAM J. Imaging Sciences 2(1), 2009). Level ground only.
/// @return the squared error of force and moment; the moment is about the mean of the contacts, over their size.
class Nearest {
 public:
  explicit Nearest(const std::vector<ContactPoint>& contacts) : contacts_(contacts) {
    for (const ContactPoint& contact : contacts) centre_ += contact.p_W / static_cast<double>(contacts.size());
    for (const ContactPoint& contact : contacts) length_ = std::max(length_, (contact.p_W - centre_).norm());
  }
  Vector6 Left(const PointWrench& wanted, const std::vector<Vector3>& force) const {
    Vector3 left = wanted.force_W, moment = wanted.moment_W + (wanted.p_W - centre_).cross(wanted.force_W);
    for (std::size_t i = 0; i < force.size(); ++i) {
      left -= force[i];
      moment -= (contacts_[i].p_W - centre_).cross(force[i]);
    }
    Vector6 all;
    all << left, moment / length_;
    return all;
  }
  double Best(const PointWrench& wanted) const {
    std::vector<Vector3> force(contacts_.size(), Vector3::Zero()), extrapolated = force;
    const double step = 0.5 / static_cast<double>(contacts_.size());
    double momentum = 1.0;
    for (int k = 0; k < 20000; ++k) {
      const Vector6 left = Left(wanted, extrapolated);
      const double next = 0.5 * (1.0 + std::sqrt(1.0 + 4.0 * momentum * momentum));
      for (std::size_t i = 0; i < force.size(); ++i) {
        const Vector3 arm = (contacts_[i].p_W - centre_) / length_;
        const Vector3 moved =
            Projected(extrapolated[i] + step * (left.head<3>() - arm.cross(left.tail<3>())), contacts_[i].friction);
        extrapolated[i] = moved + (momentum - 1.0) / next * (moved - force[i]);
        force[i] = moved;
      }
      momentum = next;
    }
    return Left(wanted, force).squaredNorm();
  }

 private:
  static Vector3 Projected(const Vector3& f, double mu) {
    const double t = f.head<2>().norm();
    if (t <= mu * f.z()) return f;
    if (mu * t <= -f.z()) return Vector3::Zero();
    const double along = (mu * t + f.z()) / (1.0 + mu * mu);
    return {along * mu * f.x() / t, along * mu * f.y() / t, along};
  }

  const std::vector<ContactPoint>& contacts_;
  Vector3 centre_ = Vector3::Zero();
  double length_ = 0.05;
};

TEST(ContactSplit, ComesAsNearAsForcesInTheConesCan) {
  std::mt19937 engine(17);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform;
  int beyond = 0, most_iterations = 0;
  for (int trial = 0; trial < 150; ++trial) {
    std::vector<ContactPoint> contacts;
    const int count = trial % 3 == 0 ? 2 : trial % 3 == 1 ? 4 : 8;
    for (int i = 0; i < count; ++i) {
      const Vector3 place = Vector3(0.2, 0.2, 0.02).cwiseProduct(Drawn<Vector3>(normal, engine));
      contacts.push_back({place, Vector3::UnitZ(), 0.6, std::pow(10.0, 2.0 * uniform(engine))});
    }
    const Vector2 place = 0.1 * Drawn<Vector2>(normal, engine), sideways = 20.0 * Drawn<Vector2>(normal, engine);
    const PointWrench wanted = {Vector3(place.x(), place.y(), 0.3),
                                Vector3(sideways.x(), sideways.y(), 100.0 * uniform(engine)),
                                3.0 * Drawn<Vector3>(normal, engine)};
    ContactSplit split;
    ContactSplitter().Solve(contacts, wanted, split);
    const Nearest nearest(contacts);
    const double best = nearest.Best(wanted), left = nearest.Left(wanted, split.force_W).squaredNorm();
    EXPECT_LE(std::sqrt(left), std::sqrt(best) + 0.01) << trial << ", " << split.iterations << " iterations";
    for (int i = 0; i < count; ++i) {
      EXPECT_LE(ConeViolation(contacts[static_cast<std::size_t>(i)], split.force_W[static_cast<std::size_t>(i)]), 1e-6);
    }
    beyond += static_cast<int>(best > 1.0);
    most_iterations = std::max(most_iterations, split.iterations);
  }
  EXPECT_GT(beyond, 50) << "wrenches that cannot be had";
  EXPECT_LT(beyond, 140);
  EXPECT_LT(most_iterations, 250);
}

TEST(ContactSplit, ALightFootAskedToTurnDoesNotStamp) {
  std::vector<ContactPoint> contacts = Rectangle(0.2, 0.15);
  for (ContactPoint& contact : contacts) contact.friction = 0.72;
  ContactSplit split;
  ContactSplitter().Solve(
      contacts, {Vector3(0.03, 0.1616, 0.634), Vector3(5.57, -0.92, 29.43), Vector3(-1.15, -3.13, 4.53)}, split);
  for (const Vector3& force : split.force_W) EXPECT_LT(force.norm(), 40.0) << force.transpose();
}

TEST(ContactSplit, RefusesNoContact) {
  ContactSplit split;
  EXPECT_THROW(ContactSplitter().Solve({}, {}, split), InvalidArgument);
}

}  // namespace
}  // namespace gaitwright
