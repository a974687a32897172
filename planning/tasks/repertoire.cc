// SPDX-License-Identifier: BSD-3-Clause
#include "planning/tasks/repertoire.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "kinematics/dynamics/foot_contact.h"
#include "kinematics/model/actuator.h"
#include "kinematics/model/dof_units.h"
#include "kinematics/model/upper_body.h"
#include "planning/tasks/gestures.h"

namespace gaitwright {
namespace {

/// Natural-looking duration of a move, from the body's distance and angle and from the joints' speeds.
double TimeOf(const RobotModel& model, const PostureKey& from, const PostureKey& to) {
  constexpr double kPeakOfMean = 1.875;         // peak speed over mean speed of a minimum-jerk move
  constexpr double kPeakAcceleration = 5.7735;  // peak acceleration times T^2 over distance
  constexpr double kGentle = 0.1;               // share of gravity
  constexpr double kTurnRate = 0.8, kJointRate = 2.5, kSpeedShare = 0.4, kSlideRate = 0.3;  // [rad/s], [m/s]
  const double leg = model.leg_length_m();
  double time_s = 0.5 * std::sqrt(leg / 0.3);
  time_s = std::max(time_s, std::sqrt(kPeakAcceleration * (to.shift - from.shift).norm() / (kGentle * kGravity)));
  time_s = std::max(time_s, kPeakOfMean * (to.turn_rad - from.turn_rad).cwiseAbs().maxCoeff() / kTurnRate);
  for (int d = 0; d < model.num_dofs(); ++d) {
    const double natural = Slides(model, d) ? kSlideRate : kJointRate;
    const Actuator motor = ActuatorOf(model, d);
    const double turns = std::abs(motor.Speed(to.joints - from.joints));
    time_s = std::max({time_s, kPeakOfMean * std::abs(to.joints[d] - from.joints[d]) / natural,
                       kPeakOfMean * turns / (kSpeedShare * motor.velocity_limit)});
  }
  return time_s;
}

/// Appends a move to a key, and a stay there.
void Go(const RobotModel& model, PostureMotion& motion, PostureKey to, double stay_s = 0.0) {
  to.after_s = TimeOf(model, motion.keys.back(), to);
  motion.keys.push_back(to);
  if (stay_s <= 0.0) return;
  to.after_s = stay_s;
  motion.keys.push_back(to);
}

PostureMotion StartOf(const std::string& name, PostureKey from, OptionTexts options) {
  from.after_s = 0.0;
  PostureMotion motion{name, {from}};
  motion.options = std::move(options);
  return motion;
}

std::string Text(double value) { return fmt::format("{}", value); }

Failure NoArm(const RobotModel& model, bool left) {
  const UpperBody upper = FindUpperBody(model);
  const std::string has = upper.left_arm || upper.right_arm ? "has no arm on that side" : "has no arms";
  return {FailureKind::kBadInput,
          FailureCode::kNoArm,
          "Repertoire",
          fmt::format("the {} arm cannot be moved: robot '{}' {}", left ? "left" : "right", model.name, has),
          {}};
}

/// Applies a change of joints for each of the arms.
template <class Change>
Result<VectorX> ForArms(const RobotModel& model, VectorX joints, Sides sides, Change change) {
  const UpperBody upper = FindUpperBody(model);
  for (const bool left : {true, false}) {
    if (!(left ? sides.left : sides.right)) continue;
    const std::optional<Limb>& arm = upper.arm(left);
    if (!arm) return NoArm(model, left);
    Result<VectorX> changed = change(*arm, joints);
    if (!changed) return changed;
    joints = std::move(*changed);
  }
  return joints;
}

std::string SidesText(Sides sides) { return sides.left && sides.right ? "both" : sides.left ? "left" : "right"; }

}  // namespace

PostureKey StandingKey(const RobotModel& model) {
  PostureKey key;
  key.joints = model.standing_joints;
  return key;
}

PostureMotion Hold(const PostureKey& from, double duration_s) {
  PostureMotion motion = StartOf("stand", from, {{"duration_s", Text(duration_s)}});
  motion.keys.push_back(from);
  motion.keys.back().after_s = duration_s;
  return motion;
}

PostureMotion GoTo(const RobotModel& model, const std::string& name, const PostureKey& from, const PostureKey& to) {
  constexpr double kStay = 0.4;  // [s]
  PostureMotion motion = StartOf(name, from, {});
  Go(model, motion, to, kStay);
  return motion;
}

PostureMotion Squat(const RobotModel& model, const PostureKey& from, double depth_m, int times, double hold_s) {
  constexpr double kLeastStay = 0.1;  // [s]
  PostureMotion motion =
      StartOf("squat", from, {{"depth_m", Text(depth_m)}, {"times", std::to_string(times)}, {"hold_s", Text(hold_s)}});
  PostureKey low = from;
  low.shift.z() -= depth_m;
  for (int k = 0; k < times; ++k) {
    Go(model, motion, low, std::max(kLeastStay, hold_s));
    Go(model, motion, from, kLeastStay);
  }
  return motion;
}

PostureMotion Bow(const RobotModel& model, const PostureKey& from, double angle_rad, double lower_m, int times) {
  constexpr double kStay = 0.4, kPause = 0.2;  // [s]
  PostureMotion motion = StartOf(
      "bow", from, {{"angle_rad", Text(angle_rad)}, {"lower_m", Text(lower_m)}, {"times", std::to_string(times)}});
  PostureKey bowed = from;
  bowed.turn_rad.y() += angle_rad;
  bowed.shift.z() -= lower_m;
  for (int k = 0; k < times; ++k) {
    Go(model, motion, bowed, kStay);
    Go(model, motion, from, kPause);
  }
  return motion;
}

PostureKey SittingKey(const RobotModel& model, double angle_rad, double lower_m) {
  PostureKey key = StandingKey(model);
  key.turn_rad.y() = -angle_rad;
  key.shift.z() = -lower_m;
  return key;
}

PostureMotion Nod(const RobotModel& model, const PostureKey& from, int times) {
  constexpr double kDown = 0.3, kBodyDown = 0.12;  // [rad]
  const UpperBody upper = FindUpperBody(model);
  PostureMotion motion =
      StartOf("nod", from, {{"times", std::to_string(times)}, {"with", upper.head ? "head" : "body"}});
  PostureKey down = from;
  if (upper.head) {
    down.joints = NoddedHead(model, *upper.head, from.joints, kDown);
  } else {
    down.turn_rad.y() += kBodyDown;
  }
  for (int k = 0; k < times; ++k) {
    Go(model, motion, down);
    Go(model, motion, from);
  }
  return motion;
}

Result<PostureMotion> RaiseArms(const RobotModel& model, const PostureKey& from, Sides sides) {
  const Result<VectorX> raised = ForArms(
      model, from.joints, sides, [&](const Limb& arm, const VectorX& joints) { return RaisedArm(model, arm, joints); });
  if (!raised) return raised.failure();
  PostureKey up = from;
  up.joints = *raised;
  PostureMotion motion = GoTo(model, "raise_arm", from, up);
  motion.options = {{"side", SidesText(sides)}};
  return motion;
}

Result<PostureMotion> LowerArms(const RobotModel& model, const PostureKey& from, Sides sides) {
  const Result<VectorX> lowered =
      ForArms(model, from.joints, sides, [&](const Limb& arm, VectorX joints) -> Result<VectorX> {
        for (const int dof : arm.dofs) joints[dof] = model.standing_joints[dof];
        return joints;
      });
  if (!lowered) return lowered.failure();
  PostureKey down = from;
  down.joints = *lowered;
  PostureMotion motion = GoTo(model, "lower_arm", from, down);
  motion.options = {{"side", SidesText(sides)}};
  return motion;
}

Result<PostureMotion> WaveArms(const RobotModel& model, const PostureKey& from, Sides sides, int times) {
  Result<PostureMotion> raise = RaiseArms(model, from, sides);
  if (!raise) return raise;
  PostureKey out = raise->keys.back(), in = out;
  const UpperBody upper = FindUpperBody(model);
  for (const bool left : {true, false}) {
    if (!(left ? sides.left : sides.right)) continue;
    const Result<Wave> wave = WaveOf(model, *upper.arm(left), raise->keys.back().joints);
    if (!wave) return wave.failure();
    for (const int dof : upper.arm(left)->dofs) {
      out.joints[dof] = wave->out[dof];
      in.joints[dof] = wave->in[dof];
    }
  }
  PostureMotion motion = StartOf("wave", from, {{"side", SidesText(sides)}, {"times", std::to_string(times)}});
  Go(model, motion, raise->keys.back());
  for (int k = 0; k < times; ++k) {
    Go(model, motion, out);
    Go(model, motion, in);
  }
  Go(model, motion, raise->keys.back());
  Go(model, motion, from);
  return motion;
}

Result<PostureMotion> BalanceOn(const RobotModel& model, const PostureKey& from, int on, double inward, double hold_s) {
  constexpr double kSettle = 0.5, kLift = 0.12, kLeast = 1.0;  // [s], share of the leg's length, [s]
  constexpr double kLower = 0.02;                              // share of the leg's length
  const auto soles =
      std::count_if(model.feet.begin(), model.feet.end(), [](const Foot& foot) { return foot.has_sole(); });
  if (model.feet.size() != 2 || soles != 2) {
    return Failure{
        FailureKind::kBadInput,
        FailureCode::kTwoFeet,
        "BalanceOn",
        fmt::format("balancing on one foot needs two feet with soles; robot '{}' has {} feet, {} of them with soles",
                    model.name, model.feet.size(), soles),
        {}};
  }
  DynamicsScratch scratch(model);
  ForwardKinematics(model, StandingConfiguration(model), scratch);
  const Pose X_WF = ContactFrame(model, scratch, on), X_WG = ContactFrame(model, scratch, 1 - on);
  Vector3 shift = X_WF.translation() - CentreOfMass(model, scratch);
  const double width = X_WG.translation().y() - X_WF.translation().y();
  shift.y() += inward * width;
  PostureMotion motion = StartOf(
      "balance", from,
      {{"on", model.feet[static_cast<std::size_t>(on)].name}, {"inward", Text(inward)}, {"hold_s", Text(hold_s)}});
  PostureKey over = from;
  over.shift = Vector3(shift.x(), shift.y(), from.shift.z() - kLower * model.leg_length_m());
  Go(model, motion, over, kSettle);
  const std::size_t lifts = motion.keys.size() - 1;
  over.after_s = std::max(kLeast, hold_s);
  motion.keys.push_back(over);
  over.after_s = kSettle;
  motion.keys.push_back(over);
  Go(model, motion, from, kSettle);
  motion.lifts = {{1 - on, lifts, lifts + 1, kLift * model.leg_length_m()}};
  return motion;
}

PostureMotion Brace(const RobotModel& model, const PostureKey& from, double depth_m, double hold_s) {
  constexpr double kOfNaturalTime = 0.5;  // share of the natural duration
  PostureMotion motion = StartOf("brace", from, {{"depth_m", Text(depth_m)}, {"hold_s", Text(hold_s)}});
  PostureKey low = from;
  low.shift.z() -= depth_m;
  Go(model, motion, low, hold_s);
  motion.keys[1].after_s *= kOfNaturalTime;
  return motion;
}

}  // namespace gaitwright
