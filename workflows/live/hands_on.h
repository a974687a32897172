// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "playback/bullet/world.h"
#include "playback/control/gains.h"

namespace gaitwright {

/// What people do to a robot by hand while it goes on: pulling at it, pushing it, moving what a joint is told.
class HandsOn {
 public:
  /// The model must outlive it.
  explicit HandsOn(const RobotModel& model) : model_(model) {}

  /// A force at a point of a body that goes with it, until it is let go: a spring to where it is pulled, two weights of
  /// the robot for each leg length and never more than two weights.
  /// @throws InvalidArgument for no such body, and numbers that are none.
  void Pull(int body, const Vector3& p_Body, const Vector3& to_W);
  void LetGo();
  bool pulls() const { return pulled_.has_value(); }
  /// A force [N] on the base up to a time. @throws InvalidArgument for more than ten weights.
  void Push(const Vector3& force_W, double until_s);
  /// Tells a joint to be so much [rad] or [m] elsewhere up to a time, and holds it by its gains: to see how it answers.
  /// @throws InvalidArgument for no such joint, and for more than a radian or 0.3 m.
  void Nudge(int dof, double by, double until_s);
  /// Nothing of all that any more.
  void Off();

  /// Adds all of it to the coming step.
  void Apply(double time_s, const Gains& gains, BulletWorld& world, JointCommand& command);
  /// The force of pull and push in the last step [N]; nothing where there was none.
  const std::optional<Vector3>& force_W() const { return force_W_; }

 private:
  struct Pulled {
    int body = 0;
    Vector3 p_Body, to_W;
  };
  struct Pushed {
    Vector3 force_W;
    double until_s = 0.0;
  };
  struct Nudged {
    int dof = 0;
    double by = 0.0, until_s = 0.0;
    std::optional<double> from;  ///< where it was, once it has begun
  };
  static void Apply(Nudged& nudged, const BulletWorld& world, const Gains& gains, JointCommand& command);
  void Add(const Vector3& force_W);

  const RobotModel& model_;
  std::optional<Pulled> pulled_;
  std::optional<Pushed> pushed_;
  std::optional<Nudged> nudged_;
  std::optional<Vector3> force_W_;
};

}  // namespace gaitwright
