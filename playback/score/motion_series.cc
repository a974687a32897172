// SPDX-License-Identifier: BSD-3-Clause
#include "playback/score/motion_series.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "kinematics/base/result.h"
#include "kinematics/model/base_height.h"
#include "kinematics/stability/zero_moment_point.h"
#include "planning/plan/check_motion.h"
#include "planning/plan/heel_off_internal.h"
#include "planning/plan/plans_contacts_internal.h"

namespace gaitwright {
namespace {

/// Force on the robot and its moment about a point, in W.
struct TotalWrench {
  Vector3 force_W = Vector3::Zero(), moment_W = Vector3::Zero();

  void Add(const Vector3& force, const Vector3& moment, const Vector3& arm) {
    force_W += force;
    moment_W += moment + arm.cross(force);
  }
};

class Sampler {
 public:
  Sampler(const RobotModel& model, const MotionPlan& plan, const ScoreOptions& options)
      : model_(model), plan_(plan), options_(options), height_point_B_(HeightPoint(model)), scratch_(model) {}

  /// All quantities that follow from posture and velocity. @param contact_s  time of the contacts of `stance`.
  MotionSample Posture(double time_s, double contact_s, FootSet stance, const VectorX& q, const VectorX& v) {
    ForwardVelocities(model_, q, v, scratch_);
    const FootSet on_edge = FeetOnEdge(stance, contact_s);
    MotionSample sample;
    sample.time_s = time_s;
    sample.stance = stance;
    sample.X_WB.linear() = scratch_.R_WB[0];
    sample.X_WB.translation() = scratch_.p_WB[0];
    sample.base_height_m = (sample.X_WB * height_point_B_).z();
    sample.p_WC = CentreOfMass(model_, scratch_);
    sample.v_WC = CentroidalMomentum(model_, scratch_).head<3>() / model_.total_mass_kg;
    sample.support = SupportOf(model_, scratch_, plan_.terrain, stance, on_edge);
    const double ground = sample.support.empty() ? GroundAt(plan_.terrain, sample.p_WC.head<2>()).height_m
                                                 : sample.support.reference_W.z();
    sample.omega_rad_s = std::sqrt(kGravity / std::max(sample.p_WC.z() - ground, 1e-3));
    sample.dcm_W = DivergentComponent(sample.p_WC, sample.v_WC, sample.omega_rad_s);
    for (int foot = 0; foot < static_cast<int>(model_.feet.size()); ++foot)
      sample.feet.push_back(FootOf(foot, Contains(on_edge, foot)));
    return sample;
  }

  /// The unfiltered ZMP of the wrenches on the feet. @pre Posture at the same q.
  void AddMeasuredForces(const std::vector<ContactWrench>& wrenches, MotionSample& sample) {
    TotalWrench total;
    for (std::size_t i = 0; i < std::min(wrenches.size(), sample.feet.size()); ++i) {
      sample.feet[i].force_W = wrenches[i].force_W;
      total.Add(wrenches[i].force_W, wrenches[i].moment_W, sample.feet[i].p_WF - sample.support.reference_W);
    }
    SetZmp(total, sample);
  }

  /// The unfiltered ZMP of a plan's row, by inverse dynamics.
  void AddPlannedForces(const WholeBodySample& row, MotionSample& sample) {
    VectorX tau;
    InverseDynamics(model_, row.q, row.v, row.a, scratch_, tau);
    TotalWrench total;
    total.Add(tau.head<3>(), tau.segment<3>(3), Vector3(row.q.head<3>()) - sample.support.reference_W);
    for (std::size_t i = 0; i < std::min(row.wrenches.size(), sample.feet.size()); ++i) {
      sample.feet[i].force_W = row.wrenches[i].force_W;
    }
    SetZmp(total, sample);
  }

 private:
  /// Feet of a stance that stand on their soles' front edges by the plan.
  FootSet FeetOnEdge(FootSet stance, double time_s) const {
    FootSet on_edge = 0;
    for (int foot = 0; foot < static_cast<int>(model_.feet.size()); ++foot) {
      const int index = FootholdAt(plan_.footsteps, foot, time_s);
      if (index < 0 || !Contains(stance, foot) || !model_.feet[static_cast<std::size_t>(foot)].has_sole()) continue;
      if (StandsOnEdge(plan_.footsteps.footholds[static_cast<std::size_t>(index)], time_s)) on_edge |= FootBit(foot);
    }
    return on_edge;
  }

  FootSample FootOf(int foot, bool on_edge) const {
    const Foot& f = model_.feet[static_cast<std::size_t>(foot)];
    FootSample sample;
    const Pose X_WF = ContactFrame(model_, scratch_, plan_.terrain, foot);
    sample.p_WF = X_WF.translation();
    const std::size_t body = static_cast<std::size_t>(f.body);
    const Vector3 p_WQ = on_edge ? X_WF * EdgeMiddle(f) : sample.p_WF;
    const Vector3 p_BF = scratch_.R_WB[body].transpose() * (p_WQ - scratch_.p_WB[body]);
    const Vector3 v = PointVelocity(scratch_, f.body, p_BF).head<3>();
    const Vector3 normal = GroundAt(plan_.terrain, sample.p_WF.head<2>()).normal_W;
    sample.slide_m_s = (v - v.dot(normal) * normal).norm();
    sample.height_m = std::numeric_limits<double>::infinity();
    for (const Vector3& p : ContactPoints(model_, scratch_, plan_.terrain, foot)) {
      const GroundPoint ground = GroundAt(plan_.terrain, p.head<2>());
      if (ground.patch >= 0) sample.height_m = std::min(sample.height_m, p.z() - ground.height_m);
    }
    return sample;
  }

  /// p_WZ = p_WS + n x M_S / (n . F): the point of the support plane at which the moment has only a normal component.
  /// Sardain and Bessonnet, IEEE T-SMC A 34(5) 2004.
  void SetZmp(const TotalWrench& about_support, MotionSample& sample) const {
    const Vector3& n = sample.support.normal_W;
    sample.normal_n = n.dot(about_support.force_W);
    sample.has_zmp = !sample.support.empty() && sample.support.coplanar && std::isfinite(sample.normal_n) &&
                     sample.normal_n >= options_.min_normal_fraction * model_.weight_n();
    if (!sample.has_zmp) return;
    const Vector3 offset = n.cross(about_support.moment_W) / sample.normal_n;
    sample.p_WZ = (sample.support.reference_W + offset).head<2>();
  }

  const RobotModel& model_;
  const MotionPlan& plan_;
  const ScoreOptions& options_;
  Vector3 height_point_B_;
  DynamicsScratch scratch_;
};

void LowPassZmp(std::vector<MotionSample>& samples, double time_constant_s) {
  const MotionSample* before = nullptr;
  for (MotionSample& sample : samples) {
    const bool same_feet = before != nullptr && before->stance == sample.stance;
    if (sample.has_zmp && same_feet && time_constant_s > 0.0) {
      const double gain = 1.0 - std::exp(-(sample.time_s - before->time_s) / time_constant_s);
      sample.p_WZ = before->p_WZ + gain * (sample.p_WZ - before->p_WZ);
    }
    before = sample.has_zmp ? &sample : nullptr;
  }
}

void CheckSize(const char* what, const VectorX& vector, int expected, const std::string& robot) {
  if (vector.size() == expected) return;
  throw InvalidArgument(
      fmt::format("Score: {} has {} entries; robot '{}' needs {}", what, vector.size(), robot, expected));
}

void CheckLog(const RobotModel& model, const PlaybackLog& log) {
  const std::size_t feet = model.feet.size();
  double before_s = -std::numeric_limits<double>::infinity();
  for (const LogSample& sample : log.samples) {
    if (!(sample.time_s > before_s)) {
      throw InvalidArgument(fmt::format("Score: the log has a sample at {} s after one at {} s; times must increase",
                                        sample.time_s, before_s));
    }
    before_s = sample.time_s;
    CheckSize("the log's q", sample.q, model.nq(), model.name);
    CheckSize("the log's v", sample.v, model.nv(), model.name);
    CheckSize("the log's tau", sample.tau, model.num_dofs(), model.name);
    CheckSize("the log's tau_peak", sample.tau_peak, model.num_dofs(), model.name);
    CheckSize("the log's effort_use", sample.effort_use, model.num_dofs(), model.name);
    if (sample.wrenches.size() > feet) {
      throw InvalidArgument(fmt::format("Score: the log has wrenches of {} feet; robot '{}' has {}",
                                        sample.wrenches.size(), model.name, feet));
    }
  }
  for (const StanceRecord& stance : log.stances) {
    if (stance.foot >= 0 && static_cast<std::size_t>(stance.foot) < feet) continue;
    throw InvalidArgument(fmt::format("Score: the log has a stance of foot {}; robot '{}' has feet 0 to {}",
                                      stance.foot, model.name, static_cast<int>(feet) - 1));
  }
  if (!(log.log_rate_hz > 0.0 && std::isfinite(log.log_rate_hz))) {
    throw InvalidArgument(
        fmt::format("Score: the log's rate is {} Hz; it must be positive and finite", log.log_rate_hz));
  }
}

FootSet ScheduledAt(const ContactSchedule& schedule, double time_s) {
  if (schedule.phases.empty()) return 0;
  return schedule.phases[static_cast<std::size_t>(PhaseAt(schedule, time_s))].stance;
}

/// The plan's rows. If torques or wrenches are missing, each row has empty ones. Complete rows are not copied.
class AllRows {
 public:
  explicit AllRows(const WholeBodyTrajectory& motion) : rows_(&motion) {
    if (motion.tau.size() == motion.q.size() && motion.wrenches.size() == motion.q.size()) return;
    filled_ = motion;
    filled_.tau.resize(motion.q.size());
    filled_.wrenches.resize(motion.q.size());
    rows_ = &filled_;
  }
  AllRows(const AllRows&) = delete;
  AllRows& operator=(const AllRows&) = delete;

  const WholeBodyTrajectory& operator*() const { return *rows_; }

 private:
  WholeBodyTrajectory filled_;
  const WholeBodyTrajectory* rows_;
};

WholeBodySample At(const WholeBodyTrajectory& motion, double time_s) {
  WholeBodySample sample;
  SampleWholeBody(motion, time_s, sample);
  return sample;
}

/// The end of a log interval, its middle, the feet on the ground, and whether the plan has forces.
struct PlannedTime {
  double time_s, middle_s;
  FootSet stance;
  bool with_forces;
};

/// Adds the planned state at the end of a log interval, with the forces of its middle.
void AddPlanned(const WholeBodyTrajectory& motion, const PlannedTime& at, Sampler& sampler, MotionSeries& series) {
  const auto& [time_s, middle_s, stance, with_forces] = at;
  series.plan.push_back(At(motion, time_s));
  series.planned.push_back(sampler.Posture(time_s, middle_s, stance, series.plan.back().q, series.plan.back().v));
  if (with_forces) sampler.AddPlannedForces(At(motion, middle_s), series.planned.back());
}

/// Calls `add` with each sample of a log, the middle of its interval and the feet on the ground, up to the first state
/// that is not finite: there the simulation diverged, and Score reports the time.
template <class Add>
void ForEachSample(const MotionPlan& plan, const PlaybackLog& log, Add add) {
  const double half_interval = 0.5 / log.log_rate_hz;
  for (const LogSample& row : log.samples) {
    if (!row.q.allFinite() || !row.v.allFinite()) break;
    const double middle_s = row.time_s - half_interval;
    add(row, middle_s, PlansContacts(plan) ? ScheduledAt(plan.schedule, middle_s) : row.contact);
  }
}

MotionSample MeasuredSample(const LogSample& row, double middle_s, FootSet stance, Sampler& sampler) {
  MotionSample sample = sampler.Posture(row.time_s, middle_s, stance, row.q, row.v);
  sampler.AddMeasuredForces(row.wrenches, sample);
  return sample;
}

}  // namespace

std::vector<MotionSample> MakeMeasuredSeries(const RobotModel& model, const MotionPlan& plan, const PlaybackLog& log,
                                             const ScoreOptions& options) {
  CheckLog(model, log);
  Sampler sampler(model, plan, options);
  std::vector<MotionSample> measured;
  measured.reserve(log.samples.size());
  ForEachSample(plan, log, [&](const LogSample& row, double middle_s, FootSet stance) {
    measured.push_back(MeasuredSample(row, middle_s, stance, sampler));
  });
  LowPassZmp(measured, options.zmp_filter_s);
  return measured;
}

MotionSeries MakeMotionSeries(const RobotModel& model, const MotionPlan& plan, const PlaybackLog& log,
                              const ScoreOptions& options) {
  CheckMotion(model, plan.whole_body);
  CheckLog(model, log);
  Sampler sampler(model, plan, options);
  const AllRows rows(plan.whole_body);
  const WholeBodyTrajectory& motion = *rows;
  MotionSeries series;
  ForEachSample(plan, log, [&](const LogSample& row, double middle_s, FootSet stance) {
    series.measured.push_back(MeasuredSample(row, middle_s, stance, sampler));
    AddPlanned(motion, {row.time_s, middle_s, stance, PlansContacts(plan)}, sampler, series);
  });
  LowPassZmp(series.measured, options.zmp_filter_s);
  LowPassZmp(series.planned, options.zmp_filter_s);
  return series;
}

MotionSeries MakePlannedSeries(const RobotModel& model, const MotionPlan& plan, double rate_hz,
                               const ScoreOptions& options) {
  if (!(rate_hz > 0.0 && std::isfinite(rate_hz)))
    throw InvalidArgument(fmt::format("MakePlannedSeries: the rate is {} Hz; it must be positive and finite", rate_hz));
  CheckMotion(model, plan.whole_body);
  Sampler sampler(model, plan, options);
  const AllRows rows(plan.whole_body);
  const WholeBodyTrajectory& motion = *rows;
  MotionSeries series;
  const int intervals = static_cast<int>(std::floor(plan.duration_s() * rate_hz + 1e-6));
  for (int k = 0; k <= intervals; ++k) {
    const double time = motion.start_s + k / rate_hz, middle = time - 0.5 / rate_hz;
    AddPlanned(motion, {time, middle, ScheduledAt(plan.schedule, middle), true}, sampler, series);
  }
  LowPassZmp(series.planned, options.zmp_filter_s);
  return series;
}

}  // namespace gaitwright
