// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "kinematics/collision/link_distances_internal.h"
#include "optimisation/numerics/elastic_rows_internal.h"
#include "optimisation/trajectory/chain_spline_internal.h"
#include "optimisation/trajectory/knot_model_internal.h"
#include "optimisation/trajectory/turning_chart_internal.h"

namespace gaitwright {

/// A foot's contact with the ground at a knot: forces are unknowns, inside friction cones.
struct PressingFoot {
  KnotContact contact;
  Matrix3 axes_W = Matrix3::Identity();  ///< two tangents of the ground, and its normal
  double friction = 0.8;                 ///< that forces may use
};

/// Where a foot is to be at a knot.
///
/// A sphere that turns rolls: with its radius r and the normal n, the origin of F is to be at
///   p_W + r log(R R_roll^T) x n,   R its rotation, R_roll the one for which p_W was reckoned.
struct FootGoal {
  int foot = 0;
  Vector3 p_W = Vector3::Zero();         ///< of the origin of F [m]
  Matrix3 R_W = Matrix3::Identity();     ///< of a sole
  Matrix3 R_roll = Matrix3::Identity();  ///< of a sphere
  Vector3 normal_W = Vector3::UnitZ();   ///< of a sphere
  Matrix3 axes_W = Matrix3::Identity();  ///< along which the position's rows are
  std::array<bool, 6> rows{};            ///< position by axis, rotation by axis of F
  std::array<double, 6> below{};         ///< how far each of these may be below its goal [m], [rad]
  std::array<double, 6> above{};         ///< how far each of these may be above it
  bool swings = false;                   ///< for messages

  int count() const;
};

/// Two links that are to keep a distance at a knot.
struct ApartPair {
  int pair = 0;          ///< of the problem's LinkDistances
  double least_m = 0.0;  ///< times BodyLimitUse::apart
};

/// A point of a body that is to be near a place at a knot.
struct PointGoal {
  int body = 0;
  Vector3 p_BQ = Vector3::Zero();  ///< the point [m]
  Vector3 p_W = Vector3::Zero();   ///< the place [m]; from the origin of the base in its axes if `in_base`
  bool in_base = false;
  double weight = 1.0;  ///< [1/m], for 10 ms
};

/// A knot at which a periodic motion repeats itself: its coordinates, rates and accelerations are those of the cycle's
/// own state, a free variable, turned about the vertical axis through the origin of W and moved. The chart of the
/// problem turns by yaw first.
struct CycleTie {
  int cycle = 0;         ///< of the problem: ties of one cycle have one state
  double yaw_rad = 0.0;  ///< this and the next are 0 for the first tie of a cycle
  Vector3 move_W = Vector3::Zero();
};

/// What is asked at a knot. Vectors are in the coordinates of BodyProblem.
struct BodyKnot {
  std::vector<PressingFoot> pressing;
  std::vector<FootGoal> feet;
  std::vector<ApartPair> apart;
  std::vector<PointGoal> points;
  VectorJet reference;  ///< what the motion is to be near
  VectorX near_scale;   ///< factors of the weights on the distance from the reference, by coordinate; empty: all 1
  /// Wrench on the base about its origin that the spline leaves unbalanced [N, N m]; see SolvedTrajectory.
  Vector6 residual_W = Vector6::Zero();
  bool pins_place = false;      ///< the position is that of the reference
  bool pins_motion = false;     ///< rate and acceleration are those of the reference
  std::optional<CycleTie> tie;  ///< the state of a cycle is repeated here
  bool is_given = false;        ///< place and motion are those of the reference, and nothing else is asked or weighed
};

/// Bounds on the rows of a knot's feet, in their order: how far each may be from its goal [m], [rad].
std::vector<RowBounds> FootBoundsOf(const BodyKnot& knot);

/// Weights of the cost, each for a unit of what it weighs and for 10 ms.
struct BodyWeights {
  double base_position = 20.0;         ///< distance from the reference [1/m]
  double base_rotation = 10.0;         ///< [1/rad]
  double joint = 2.0;                  ///< [1/rad]
  double base_acceleration = 0.05;     ///< difference from the reference's [s^2/m], [s^2/rad]
  double joint_acceleration = 1e-3;    ///< [s^2/rad]
  double effort = 0.3;                 ///< share of a motor's limit
  double force = 0.1;                  ///< force of a contact point over the weight
  std::vector<double> effort_of = {};  ///< factors of `effort` by motor; empty: all 1
  double power = 0.0;                  ///< mechanical power of a motor over weight times root of g times leg length
};

/// Shares of limits that a motion may use at knots. Controllers need room for corrections, and more is used between
/// knots.
struct BodyLimitUse {
  double effort = 0.92, speed = 0.97;  ///< shares of the limits of torque, and of those of speed and acceleration
  double range_margin = 0.015;         ///< to the ends of a joint's range [rad], [m]; smaller near the start and end
  double landing_margin = 0.0;  ///< the same for landings, where joints go further than planned; smaller to an end that
                                ///< is near the standing posture
  double cone_margin = 1e-3;    ///< of the force at a contact point to its friction cone, over the weight
  double apart = 1.0;           ///< share of the distances of ApartPair
  /// Factors of effort and speed by motor, which make up for what motors use between knots; empty: all 1.
  std::vector<double> effort_of = {}, speed_of = {};
};

/// For motions that need nearly all that the robot has.
inline const BodyLimitUse kFullUse = {0.98, 0.99, 4e-3, 0.0, 0.0, 0.3};

/// Of a problem that is some knots in a row of a longer problem.
struct BodyWindow {
  std::vector<KnotBasis> basis;       ///< of the longer problem's spline, by knot
  double start_s = 0.0, end_s = 0.0;  ///< of the longer problem
};

/// A motion of the whole body and of the forces on its feet over a schedule of contacts, as a spline over knots.
///
/// Unknowns: the control points of a ChainSpline of the coordinates
///   x = [p_WB (3), angles of TurningChart (3), independent joints (n)],
/// and at each knot the force at each contact point, in units of the weight; between knots forces are linear. At knots
/// hold: Newton's and Euler's equations of the whole (six rows), feet on their goals, forces inside their cones,
/// positions, speeds, accelerations and efforts within limits, between them jerks, torque-speed curves included; links
/// that are listed keep their distance. Knots with a CycleTie repeat the state of their cycle.
struct BodyProblem {
  const RobotModel* model = nullptr;
  TurningChart chart;
  std::vector<double> time_s;   ///< of the knots
  std::vector<BodyKnot> knots;  ///< as many
  BodyWeights weights;
  BodyLimitUse use;
  std::vector<bool> still;  ///< by joint: it stays exactly where the first reference has it; empty: none does
  std::optional<BodyWindow> window;
  const LinkDistances* distances = nullptr;  ///< of the model; needed if a knot has an ApartPair
  bool limits_jerk = true;                   ///< limits of jerk are constraints; not where the pace is chosen

  bool StaysStill(int dof) const { return !still.empty() && still[static_cast<std::size_t>(dof)]; }
  double start_s() const { return window ? window->start_s : time_s.front(); }
  double end_s() const { return window ? window->end_s : time_s.back(); }
  ChainSpline spline() const { return window ? ChainSpline(time_s, window->basis) : ChainSpline(time_s); }
};

/// The problem of the knots from `first` to `last`, both included. Unless the first one is that of the whole problem,
/// its motion is given: that of `points`, control points of the whole problem. The last one is free like any other.
BodyProblem WindowOf(const BodyProblem& whole, const ChainSpline& spline, const MatrixX& points, int first, int last);

/// State of the robot for a jet of the coordinates.
struct ChartedState {
  VectorX q, v, a;
  ChartedTurn turn;
};
void StateOf(const TurningChart& chart, const VectorJet& jet, ChartedState& state);

/// The reverse. @param near  coordinates of a state nearby, for angles beyond pi.
VectorJet JetOf(const TurningChart& chart, const VectorX& q, const VectorX& v, const VectorX& a, const VectorX& near);

}  // namespace gaitwright
