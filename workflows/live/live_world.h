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

/// Present activity of the robot.
enum class LiveMode {
  kStands,
  kWalks,
  kPosed,   ///< its joints and base are held in a set posture
  kFallen,  ///< its motors only add damping
};

/// A request that has no plan yet.
struct WalkWish {
  WalkPace pace;
  std::optional<double> heading_rad;  ///< heading to turn to first

  bool operator==(const WalkWish&) const = default;
};

/// "stands", "walks", "posed", "fallen".
std::string NameOf(LiveMode mode);

/// A simulated robot that accepts commands while it moves.
///
/// Speeds are planned in a separate thread while the robot continues. A speed without a feasible plan is reported in
/// the notes and changes nothing. When a new plan takes over, its controller is initialised with the robot's recent
/// states, so it keeps its estimates of the ground and of its footholds.
class LiveWorld {
 public:
  /// Makes a robot that stands at the origin.
  /// @param usual  options of plans. @param play physics and controller, mainly `play.world` and `play.stabilised`.
  /// Failure: no plan for the robot's default gait; an option out of range or an unknown controller throws
  /// InvalidArgument.
  static Result<std::unique_ptr<LiveWorld>> Make(const RobotModel& model, const WalkRequest& usual,
                                                 const PlayRequest& play);
  ~LiveWorld();
  LiveWorld(const LiveWorld&) = delete;
  LiveWorld& operator=(const LiveWorld&) = delete;

  /// One time step of physics.
  void Step();

  /// Changes to this speed and gait as soon as they are planned; a later request replaces one that is being planned. A
  /// commanded heading is kept if the robot walks straight.
  void Ask(const WalkPace& pace);
  /// Turns to this heading and continues straight at the last commanded speed. If the robot stands or has fallen, this
  /// only adds a note.
  void AskHeading(double heading_rad);
  /// Stands at the origin again, at time 0. @param engine  to change to, one of EngineNames(); "" keeps the present
  /// one.
  void Reset(const std::string& engine = "");
  /// Manual actions on the robot.
  HandsOn& hands() { return hands_; }
  const HandsOn& hands() const { return hands_; }
  /// Holds joints and base in a posture, without physics. @throws InvalidArgument for a wrong size.
  void PutInPose(const VectorX& q);
  /// Puts the robot upright at its present position, with the same heading.
  void StandUp();
  /// Changes the ground: friction (0 for the plan's) and slope, which rotates the robot with it about its position.
  void SetGround(double friction, double slope_deg, double slope_direction_deg);
  /// Takes controller options and gains from a request.
  void SetControl(const PlayRequest& from);

  const RobotModel& model() const { return model_; }
  double time_s() const { return time_s_; }
  double step_s() const { return play_.play.world.step_s; }
  LiveMode mode() const { return mode_; }
  /// The present speed and gait; standing if the robot is posed or has fallen.
  const WalkPace& pace() const { return may_walk() ? stream_.pace() : kNone; }
  const std::optional<WalkWish>& wanted() const { return wanted_; }
  /// Whether a walk is being planned. The destructor waits for the planning.
  bool plans() const { return planning_.valid(); }
  /// The heading to which the robot turns or was commanded to turn.
  std::optional<double> wanted_heading_rad() const;
  /// The robot's default speed and gait.
  const WalkPace& usual_pace() const { return usual_pace_; }
  /// Rotation of the ground by the present slope.
  Pose ground_tilt() const;
  const World& world() const { return *world_; }
  const MotionPlan& plan() const { return stream_.plan(); }
  const JointCommand& command() const { return command_; }
  /// Gains of each joint that follows a position command, such as a swinging or pushed joint.
  const Gains& gains() const { return gains_; }
  const PlayRequest& play() const { return play_; }
  /// The state now, with torques and contact forces as means since the last call.
  LogSample TakeSample();
  /// Texts of the events since the last call.
  std::vector<std::string> TakeNotes() { return std::exchange(notes_, {}); }
  /// Waits until the present planning has finished and its plan is used at the next step; for tests.
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
  const PacePlan first_;  ///< plan of the default speed; the robot stands at its beginning
  WalkStream stream_;
  std::unique_ptr<World> world_;
  HandsOn hands_;
  LiveControl control_;
  Gains gains_;
  JointCommand command_;
  std::deque<ControlInput> history_;  ///< the latest inputs
  LogSample sums_;                    ///< sums of torques and forces since the last sample
  int summed_ = 0;
  Vector2 ground_from_ = Vector2::Zero();  ///< centre of the slope's rotation
  LiveMode mode_ = LiveMode::kStands;
  double time_s_ = 0.0, down_since_s_ = 0.0;
  std::optional<WalkWish> wanted_;
  WalkWish planned_wish_;
  PaceChange planned_;                  ///< change that is being planned
  std::optional<double> turns_to_rad_;  ///< the heading that it is turning to
  std::future<Result<PacePlan>> planning_;
  std::vector<std::string> notes_;
};

}  // namespace gaitwright
