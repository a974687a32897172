// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "kinematics/ik/leg_balls.h"
#include "kinematics/ik/leg_ik.h"
#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// Workspace of a leg for many queries: whether a pose of its foot in the base is within the joint limits, with a
/// margin.
///
/// Answers hold for cells of a grid of poses: positions in cubes of the leg length / kCellsPerLeg, and of soles and
/// lines their yaw, roll and pitch in steps of kAngle. A cell is reachable if inverse kinematics reaches its centre,
/// and a point farther from the hip by the margin, within joint limits reduced by the margin on both sides; near those
/// limits its corners too. The margin is limited so that the standing posture stays reachable. A cell is computed at
/// its first query and cached. The standing posture is the middle of a cell, and those of left and right are mirrored
/// about it. Results do not depend on the order of queries. Not thread-safe.
class LegWorkspace {
 public:
  static constexpr double kCellsPerLeg = 40.0;
  static constexpr double kAngle = 0.07;  ///< [rad]

  /// @param reserve  share of each joint's range, and of the leg length, that is kept free: in [0, 0.2].
  /// @throws InvalidArgument when the model has no such leg or the reserve is out of its range.
  LegWorkspace(const RobotModel& model, int leg, double reserve);

  /// Whether the foot's controlled frame (middle of a sole, centre of a sphere) can be brought there.
  /// @param X_BF  pose in the base [m]; of a point or sphere only the position counts.
  bool Reaches(const Pose& X_BF);

  /// The balls of the leg's shapes (LegBalls) when its foot is there, to the change of posture within a cell. They are
  /// computed at the first query and cached.
  /// @param balls  replaced; empty for a leg without shapes.  @return false if the foot cannot be there.
  bool BallsAt(const Pose& X_BF, std::vector<Ball>& balls);

  /// How many cells have been worked out.
  int size() const { return known_; }
  /// The foot's controlled frame in the base in the standing posture.
  const Pose& standing() const { return X_BF_standing_; }

 private:
  struct Entry {
    std::uint64_t key = 0;  // 0 for none; the answer is its lowest bit
    int posture = -1;       // of the leg, in centres_; -1 while not asked for
  };
  using Cell = std::int64_t[6];

  bool CellOf(const Pose& X_BF, Cell& cell) const;
  std::size_t Find(const Cell& cell);
  bool WorkOut(const Cell& cell) const;
  Pose InCell(const Cell& cell, double share, unsigned corner) const;
  bool Solves(const Pose& X_BF) const { return SpareOf(X_BF) >= 0.0; }
  double SpareOf(const Pose& X_BF) const;
  std::optional<VectorX> JointsAt(const Pose& X_BF) const;
  void Grow();

  std::shared_ptr<const RobotModel> narrow_;  // with the reserve off its limits
  LegIk ik_;
  LegChain chain_;
  Pose X_BF_standing_ = Pose::Identity();
  Vector3 p_BH_ = Vector3::Zero();  // hip
  VectorX standing_;                // by dofs of the leg
  double cell_m_ = 0.0, side_ = 1.0, reserve_m_ = 0.0;
  bool turned_ = false;  // rotations count
  std::vector<Entry> table_;
  LegBalls balls_;
  std::vector<Vector3> centres_;  // in the middle of cells, by posture, by ball
  int known_ = 0;
};

}  // namespace gaitwright
