// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "kinematics/ik/leg_balls.h"
#include "kinematics/ik/leg_ik.h"
#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// Workspace of a leg for many queries: whether a pose of its foot in the base is within the joint limits, with a
/// margin.
///
/// Answers are computed for cells of a grid of poses: positions in cubes of the leg length / kCellsPerLeg, and for
/// soles and lines yaw, roll and pitch in steps of kAngle. A cell is reachable if inverse kinematics reaches its
/// centre, and a point farther from the hip by the margin, within joint limits reduced by the margin on both sides;
/// near those limits, its corners must be reachable too. The margin is limited so that the standing posture stays
/// reachable. A cell is computed at its first query and cached. The standing posture is at the centre of a cell, and
/// the cells of left and right legs are mirrored about it. Results do not depend on the order of queries. Not
/// thread-safe.
class LegWorkspace {
 public:
  static constexpr double kCellsPerLeg = 40.0;
  static constexpr double kAngle = 0.07;  ///< [rad]

  /// @param reserve  margin, as a share of each joint's range and of the leg length, in [0, 0.2].
  /// @throws InvalidArgument if the model has no such leg or the margin is out of its range.
  LegWorkspace(const RobotModel& model, int leg, double reserve);

  /// Whether the foot's controlled frame (middle of a sole, centre of a sphere) can reach a pose.
  /// @param X_BF  pose in the base [m]; for a point or sphere, only the position is used.
  bool Reaches(const Pose& X_BF);

  /// The balls of the leg's shapes (LegBalls) for a pose of its foot. They are approximate, because the posture is that
  /// of the cell's centre. They are computed at the first query and cached.
  /// @param balls  replaced; empty for a leg without shapes.  @return false if the foot cannot reach the pose.
  bool BallsAt(const Pose& X_BF, std::vector<Ball>& balls);

  /// Number of computed cells.
  int size() const { return known_; }
  /// The foot's controlled frame in the base in the standing posture.
  const Pose& standing() const { return X_BF_standing_; }

 private:
  struct Entry {
    std::uint64_t key = 0;  // 0 for an empty entry; the lowest bit is the answer
    int posture = -1;       // index of the leg's posture in centres_; -1 if not computed
  };
  using Cell = std::int64_t[6];

  bool CellOf(const Pose& X_BF, Cell& cell) const;
  std::size_t Find(const Cell& cell);
  bool WorkOut(const Cell& cell) const;
  Pose InCell(const Cell& cell, double share, unsigned corner) const;
  double MarginOf(const VectorX& joints) const;
  std::optional<VectorX> JointsAt(const Pose& X_BF, const VectorX& guess) const;
  void Grow();

  std::shared_ptr<const RobotModel> narrow_;  // with limits reduced by the margin
  LegIk ik_;
  LegChain chain_;
  Pose X_BF_standing_ = Pose::Identity();
  Vector3 p_BH_ = Vector3::Zero();  // hip
  VectorX standing_;                // standing posture by dofs of the leg
  double cell_m_ = 0.0, side_ = 1.0, reserve_m_ = 0.0;
  bool turned_ = false;  // whether rotations are controlled
  std::vector<Entry> table_;
  LegBalls balls_;
  std::vector<Vector3> centres_;  // ball centres at the centres of cells, by posture and ball
  int known_ = 0;
};

/// The workspaces of a robot's legs, for searches that follow each other. Not thread-safe.
class LegWorkspaces {
 public:
  /// The workspace of a leg with a margin, which is made at the first call. @param model  the same at all calls.
  /// @throws InvalidArgument as the constructor of LegWorkspace.
  LegWorkspace& Of(const RobotModel& model, int leg, double reserve);

 private:
  std::map<std::pair<int, double>, std::unique_ptr<LegWorkspace>> of_;  // by leg and margin
};

}  // namespace gaitwright
