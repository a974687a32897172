// SPDX-License-Identifier: BSD-3-Clause
#include "playback/score/agreement.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>

#include "playback/score/log_options_internal.h"
#include "playback/score/motion_series.h"

namespace gaitwright {
namespace {

constexpr double kForceShare = 0.15;  // of the weight
constexpr double kMean_s = 0.05;
constexpr double kZmpShare = 0.1, kPositionShare = 0.03, kSlipShare = 0.02, kDepthShare = 0.0006;  // of the leg length
constexpr double kAngle_rad = 0.03;
constexpr double kLoaded = 0.5;  // of the weight: ZMPs count only above it

/// A quantity of one playback at its samples; NaN where it has no value.
struct TimedValues {
  std::vector<double> time_s, value;
};

using Figure = std::function<double(const MotionSample&)>;

TimedValues ValuesOf(const std::vector<MotionSample>& samples, const Figure& figure) {
  TimedValues values;
  for (const MotionSample& sample : samples) {
    values.time_s.push_back(sample.time_s);
    values.value.push_back(figure(sample));
  }
  return values;
}

/// Means over a window around each sample; NaN where the window extends beyond an end.
TimedValues Smoothed(const TimedValues& rough, double window_s) {
  TimedValues smooth = rough;
  const double half_s = 0.5 * window_s;
  std::size_t first = 0, end = 0;
  double sum = 0.0;
  for (std::size_t k = 0; k < rough.time_s.size(); ++k) {
    const double time_s = rough.time_s[k];
    while (end < rough.time_s.size() && rough.time_s[end] <= time_s + half_s) sum += rough.value[end++];
    while (rough.time_s[first] < time_s - half_s) sum -= rough.value[first++];
    const bool whole = time_s - half_s >= rough.time_s.front() && time_s + half_s <= rough.time_s.back();
    smooth.value[k] = whole ? sum / static_cast<double>(end - first) : std::nan("");
  }
  return smooth;
}

/// Integral over time, from the values at the ends of the intervals.
TimedValues Integrated(const TimedValues& rate) {
  TimedValues sum = rate;
  double total = 0.0;
  for (std::size_t k = 0; k < rate.time_s.size(); ++k) {
    if (k > 0) total += rate.value[k] * (rate.time_s[k] - rate.time_s[k - 1]);
    sum.value[k] = total;
  }
  return sum;
}

/// Removes jumps of 2 pi.
TimedValues Unwrapped(TimedValues angle) {
  for (std::size_t k = 1; k < angle.value.size(); ++k)
    angle.value[k] = angle.value[k - 1] + std::remainder(angle.value[k] - angle.value[k - 1], 2.0 * M_PI);
  return angle;
}

/// Value at a time within the samples, interpolated. @param from  a sample at or before the time; moved forward.
double At(const TimedValues& values, double time_s, std::size_t& from) {
  while (from + 1 < values.time_s.size() && values.time_s[from + 1] <= time_s) ++from;
  if (from + 1 == values.time_s.size() || values.time_s[from] >= time_s) return values.value[from];
  const double share = (time_s - values.time_s[from]) / (values.time_s[from + 1] - values.time_s[from]);
  return (1.0 - share) * values.value[from] + share * values.value[from + 1];
}

struct Quantity {
  std::string name, unit;
  double tolerance;
  Figure figure;
  std::function<TimedValues(const TimedValues&)> then = nullptr;
};

std::vector<Quantity> QuantitiesOf(const RobotModel& model) {
  const double leg = model.leg_length_m();
  std::vector<Quantity> list;
  for (std::size_t foot = 0; foot < model.feet.size(); ++foot) {
    list.push_back({"normal force of " + model.feet[foot].name, "N", kForceShare * model.weight_n(),
                    [foot](const MotionSample& s) { return s.feet[foot].force_W.z(); },
                    [](const TimedValues& v) { return Smoothed(v, kMean_s); }});
    list.push_back(
        {"slip of " + model.feet[foot].name, "m", kSlipShare * leg,
         [foot](const MotionSample& s) { return s.feet[foot].force_W.z() > 0.0 ? s.feet[foot].slide_m_s : 0.0; },
         Integrated});
    list.push_back({"depth of " + model.feet[foot].name, "m", kDepthShare * leg,
                    [foot](const MotionSample& s) {
                      return std::isfinite(s.feet[foot].height_m) ? std::max(0.0, -s.feet[foot].height_m) : 0.0;
                    },
                    [](const TimedValues& v) { return Smoothed(v, kMean_s); }});
  }
  const double none = std::nan(""), loaded = kLoaded * model.weight_n();
  for (int axis = 0; axis < 2; ++axis) {
    list.push_back(
        {std::string("ZMP ") + "xy"[axis], "m", kZmpShare * leg, [axis, none, loaded](const MotionSample& s) {
           return s.has_zmp && s.normal_n > loaded ? s.p_WZ[axis] : none;
         }});
  }
  for (int axis = 0; axis < 3; ++axis) {
    list.push_back({std::string("base ") + "xyz"[axis], "m", kPositionShare * leg,
                    [axis](const MotionSample& s) { return s.X_WB.translation()[axis]; }});
  }
  const auto R = [](const MotionSample& s) -> Matrix3 { return s.X_WB.linear(); };
  list.push_back({"base roll", "rad", kAngle_rad,
                  [R](const MotionSample& s) { return std::atan2(R(s)(2, 1), R(s)(2, 2)); }, Unwrapped});
  list.push_back({"base pitch", "rad", kAngle_rad,
                  [R](const MotionSample& s) { return std::asin(std::clamp(-R(s)(2, 0), -1.0, 1.0)); }});
  list.push_back({"base yaw", "rad", kAngle_rad,
                  [R](const MotionSample& s) { return std::atan2(R(s)(1, 0), R(s)(0, 0)); }, Unwrapped});
  return list;
}

/// Nothing if there is no time at which both have a value.
std::optional<QuantityAgreement> Compared(const Quantity& quantity, const TimedValues& a, const TimedValues& b,
                                          const Agreement& shared) {
  QuantityAgreement result;
  result.quantity = quantity.name;
  result.unit = quantity.unit;
  result.tolerance = quantity.tolerance;
  std::size_t from = 0;
  int count = 0;
  double squares = 0.0;
  for (std::size_t k = 0; k < a.time_s.size(); ++k) {
    const double time_s = a.time_s[k];
    if (time_s < shared.start_s || time_s > shared.end_s) continue;
    const double of_a = a.value[k], of_b = At(b, time_s, from), difference = std::abs(of_b - of_a);
    if (!std::isfinite(difference)) continue;
    ++count;
    squares += difference * difference;
    if (difference > result.largest) {
      result.largest = difference;
      result.at_s = time_s;
    }
    if (!result.parts_s && difference > quantity.tolerance) {
      result.parts_s = time_s;
      result.a = of_a;
      result.b = of_b;
    }
  }
  if (count == 0) return std::nullopt;
  result.rms = std::sqrt(squares / count);
  return result;
}

std::string ValueText(double value, const std::string& unit) {
  if (unit == "m") return fmt::format("{:.{}f} mm", 1e3 * value, std::abs(value) < 1e-3 ? 2 : 1);
  return unit == "N" ? fmt::format("{:.0f} N", value) : fmt::format("{:.3f} {}", value, unit);
}

/// The quantity with the largest difference among those whose name begins with `begins`, without angles; null if none.
const QuantityAgreement* Largest(const Agreement& agreement, const std::string& begins) {
  const QuantityAgreement* most = nullptr;
  for (const QuantityAgreement& quantity : agreement.quantities) {
    if (quantity.unit != "rad" && quantity.quantity.starts_with(begins) &&
        (most == nullptr || quantity.largest > most->largest))
      most = &quantity;
  }
  return most;
}

}  // namespace

const QuantityAgreement* Agreement::first() const {
  const QuantityAgreement* earliest = nullptr;
  for (const QuantityAgreement& quantity : quantities) {
    if (quantity.parts_s && (earliest == nullptr || *quantity.parts_s < *earliest->parts_s)) earliest = &quantity;
  }
  return earliest;
}

std::string EngineOf(const PlaybackLog& log) {
  const std::string name = LogOptions(log).Text("play.engine");
  return name.empty() ? "bullet" : name;
}

std::string EngineTitle(const std::string& engine) {
  if (engine == "bullet") return "Bullet";
  return engine == "mujoco" ? "MuJoCo" : engine;
}

Agreement AgreementOf(const RobotModel& model, const MotionPlan& plan, const PlaybackLog& a, const PlaybackLog& b) {
  const std::vector<MotionSample> of_a = MakeMeasuredSeries(model, plan, a, ScoreOptionsOf(a));
  const std::vector<MotionSample> of_b = MakeMeasuredSeries(model, plan, b, ScoreOptionsOf(b));
  Agreement agreement;
  agreement.name_a = EngineOf(a);
  agreement.name_b = EngineOf(b);
  if (agreement.name_a == agreement.name_b) {
    agreement.name_a = "A (" + agreement.name_a + ")";
    agreement.name_b = "B (" + agreement.name_b + ")";
  }
  if (of_a.empty() || of_b.empty()) return agreement;
  agreement.start_s = std::max(of_a.front().time_s, of_b.front().time_s);
  agreement.end_s = std::min(of_a.back().time_s, of_b.back().time_s);
  agreement.samples = static_cast<int>(std::count_if(of_a.begin(), of_a.end(), [&](const MotionSample& s) {
    return s.time_s >= agreement.start_s && s.time_s <= agreement.end_s;
  }));
  for (const Quantity& quantity : QuantitiesOf(model)) {
    TimedValues values_a = ValuesOf(of_a, quantity.figure), values_b = ValuesOf(of_b, quantity.figure);
    if (quantity.then) {
      values_a = quantity.then(values_a);
      values_b = quantity.then(values_b);
    }
    if (auto compared = Compared(quantity, values_a, values_b, agreement))
      agreement.quantities.push_back(std::move(*compared));
  }
  return agreement;
}

std::string AgreementText(const Agreement& agreement) {
  const std::string a = EngineTitle(agreement.name_a), b = EngineTitle(agreement.name_b);
  if (agreement.quantities.empty()) return fmt::format("{} and {} have no common time range", a, b);
  if (const QuantityAgreement* first = agreement.first()) {
    return fmt::format("{} and {} first differ in the {} at {:.2f} s: {} and {}, tolerance {}", a, b, first->quantity,
                       *first->parts_s, ValueText(first->a, first->unit), ValueText(first->b, first->unit),
                       ValueText(first->tolerance, first->unit));
  }
  std::string text = fmt::format("{} and {} agree over {:.2f} s:", a, b, agreement.end_s - agreement.start_s);
  const char* separator = " ";
  for (const auto& [begins, words] :
       {std::pair("normal force", "forces"), std::pair("ZMP", "ZMP"), std::pair("slip", "slips"),
        std::pair("depth", "depths"), std::pair("base", "base")}) {
    const QuantityAgreement* most = Largest(agreement, begins);
    if (most == nullptr) continue;
    text += fmt::format("{}{} within {}", separator, words, ValueText(most->largest, most->unit));
    separator = ", ";
  }
  return text;
}

std::string AgreementJson(const Agreement& agreement) {
  using Json = nlohmann::ordered_json;
  const auto quantity_json = [](const QuantityAgreement& quantity) {
    Json json = {{"quantity", quantity.quantity},
                 {"unit", quantity.unit},
                 {"rms", quantity.rms},
                 {"largest", quantity.largest},
                 {"at_s", quantity.at_s},
                 {"tolerance", quantity.tolerance},
                 {"parts_s", nullptr},
                 {"values", Json::array()}};
    if (quantity.parts_s) {
      json["parts_s"] = *quantity.parts_s;
      json["values"] = {quantity.a, quantity.b};
    }
    return json;
  };
  Json json = {{"engines", {agreement.name_a, agreement.name_b}},
               {"start_s", agreement.start_s},
               {"end_s", agreement.end_s},
               {"agree", agreement.first() == nullptr},
               {"first", nullptr},
               {"quantities", Json::array()}};
  if (const QuantityAgreement* first = agreement.first()) json["first"] = quantity_json(*first);
  for (const QuantityAgreement& quantity : agreement.quantities) json["quantities"].push_back(quantity_json(quantity));
  return json.dump(2);
}

}  // namespace gaitwright
