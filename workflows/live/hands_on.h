// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "playback/control/gains.h"
#include "playback/engine/world.h"

namespace gaitwright {

/// Owner of a hand: the number of a page.
using HandId = std::uint64_t;

/// Spring of a pulling hand.
struct PullSpring {
  double n_per_m = 0.0;
  double most_n = 0.0;  ///< largest force
};

/// Stiffness of two robot weights per leg length; force of at most two weights.
PullSpring PullSpringFor(const RobotModel& model);

/// A hand that holds and pulls the robot.
struct Grip {
  HandId hand = 0;
  int body = 0;
  Vector3 p_Body = Vector3::Zero();    ///< held point
  Vector3 by_W = Vector3::Zero();      ///< displacement of the hand from its grip point
  bool along = false;                  ///< the grip point moves along with the commanded walk
  std::optional<Vector3> from_W = {};  ///< grip point, once it is known
  Vector3 force_W = Vector3::Zero();   ///< force in the last step [N]
};

/// Manual actions on a running robot: pulls, pushes, and offsets of joint commands.
class HandsOn {
 public:
  static constexpr std::size_t kMostGrips = 8;

  /// The model must outlive this object.
  explicit HandsOn(const RobotModel& model) : model_(model), spring_(PullSpringFor(model)) {}

  /// Pulls a point of a body with a spring to a hand that is displaced from its grip point, until the hand lets go. A
  /// hand pulls at one point at a time; a pull at another point begins a new grip.
  /// @param along  the hand moves along with the robot, see `GoAlong`.
  /// @throws InvalidArgument for an unknown body, values that are not finite, and more hands than kMostGrips.
  void Pull(HandId hand, int body, const Vector3& p_Body, const Vector3& by_W, bool along = false);
  void LetGo(HandId hand);
  /// Moves the hands with `along` by the distance that the robot was commanded to walk.
  void GoAlong(const Vector3& displacement_W);
  const std::vector<Grip>& grips() const { return grips_; }
  /// Applies a force [N] to the base up to a time. @throws InvalidArgument for more than ten weights.
  void Push(const Vector3& force_W, double until_s);
  /// Offsets a joint command by an amount [rad] or [m] up to a time, held by its gains, to show its response.
  /// @throws InvalidArgument for an unknown joint, and for more than 1 rad or 0.3 m.
  void Nudge(int dof, double by, double until_s);
  /// Ends all manual actions.
  void Off();

  /// Applies all actions to the next step.
  void Apply(double time_s, const Gains& gains, World& world, JointCommand& command);
  /// The force of a push in the last step [N]; nothing if there was none.
  std::optional<Vector3> push_W() const { return pushed_ ? std::optional(pushed_->force_W) : std::nullopt; }

 private:
  struct Pushed {
    Vector3 force_W;
    double until_s = 0.0;
  };
  struct Nudged {
    int dof = 0;
    double by = 0.0, until_s = 0.0;
    std::optional<double> from;  ///< initial position, once it has begun
  };
  static void Apply(Nudged& nudged, const World& world, const Gains& gains, JointCommand& command);

  const RobotModel& model_;
  const PullSpring spring_;
  std::vector<Grip> grips_;
  std::optional<Pushed> pushed_;
  std::optional<Nudged> nudged_;
};

}  // namespace gaitwright
