// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/centroidal/body_trajectory.h"

#include <algorithm>
#include <cmath>

#include "kinematics/spatial/rotation.h"
#include "kinematics/stability/polygon.h"
#include "optimisation/centroidal/rigid_body_cost.h"
#include "optimisation/numerics/affine_vector.h"
#include "optimisation/numerics/constrained_problem.h"

namespace gaitwright {
namespace {

/// Weights of distances out of reach and out of a region, relative to the distance from a nominal position.
constexpr double kReach = 30.0, kRegion = 100.0;
/// Accelerations that cost as much as one metre [m/s^2], [rad/s^2]; cost of a radian of tilt [m].
constexpr double kAcceleration = 20.0, kTurning = 60.0, kTilt = 0.3;

Matrix3 HeadingAt(const RigidBodyProblem& problem, double time_s) {
  return YawRotation(WantedAngles(problem, time_s).z());
}

/// Indices of the times within a stance; the nearest time if there is none.
std::vector<std::size_t> TimesOf(const RigidStance& stance, const BodyTrajectory& trajectory) {
  std::vector<std::size_t> times;
  for (std::size_t k = 0; k < trajectory.time_s.size(); ++k) {
    if (trajectory.time_s[k] >= stance.start_s - 1e-9 && trajectory.time_s[k] <= stance.end_s + 1e-9)
      times.push_back(k);
  }
  if (!times.empty()) return times;
  const auto nearest = std::lower_bound(trajectory.time_s.begin(), trajectory.time_s.end(), stance.start_s);
  return {static_cast<std::size_t>(nearest - trajectory.time_s.begin())};
}

/// Distance of a point beyond a side of a workspace, in coordinates from the centre of mass; 0 inside.
double Beyond(const WorkspaceSide& side, const Vector3& p_B) {
  return std::max(0.0, side.normal.dot(p_B) - side.offset);
}

/// A stance's foothold relative to the centre of mass, in the body's frame.
Vector3 FromBody(const RigidBodyProblem& problem, const BodyTrajectory& trajectory, std::size_t stance, std::size_t k) {
  return RotationOf(trajectory.angles_rad[k]).transpose() *
         (problem.stances[stance].X_WF.translation() - trajectory.p_WC[k]);
}

/// Distance of a stance's foot out of reach at one time.
BodyTrajectoryMisfit At(const RigidBodyProblem& problem, const BodyTrajectory& trajectory, std::size_t stance,
                        std::size_t k) {
  BodyTrajectoryMisfit misfit;
  const Vector3 p_B = FromBody(problem, trajectory, stance, k);
  for (const WorkspaceSide& side : FootOf(problem, stance).workspace_B) {
    const double out = Beyond(side, p_B);
    misfit.sum += out * out;
    misfit.largest_m = std::max(misfit.largest_m, out);
  }
  misfit.at_s = trajectory.time_s[k];
  misfit.stance = misfit.largest_m > 0.0 ? static_cast<int>(stance) : -1;
  return misfit;
}

/// The worse of two misfits, with the sum of both.
BodyTrajectoryMisfit Worse(const BodyTrajectoryMisfit& a, const BodyTrajectoryMisfit& b) {
  BodyTrajectoryMisfit worse = b.largest_m > a.largest_m ? b : a;
  worse.sum = a.sum + b.sum;
  return worse;
}

/// Rows of a foothold at one time: its position relative to the centre of mass, minus the nominal position, and the
/// weighted distances beyond the sides of the workspace.
struct StandingRows {
  RigidFoot foot;
  Vector3 origin;                    // origin of the foothold's plane
  Eigen::Matrix<double, 3, 2> axes;  // axes of that plane
  int foothold;                      // index of its unknowns; -1 if it is fixed
  AffineVector com, angles;

  void operator()(const VectorX& x, VectorX& value, MatrixX* J) const {
    Vector3 from_com = origin - com.At(x);
    if (foothold >= 0) from_com += axes * x.segment<2>(foothold);
    const Vector3 now = angles.At(x);
    const Matrix3 R_BW = RotationOf(now).transpose();
    const Vector3 p_B = R_BW * from_com;
    const auto sides = static_cast<Eigen::Index>(foot.workspace_B.size());
    value.resize(3 + sides);
    value.head<3>() = p_B - foot.p_CF_nominal_B;
    MatrixX by_place = MatrixX::Zero(3 + sides, 3);
    by_place.topRows(3).setIdentity();
    for (Eigen::Index i = 0; i < sides; ++i) {
      const WorkspaceSide& side = foot.workspace_B[static_cast<std::size_t>(i)];
      value[3 + i] = kReach * Beyond(side, p_B);
      if (value[3 + i] > 0.0) by_place.row(3 + i) = kReach * side.normal;
    }
    if (J == nullptr) return;
    angles.AddTo(MatrixX(by_place * Skew(p_B) * BodyRatesByAngleRates(now)), *J, 0);
    by_place = by_place * R_BW;
    com.AddTo(-by_place, *J, 0);
    if (foothold >= 0) J->middleCols(foothold, 2) += by_place * axes;
  }
};

/// Weighted distances of a foothold beyond the sides of its region.
struct RegionRows {
  std::vector<Vector2> corners;

  void operator()(const VectorX& x, VectorX& value, MatrixX* J) const {
    value.resize(static_cast<Eigen::Index>(corners.size()));
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Vector2 along = corners[(i + 1) % corners.size()] - corners[i];
      const Vector2 outward = Vector2(along.y(), -along.x()).normalized();
      const auto row = static_cast<Eigen::Index>(i);
      value[row] = kRegion * std::max(0.0, outward.dot(x - corners[i]));
      if (J != nullptr && value[row] > 0.0) J->row(row) = kRegion * outward;
    }
  }
};

/// The least-squares problem of FitBodyTrajectory.
class Fit {
 public:
  Fit(RigidBodyProblem& problem, BodyTrajectory& trajectory)
      : problem_(problem),
        trajectory_(trajectory),
        p_(trajectory.time_s.size()),
        angles_(p_.size()),
        foothold_(problem.stances.size(), -1) {
    int size = 0;
    p_.front().constant = trajectory.p_WC.front();
    p_.back().constant = trajectory.p_WC.back();
    angles_.front().constant = trajectory.angles_rad.front();
    angles_.back().constant = trajectory.angles_rad.back();
    for (std::size_t k = 1; k + 1 < p_.size(); ++k, size += 6) {
      p_[k] = AffineVector::Unknown(size);
      angles_[k] = AffineVector::Unknown(size + 3);
    }
    for (std::size_t s = 0; s < foothold_.size(); ++s) {
      if (problem.stances[s].held) continue;
      foothold_[s] = size;
      size += 2;
    }
    rows_.start = VectorX::Zero(size);
    for (std::size_t k = 1; k + 1 < p_.size(); ++k) {
      rows_.start.segment<3>(p_[k].parts[0].start) = trajectory.p_WC[k];
      rows_.start.segment<3>(angles_[k].parts[0].start) = trajectory.angles_rad[k];
    }
    AddBends(p_, kAcceleration);
    AddBends(angles_, kTurning);
    AddTilts();
    for (std::size_t s = 0; s < foothold_.size(); ++s) AddStance(s);
  }

  void Run() {
    ConstrainedOptions options;
    options.trust_radius = 1e7;
    options.cost_tolerance = options.inner_tolerance = 1e-3;
    options.max_outer = 2;
    options.max_inner = 20;
    ConstrainedSolution at;
    (void)Solve(rows_, options, &at);  // the result is usable without convergence
    for (std::size_t k = 1; k + 1 < p_.size(); ++k) {
      trajectory_.p_WC[k] = p_[k].At(at.x);
      trajectory_.angles_rad[k] = angles_[k].At(at.x);
    }
    for (std::size_t s = 0; s < foothold_.size(); ++s) {
      if (foothold_[s] >= 0) Move(problem_.stances[s], at.x.segment<2>(foothold_[s]));
    }
  }

 private:
  void AddRows(const AffineVector& vector, double weight, const Vector3& wanted) {
    SeenUnknowns seen;
    VectorFunction rows = AffineRows(vector, weight * Matrix3::Identity(), weight * wanted, seen);
    if (!seen.variables().empty()) rows_.residuals.emplace_back(std::move(rows), seen.variables());
  }

  /// Accelerations divided by `bad`. Both ends are at rest, so the path is extended by its mirror image there.
  void AddBends(const std::vector<AffineVector>& path, double bad) {
    const double h = trajectory_.time_s[1] - trajectory_.time_s[0];
    for (std::size_t k = 0; k < path.size(); ++k) {
      AffineVector bend = path[k == 0 ? 1 : k - 1];
      bend.Add(1.0, path[k + 1 == path.size() ? k - 1 : k + 1]).Add(-2.0, path[k]);
      AddRows(bend, 1.0 / (h * h * bad), Vector3::Zero());
    }
  }

  void AddTilts() {
    for (std::size_t k = 1; k + 1 < angles_.size(); ++k)
      AddRows(angles_[k], kTilt, WantedAngles(problem_, trajectory_.time_s[k]));
  }

  void AddStance(std::size_t s) {
    const RigidStance& stance = problem_.stances[s];
    for (const std::size_t k : TimesOf(stance, trajectory_)) {
      SeenUnknowns seen;
      StandingRows rows{FootOf(problem_, s),
                        stance.X_WF.translation(),
                        stance.X_WF.linear().leftCols<2>(),
                        foothold_[s] < 0 ? -1 : seen.See(foothold_[s], 2),
                        seen.See(p_[k]),
                        seen.See(angles_[k])};
      if (!seen.variables().empty()) rows_.residuals.emplace_back(std::move(rows), seen.variables());
    }
    if (foothold_[s] < 0 || stance.region_F.empty()) return;
    rows_.residuals.emplace_back(RegionRows{stance.region_F}, std::vector<int>{foothold_[s], foothold_[s] + 1});
  }

  /// Moves a foothold on its plane, within its region.
  static void Move(RigidStance& stance, Vector2 by_F) {
    if (!stance.region_F.empty()) by_F = NearestPoint(stance.region_F, by_F);
    stance.X_WF = stance.X_WF * Eigen::Translation3d(by_F.x(), by_F.y(), 0.0);
    for (Vector2& corner : stance.region_F) corner -= by_F;
  }

  RigidBodyProblem& problem_;
  BodyTrajectory& trajectory_;
  std::vector<AffineVector> p_, angles_;  // by time
  std::vector<int> foothold_;             // first unknown by stance; -1 if it is fixed
  ConstrainedProblem rows_;
};

}  // namespace

const RigidFoot& FootOf(const RigidBodyProblem& problem, std::size_t stance) {
  return problem.feet[static_cast<std::size_t>(problem.stances[stance].foot)];
}

double LeastOutOfReach(const RigidBodyProblem& problem, std::size_t stance, const RigidBodyState& body) {
  RigidBodyProblem alone = problem;
  alone.stances = {problem.stances[stance]};
  alone.stances.front().held = false;
  BodyTrajectory still{{0.0, problem.duration_s}, {body.p_WC, body.p_WC}, {body.angles_rad, body.angles_rad}};
  FitBodyTrajectory(alone, still);
  return OutOfReach(alone, still).largest_m;
}

BodyTrajectory StraightPath(const Terrain& terrain, const RigidBodyProblem& problem, double spacing_s) {
  double first_liftoff = problem.duration_s, last_touchdown = 0.0;
  for (const RigidStance& stance : problem.stances) {
    if (stance.end_s < problem.duration_s) first_liftoff = std::min(first_liftoff, stance.end_s);
    if (stance.start_s > 0.0) last_touchdown = std::max(last_touchdown, stance.start_s);
  }
  if (last_touchdown <= first_liftoff) {
    first_liftoff = 0.0;
    last_touchdown = problem.duration_s;
  }
  const int parts = std::max(4, static_cast<int>(std::lround(problem.duration_s / spacing_s)));
  BodyTrajectory trajectory;
  for (int k = 0; k <= parts; ++k) {
    const double t = problem.duration_s * k / parts;
    const double u = std::clamp((t - first_liftoff) / (last_touchdown - first_liftoff), 0.0, 1.0);
    Vector3 p = (1.0 - u) * problem.start.p_WC + u * problem.goal.p_WC;
    double height = 0.0;
    int grounded = 0;
    for (const RigidFoot& foot : problem.feet) {
      const Vector3 below = p + HeadingAt(problem, t) * foot.p_CF_nominal_B;
      const GroundPoint ground = GroundAt(terrain, below.head<2>());
      if (ground.patch < 0) continue;
      height += ground.height_m - foot.p_CF_nominal_B.z();
      ++grounded;
    }
    if (grounded > 0 && k > 0 && k < parts) p.z() = height / grounded;
    trajectory.time_s.push_back(t);
    trajectory.p_WC.push_back(p);
    trajectory.angles_rad.push_back(WantedAngles(problem, t));
  }
  return trajectory;
}

void FitBodyTrajectory(RigidBodyProblem& problem, BodyTrajectory& trajectory) { Fit(problem, trajectory).Run(); }

Vector3 WantedFoothold(const RigidBodyProblem& problem, const BodyTrajectory& trajectory, std::size_t stance) {
  Vector3 sum = Vector3::Zero();
  const std::vector<std::size_t> times = TimesOf(problem.stances[stance], trajectory);
  for (const std::size_t k : times)
    sum += trajectory.p_WC[k] + RotationOf(trajectory.angles_rad[k]) * FootOf(problem, stance).p_CF_nominal_B;
  return sum / static_cast<double>(times.size());
}

double StanceMisfit(const RigidBodyProblem& problem, const BodyTrajectory& trajectory, std::size_t stance) {
  double sum = 0.0;
  for (const std::size_t k : TimesOf(problem.stances[stance], trajectory)) {
    const Vector3 p_B = FromBody(problem, trajectory, stance, k);
    sum += (p_B - FootOf(problem, stance).p_CF_nominal_B).squaredNorm();
    for (const WorkspaceSide& side : FootOf(problem, stance).workspace_B)
      sum += std::pow(kReach * Beyond(side, p_B), 2);
  }
  return sum;
}

BodyTrajectoryMisfit OutOfReach(const RigidBodyProblem& problem, const BodyTrajectory& trajectory, std::size_t stance) {
  BodyTrajectoryMisfit worst;
  for (const std::size_t k : TimesOf(problem.stances[stance], trajectory))
    worst = Worse(worst, At(problem, trajectory, stance, k));
  return worst;
}

BodyTrajectoryMisfit OutOfReach(const RigidBodyProblem& problem, const BodyTrajectory& trajectory) {
  BodyTrajectoryMisfit worst;
  for (std::size_t s = 0; s < problem.stances.size(); ++s) worst = Worse(worst, OutOfReach(problem, trajectory, s));
  return worst;
}

}  // namespace gaitwright
