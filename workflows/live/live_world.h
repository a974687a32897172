// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "playback/engine/world.h"
#include "playback/log/playback_log.h"
#include "workflows/live/hands_on.h"
#include "workflows/live/live_control.h"
#include "workflows/live/walk_stream.h"

namespace gaitwright {

/// What the robot does at present.
enum class LiveMode {
  kStands,
  kWalks,
  kPosed,   ///< its joints and base are held where they were put
  kFallen,  ///< its motors only damp
};

/// What it has been asked for and has no plan for yet.
struct WalkWish {
  WalkPace pace;
  std::optional<double> heading_rad;  ///< to turn to before

  bool operator==(const WalkWish&) const = default;
};

/// "stands", "walks", "posed", "fallen".
std::string NameOf(LiveMode mode);

/// A robot in physics that can be told how to go while it does.
///
/// Paces are planned in a thread of their own while the robot goes on; a pace that has no plan is told in `Notes` and
/// changes nothing. Where a new plan takes over, its controller has been shown what the robot did lately, so that it
/// goes on with what it has learnt of the ground and of its own footholds.
class LiveWorld {
 public:
  /// Stands at the origin.
  /// @param usual  what shapes plans.  @param play  physics and controller, `play.world` and `play.stabilised` first of
  /// all. Failure: no plan for the robot's usual gait; an option out of range, or a controller that there is not,
  /// throws InvalidArgument.
  static Result<std::unique_ptr<LiveWorld>> Make(const RobotModel& model, const WalkRequest& usual,
                                                 const PlayRequest& play);
  ~LiveWorld();
  LiveWorld(const LiveWorld&) = delete;
  LiveWorld& operator=(const LiveWorld&) = delete;

  /// One time step of physics.
  void Step();

  /// Goes over into that pace as soon as it is planned; a later one takes the place of one that is being planned. A
  /// heading that it is to turn to stays so where the pace is straight.
  void Ask(const WalkPace& pace);
  /// Turns to that heading and goes on straight, as fast as asked for last. Standing or down it does nothing but say
  /// so.
  void AskHeading(double heading_rad);
  /// Stands at the origin again, at time 0.
  void Reset();
  /// What people do to it by hand.
  HandsOn& hands() { return hands_; }
  const HandsOn& hands() const { return hands_; }
  /// Holds joints and base there, without physics. @throws InvalidArgument for a wrong size.
  void PutInPose(const VectorX& q);
  /// Stands up from where it is: lifted and put down upright, its heading kept.
  void StandUp();
  /// Another ground under the robot: friction (0 for the plan's) and slope, which turns the robot along, about where it
  /// is.
  void SetGround(double friction, double slope_deg, double slope_direction_deg);
  /// Takes over options and gains of the controllers from there.
  void SetControl(const PlayRequest& from);

  const RobotModel& model() const { return model_; }
  double time_s() const { return time_s_; }
  double step_s() const { return play_.play.world.step_s; }
  LiveMode mode() const { return mode_; }
  /// Standing, where it is posed or has fallen.
  const WalkPace& pace() const { return may_walk() ? stream_.pace() : kNone; }
  const std::optional<WalkWish>& wanted() const { return wanted_; }
  /// Whether a pace is being planned. The destructor waits for it.
  bool plans() const { return planning_.valid(); }
  /// The heading that it turns to, or is asked to turn to.
  std::optional<double> wanted_heading_rad() const;
  /// The robot's own.
  const WalkPace& usual_pace() const { return usual_pace_; }
  /// How the present slope turns the ground.
  Pose ground_tilt() const;
  const World& world() const { return *world_; }
  const MotionPlan& plan() const { return stream_.plan(); }
  const JointCommand& command() const { return command_; }
  /// Of each joint that follows a position: one that swings, or is knocked.
  const Gains& gains() const { return gains_; }
  const PlayRequest& play() const { return play_; }
  /// The state now, with torques and contact forces as means since the last call.
  LogSample TakeSample();
  /// What happened since the last call, in words.
  std::vector<std::string> TakeNotes() { return std::exchange(notes_, {}); }
  /// Waits until what is being planned is there and taken up at the next step: for tests.
  void WaitForPlan();

 private:
  inline static const WalkPace kNone = {.gait = kStanding};

  LiveWorld(const RobotModel& model, const WalkRequest& usual, const PlayRequest& play, PacePlan first,
            LiveControl control);
  bool may_walk() const { return mode_ == LiveMode::kStands || mode_ == LiveMode::kWalks; }
  void Stand(const Pose& X, double time_s);
  void Fall(bool broken);
  void GiveUpWishes();
  Result<PacePlan> Planned();
  void StartPlanning();
  void TakeUpPlan();
  void GoOn();
  void TakeControl();
  void PutOnGround(const VectorX& level_q, const VectorX& level_v);
  void Watch();
  void AddToMeans();
  JointCommand Damping() const;
  ControlInput Measured() const;
  void ComeToStand();
  bool StandsToWalk();

  const RobotModel& model_;
  const WalkRequest usual_;
  PlayRequest play_;
  const WalkPace usual_pace_;
  const PacePlan first_;  ///< of that: where it stands is its beginning
  WalkStream stream_;
  std::unique_ptr<World> world_;
  HandsOn hands_;
  LiveControl control_;
  Gains gains_;
  JointCommand command_;
  std::deque<ControlInput> history_;  ///< the latest
  LogSample sums_;                    ///< of torques and forces since the last sample
  int summed_ = 0;
  Vector2 ground_from_ = Vector2::Zero();  ///< where a slope turns the ground
  LiveMode mode_ = LiveMode::kStands;
  double time_s_ = 0.0, down_since_s_ = 0.0;
  std::optional<WalkWish> wanted_;
  WalkWish planned_wish_;
  PaceChange planned_;                  ///< for that
  std::optional<double> turns_to_rad_;  ///< the heading that it is on its way to
  std::future<Result<PacePlan>> planning_;
  std::vector<std::string> notes_;
};

}  // namespace gaitwright
