// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/live/live_world.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <utility>

#include "kinematics/spatial/rotation.h"
#include "planning/plan/carried_plan.h"
#include "planning/plan/sample_plan.h"
#include "playback/play/make_world.h"

namespace gaitwright {
namespace {

constexpr double kLead = 0.45;          // from a request to the earliest change, longer than the blending at a seam [s]
constexpr double kLookahead = 1.0;      // a stop is decided this long before it begins [s]
constexpr double kSameHeading = 0.01;   // [rad]
constexpr double kSameHeight = 1e-3;    // [m]
constexpr double kFallenTilt = 1.0;     // [rad]
constexpr double kFallenContact = 0.2;  // a body on the ground for this long is a fall [s]
constexpr double kFallenHeight = 0.4;   // share of the standing height
constexpr char kIgnored[] = "the command was ignored: the robot does not stand; let it stand up first";

/// Length of the past motion that a new controller receives: until each foot was in stance and in swing.
double Shown(const MotionPlan& plan) {
  constexpr double kLeast = 0.5, kCycles = 1.5;
  double shown = kLeast;
  for (const MotionPart& part : plan.parts) {
    if (!StandsStill(part.gait)) shown = std::max(shown, kCycles * part.gait.cycle_s);
  }
  return shown;
}

/// Height of the centre of mass above the feet.
double CentreOverFeet(const MotionPlan& plan) {
  if (plan.centroidal.p_WC.empty() || plan.footsteps.footholds.empty()) return 0.0;
  return plan.centroidal.p_WC.back().z() - plan.footsteps.footholds.back().X_WF.translation().z();
}

}  // namespace

std::string NameOf(LiveMode mode) {
  switch (mode) {
    case LiveMode::kStands:
      return "stands";
    case LiveMode::kWalks:
      return "walks";
    case LiveMode::kPosed:
      return "posed";
    case LiveMode::kFallen:
      return "fallen";
  }
  return "";
}

Result<std::unique_ptr<LiveWorld>> LiveWorld::Make(const RobotModel& model, const WalkRequest& usual,
                                                   const PlayRequest& play) {
  PlayRequest checked = play;
  CheckOptions(checked.Fields());
  Result<LiveControl> control = LiveControl::Make(model, play);
  if (!control) return control.failure();
  PaceChange begins;
  begins.from.gait = kStanding;
  begins.to = UsualPace(model, usual.gait_options);
  Result<PacePlan> first = PlanPace(model, begins, usual);
  if (!first) return first.failure();
  return std::unique_ptr<LiveWorld>(new LiveWorld(model, usual, play, std::move(*first), std::move(*control)));
}

LiveWorld::LiveWorld(const RobotModel& model, const WalkRequest& usual, const PlayRequest& play, PacePlan first,
                     LiveControl control)
    : model_(model),
      usual_(usual),
      play_(play),
      usual_pace_(UsualPace(model, usual.gait_options)),
      first_(std::move(first)),
      stream_(first_.plan),
      world_(MakeWorld(model, first_.plan.terrain, first_.plan.whole_body.q.front(), play.play.world)),
      hands_(model),
      control_(std::move(control)),
      gains_(DeriveGains(model, GainsFor(play))) {
  Reset();
}

LiveWorld::~LiveWorld() {
  if (planning_.valid()) planning_.wait();
}

void LiveWorld::Reset(const std::string& engine) {
  if (!engine.empty()) play_.play.world.engine = engine;
  Stand(Pose::Identity(), 0.0);
}

/// Sets the robot to the first posture of the first plan, moved by X in plan view, at a time.
void LiveWorld::Stand(const Pose& X, double time_s) {
  const MotionPlan& stands = first_.plan;
  PutOnGround(CarriedState(X, stands.whole_body.q.front()), VectorX::Zero(model_.nv()));
  stream_ = WalkStream(CarriedPlan(X, time_s - stands.whole_body.start_s, stands));
  time_s_ = down_since_s_ = time_s;
  history_.clear();
  GiveUpWishes();
  hands_.Off();
  mode_ = LiveMode::kStands;
  TakeControl();
}

void LiveWorld::Step() {
  if (mode_ == LiveMode::kPosed) return;
  if (mode_ != LiveMode::kFallen) {
    TakeUpPlan();
    GoOn();
  }
  history_.push_back(Measured());
  const auto most = static_cast<std::size_t>(std::lround(Shown(stream_.plan()) / step_s()));
  while (history_.size() > most) history_.pop_front();
  command_ = mode_ == LiveMode::kFallen ? Damping() : control_.Update(history_.back());
  hands_.Apply(time_s_, gains_, *world_, command_);
  if (!IsFinite(command_)) return Fall(true);
  world_->Step(command_);
  if (!IsPhysical(*world_)) return Fall(true);
  AddToMeans();
  time_s_ += step_s();
  if (may_walk() && !hands_.grips().empty())
    hands_.GoAlong(CentreDisplacement(control_.plan().centroidal, time_s_ - step_s(), time_s_));
  Watch();
}

ControlInput LiveWorld::Measured() const {
  ControlInput input;
  input.time_s = time_s_;
  input.step_s = step_s();
  input.q = world_->q();
  input.v = world_->v();
  for (std::size_t i = 0; i < world_->feet().size(); ++i) {
    input.wrenches.push_back(world_->feet()[i].wrench);
    if (world_->feet()[i].touching) input.contact |= FootBit(static_cast<int>(i));
  }
  input.wrenches.resize(model_.feet.size());
  return input;
}

void LiveWorld::GiveUpWishes() {
  wanted_.reset();
  turns_to_rad_.reset();
}

std::optional<double> LiveWorld::wanted_heading_rad() const {
  return wanted_ && wanted_->heading_rad ? wanted_->heading_rad : turns_to_rad_;
}

void LiveWorld::Ask(const WalkPace& pace) {
  if (!may_walk()) return notes_.emplace_back(kIgnored), void();
  if (!pace.stands()) {
    const bool keeps_heading = wanted_ && pace.yaw_rate_rad_s == 0.0;
    wanted_ = {pace, keeps_heading ? wanted_->heading_rad : std::nullopt};
    return StartPlanning();
  }
  GiveUpWishes();
  if (stream_.stops()) return;
  if (const auto failure = stream_.Stop(time_s_ + kLead)) notes_.push_back(failure->message);
  TakeControl();
}

void LiveWorld::AskHeading(double heading_rad) {
  if (mode_ != LiveMode::kWalks || stream_.stops())
    return notes_.emplace_back("the robot can turn to a heading only while it walks"), void();
  WalkPace straight = wanted_ ? wanted_->pace : stream_.pace();
  straight.yaw_rate_rad_s = 0.0;
  if (straight.stands()) {
    notes_.emplace_back("the robot can turn to a heading only while it walks forward or sideways, not on the spot");
    return;
  }
  wanted_ = {straight, heading_rad};
  StartPlanning();
}

void LiveWorld::StartPlanning() {
  if (planning_.valid() || !wanted_) return;
  planned_wish_ = *wanted_;
  planned_ = {.from = stream_.pace(), .to = wanted_->pace};
  // During a turn the final heading is not known, so the robot walks straight first.
  if (wanted_->heading_rad && planned_.from.yaw_rate_rad_s == 0.0)
    planned_.turn_rad = std::remainder(*wanted_->heading_rad - stream_.heading_rad(), 2.0 * std::numbers::pi);
  // The body stays low after a speed that needed it, because each change of height changes the posture in walking.
  const double lower = CentreOverFeet(first_.plan) - CentreOverFeet(stream_.plan());
  if (lower > kSameHeight) planned_.com_height_m = first_.plan.centroidal.p_WC.back().z() - lower;
  if (std::abs(planned_.turn_rad) < kSameHeading) planned_.turn_rad = 0.0;
  if (planned_.from == planned_.to && planned_.turn_rad == 0.0) return wanted_.reset();
  planning_ = std::async(std::launch::async, [this, change = planned_] { return PlanPace(model_, change, usual_); });
}

Result<PacePlan> LiveWorld::Planned() {
  try {
    return planning_.get();
  } catch (const std::exception& error) {
    return Failure{FailureKind::kInfeasible, FailureCode::kPlanning, "PlanPace", error.what(), {}};
  }
}

void LiveWorld::TakeUpPlan() {
  if (!planning_.valid() || planning_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return;
  if (wanted_ && control_.recovers() && !StandsToWalk()) return;
  const Result<PacePlan> next = Planned();
  if (!wanted_) return;
  if (*wanted_ != planned_wish_ || stream_.pace() != planned_.from) return StartPlanning();
  if (!next) {
    notes_.push_back(fmt::format("{}: {}", TextOf(planned_), next.failure().message));
    return wanted_.reset();
  }
  if (const auto failure = stream_.GoOver(time_s_ + kLead, planned_.to, *next)) {
    notes_.push_back(failure->message);
    return wanted_.reset();
  }
  notes_.push_back("changes to " + TextOf(planned_));
  mode_ = LiveMode::kWalks;
  TakeControl();
  const bool straight_first = wanted_->heading_rad && planned_.from.yaw_rate_rad_s != 0.0;
  if (straight_first) return StartPlanning();
  turns_to_rad_ = wanted_->heading_rad;
  wanted_.reset();
}

void LiveWorld::GoOn() {
  if (turns_to_rad_ && time_s_ > stream_.steady_from_s()) turns_to_rad_.reset();
  if (stream_.stops()) {
    if (mode_ == LiveMode::kWalks && time_s_ > stream_.plan().whole_body.end_s()) ComeToStand();
    return;
  }
  if (!stream_.GoOn(time_s_ + kLookahead)) return;
  stream_.Forget(time_s_ - 2.0 * Shown(stream_.plan()));
  TakeControl();
}

/// Called after a walk has come to rest. A controller for standing robots takes over, with a plan that only stands.
void LiveWorld::ComeToStand() {
  notes_.emplace_back("stands");
  if (control_.stood_in_for()) {
    stream_.Forget(time_s_);
    history_ = {history_.back()};
    TakeControl();
  }
  mode_ = LiveMode::kStands;
}

/// Whether a robot that may have made recovery steps is at rest and upright. If so, the plan is moved to its position.
bool LiveWorld::StandsToWalk() {
  constexpr double kStill = 0.05, kUpright = 0.8;  // [m/s], [rad or m]
  const auto n = static_cast<Eigen::Index>(model_.num_dofs());
  for (const ControlInput& input : history_) {
    if (input.v.head<3>().norm() > kStill) return false;
  }
  const VectorX& q = world_->q();
  const VectorX& stands = stream_.plan().whole_body.q.front();
  if ((q - stands).tail(n).lpNorm<Eigen::Infinity>() > kUpright) {
    notes_.emplace_back(kIgnored);
    return wanted_.reset(), false;
  }
  const Pose X = PoseOf(BaseInPlan(q)) * PoseOf(BaseInPlan(stands)).inverse();
  stream_ = WalkStream(CarriedPlan(X, 0.0, stream_.plan()));
  return true;
}

/// Makes a controller for the present plan and gives it the recent motion. The plan is moved to the robot's position.
void LiveWorld::TakeControl() {
  if (mode_ == LiveMode::kWalks && !history_.empty())
    stream_.Shift(FootOffset(model_, stream_.plan(), history_.back()));
  if (const auto why_not = control_.Follow(stream_.plan(), play_, history_)) notes_.push_back(*why_not);
}

JointCommand LiveWorld::Damping() const {
  const auto n = static_cast<Eigen::Index>(model_.num_dofs());
  const VectorX none = VectorX::Zero(n);
  return {world_->q().tail(n), none, none, none, gains_.damping};
}

void LiveWorld::Watch() {
  if (mode_ == LiveMode::kFallen) return;
  const double up = std::clamp(BaseRotation(world_->q())(2, 2), -1.0, 1.0);
  const double standing = first_.plan.whole_body.q.front()[2];
  double ground = 0.0;
  int touching = 0;
  for (const FootContact& foot : world_->feet()) {
    if (!foot.touching) continue;
    ground += foot.p_W.z();
    ++touching;
  }
  const bool sunk = touching > 0 && world_->q()[2] - ground / touching < kFallenHeight * standing;
  if (world_->body_contacts().empty()) down_since_s_ = time_s_;
  if (std::acos(up) > kFallenTilt || sunk || time_s_ - down_since_s_ > kFallenContact) Fall(false);
}

/// @param broken  the physics or the controller gave a value that is not finite: the simulation restarts.
void LiveWorld::Fall(bool broken) {
  notes_.push_back(fmt::format("{} at {:.2f} s", broken ? "the simulation diverged" : "the robot fell", time_s_));
  if (broken) return Reset();
  mode_ = LiveMode::kFallen;
  GiveUpWishes();
}

void LiveWorld::AddToMeans() {
  const std::vector<FootContact>& feet = world_->feet();
  if (summed_ == 0) {
    sums_.tau = VectorX::Zero(static_cast<Eigen::Index>(model_.num_dofs()));
    sums_.wrenches.assign(model_.feet.size(), {});
  }
  sums_.tau += world_->tau();
  for (std::size_t i = 0; i < feet.size(); ++i) {
    sums_.wrenches[i].force_W += feet[i].wrench.force_W;
    sums_.wrenches[i].moment_W += feet[i].wrench.moment_W;
  }
  ++summed_;
}

LogSample LiveWorld::TakeSample() {
  if (summed_ == 0) AddToMeans();
  LogSample sample = std::exchange(sums_, {});
  const double share = 1.0 / std::exchange(summed_, 0);
  sample.tau *= share;
  sample.tau_peak = world_->motor_torque().cwiseAbs();
  sample.effort_use = world_->effort_use();
  for (ContactWrench& wrench : sample.wrenches) {
    wrench.force_W *= share;
    wrench.moment_W *= share;
  }
  const ControlInput now = Measured();
  sample.time_s = now.time_s;
  sample.q = now.q;
  sample.v = now.v;
  sample.contact = now.contact;
  return sample;
}

Pose LiveWorld::ground_tilt() const { return GroundTilt(first_.plan.terrain, play_.play.world, ground_from_); }

void LiveWorld::PutInPose(const VectorX& q) {
  constexpr double kFarthest = 100.0;  // [m]
  if (q.size() != model_.nq() || !q.allFinite())
    throw InvalidArgument(fmt::format("a posture has {} numbers; {} are needed", q.size(), model_.nq()));
  if ((q.head<3>() - world_->q().head<3>()).norm() > kFarthest)
    throw InvalidArgument(fmt::format("the base can be moved by at most {} m", kFarthest));
  VectorX level = q;
  level.head<2>() = ground_from_;
  std::unique_ptr<World> posed = MakeWorld(model_, first_.plan.terrain, level, play_.play.world);
  posed->SetState(q, VectorX::Zero(model_.nv()));  // `q` may refer to the previous world
  world_ = std::move(posed);
  GiveUpWishes();
  hands_.Off();
  mode_ = LiveMode::kPosed;
}

void LiveWorld::StandUp() {
  const VectorX& q = world_->q();
  const VectorX& origin = first_.plan.whole_body.q.front();
  Stand(PoseOf(BaseInPlan(q)) * PoseOf({origin[0], origin[1], 0.0}).inverse(), time_s_);
}

void LiveWorld::SetGround(double friction, double slope_deg, double slope_direction_deg) {
  WorldOptions changed = play_.play.world;
  changed.friction = friction;
  changed.ground_slope_deg = slope_deg;
  changed.ground_slope_direction_deg = slope_direction_deg;
  CheckOptions(changed.Fields());
  const VectorX q = world_->q();
  const Pose level = ground_tilt().inverse();
  play_.play.world = changed;
  PutOnGround(CarriedState(level, q), CarriedRates(level, world_->v()));
  stream_.Shift(world_->q().head<3>() - q.head<3>());
  history_.clear();
  if (may_walk()) TakeControl();
}

/// Puts the robot into a new world with the present ground. A slope rotates the robot about its position.
void LiveWorld::PutOnGround(const VectorX& level_q, const VectorX& level_v) {
  ground_from_ = level_q.head<2>();
  world_ = MakeWorld(model_, first_.plan.terrain, level_q, play_.play.world);
  const Pose X = ground_tilt();
  world_->SetState(CarriedState(X, level_q), CarriedRates(X, level_v));
}

void LiveWorld::SetControl(const PlayRequest& from) {
  PlayRequest changed = play_;
  changed.stabilised = from.stabilised;
  changed.recovering = from.recovering;
  changed.gains = from.gains;
  CheckOptions(changed.Fields());
  gains_ = DeriveGains(model_, GainsFor(changed));
  play_ = std::move(changed);
  if (may_walk()) TakeControl();
}

void LiveWorld::WaitForPlan() {
  if (planning_.valid()) planning_.wait();
}

}  // namespace gaitwright
