// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/centroidal/body_limits.h"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

namespace gaitwright {
namespace {

constexpr double kSame = 1e-6;  // [s]

/// Distance from the origin to the farthest point of a polytope [m]. That is one of the corners, in which three sides
/// meet; for an unbounded polytope, a corner of a box around all legs.
double FarthestOf(std::vector<WorkspaceSide> sides) {
  constexpr double kSlack = 1e-9, kWithoutEnd = 100.0;
  const std::vector<WorkspaceSide> box = BoxAbout(Vector3::Zero(), Vector3::Constant(kWithoutEnd));
  sides.insert(sides.end(), box.begin(), box.end());
  double farthest = 0.0;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    for (std::size_t j = i + 1; j < sides.size(); ++j) {
      for (std::size_t k = j + 1; k < sides.size(); ++k) {
        Matrix3 normals;
        normals << sides[i].normal.transpose(), sides[j].normal.transpose(), sides[k].normal.transpose();
        if (std::abs(normals.determinant()) < 1e-6) continue;
        const Vector3 corner = normals.inverse() * Vector3(sides[i].offset, sides[j].offset, sides[k].offset);
        const bool inside = std::all_of(sides.begin(), sides.end(), [&](const WorkspaceSide& side) {
          return side.normal.dot(corner) <= side.offset + kSlack;
        });
        if (inside) farthest = std::max(farthest, corner.norm());
      }
    }
  }
  return farthest;
}

/// A time interval during which at least one foot is on the ground.
struct Support {
  double start_s = 0.0, end_s = 0.0;
  double most_n = 0.0;                                        // largest total force of its feet
  double lowest_m = std::numeric_limits<double>::infinity();  // lowest foothold
  double highest_m = -lowest_m;                               // largest height of the centre of mass above a foothold
  double leaves_m = std::numeric_limits<double>::infinity();  // the same for the feet that leave last
  double lands_m = -lowest_m;                                 // highest foothold of the feet that land first
};

class Limits {
 public:
  explicit Limits(const RigidBodyProblem& problem) : problem_(problem) {
    for (const RigidFoot& foot : problem.feet) reach_m_.push_back(FarthestOf(foot.workspace_B));
    std::vector<const RigidStance*> stances;
    for (const RigidStance& stance : problem.stances) stances.push_back(&stance);
    std::sort(stances.begin(), stances.end(), [](const auto* a, const auto* b) { return a->start_s < b->start_s; });
    for (const RigidStance* stance : stances) {
      if (supports_.empty() || stance->start_s > supports_.back().end_s + kSame)
        supports_.push_back({stance->start_s, stance->end_s});
      supports_.back().end_s = std::max(supports_.back().end_s, stance->end_s);
    }
    for (Support& support : supports_) Fill(support);
  }

  std::optional<Failure> Flights() {
    double up = 0.0;  // largest upward speed at the start of a support
    for (std::size_t i = 0; i + 1 < supports_.size(); ++i) {
      const Support &from = supports_[i], &to = supports_[i + 1];
      const double flight_s = to.start_s - from.end_s, fall_m = from.leaves_m - to.lands_m;
      const double gains = from.most_n / problem_.mass_kg - kGravity, stroke = from.highest_m - from.lowest_m;
      const double over_stroke = std::sqrt(std::max(0.0, up) * up + std::max(0.0, 2.0 * gains * stroke));
      const double gives = std::min(std::max(up, over_stroke), up + gains * (from.end_s - from.start_s));
      const double takes = 0.5 * kGravity * flight_s - fall_m / flight_s;
      fastest_ = std::max(fastest_, gives);
      if (takes > gives) return TooLong(from, flight_s, takes, gives, fall_m);
      up = gives - kGravity * flight_s;
    }
    return std::nullopt;
  }

  std::optional<Failure> Friction(double use) const {
    double friction = 0.0, reach = 0.0;
    for (const RigidStance& stance : problem_.stances) {
      if (stance.X_WF.linear()(2, 2) < 1.0 - 1e-6) return std::nullopt;
      friction = std::max(friction, stance.friction);
    }
    for (const double of_foot : reach_m_) reach = std::max(reach, of_foot);
    const double distance = (problem_.goal.p_WC - problem_.start.p_WC).head<2>().norm(), t = problem_.duration_s;
    // Also without flight, a body that its legs throw up stops rising within their reach.
    const double up = std::max(fastest_, std::sqrt(2.0 * kGravity * reach));
    const double most = friction * t * (0.25 * kGravity * t + up);
    if (distance <= most) return std::nullopt;
    return Failure{
        FailureKind::kInfeasible,
        FailureCode::kTooLittleFriction,
        "PlanRigidBody",
        fmt::format("moving {:.2f} m from rest to rest in {:.2f} s needs more friction than {:.3g}, which allows at "
                    "most {:.2f} m",
                    distance, t, friction / use, most),
        {fmt::format("a friction of {:.3g} or more", friction / use * distance / most), "give more time",
         "choose a shorter distance"}};
  }

 private:
  void Fill(Support& support) const {
    std::vector<double> most_n(problem_.feet.size(), 0.0);  // upward
    for (const RigidStance& stance : problem_.stances) {
      if (stance.end_s < support.start_s - kSame || stance.start_s > support.end_s + kSame) continue;
      const auto foot = static_cast<std::size_t>(stance.foot);
      const RigidFoot& described = problem_.feet[foot];
      const double height = stance.X_WF.translation().z(), highest = height + reach_m_[foot];
      support.lowest_m = std::min(support.lowest_m, height);
      support.highest_m = std::max(support.highest_m, highest);
      if (stance.end_s > support.end_s - kSame) support.leaves_m = std::min(support.leaves_m, highest);
      if (stance.start_s < support.start_s + kSame) support.lands_m = std::max(support.lands_m, height);
      const Vector3 normal_W = stance.X_WF.linear().col(2);
      const double upward = normal_W.z() + stance.friction * normal_W.head<2>().norm();
      most_n[foot] =
          std::max(most_n[foot], upward * described.force_max_n * static_cast<double>(described.contacts_F.size()));
    }
    support.most_n = std::accumulate(most_n.begin(), most_n.end(), 0.0);
  }

  Failure TooLong(const Support& from, double flight_s, double takes, double gives, double fall_m) const {
    const double most_s = (gives + std::sqrt(std::max(0.0, gives * gives + 2.0 * kGravity * fall_m))) / kGravity;
    std::vector<Suggestion> suggestions = {"a shorter cycle", "a larger duty factor"};
    if (most_s > 0.0) suggestions.insert(suggestions.begin(), fmt::format("flights of {:.2f} s at most", most_s));
    return {FailureKind::kInfeasible, FailureCode::kFlightTooLong, "PlanRigidBody",
            fmt::format("a flight of {:.2f} s at {:.2f} s needs a lift-off speed of {:.2f} m/s; legs that push with "
                        "{:.0f} N over {:.2f} m and {:.2f} s give a body of {:.1f} kg at most {:.2f} m/s",
                        flight_s, from.end_s, takes, from.most_n, from.highest_m - from.lowest_m,
                        from.end_s - from.start_s, problem_.mass_kg, std::max(0.0, gives)),
            suggestions};
  }

  const RigidBodyProblem& problem_;
  std::vector<double> reach_m_;  // by foot
  std::vector<Support> supports_;
  double fastest_ = 0.0;  // upward
};

}  // namespace

std::optional<Failure> ReasonBeyondLegs(const RigidBodyProblem& problem, double friction_use) {
  CheckRigidBodyProblem(problem);
  Limits limits(problem);
  if (auto failure = limits.Flights()) return failure;
  return limits.Friction(friction_use);
}

}  // namespace gaitwright
