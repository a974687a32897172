// SPDX-License-Identifier: BSD-3-Clause
#include "planning/footsteps/explain_blockage.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "kinematics/base/non_finite.h"
#include "kinematics/stability/polygon.h"
#include "planning/footsteps/step_limits.h"

namespace gaitwright {
namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;

/// An obstruction on the path of a foot.
struct Hurdle {
  enum class Kind { kGap, kStep, kSlope } kind;
  Vector2 place_W;
  double station_m;
  double size;  ///< width [m], infinite if the ground ends; rise [m]; slope [rad]
};

std::string PlaceText(const Vector2& p) {
  if (std::abs(p.y()) < 0.005) return fmt::format("x = {:.2f} m", p.x());
  return fmt::format("x = {:.2f} m, y = {:.2f} m", p.x(), p.y());
}

/// The ground on the path of a foot, sampled finely.
class Lane {
 public:
  Lane(const SearchScene& scene, const FootstepGraph& graph, int foot, double from_m)
      : scene_(scene), table_(graph.table()), foot_(foot), step_m_(0.01 * scene.model.leg_length_m()) {
    // Starts in front of the sole or the sphere; the ground under it is known to be good.
    constexpr double kLookahead = 2.0;  // leg lengths
    end_m_ = std::min(from_m + kLookahead * scene.model.leg_length_m(), scene.query.route.length_m());
    start_m_ = from_m;
  }

  /// Obstructions in the order in which the foot meets them.
  std::vector<Hurdle> Hurdles(double height_m) const {
    std::vector<Hurdle> hurdles;
    const double lift = scene_.options.step_height * scene_.model.leg_length_m();
    const double steep = std::tan(scene_.checker.options().slope_deg / kDegrees);
    bool on_slope = false;
    for (double u = start_m_; u <= end_m_; u += step_m_) {
      const Vector2 p = PlaceAt(u);
      const GroundPoint ground = scene_.ground.At(p);
      if (ground.patch < 0 || ground.height_m < height_m - lift) {
        const double beyond = EndOfGap(u, height_m, lift);
        if (beyond == kInfinity && ground.patch >= 0) {
          hurdles.push_back({Hurdle::Kind::kStep, BesidePath(u), u, ground.height_m - height_m});
          break;
        }
        const double width = beyond < kInfinity ? (PlaceAt(beyond) - p).norm() : kInfinity;
        if (beyond == kInfinity || !SurfacesBeside(u, beyond))
          hurdles.push_back({Hurdle::Kind::kGap, BesidePath(u), u, width});
        if (beyond == kInfinity) break;
        u = beyond;
        height_m = scene_.ground.At(PlaceAt(u)).height_m;
        continue;
      }
      const double slope = ground.normal_W.head<2>().norm() / ground.normal_W.z();
      if (slope > steep && !on_slope) hurdles.push_back({Hurdle::Kind::kSlope, BesidePath(u), u, std::atan(slope)});
      on_slope = slope > steep;
      constexpr double kSheer = 2.0;  // smallest slope (rise / run) of a step
      const double rise = ground.height_m - height_m;
      if (std::abs(rise) > kSheer * step_m_) hurdles.push_back({Hurdle::Kind::kStep, BesidePath(u), u, rise});
      height_m = ground.height_m;
    }
    return hurdles;
  }

 private:
  Vector2 PlaceAt(double u) const {
    const PlanarPose place = table_.PlaceAt(foot_, u);
    return {place.x_m, place.y_m};
  }

  /// The place on the centre line of the path, beside the foot's own path.
  Vector2 BesidePath(double u) const {
    const PlanarPose base = RouteAt(scene_.query.route, u);
    const Vector2 forward(std::cos(base.yaw_rad), std::sin(base.yaw_rad)), middle(base.x_m, base.y_m);
    return middle + forward.dot(PlaceAt(u) - middle) * forward;
  }

  /// Whether there are surfaces beside the gap on which the foot could step instead.
  bool SurfacesBeside(double u, double beyond) const {
    const Vector2 a = PlaceAt(u + step_m_), b = PlaceAt(beyond - step_m_);
    if (beyond - u < 4.0 * step_m_) return false;
    const Vector2 low = a.cwiseMin(b), high = a.cwiseMax(b), across(-(b - a).y(), (b - a).x());
    const Vector2 side = table_.offset_m() * across.normalized().cwiseAbs();
    std::vector<int> near;
    scene_.ground.PatchesIn(low - side, high + side, near);
    const GroundPoint last = scene_.ground.At(PlaceAt(u - step_m_)), next = scene_.ground.At(PlaceAt(beyond));
    return std::any_of(near.begin(), near.end(), [&](int i) {
      const GroundSurface& surface = scene_.ground.surfaces()[static_cast<std::size_t>(i)];
      const bool meets = (surface.lowest_W.array() <= (high + side).array()).all() &&
                         (surface.highest_W.array() >= (low - side).array()).all();
      return meets && i != last.patch && i != next.patch;
    });
  }

  double EndOfGap(double u, double height_m, double lift_m) const {
    for (; u <= scene_.query.route.length_m(); u += step_m_) {
      const GroundPoint ground = scene_.ground.At(PlaceAt(u));
      if (ground.patch >= 0 && std::abs(ground.height_m - height_m) <= lift_m) return u;
    }
    return kInfinity;
  }

  const SearchScene& scene_;
  const FootholdTable& table_;
  int foot_;
  double step_m_, start_m_ = 0.0, end_m_ = 0.0;
};

/// Builds the message and the suggestions of a failure.
class Explanation {
 public:
  Explanation(const SearchScene& scene, FootstepGraph& graph, const Blockage& blockage)
      : scene_(scene),
        graph_(graph),
        farthest_(blockage.farthest),
        out_of_budget_(blockage.out_of_budget),
        leg_m_(scene.model.leg_length_m()) {}

  Failure Make() {
    for (const Hurdle& hurdle : HurdlesOnRoute()) {
      if (const auto reason = ReasonOf(hurdle)) return Explained(*reason);
    }
    if (out_of_budget_)
      suggestions_.emplace_back("footsteps.search.max_expansions", std::monostate(), Certainty::kUntried,
                                "more footsteps.search.max_expansions");
    if (const auto reason = ObstacleReason()) return Explained(*reason);
    return Explained(CommonReason());
  }

 private:
  Failure Explained(const std::string& reason) const {
    return {FailureKind::kInfeasible, FailureCode::kNoFootholds, "SearchFootsteps", reason, suggestions_};
  }

  /// Obstructions of all feet, in the order in which they are met along the route.
  std::vector<Hurdle> HurdlesOnRoute() const {
    std::vector<Hurdle> all;
    for (int foot = 0; foot < static_cast<int>(scene_.model.feet.size()); ++foot) {
      const FootholdChoice& at = graph_.table()[graph_.FootholdsOf(farthest_)[static_cast<std::size_t>(foot)]];
      const std::vector<Hurdle> own =
          Lane(scene_, graph_, foot, at.station_m).Hurdles(at.placed.X_WF.translation().z());
      all.insert(all.end(), own.begin(), own.end());
    }
    std::stable_sort(all.begin(), all.end(),
                     [](const Hurdle& a, const Hurdle& b) { return a.station_m < b.station_m; });
    return all;
  }

  StepLimits Limits(double station_m) const {
    const double half_span = 0.1 * leg_m_;
    const PlanarPose a = RouteAt(scene_.query.route, station_m - half_span);
    const PlanarPose b = RouteAt(scene_.query.route, station_m + half_span);
    const double heading = std::atan2(b.y_m - a.y_m, b.x_m - a.x_m) - a.yaw_rad;
    return {scene_.model, scene_.query, scene_.checker.options(), scene_.options, heading};
  }

  std::optional<std::string> ReasonOf(const Hurdle& hurdle) {
    if (hurdle.kind == Hurdle::Kind::kGap) return GapReason(hurdle);
    if (hurdle.kind == Hurdle::Kind::kStep) return StepReason(hurdle);
    return fmt::format("slope of {:.0f} degrees at {}; footholds need at most {:.0f} degrees", kDegrees * hurdle.size,
                       PlaceText(hurdle.place_W), scene_.checker.options().slope_deg);
  }

  std::optional<std::string> GapReason(const Hurdle& gap) {
    if (gap.size == kInfinity)
      return fmt::format("the ground ends at {}; there is no ground on the path beyond it", PlaceText(gap.place_W));
    if (tried_gap_m_ <= gap.size && gap.size < 1.02 * tried_gap_m_) return std::nullopt;
    tried_gap_m_ = gap.size;
    const double reach = Limits(gap.station_m).WidestGap(std::min(gap.size, 2.0 * leg_m_));
    if (reach >= gap.size - 0.02 * leg_m_) return std::nullopt;
    HintAtLeap(gap.size);
    return fmt::format("the gap at {} is {:.2f} m wide; {} reaches {:.2f} m", PlaceText(gap.place_W), gap.size,
                       scene_.model.name, reach);
  }

  /// Suggests a jump over a gap or step that is too large for a stride.
  void HintAtLeap(double size_m) {
    const bool leaps = scene_.model.legs.size() == 4 && !HasFlight(scene_.query.gait);
    if (leaps && size_m <= 2.0 * leg_m_) suggestions_.emplace_back("gait", "jump", Certainty::kUntried, "--gait jump");
  }

  std::optional<std::string> StepReason(const Hurdle& step) {
    const bool up = step.size > 0.0;
    const double rise = std::abs(step.size), lift = scene_.options.step_height * leg_m_;
    const std::string what = fmt::format("step {} of {:.2f} m at {}; {}", up ? "up" : "down", rise,
                                         PlaceText(step.place_W), scene_.model.name);
    if (rise > lift + 1e-9) {
      const std::string option =
          fmt::format("footsteps.search.{}", HasFlight(scene_.query.gait) ? "leap_height" : "step_height");
      suggestions_.emplace_back(option, std::monostate(), Certainty::kUntried, "a larger " + option);
      return fmt::format("{} lifts its feet {:.2f} m", what, lift);
    }
    if (rise <= tried_step_m_) return std::nullopt;
    tried_step_m_ = rise;
    const double most = Limits(step.station_m).HighestStep(rise, up);
    if (most >= rise - 0.01 * leg_m_) return std::nullopt;
    return fmt::format("{} steps {} {:.2f} m", what, up ? "up" : "down", most);
  }

  /// Names of at most two obstacles nearest to a place.
  std::vector<std::string> ObstaclesNear(const Vector2& p) const {
    std::vector<std::pair<double, std::string>> near;
    const std::vector<ObstacleOutline>& outlines = scene_.ground.obstacles();
    for (std::size_t i = 0; i < outlines.size(); ++i)
      near.emplace_back((NearestPoint(outlines[i].outline_W, p) - p).norm(), scene_.ground.terrain().obstacles[i].name);
    std::stable_sort(near.begin(), near.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<std::string> names;
    for (std::size_t i = 0; i < std::min<std::size_t>(2, near.size()); ++i) names.push_back(near[i].second);
    return names;
  }

  void CountFaults() {
    std::vector<FootstepGraph::Edge> edges;
    graph_.Steps(farthest_, edges, &refusals_);
    for (const FootstepGraph::Edge& edge : edges) {
      if (graph_.Progress(edge.to) > graph_.Progress(farthest_) + 1e-9)
        ++stances_[static_cast<std::size_t>(graph_.FaultOf(edge.to))];
    }
    const FootholdTable& table = graph_.table();
    for (const int foot : graph_.groups()[static_cast<std::size_t>(graph_.GroupOf(farthest_))]) {
      const FootholdChoice& at = table[graph_.FootholdsOf(farthest_)[static_cast<std::size_t>(foot)]];
      const int first = 1 + static_cast<int>(at.station_m / table.step_m());
      const int last = std::min(table.num_steps(), first + static_cast<int>(leg_m_ / table.step_m()));
      for (int step = first; step <= last; ++step) {
        const FootholdTable::Faults faults = table.FaultsAt(foot, step);
        for (std::size_t i = 0; i < faults.size(); ++i) footholds_[i] += faults[i];
      }
    }
  }

  std::optional<std::string> ObstacleReason() {
    CountFaults();
    const int hits = stances_[static_cast<std::size_t>(StanceFault::kBodyObstacle)] + refusals_.obstacle +
                     footholds_[static_cast<std::size_t>(FootholdFault::kObstacle)];
    if (hits == 0 || scene_.ground.obstacles().empty()) return std::nullopt;
    const PlanarPose base = RouteAt(scene_.query.route, graph_.Progress(farthest_) + 0.5 * leg_m_);
    const Vector2 p(base.x_m, base.y_m);
    const std::vector<std::string> names = ObstaclesNear(p);
    if (names.size() == 1) return fmt::format("no room beside '{}' at {}", names[0], PlaceText(p));
    return fmt::format("no room between '{}' and '{}' at {}", names[0], names[1], PlaceText(p));
  }

  /// The most frequent reason for which footholds or stances beyond this place fail.
  std::string CommonReason() const {
    const PlanarPose base = RouteAt(scene_.query.route, graph_.Progress(farthest_));
    std::string most = "only backward steps are possible";
    int count = 0;
    const auto take = [&](int n, const std::string& what) {
      if (n <= count) return;
      count = n;
      most = what;
    };
    for (std::size_t i = 1; i < stances_.size(); ++i) take(stances_[i], Describe(static_cast<StanceFault>(i)));
    const bool no_stance = count == 0 || stances_[0] == 0;
    if (no_stance && count == 0)
      for (std::size_t i = 1; i < footholds_.size(); ++i) take(footholds_[i], Describe(static_cast<FootholdFault>(i)));
    take(refusals_.riser, "a riser blocks the feet");
    return fmt::format("robot '{}' finds no footholds beyond {}; most frequent reason: {}", scene_.model.name,
                       PlaceText({base.x_m, base.y_m}), most);
  }

  const SearchScene& scene_;
  FootstepGraph& graph_;
  int farthest_;
  bool out_of_budget_;
  double leg_m_;
  std::vector<Suggestion> suggestions_;
  double tried_gap_m_ = 0.0, tried_step_m_ = 0.0;
  FootstepGraph::Refusals refusals_;
  StanceFaults stances_{};
  FootholdTable::Faults footholds_{};
};

}  // namespace

Failure ExplainBlockage(const SearchScene& scene, FootstepGraph& graph, const Blockage& blockage) {
  return Explanation(scene, graph, blockage).Make();
}

}  // namespace gaitwright
