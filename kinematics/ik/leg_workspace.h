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

/// What a leg reaches, for many questions: is a pose of its foot in the base within its joints' limits, with a reserve?
///
/// Answers hold for cells of a grid of poses: positions in cubes of the leg length / kCellsPerLeg, and of soles and
/// lines their yaw, roll and pitch in steps of kAngle. A cell is reached when inverse kinematics brings the foot to its
/// middle, and a reserve farther from the hip too, within limits that are the reserve narrower on both sides, and near
/// those limits to its corners as well. The reserve is never so much that the standing posture is left out. A cell is
/// worked out when first asked for and then kept, so later questions cost a look-up. The standing posture is the middle
/// of a cell, and those of left and right are mirrored about it. Answers do not depend on the order of questions. Not
/// for several threads at once.
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
  /// worked out when first asked for and then kept.
  /// @param balls  replaced; empty for a leg without shapes.  @return false where the foot cannot be.
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
