// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/centroidal/zmp_knots.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace gaitwright {
namespace {

/// Whether each corner of `inner` lies in `outer`.
bool Holds(const Polygon& outer, const Polygon& inner) {
  constexpr double kTouching = 1e-6;
  return std::all_of(inner.begin(), inner.end(),
                     [&](const Vector2& corner) { return SignedDistance(outer, corner) >= -kTouching; });
}

Vector2 Mean(const Polygon& region) {
  Vector2 sum = Vector2::Zero();
  for (const Vector2& corner : region) sum += corner;
  return sum / static_cast<double>(region.size());
}

/// Largest displacement of a region's corners relative to each other between two times.
double Deformation(const ZmpPhase& phase, double from_s, double to_s) {
  const Polygon before = RegionAt(phase, from_s), after = RegionAt(phase, to_s);
  const Vector2 moved = Mean(after) - Mean(before);
  double most = 0.0;
  for (std::size_t i = 0; i < before.size(); ++i) most = std::max(most, (after[i] - before[i] - moved).norm());
  return most;
}

/// The segment without `margin_m` at both ends; its middle if it is too short.
Polygon Shortened(const Polygon& line, double margin_m) {
  const double share = std::min(margin_m / std::max((line[1] - line[0]).norm(), 1e-12), 0.5);
  return {(1.0 - share) * line[0] + share * line[1], share * line[0] + (1.0 - share) * line[1]};
}

class Placer {
 public:
  Placer(const ZmpProblem& problem, double margin_m, double spacing_s)
      : problem_(problem), margin_m_(margin_m), spacing_s_(spacing_s) {}

  Result<ZmpKnots> Run() {
    const auto& phases = problem_.phases;
    for (std::size_t i = 0; i < phases.size(); ++i) {
      std::vector<std::size_t> own;
      if (i == 0) {
        own.push_back(AddGiven(0, phases[0].start_s, phases[0].preferred_start));
      } else {
        own.push_back(shared_ ? out_.knots.size() - 1 : Add(i, phases[i].start_s, 0.0));
      }
      const int intervals = Intervals(phases[i]);
      const double step_s = (phases[i].end_s - phases[i].start_s) / intervals;
      // Between two knots at corners of a region that deforms, a straight piece can leave the region by half of the
      // deformation.
      const double extra_margin_m = 0.5 * Deformation(phases[i], phases[i].start_s, phases[i].start_s + step_s);
      for (int k = 1; k < intervals; ++k) own.push_back(Add(i, phases[i].start_s + k * step_s, extra_margin_m));
      own.push_back(AddLast(i));
      Blend(i, own);
    }
    if (narrow_) return *narrow_;
    return std::move(out_);
  }

 private:
  int Intervals(const ZmpPhase& phase) const {
    constexpr int kFewestSamples = 4;
    const double length_s = phase.end_s - phase.start_s;
    const int wanted = std::max(2, static_cast<int>(std::ceil(length_s / spacing_s_ - 1e-9)));
    return std::clamp(static_cast<int>(length_s / (kFewestSamples * problem_.step_s)), 1, wanted);
  }

  std::size_t AddLast(std::size_t phase) {
    const auto& phases = problem_.phases;
    const double end_s = phases[phase].end_s;
    if (phase + 1 == phases.size()) return AddGiven(phase, end_s, phases[phase].preferred_end);
    const Polygon here = RegionAt(phases[phase], end_s), there = RegionAt(phases[phase + 1], end_s);
    shared_ = true;
    if (Holds(there, here)) return Add(phase, end_s, 0.0);
    if (Holds(here, there)) return Add(phase + 1, end_s, 0.0);
    shared_ = false;
    return Add(phase, end_s, 0.0);
  }

  std::size_t AddGiven(std::size_t phase, double time_s, const Vector2& p_W) {
    out_.knots.push_back({time_s, phase, out_.num_variables, 0, p_W, Eigen::Matrix2d::Zero(), {p_W}, 0.0});
    return out_.knots.size() - 1;
  }

  std::size_t Add(std::size_t phase, double time_s, double extra_margin_m) {
    const Polygon region = RegionAt(problem_.phases[phase], time_s);
    if (region.size() == 1) return AddGiven(phase, time_s, region[0]);
    ZmpKnot knot{time_s, phase, out_.num_variables, 2, Mean(region), Eigen::Matrix2d::Identity(), {}, 0.0};
    if (region.size() == 2) {
      knot.size = 1;
      knot.origin_W = region[0];
      knot.basis.col(0) = region[1] - region[0];
      knot.region_W = Shortened(region, margin_m_);
    } else {
      knot.region_W = Shrunk(region, margin_m_ + extra_margin_m);
      knot.margin_m = margin_m_;
      if (knot.region_W.size() < 3 && margin_m_ > 0.0) NoteNarrow(phase, time_s);
      if (knot.region_W.size() < 3) return AddGiven(phase, time_s, Centroid(region));
    }
    out_.num_variables += knot.size;
    out_.knots.push_back(knot);
    return out_.knots.size() - 1;
  }

  void NoteNarrow(std::size_t phase, double time_s) {
    if (narrow_) return;
    narrow_ = Failure{FailureKind::kInfeasible,
                      FailureCode::kZmpSupport,
                      "PlanCentreOfMass",
                      fmt::format("in phase {}, the support at {:.2f} s has no point {:.1f} mm inside its edge", phase,
                                  time_s, 1e3 * margin_m_),
                      {"lower centre_of_mass.zmp_margin_m"},
                      Violation{Law::kZmpSupport, time_s, "zero-moment point", margin_m_, 0.0, "m"}};
  }

  /// The samples of a phase from its knots; a sample on a boundary belongs to the later phase.
  void Blend(std::size_t phase, const std::vector<std::size_t>& own) {
    for (std::size_t k = 0; k + 1 < own.size(); ++k) out_.spans.emplace_back(own[k], own[k + 1]);
    std::size_t at = 0;
    while (static_cast<int>(out_.samples.size()) < problem_.samples) {
      const double t = problem_.start_s + static_cast<double>(out_.samples.size()) * problem_.step_s;
      if (ZmpPhaseAt(problem_, t) != phase) break;
      while (at + 2 < own.size() && out_.knots[own[at + 1]].time_s <= t) ++at;
      out_.samples.push_back(BlendAt(problem_.phases[phase], t, own[at], own[at + 1]));
    }
  }

  ZmpBlend BlendAt(const ZmpPhase& phase, double t, std::size_t left, std::size_t right) const {
    const double t0 = out_.knots[left].time_s, t1 = out_.knots[right].time_s;
    const double s = std::clamp((t - t0) / (t1 - t0), 0.0, 1.0);
    const Polygon now = RegionAt(phase, t), before = RegionAt(phase, t0), after = RegionAt(phase, t1);
    ZmpBlend blend{left, right, s, Eigen::Matrix2d::Zero(), Eigen::Matrix2d::Zero(), now[0]};
    if (now.size() == 2) {
      const Vector2 d0 = before[1] - before[0], d1 = after[1] - after[0], d = now[1] - now[0];
      blend.by_left = (1.0 - s) / d0.squaredNorm() * d * d0.transpose();
      blend.by_right = s / d1.squaredNorm() * d * d1.transpose();
      blend.constant_W = now[0] - blend.by_left * before[0] - blend.by_right * after[0];
    } else if (now.size() > 2) {
      blend.by_left = (1.0 - s) * Eigen::Matrix2d::Identity();
      blend.by_right = s * Eigen::Matrix2d::Identity();
      blend.constant_W = Mean(now) - (1.0 - s) * Mean(before) - s * Mean(after);
    }
    return blend;
  }

  const ZmpProblem& problem_;
  const double margin_m_, spacing_s_;
  ZmpKnots out_;
  bool shared_ = false;
  std::optional<Failure> narrow_;
};

}  // namespace

std::vector<Vector2> ZmpKnots::Sample(const VectorX& x) const {
  std::vector<Vector2> p_WZ;
  p_WZ.reserve(samples.size());
  for (const ZmpBlend& s : samples) {
    p_WZ.push_back(s.constant_W + s.by_left * knots[s.left].At(x) + s.by_right * knots[s.right].At(x));
  }
  return p_WZ;
}

std::vector<double> ZmpKnots::Margins() const {
  std::vector<double> margins_m;
  margins_m.reserve(samples.size());
  for (const ZmpBlend& s : samples) {
    margins_m.push_back((1.0 - s.share) * knots[s.left].margin_m + s.share * knots[s.right].margin_m);
  }
  return margins_m;
}

Result<ZmpKnots> PlaceZmpKnots(const ZmpProblem& problem, double margin_m, double spacing_s) {
  return Placer(problem, margin_m, spacing_s).Run();
}

}  // namespace gaitwright
