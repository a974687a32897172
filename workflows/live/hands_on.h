// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "playback/control/gains.h"
#include "playback/engine/world.h"

namespace gaitwright {

/// Whose hand it is: the number of a page.
using HandId = std::uint64_t;

/// How hands pull.
struct PullSpring {
  double n_per_m = 0.0;
  double most_n = 0.0;  ///< never harder than that
};

/// Two weights of the robot for each leg length, and at most two weights.
PullSpring PullSpringFor(const RobotModel& model);

/// A hand that holds the robot and pulls.
struct Grip {
  HandId hand = 0;
  int body = 0;
  Vector3 p_Body = Vector3::Zero();    ///< where it holds
  Vector3 by_W = Vector3::Zero();      ///< how far it pulls from where it took hold
  bool along = false;                  ///< where it took hold goes with the walk that the robot is told
  std::optional<Vector3> from_W = {};  ///< where it took hold, once it has
  Vector3 force_W = Vector3::Zero();   ///< in the last step [N]
};

/// What people do to a robot by hand while it goes on: pulling at it, pushing it, moving what a joint is told.
class HandsOn {
 public:
  static constexpr std::size_t kMostGrips = 8;

  /// The model must outlive it.
  explicit HandsOn(const RobotModel& model) : model_(model), spring_(PullSpringFor(model)) {}

  /// A spring from a point of a body, which goes with it, to a hand that is so far from where it took hold of it, until
  /// it lets go. A hand pulls at one place at a time, and takes hold anew where that is another.
  /// @param along  the hand walks beside the robot, as told by `GoAlong`.
  /// @throws InvalidArgument for no such body, numbers that are none, and more hands than kMostGrips.
  void Pull(HandId hand, int body, const Vector3& p_Body, const Vector3& by_W, bool along = false);
  void LetGo(HandId hand);
  /// The robot was told to walk so far.
  void GoAlong(const Vector3& way_W);
  const std::vector<Grip>& grips() const { return grips_; }
  /// A force [N] on the base up to a time. @throws InvalidArgument for more than ten weights.
  void Push(const Vector3& force_W, double until_s);
  /// Tells a joint to be so much [rad] or [m] elsewhere up to a time, and holds it by its gains: to see how it answers.
  /// @throws InvalidArgument for no such joint, and for more than a radian or 0.3 m.
  void Nudge(int dof, double by, double until_s);
  /// Nothing of all that any more.
  void Off();

  /// Adds all of it to the coming step.
  void Apply(double time_s, const Gains& gains, World& world, JointCommand& command);
  /// The force of a push in the last step [N]; nothing where there was none.
  std::optional<Vector3> push_W() const { return pushed_ ? std::optional(pushed_->force_W) : std::nullopt; }

 private:
  struct Pushed {
    Vector3 force_W;
    double until_s = 0.0;
  };
  struct Nudged {
    int dof = 0;
    double by = 0.0, until_s = 0.0;
    std::optional<double> from;  ///< where it was, once it has begun
  };
  static void Apply(Nudged& nudged, const World& world, const Gains& gains, JointCommand& command);

  const RobotModel& model_;
  const PullSpring spring_;
  std::vector<Grip> grips_;
  std::optional<Pushed> pushed_;
  std::optional<Nudged> nudged_;
};

}  // namespace gaitwright
