// SPDX-License-Identifier: BSD-3-Clause
#include "playback/score/reason.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "playback/score/report_text.h"
#include "playback/score/why_it_fell.h"

namespace gaitwright {
namespace {

/// Options of a playback that are numbers.
class Options {
 public:
  explicit Options(const PlaybackLog& log) : log_(log) {}

  double At(const std::string& key, double otherwise = 0.0) const {
    const std::string text = Text(key);
    return text.empty() ? otherwise : std::strtod(text.c_str(), nullptr);
  }

  std::string Text(const std::string& key) const {
    for (const auto& [name, text] : log_.options) {
      if (name == key) return text;
    }
    return "";
  }

 private:
  const PlaybackLog& log_;
};

/// Where a push in W goes, in words.
std::string PushWords(const Vector3& force) {
  const char* names[3][2] = {{"backward", "ahead"}, {"to the right", "to the left"}, {"down", "up"}};
  Eigen::Index axis = 0;
  force.cwiseAbs().maxCoeff(&axis);
  return fmt::format("{:.4g} N {}", force.norm(), names[axis][force[axis] > 0.0]);
}

std::vector<std::string> PushesBefore(const PlaybackLog& log, double before_s) {
  constexpr std::size_t kMost = 2;
  std::vector<std::string> words;
  for (const TimedPush& push : log.pushes) {
    if (push.at_s >= before_s) continue;
    if (words.size() == kMost) words.erase(words.begin());
    words.push_back(
        fmt::format("a push of {} from {:.2f} s for {:.2f} s", PushWords(push.force_W), push.at_s, push.for_s));
  }
  return words;
}

std::vector<std::string> OfTheGround(const Options& options) {
  std::vector<std::string> words;
  const double slope = options.At("play.ground_slope_deg"), bumps = options.At("play.ground_bumps_m");
  const double friction = options.At("play.friction");
  if (slope != 0.0) words.push_back(fmt::format("a slope of {:.3g} degrees", slope));
  if (bumps != 0.0) words.push_back(fmt::format("bumps of {:.3g} mm", 1e3 * bumps));
  if (friction > 0.0) words.push_back(fmt::format("a friction of {:.3g}", friction));
  return words;
}

std::vector<std::string> OfTheBody(const Options& options) {
  std::vector<std::string> words;
  const double mass = options.At("play.mass_scale", 1.0), inertia = options.At("play.inertia_scale", 1.0);
  const Vector3 shift(options.At("play.com_shift_x_m"), options.At("play.com_shift_y_m"),
                      options.At("play.com_shift_z_m"));
  if (mass != 1.0) words.push_back(fmt::format("{:.3g} times the mass", mass));
  if (inertia != 1.0) words.push_back(fmt::format("{:.3g} times the moments of inertia", inertia));
  if (!shift.isZero(0.0)) words.push_back(fmt::format("the base's centre of mass {:.3g} mm off", 1e3 * shift.norm()));
  return words;
}

std::vector<std::string> OfTheDrives(const Options& options) {
  std::vector<std::string> words;
  const auto factor = [&](const char* key, const char* what) {
    const double scale = options.At(key, 1.0);
    if (scale != 1.0) words.push_back(fmt::format("{:.3g} times {}", scale, what));
  };
  const double late = options.At("command_delay_s"), friction = options.At("play.joint_friction_nm");
  if (late != 0.0) words.push_back(fmt::format("commands late by {:.3g} ms", 1e3 * late));
  factor("play.motor_strength", "the motors' strength");
  factor("play.torque_scale", "the motors' torque");
  factor("gains.stiffness_scale", "the joints' stiffness");
  factor("gains.damping_scale", "the joints' damping");
  if (friction != 0.0) words.push_back(fmt::format("{:.3g} N m of friction more in each joint", friction));
  if (options.At("play.rotor_inertia_kg_m2") != 0.0) words.emplace_back("rotors of more inertia");
  const std::string state = options.Text("state");
  if (!state.empty() && state != "true") words.push_back("the state as it is " + state);
  return words;
}

std::vector<std::string> OfTheStart(const Options& options) {
  const auto at = [&](const char* part) { return options.At(std::string("play.start_") + part); };
  const double off = Vector3(at("x_m"), at("y_m"), at("z_m")).norm();
  const double turned = Vector3(at("roll_rad"), at("pitch_rad"), at("yaw_rad")).norm();
  std::vector<std::string> words;
  if (off != 0.0) words.push_back(fmt::format("a start {:.3g} mm off", 1e3 * off));
  if (turned != 0.0) words.push_back(fmt::format("a start turned by {:.3g} rad", turned));
  return words;
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
      text += fmt::format("{} its limit {}", over ? "just over" : "not over", limit);
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
  if (tightest == nullptr) return "every gate holds";
  return fmt::format("every gate holds; nearest to its limit is {} with {} of {}", tightest->key,
                     FigureText(*tightest, *tightest->value), FigureText(*tightest, *tightest->limit));
}

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
      return "a body that is no foot touched the ground";
  }
  return "";
}

std::string Joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

}  // namespace

std::vector<std::string> DisturbancesOf(const PlaybackLog& log, double before_s) {
  const Options options(log);
  std::vector<std::string> words = PushesBefore(log, before_s);
  for (const auto& list : {OfTheGround(options), OfTheBody(options), OfTheDrives(options), OfTheStart(options)})
    words.insert(words.end(), list.begin(), list.end());
  return words;
}

std::string ReasonOf(const ScoreInputs& in, const std::vector<Metric>& metrics) {
  const bool pass = std::all_of(metrics.begin(), metrics.end(), [](const Metric& m) { return m.pass; });
  if (pass) return Tightest(metrics);
  const std::vector<FailureEvent> events = FailureEvents(in);
  const std::string under = Joined(in.fall.fell ? DisturbancesOf(in.log, in.fall.time_s) : DisturbancesOf(in.log));
  std::string text = under.empty() ? "" : "under " + under + " ";
  text += in.fall.fell ? fmt::format("it fell at {:.2f} s: {}", in.fall.time_s, in.fall.what)
                       : "it did not fall, but " + BrokenGates(metrics);
  if (!events.empty()) text += "; " + First(events, in.fall.fell ? 3 : 1);
  return text;
}

std::string CauseOf(const ScoreInputs& in, const std::vector<Metric>& metrics) {
  constexpr double kLast = 1.0;  // [s]
  const auto broken = std::find_if(metrics.begin(), metrics.end(), [](const Metric& m) { return !m.pass; });
  if (broken == metrics.end()) return "";
  if (!in.fall.fell) return broken->key;
  if (!in.log.broke_off.empty() && in.fall.what == in.log.broke_off) {
    const bool by_controller = in.fall.what.starts_with("the controller");
    return by_controller ? "the controller came to no number" : "the physics came to no number";
  }
  for (const FailureEvent& event : FailureEvents(in)) {
    if (event.time_s >= in.fall.time_s - kLast) return WordsOf(event.kind);
  }
  const std::string& what = in.fall.what;
  if (what.find("tilted") != std::string::npos) return "the base tilted";
  if (what.find("high where") != std::string::npos) return "the base left its height";
  return what.find("not finite") != std::string::npos ? "the physics came to no number" : "it ended before its plan";
}

}  // namespace gaitwright
