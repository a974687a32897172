// SPDX-License-Identifier: BSD-3-Clause
#include "playback/score/reason.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "playback/score/log_options_internal.h"
#include "playback/score/reason_of_fall.h"
#include "playback/score/report_text.h"

namespace gaitwright {
namespace {

/// A push in W in words, with its main direction.
std::string PushWords(const Vector3& force) {
  const char* names[3][2] = {{"backward", "forward"}, {"to the right", "to the left"}, {"down", "up"}};
  Eigen::Index axis = 0;
  force.cwiseAbs().maxCoeff(&axis);
  return fmt::format("{:.4g} N {}", force.norm(), names[axis][force[axis] > 0.0]);
}

/// A disturbance that the plan did not know, in words, and its size relative to the usual size in trials.
struct Unforeseen {
  std::string words;
  double size = 0.0;
};

std::vector<Unforeseen> PushesBefore(const PlaybackLog& log, double before_s) {
  constexpr std::size_t kMost = 2;
  constexpr double kUsual = 0.1;  // of the weight
  std::vector<Unforeseen> reported;
  for (const TimedPush& push : log.pushes) {
    if (push.at_s >= before_s) continue;
    if (reported.size() == kMost) reported.erase(reported.begin());
    reported.push_back(
        {fmt::format("a push of {} from {:.2f} s for {:.2f} s", PushWords(push.force_W), push.at_s, push.for_s),
         push.force_W.norm() / std::max(kUsual * log.total_mass_kg * kGravity, 1e-9)});
  }
  return reported;
}

/// Whether the whole ground has this friction.
bool HasFriction(const Terrain& terrain, double friction) {
  for (int surface = 0; surface < terrain.num_surfaces(); ++surface) {
    if (FrictionOf(terrain, surface) != friction) return false;
  }
  return true;
}

std::vector<Unforeseen> OfTheGround(const LogOptions& options, const Terrain& planned) {
  std::vector<Unforeseen> reported;
  const double slope = options.At("play.ground_slope_deg"), bumps = options.At("play.ground_bumps_m");
  const double friction = options.At("play.friction");
  if (slope != 0.0) reported.push_back({fmt::format("a slope of {:.3g} degrees", slope), std::abs(slope) / 2.0});
  if (bumps != 0.0) reported.push_back({fmt::format("bumps of {:.3g} mm", 1e3 * bumps), bumps / 0.003});
  if (friction > 0.0 && !HasFriction(planned, friction))
    reported.push_back({fmt::format("a friction of {:.3g}", friction), 0.5 / friction});
  return reported;
}

/// Adds a factor that differs from one.
void AddFactor(const LogOptions& options, const char* key, const char* what, std::vector<Unforeseen>& reported) {
  constexpr double kUsual = 0.1;
  const double scale = options.At(key, 1.0);
  if (scale != 1.0)
    reported.push_back(
        {fmt::format("{:.3g} times {}", scale, what), std::abs(std::log(std::max(scale, 1e-9))) / kUsual});
}

std::vector<Unforeseen> OfTheBody(const LogOptions& options) {
  std::vector<Unforeseen> reported;
  AddFactor(options, "play.mass_scale", "the mass", reported);
  AddFactor(options, "play.inertia_scale", "the moments of inertia", reported);
  const double shift_m =
      Vector3(options.At("play.com_shift_x_m"), options.At("play.com_shift_y_m"), options.At("play.com_shift_z_m"))
          .norm();
  if (shift_m != 0.0)
    reported.push_back({fmt::format("the base's centre of mass shifted by {:.3g} mm", 1e3 * shift_m), shift_m / 0.01});
  return reported;
}

std::vector<Unforeseen> OfTheDrives(const LogOptions& options) {
  std::vector<Unforeseen> reported;
  const double step_s = options.At("play.step_s", 1e-3), friction = options.At("play.joint_friction_nm");
  const double late_s = step_s * std::round(options.At("command_delay_s") / step_s);  // in whole steps
  if (late_s != 0.0) reported.push_back({fmt::format("a command delay of {:.3g} ms", 1e3 * late_s), late_s / 0.004});
  AddFactor(options, "play.motor_strength", "the motors' strength", reported);
  AddFactor(options, "play.torque_scale", "the motors' torque", reported);
  AddFactor(options, "gains.stiffness_scale", "the joints' stiffness", reported);
  AddFactor(options, "gains.damping_scale", "the joints' damping", reported);
  if (friction != 0.0)
    reported.push_back({fmt::format("{:.3g} N m of additional friction in each joint", friction), 1.0});
  if (options.At("play.rotor_inertia_kg_m2") != 0.0) reported.push_back({"additional rotor inertia", 1.0});
  const std::string state = options.Text("state");
  if (!state.empty() && state != "true") reported.push_back({"the state source " + state, 1.0});
  return reported;
}

std::vector<Unforeseen> OfTheStart(const LogOptions& options) {
  const auto at = [&](const char* part) { return options.At(std::string("play.start_") + part); };
  const double off_m = Vector3(at("x_m"), at("y_m"), at("z_m")).norm();
  const double turned = Vector3(at("roll_rad"), at("pitch_rad"), at("yaw_rad")).norm();
  std::vector<Unforeseen> reported;
  if (off_m != 0.0) reported.push_back({fmt::format("a start displaced by {:.3g} mm", 1e3 * off_m), off_m / 0.01});
  if (turned != 0.0) reported.push_back({fmt::format("a start rotated by {:.3g} rad", turned), turned / 0.05});
  return reported;
}

std::vector<Unforeseen> AllUnforeseen(const MotionPlan& plan, const PlaybackLog& log, double before_s) {
  const LogOptions options(log);
  std::vector<Unforeseen> all = PushesBefore(log, before_s);
  for (const auto& list :
       {OfTheGround(options, plan.terrain), OfTheBody(options), OfTheDrives(options), OfTheStart(options)})
    all.insert(all.end(), list.begin(), list.end());
  return all;
}

/// The largest disturbances in their order, and the number of the others.
std::string MostOf(const std::vector<Unforeseen>& all) {
  constexpr std::size_t kMost = 5;
  std::vector<double> sizes;
  for (const Unforeseen& one : all) sizes.push_back(one.size);
  std::sort(sizes.rbegin(), sizes.rend());
  std::vector<std::string> words;
  for (const Unforeseen& one : all) {
    if (words.size() < kMost && (all.size() <= kMost || one.size >= sizes[kMost - 1])) words.push_back(one.words);
  }
  std::string most = fmt::format("{}", fmt::join(words, ", "));
  if (all.size() == words.size()) return most;
  return most + fmt::format(" and {} smaller disturbances", all.size() - words.size());
}

std::string First(const std::vector<FailureEvent>& events, std::size_t most) {
  std::string text;
  for (std::size_t i = 0; i < std::min(most, events.size()); ++i) {
    text += (i == 0 ? "first, " : "; then ") + events[i].text;
  }
  return text;
}

std::string BrokenGates(const std::vector<Metric>& metrics) {
  std::string text;
  for (const Metric& m : metrics) {
    if (m.pass) continue;
    const std::string value = FigureText(m, *m.value), limit = FigureText(m, *m.limit);
    const bool over = m.bound == Bound::kAtMost;
    text += fmt::format("{}{} is ", text.empty() ? "" : "; ", m.key);
    if (value == limit) {
      text += fmt::format("{} its limit {} (by {:.1g} {})", over ? "just over" : "just under", limit,
                          std::abs(*m.value - *m.limit), m.unit);
    } else {
      text += fmt::format("{}, {} its limit {}", value, over ? "over" : "not over", limit);
    }
  }
  return text;
}

std::string Tightest(const std::vector<Metric>& metrics) {
  const Metric* tightest = nullptr;
  const auto use = [](const Metric& m) { return *m.value / *m.limit; };
  for (const Metric& m : metrics) {
    if (!m.applied || !m.value || m.bound != Bound::kAtMost || *m.limit <= 0.0) continue;
    if (tightest == nullptr || use(m) > use(*tightest)) tightest = &m;
  }
  if (tightest == nullptr) return "every gate passes";
  return fmt::format("every gate passes; closest to its limit is {} with {} of {}", tightest->key,
                     FigureText(*tightest, *tightest->value), FigureText(*tightest, *tightest->limit));
}

// Causes of a fall if no event in its last second explains it.
constexpr char kControllerBroke[] = "the controller's output was not finite",
               kPhysicsBroke[] = "the simulation diverged", kTilted[] = "the base tilted",
               kLeftHeight[] = "the base height was out of bounds", kEndedEarly[] = "the log ended before the plan";

const char* WordsOf(FailureEvent::Kind kind) {
  using Kind = FailureEvent::Kind;
  switch (kind) {
    case Kind::kPlanUnstable:
    case Kind::kPlanBeyondLimits:
    case Kind::kPlanBeyondFriction:
    case Kind::kPlanForcesOff:
      return "the plan itself is at fault";
    case Kind::kContactLost:
      return "a foot was off the ground where it should stand";
    case Kind::kEarlyContact:
      return "a foot touched in mid swing";
    case Kind::kMissedFoothold:
      return "a foot missed its foothold";
    case Kind::kSlip:
      return "a foot slid";
    case Kind::kTorqueLimit:
      return "a joint stayed at its torque limit";
    case Kind::kDcmOut:
      return "the DCM was out of reach of the next step";
    case Kind::kBodyContact:
      return "a body that is not a foot touched the ground";
  }
  return "";
}

/// Time and cause of the fall; a fall in the first moment happened before the plan began to move.
std::string FallText(const ScoreInputs& in) {
  constexpr double kMoment = 0.05;  // [s]
  if (in.fall.time_s - in.log.start_s < kMoment)
    return fmt::format("the robot fell while settling, before the plan began: {}", in.fall.what);
  return fmt::format("the robot fell at {:.2f} s: {}", in.fall.time_s, in.fall.what);
}

}  // namespace

std::vector<std::string> DisturbancesOf(const MotionPlan& plan, const PlaybackLog& log, double before_s) {
  std::vector<std::string> words;
  for (const Unforeseen& one : AllUnforeseen(plan, log, before_s)) words.push_back(one.words);
  return words;
}

std::string ReasonOf(const ScoreInputs& in, const std::vector<Metric>& metrics) {
  const bool pass = std::all_of(metrics.begin(), metrics.end(), [](const Metric& m) { return m.pass; });
  if (pass) return Tightest(metrics);
  const std::vector<FailureEvent> events = FailureEvents(in);
  const double before_s = in.fall.fell ? in.fall.time_s : std::numeric_limits<double>::infinity();
  const std::string under = MostOf(AllUnforeseen(in.plan, in.log, before_s));
  std::string text = under.empty() ? "" : "under " + under + ": ";
  text += in.fall.fell ? FallText(in) : "the robot did not fall, but " + BrokenGates(metrics);
  if (!events.empty()) text += "; " + First(events, in.fall.fell ? 3 : 1);
  return text;
}

std::string CauseOf(const ScoreInputs& in, const std::vector<Metric>& metrics) {
  constexpr double kLast = 1.0;  // [s]
  const auto broken = std::find_if(metrics.begin(), metrics.end(), [](const Metric& m) { return !m.pass; });
  if (broken == metrics.end()) return "";
  if (!in.fall.fell) return broken->key;
  const FallKind kind = in.fall.kind;
  if (kind == FallKind::kControllerStopped) return kControllerBroke;
  if (kind == FallKind::kPhysicsStopped) return kPhysicsBroke;
  for (const FailureEvent& event : FailureEvents(in)) {
    if (event.time_s >= in.fall.time_s - kLast) return WordsOf(event.kind);
  }
  if (kind == FallKind::kTilted) return kTilted;
  if (kind == FallKind::kLeftHeight) return kLeftHeight;
  return kind == FallKind::kNotFinite ? kPhysicsBroke : kEndedEarly;
}

bool IsCauseOfFall(const std::string& cause) {
  for (const char* ending : {kControllerBroke, kPhysicsBroke, kTilted, kLeftHeight, kEndedEarly}) {
    if (cause == ending) return true;
  }
  using Kind = FailureEvent::Kind;
  for (const Kind kind : {Kind::kPlanUnstable, Kind::kContactLost, Kind::kEarlyContact, Kind::kMissedFoothold,
                          Kind::kSlip, Kind::kTorqueLimit, Kind::kDcmOut, Kind::kBodyContact}) {
    if (cause == WordsOf(kind)) return true;
  }
  return false;
}

}  // namespace gaitwright
