// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "planning/plan/sample_plan.h"
#include "playback/log/playback_log.h"
#include "playback/score/score_options.h"
#include "playback/score/support.h"

namespace gaitwright {

/// One foot at one time.
struct FootSample {
  Vector3 p_WF = Vector3::Zero();  ///< origin of its contact frame [m]
  double height_m = 0.0;           ///< of its lowest contact point over the ground
  double slide_m_s =
      0.0;  ///< speed along the ground of the material at the contact frame's origin, or at the front edge
  Vector3 force_W = Vector3::Zero();
};

/// Balance at one time; the same code computes planned and measured values.
///
/// = Notation =  W world, C centre of mass, Z zero-moment point, S support (the scheduled feet at their current places)
struct MotionSample {
  double time_s = 0.0;
  FootSet stance = 0;  ///< scheduled; measured, if the plan has no contacts
  Pose X_WB = Pose::Identity();
  double base_height_m = 0.0;  ///< z of the base's HeightPoint in W, for falls
  Vector3 p_WC = Vector3::Zero(), v_WC = Vector3::Zero();
  double omega_rad_s = 0.0;         ///< sqrt(g / h), h the height of C above S, or above the ground in flight
  Vector2 dcm_W = Vector2::Zero();  ///< c + c' / omega
  Support support;
  Vector2 p_WZ = Vector2::Zero();  ///< low-passed; valid only if has_zmp
  bool has_zmp = false;            ///< enough normal force on a coplanar support
  double normal_n = 0.0;           ///< of all contacts
  std::vector<FootSample> feet;

  /// Signed distances to the edge of S [m]. @pre has_zmp, or a support.
  double zmp_margin_m() const { return SignedDistance(support.polygon, p_WZ); }
  double static_margin_m() const { return SignedDistance(support.polygon, p_WC.head<2>()); }
};

/// Planned and measured motion; sample k of both has the same time.
struct MotionSeries {
  std::vector<MotionSample> planned, measured;
  std::vector<WholeBodySample> plan;  ///< the plan's rows at these times
};

/// The plan and the log at the log's times.
///
/// The force of a log sample is a mean over the preceding interval. Therefore scheduled feet and planned forces are
/// taken at the middle of that interval, postures and velocities at its end. The planned ZMP follows from the plan's
/// own q, v, a by inverse dynamics, the measured one from contact impulses. Both pass the same first-order low-pass, y
/// += (1 - exp(-dt / zmp_filter_s)) (x - y), which restarts after samples without a ZMP
/// and where the support changes.
/// @throws InvalidArgument if the plan has no rows or a vector of plan or log does not fit the model.
MotionSeries MakeMotionSeries(const RobotModel& model, const MotionPlan& plan, const PlaybackLog& log,
                              const ScoreOptions& options);

/// `measured` of MakeMotionSeries alone, which needs a third of the memory. @throws InvalidArgument for a log that does
/// not fit the model.
std::vector<MotionSample> MakeMeasuredSeries(const RobotModel& model, const MotionPlan& plan, const PlaybackLog& log,
                                             const ScoreOptions& options);

/// The plan from its first row to its last, sampled at a rate [Hz] as a log would be; `measured` is empty.
/// @throws InvalidArgument if the plan has no rows or does not fit the model, or the rate is not positive.
MotionSeries MakePlannedSeries(const RobotModel& model, const MotionPlan& plan, double rate_hz,
                               const ScoreOptions& options);

}  // namespace gaitwright
