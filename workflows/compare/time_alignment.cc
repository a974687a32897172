// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/compare/time_alignment.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <unsupported/Eigen/FFT>

namespace gaitwright {
namespace {

constexpr double kStep = 0.005;            // step of the search [s]
constexpr double kLeastShare = 1.0 / 3.0;  // least energy of each compared part, relative to the less energetic motion
constexpr double kRest = 1e-9;             // smaller energy counts as no motion

/// Joint speeds of a motion on a uniform time grid, one row per time.
struct EvenSpeeds {
  MatrixX v;      ///< one column per joint; zero where rows are missing
  MatrixX known;  ///< one column: 1, and 0 where rows are missing
};

EvenSpeeds SpeedsOf(const ComparedMotion& motion, const std::vector<int>& joints) {
  const auto n = static_cast<Eigen::Index>(std::floor((motion.end_s() - motion.start_s()) / kStep + 1e-6)) + 1;
  EvenSpeeds speeds{MatrixX(n, static_cast<Eigen::Index>(joints.size())), MatrixX(n, 1)};
  RowSample sample;
  for (Eigen::Index k = 0; k < n; ++k) {
    const double time_s = motion.start_s() + kStep * static_cast<double>(k);
    SampleCompared(motion, time_s, sample);
    speeds.known(k, 0) = InGap(motion.gaps, time_s) ? 0.0 : 1.0;
    for (std::size_t j = 0; j < joints.size(); ++j) {
      const double v = sample.v[6 + joints[j]];
      speeds.v(k, static_cast<Eigen::Index>(j)) = std::isfinite(v) ? v : 0.0;
    }
  }
  return speeds;
}

/// Limits of the speeds by joint. A computed speed counts at most as the largest speed of the other side, since
/// otherwise a jump of a position would outweigh the motion.
VectorX LimitsOf(const ComparedMotion& motion, const std::vector<int>& joints, const MatrixX& of_other) {
  VectorX limits = of_other.cwiseAbs().colwise().maxCoeff().transpose();
  for (std::size_t j = 0; j < joints.size(); ++j) {
    if (!motion.derives_speed(joints[j])) limits[static_cast<Eigen::Index>(j)] = INFINITY;
  }
  return limits;
}

MatrixX Limited(const MatrixX& speeds, const VectorX& limits) {
  const MatrixX most = limits.transpose().replicate(speeds.rows(), 1);
  return speeds.cwiseMin(most).cwiseMax(-most);
}

/// sum over t and joints of a(t) b(t + s), for s from -(rows of a - 1) to rows of b - 1.
std::vector<double> CrossCorrelation(const MatrixX& a, const MatrixX& b) {
  const Eigen::Index whole = a.rows() + b.rows() - 1;
  Eigen::Index size = 1;
  while (size < whole) size *= 2;
  Eigen::FFT<double> fft;
  using Spectrum = std::vector<std::complex<double>>;
  Spectrum sum(static_cast<std::size_t>(size), 0.0), of_a, of_b;
  std::vector<double> padded_a(static_cast<std::size_t>(size)), padded_b(static_cast<std::size_t>(size)), shifted;
  for (Eigen::Index j = 0; j < a.cols(); ++j) {
    std::fill(padded_a.begin(), padded_a.end(), 0.0);
    std::fill(padded_b.begin(), padded_b.end(), 0.0);
    for (Eigen::Index k = 0; k < a.rows(); ++k) padded_a[static_cast<std::size_t>(k)] = a(k, j);
    for (Eigen::Index k = 0; k < b.rows(); ++k) padded_b[static_cast<std::size_t>(k)] = b(k, j);
    fft.fwd(of_a, padded_a);
    fft.fwd(of_b, padded_b);
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += std::conj(of_a[i]) * of_b[i];
  }
  fft.inv(shifted, sum);
  std::vector<double> correlation;
  for (Eigen::Index s = -(a.rows() - 1); s < b.rows(); ++s)
    correlation.push_back(shifted[static_cast<std::size_t>(s < 0 ? s + size : s)]);
  return correlation;
}

/// The shift in steps with the best agreement; nothing if a side is at rest. Each side counts only while the other has
/// rows.
std::optional<Eigen::Index> BestShift(const EvenSpeeds& a, const EvenSpeeds& b) {
  const MatrixX energy_a = a.v.rowwise().squaredNorm(), energy_b = b.v.rowwise().squaredNorm();
  const double least = kLeastShare * std::min(energy_a.sum(), energy_b.sum());
  if (least < kLeastShare * kRest) return std::nullopt;
  const double least_rows = std::max(1.0, std::floor(0.5 * std::min(a.known.sum(), b.known.sum())));
  const std::vector<double> product = CrossCorrelation(a.v, b.v), in_a = CrossCorrelation(energy_a, b.known),
                            in_b = CrossCorrelation(a.known, energy_b), rows = CrossCorrelation(a.known, b.known);
  std::optional<Eigen::Index> best;
  double best_agreement = -2.0;
  for (std::size_t i = 0; i < product.size(); ++i) {
    if (rows[i] + 0.5 < least_rows || in_a[i] < least || in_b[i] < least) continue;
    const double agreement = 2.0 * product[i] / (in_a[i] + in_b[i]);
    if (agreement > best_agreement) {
      best_agreement = agreement;
      best = static_cast<Eigen::Index>(i) - (a.v.rows() - 1);
    }
  }
  return best;
}

/// The agreement at an offset that is not a multiple of the step.
class Agreement {
 public:
  Agreement(const ComparedMotion& a, const ComparedMotion& b, const std::vector<NamedPair>& joints,
            const VectorX& limits_a, const VectorX& limits_b)
      : a_(a), b_(b), joints_(joints), limits_a_(limits_a), limits_b_(limits_b) {}

  double At(double offset_s) {
    const double first = std::max(a_.start_s(), b_.start_s() - offset_s),
                 end = std::min(a_.end_s(), b_.end_s() - offset_s);
    double product = 0.0, energy = 0.0;
    for (double time_s = first; time_s <= end + 1e-9; time_s += kStep) {
      SampleCompared(a_, std::min(time_s, end), of_a_);
      SampleCompared(b_, std::min(time_s, end) + offset_s, of_b_);
      for (std::size_t j = 0; j < joints_.size(); ++j) {
        double v = of_a_.v[6 + joints_[j].a], w = of_b_.v[6 + joints_[j].b];
        if (!std::isfinite(v) || !std::isfinite(w)) continue;
        const double most_a = limits_a_[static_cast<Eigen::Index>(j)], most_b = limits_b_[static_cast<Eigen::Index>(j)];
        v = std::clamp(v, -most_a, most_a);
        w = std::clamp(w, -most_b, most_b);
        product += v * w;
        energy += v * v + w * w;
      }
    }
    return energy > 0.0 ? 2.0 * product / energy : 0.0;
  }

 private:
  const ComparedMotion &a_, &b_;
  const std::vector<NamedPair>& joints_;
  const VectorX &limits_a_, &limits_b_;
  RowSample of_a_, of_b_;
};

}  // namespace

std::vector<NamedPair> CommonNames(const std::vector<std::string>& a, const std::vector<std::string>& b) {
  std::vector<NamedPair> common;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const auto found = std::find(b.begin(), b.end(), a[i]);
    if (found != b.end()) common.push_back({a[i], static_cast<int>(i), static_cast<int>(found - b.begin())});
  }
  return common;
}

std::optional<ClockOffset> BestOffset(const ComparedMotion& a, const ComparedMotion& b,
                                      const std::vector<NamedPair>& joints) {
  std::vector<int> of_a, of_b;
  for (const NamedPair& joint : joints) {
    of_a.push_back(joint.a);
    of_b.push_back(joint.b);
  }
  if (joints.empty()) return std::nullopt;
  EvenSpeeds speeds_a = SpeedsOf(a, of_a), speeds_b = SpeedsOf(b, of_b);
  const VectorX limits_a = LimitsOf(a, of_a, speeds_b.v), limits_b = LimitsOf(b, of_b, speeds_a.v);
  speeds_a.v = Limited(speeds_a.v, limits_a);
  speeds_b.v = Limited(speeds_b.v, limits_b);
  const std::optional<Eigen::Index> shift = BestShift(speeds_a, speeds_b);
  if (!shift) return std::nullopt;
  Agreement agreement(a, b, joints, limits_a, limits_b);
  ClockOffset best{b.start_s() - a.start_s() + kStep * static_cast<double>(*shift), 0.0};
  best.agreement = agreement.At(best.offset_s);
  for (const double finer : {kStep / 10.0, kStep / 50.0}) {
    const double about_s = best.offset_s;
    for (int i = -10; i <= 10; ++i) {
      const double offset_s = about_s + finer * i;
      const double there = i == 0 ? best.agreement : agreement.At(offset_s);
      if (there > best.agreement + 1e-12) best = {offset_s, there};
    }
  }
  return best;
}

}  // namespace gaitwright
