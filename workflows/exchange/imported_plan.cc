// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/exchange/imported_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "kinematics/dynamics/dynamics.h"
#include "kinematics/spatial/rotation.h"
#include "optimisation/whole_body/solve_whole_body.h"
#include "planning/plan/carried_plan.h"
#include "planning/plan/robot_of_plan.h"
#include "planning/plan/support_plane.h"
#include "workflows/exchange/foot_track.h"
#include "workflows/exchange/given_forces.h"
#include "workflows/exchange/median_internal.h"

namespace gaitwright {
namespace {

/// A length rounded to 0.1 mm, without "-0".
std::string Metres(double length_m) { return fmt::format("{:.4f}", 1e-4 * std::round(1e4 * length_m) + 0.0); }

class Builder {
 public:
  Builder(const RobotModel& model, const Terrain& terrain, EvenMotion motion, const ImportOptions& options,
          ImportNotes& notes)
      : model_(model), motion_(std::move(motion)), options_(options), notes_(notes) {
    SetRobot(model, plan_);
    plan_.terrain = terrain;
  }

  MotionPlan Run(const std::optional<PlanarPose>& goal) {
    feet_ = FeetOf(model_, plan_.terrain, motion_);
    CheckGround();
    plan_.schedule = ScheduleOf(model_, motion_, feet_, options_, notes_.derived);
    plan_.footsteps = FootholdsOf(model_, plan_.terrain, plan_.schedule, motion_, feet_);
    notes_.derived.push_back({"footholds", "median positions of the feet in each stance, projected onto the ground"});
    NoteRolling();
    AddSwings();
    AddForces();
    AddCentroidal();
    AddPart(goal);
    NoteStart();
    return std::move(plan_);
  }

 private:
  /// Checks that the feet reach the ground; a constant height error means wrong frames or units.
  void CheckGround() {
    constexpr double kFar = 0.05, kSlight = 1e-3;  // share of the leg length, [m]
    std::vector<double> lowest;
    for (std::size_t k = 0; k < motion_.q.size(); ++k) {
      double least = feet_.front().height_m[k];
      for (const FootTrack& foot : feet_) least = std::min(least, foot.height_m[k]);
      lowest.push_back(least);
    }
    const double height = MedianOf(std::move(lowest)), lift_m = options_.lift_m - height;
    if (!options_.any_height && !(std::abs(height) <= kFar * model_.leg_length_m())) {
      throw InvalidArgument(fmt::format(
          "the robot's lowest foot is {:.3f} m {} the ground in most rows; at most {:.3f} m is accepted. base_z_m "
          "belongs to the URDF's root link; --set lift_m={} moves the base, --terrain sets another ground",
          std::abs(height), height > 0.0 ? "over" : "under", kFar * model_.leg_length_m(), Metres(lift_m)));
    }
    if (std::abs(height) > kSlight) {
      notes_.warnings.push_back(
          fmt::format("the robot's lowest foot is {:.1f} mm {} the ground in most rows; lift_m={} would correct that",
                      1e3 * std::abs(height), height > 0.0 ? "over" : "under", Metres(lift_m)));
    }
  }

  /// Warns if a foot rotates about a fixed centre: the motion was made for point feet, but this robot's feet are
  /// spheres.
  void NoteRolling() {
    constexpr double kSlides = 1e-3, kStays = 0.3;  // [m], of the slide
    double farthest = kSlides;
    std::string where;
    for (const Foothold& foothold : plan_.footsteps.footholds) {
      const FootTrack& foot = feet_[static_cast<std::size_t>(foothold.foot)];
      const auto first = RowAt(foothold.touchdown_s), last = RowAt(foothold.liftoff_s);
      double slide = 0.0, stray = 0.0;
      for (std::size_t k = first; k <= last; ++k) {
        const Vector3 moved = foot.X_WF[k].translation() - foot.X_WF[first].translation();
        stray = std::max(stray, moved.norm());
        slide = std::max(slide, (moved - (foot.rolled_W[k] - foot.rolled_W[first])).norm());
      }
      if (slide <= farthest || stray > kStays * slide) continue;
      farthest = slide;
      const Foot& described = model_.feet[static_cast<std::size_t>(foothold.foot)];
      where =
          fmt::format("foot '{}', a sphere of {:.3g} mm, rotates in place from {:.3f} s on and so slides by {:.1f} mm",
                      described.name, 1e3 * described.radius, foothold.touchdown_s, 1e3 * slide);
    }
    if (where.empty()) return;
    notes_.warnings.push_back("the file's feet are points, which do not roll: " + where +
                              "; the audit reports this, although a real foot would roll");
  }

  std::size_t RowAt(double time_s) const {
    return static_cast<std::size_t>(std::clamp<long>(std::lround(time_s / motion_.step_s), 0, motion_.size() - 1));
  }

  void AddSwings() {
    constexpr double kOff = 1e-3;  // [m]
    double farthest = 0.0;
    std::string where;
    for (std::size_t i = 0; i < plan_.footsteps.footholds.size(); ++i) {
      const Foothold& from = plan_.footsteps.footholds[i];
      const auto next =
          std::find_if(plan_.footsteps.footholds.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                       plan_.footsteps.footholds.end(), [&](const Foothold& to) { return to.foot == from.foot; });
      if (next == plan_.footsteps.footholds.end()) continue;
      const auto foot = static_cast<std::size_t>(from.foot);
      double off = 0.0;
      plan_.swings.push_back(SwingOf(from, *next, motion_, feet_[foot], off));
      if (off <= farthest) continue;
      farthest = off;
      where = fmt::format("that of foot '{}' from {:.3f} s on", model_.feet[foot].name, from.liftoff_s);
    }
    std::stable_sort(plan_.swings.begin(), plan_.swings.end(),
                     [](const auto& a, const auto& b) { return a.start_s < b.start_s; });
    if (plan_.swings.empty()) return;
    notes_.derived.push_back({"swings", "curves fitted to the feet's paths, at rest at both ends"});
    if (farthest > kOff) {
      notes_.warnings.push_back(
          fmt::format("swings are up to {:.1f} mm off the feet's paths, {}: the paths do not begin and end at rest on "
                      "their footholds",
                      1e3 * farthest, where));
    }
  }

  void AddForces() {
    WholeBodySolution solution;
    solution.trajectory.step_s = motion_.step_s;
    solution.trajectory.q = motion_.q;
    solution.trajectory.v = motion_.v;
    solution.trajectory.a = motion_.a;
    WholeBodyProblem problem;
    problem.terrain = &plan_.terrain;
    problem.schedule = &plan_.schedule;
    problem.footsteps = &plan_.footsteps;
    AddContactForces(model_, problem, {options_.load_ramp_s, options_.friction_use}, solution);
    plan_.whole_body = std::move(solution.trajectory);
    plan_.centroidal.p_WZ = HeldOverFlights(solution.zmp_W, Pressing());
    TakeGivenForces(model_, motion_, plan_, notes_.derived);
  }

  /// Rows in which the ground carries some of the weight.
  std::vector<bool> Pressing() const {
    constexpr double kPresses = 0.02;  // share of the weight
    std::vector<bool> presses;
    for (const std::vector<ContactWrench>& row : plan_.whole_body.wrenches) {
      double normal = 0.0;
      for (const ContactWrench& wrench : row) normal += wrench.force_W.z();
      presses.push_back(normal > kPresses * model_.weight_n());
    }
    return presses;
  }

  void AddCentroidal() {
    CentroidalTrajectory& c = plan_.centroidal;
    c.step_s = motion_.step_s;
    DynamicsScratch scratch(model_);
    VectorX needed;
    double height = 0.0;
    for (int k = 0; k < motion_.size(); ++k) {
      const auto i = static_cast<std::size_t>(k);
      InverseDynamics(model_, motion_.q[i], motion_.v[i], motion_.a[i], scratch, needed);
      c.p_WC.push_back(CentreOfMass(model_, scratch));
      c.v_WC.emplace_back(CentroidalMomentum(model_, scratch).head<3>() / model_.total_mass_kg);
      c.a_WC.emplace_back(needed.head<3>() / model_.total_mass_kg - kGravity * Vector3::UnitZ());
      height +=
          c.p_WC.back().z() - CarryingPlaneAt(plan_.footsteps, static_cast<int>(model_.feet.size()), motion_.TimeOf(k))
                                  .HeightAt(c.p_WC.back().head<2>());
    }
    height /= motion_.size();
    if (!(height > 0.0)) {
      throw InvalidArgument(
          fmt::format("its centre of mass is on average {:.3g} m below its footholds; it must be above them", -height));
    }
    c.omega_rad_s = std::sqrt(kGravity / height);
    notes_.derived.push_back({"centre of mass and zero-moment point", "from the model"});
  }

  void AddPart(const std::optional<PlanarPose>& goal) {
    const PlanarPose start = BaseInPlan(motion_.q.front()), end = BaseInPlan(motion_.q.back());
    const double c = std::cos(start.yaw_rad), s = std::sin(start.yaw_rad);
    MotionPart part;
    part.command.extent = WalkCommand::Extent::kGoal;
    if (goal) {
      part.command.goal_x_m = goal->x_m;
      part.command.goal_y_m = goal->y_m;
      part.command.goal_yaw_rad = goal->yaw_rad;
      part.goal = {start.x_m + c * goal->x_m - s * goal->y_m, start.y_m + s * goal->x_m + c * goal->y_m,
                   WrapAngle(start.yaw_rad + goal->yaw_rad)};
    } else {
      const double x = end.x_m - start.x_m, y = end.y_m - start.y_m;
      part.command.goal_x_m = c * x + s * y;
      part.command.goal_y_m = c * y - s * x;
      part.command.goal_yaw_rad = WrapAngle(end.yaw_rad - start.yaw_rad);
      part.goal = end;
      notes_.derived.push_back({"goal", "where the motion ends"});
    }
    part.end_s = motion_.TimeOf(motion_.size() - 1);
    part.gait = GaitOf(part.end_s);
    plan_.goal = part.goal;
    plan_.parts = {part};
  }

  /// The mean contact pattern as a gait. A motion whose base moves over feet that all stand is not the gait `stand`.
  Gait GaitOf(double duration_s) const {
    constexpr double kNearlyAll = 1.0 - 1e-9;
    Gait gait;
    gait.name = "imported";
    gait.description = "as the file has it";
    std::vector<double> cycles;
    for (std::size_t f = 0; f < feet_.size(); ++f) {
      const auto intervals = IntervalsOf(plan_.schedule, static_cast<int>(f));
      double stands_s = 0.0;
      for (std::size_t i = 0; i < intervals.size(); ++i) {
        stands_s += intervals[i].end_s - intervals[i].start_s;
        if (i > 1) cycles.push_back(intervals[i].start_s - intervals[i - 1].start_s);
      }
      gait.phase.push_back(intervals.size() > 1 ? intervals[1].start_s : 0.0);
      gait.duty_factor.push_back(std::min(stands_s / duration_s, kNearlyAll));
    }
    gait.cycle_s = cycles.empty() ? duration_s : MedianOf(std::move(cycles));
    for (double& phase : gait.phase) phase = phase / gait.cycle_s - std::floor(phase / gait.cycle_s);
    return gait;
  }

  /// Notes that playback starts from rest if the motion does not.
  void NoteStart() {
    constexpr double kSlow = 0.02;  // share of sqrt(g x leg length)
    const double speed = motion_.v.front().head<3>().norm();
    if (speed > kSlow * std::sqrt(kGravity * model_.leg_length_m())) {
      notes_.warnings.push_back(
          fmt::format("the motion begins with its base at {:.3f} m/s; playback starts it from rest", speed));
    }
  }

  const RobotModel& model_;
  const EvenMotion motion_;
  const ImportOptions& options_;
  ImportNotes& notes_;
  std::vector<FootTrack> feet_;
  MotionPlan plan_;
};

/// Refuses implausible accelerations and torques, which come from a value that jumps, such as one with a lost decimal
/// point.
void CheckDerived(const MotionPlan& plan) {
  const WholeBodyTrajectory& w = plan.whole_body;
  for (std::size_t k = 0; k < w.q.size(); ++k) {
    const std::pair<const char*, double> parts[] = {{"a speed", w.v[k].lpNorm<Eigen::Infinity>()},
                                                    {"an acceleration", w.a[k].lpNorm<Eigen::Infinity>()},
                                                    {"a torque", w.tau[k].lpNorm<Eigen::Infinity>()}};
    for (const auto& [what, most] : parts) {
      if (most <= kLargestDerived) continue;
      throw InvalidArgument(fmt::format(
          "the computed {} is {:.3g} near {:.6g} s from its start, which is not plausible: a position jumps there",
          what, most, static_cast<double>(k) * w.step_s));
    }
  }
}

}  // namespace

MotionPlan PlanOfMotion(const RobotModel& model, const Terrain& terrain, EvenMotion motion,
                        const ImportOptions& options, const std::optional<PlanarPose>& goal, ImportNotes& notes) {
  MotionPlan plan = Builder(model, terrain, std::move(motion), options, notes).Run(goal);
  CheckDerived(plan);
  return plan;
}

}  // namespace gaitwright
