// SPDX-License-Identifier: BSD-3-Clause
#include "tests/playback/synthetic.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <limits>

namespace gaitwright::synthetic {
namespace {

Joint Slider(const std::string& name, int parent, int dof, const Vector3& axis, const Vector3& p_PJ) {
  Joint joint;
  joint.name = name;
  joint.type = JointType::kPrismatic;
  joint.parent_body = parent;
  joint.X_PJ.translation() = p_PJ;
  joint.axis_J = axis;
  joint.lower = -1.0;
  joint.upper = 1.0;
  joint.velocity_limit = 10.0;
  joint.effort_limit = 200.0;
  joint.dof = dof;
  return joint;
}

void AddLeg(RobotModel& model, const std::string& name, FootType type, const Vector2& hip) {
  const int first = static_cast<int>(model.joints.size());
  const Vector3 axes[3] = {Vector3::UnitX(), Vector3::UnitY(), Vector3::UnitZ()};
  const char* const names[3] = {"_x", "_y", "_z"};
  for (int i = 0; i < 3; ++i) {
    const Vector3 origin = i == 0 ? Vector3(hip.x(), hip.y(), 0.0) : Vector3::Zero();
    model.joints.push_back(Slider(name + names[i], i == 0 ? 0 : first + i, first + i, axes[i], origin));
    model.bodies.push_back({name + names[i], 0.0, Vector3::Zero(), Matrix3::Zero()});
    model.dof_names.push_back(name + names[i]);
    model.dof_joint.push_back(first + i);
  }
  Foot foot;
  foot.name = foot.link = name;
  foot.body = first + 3;
  foot.type = type;
  if (type == FootType::kSole || type == FootType::kLine) {
    foot.sole_F = {
        {kHalfLength, -kHalfWidth}, {kHalfLength, kHalfWidth}, {-kHalfLength, kHalfWidth}, {-kHalfLength, -kHalfWidth}};
  }
  if (type == FootType::kSphere) foot.radius = 0.02;
  Leg leg;
  leg.name = name;
  leg.foot = static_cast<int>(model.feet.size());
  leg.joints = {first, first + 1, first + 2};
  leg.length_m = 0.6;
  model.feet.push_back(foot);
  model.legs.push_back(leg);
}

/// x with x - (z/g) x'' = p, both ends at rest on p. Kajita et al., ICRA 2003.
std::vector<double> SolvePendulum(const std::vector<double>& p) {
  const std::size_t n = p.size();
  const double k = kHeight / kGravity / (kStep * kStep);
  std::vector<double> c(n, 0.0), x(p);
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const double pivot = 1.0 + 2.0 * k + k * c[i - 1];
    c[i] = -k / pivot;
    x[i] = (p[i] + k * x[i - 1]) / pivot;
  }
  for (std::size_t i = n - 1; i-- > 1;) x[i] -= c[i] * x[i + 1];
  return x;
}

/// Forces on the stance feet that put the ZMP at `zmp`: weights of least norm; moments give the rest.
std::vector<ContactWrench> Split(const Vector3& force, const Vector2& zmp, const std::vector<Vector3>& foot,
                                 FootSet stance) {
  std::vector<ContactWrench> wrenches(foot.size());
  std::vector<std::size_t> standing;
  for (std::size_t i = 0; i < foot.size(); ++i) {
    if (Contains(stance, static_cast<int>(i))) standing.push_back(i);
  }
  const Eigen::Index n = static_cast<Eigen::Index>(standing.size());
  if (n == 0) return wrenches;
  MatrixX A(3, n);
  for (Eigen::Index i = 0; i < n; ++i) A.col(i) << foot[standing[static_cast<std::size_t>(i)]].head<2>(), 1.0;
  VectorX w = A.completeOrthogonalDecomposition().solve(Vector3(zmp.x(), zmp.y(), 1.0));
  w /= w.sum();
  const Vector2 rest = zmp - (A.topRows(2) * w);
  for (Eigen::Index i = 0; i < n; ++i) {
    ContactWrench& wrench = wrenches[standing[static_cast<std::size_t>(i)]];
    wrench.force_W = w[i] * force;
    wrench.moment_W = Vector3(rest.x(), rest.y(), 0.0).cross(wrench.force_W);
  }
  return wrenches;
}

void FillWholeBody(const RobotModel& model, const Motion& motion, MotionPlan& plan) {
  const std::size_t n = motion.zmp.size();
  std::vector<double> zx, zy;
  for (const Vector2& z : motion.zmp) {
    zx.push_back(z.x());
    zy.push_back(z.y());
  }
  const std::vector<double> x = SolvePendulum(zx), y = SolvePendulum(zy);
  const double radius = model.feet[0].radius;
  WholeBodyTrajectory& body = plan.whole_body;
  body.step_s = kStep;
  for (std::size_t k = 0; k < n; ++k) {
    VectorX q = VectorX::Zero(model.nq());
    q.head<7>() << x[k], y[k], kHeight, 0.0, 0.0, 0.0, 1.0;
    for (std::size_t i = 0; i < model.feet.size(); ++i) {
      const Vector3 hip = model.joints[3 * i].X_PJ.translation();
      q.segment<3>(7 + 3 * static_cast<Eigen::Index>(i)) =
          motion.foot[k][i] + Vector3(0.0, 0.0, radius) - q.head<3>() - hip;
    }
    body.q.push_back(q);
  }
  const auto without_quaternion = [&](std::size_t k) {
    VectorX p(model.nv());
    p << body.q[k].head<3>(), Vector3::Zero(), body.q[k].tail(model.num_dofs());
    return p;
  };
  for (std::size_t k = 0; k < n; ++k) {
    const bool inner = k > 0 && k + 1 < n;
    const VectorX before = without_quaternion(k > 0 ? k - 1 : k), now = without_quaternion(k);
    const VectorX after = without_quaternion(k + 1 < n ? k + 1 : k);
    body.v.push_back((after - before) / (inner ? 2.0 * kStep : kStep));
    body.a.push_back(inner ? VectorX((after - 2.0 * now + before) / (kStep * kStep)) : VectorX::Zero(model.nv()));
    const Vector3 force = model.total_mass_kg * (body.a.back().head<3>() + Vector3(0.0, 0.0, kGravity));
    const double time = kStep * static_cast<double>(k);
    const FootSet stance = plan.schedule.phases[static_cast<std::size_t>(PhaseAt(plan.schedule, time))].stance;
    body.wrenches.push_back(Split(force, motion.zmp[k], motion.foot[k], stance));
    VectorX tau(model.num_dofs());
    for (std::size_t i = 0; i < model.feet.size(); ++i) {
      tau.segment<3>(3 * static_cast<Eigen::Index>(i)) = -body.wrenches.back()[i].force_W;
    }
    body.tau.push_back(tau);
  }
}

double Smooth(double s) { return s * s * s * (10.0 + s * (6.0 * s - 15.0)); }

}  // namespace

RobotModel Robot(int num_legs, FootType type) {
  RobotModel model;
  model.name = num_legs == 2 ? "block_biped" : "block_quadruped";
  model.bodies.push_back({"trunk", 10.0, Vector3::Zero(), Matrix3(Vector3(0.1, 0.2, 0.2).asDiagonal())});
  if (num_legs == 2) {
    AddLeg(model, "left", type, {0.0, 0.1});
    AddLeg(model, "right", type, {0.0, -0.1});
  } else {
    AddLeg(model, "front_left", type, {0.2, 0.15});
    AddLeg(model, "front_right", type, {0.2, -0.15});
    AddLeg(model, "rear_left", type, {-0.2, 0.15});
    AddLeg(model, "rear_right", type, {-0.2, -0.15});
  }
  model.total_mass_kg = 10.0;
  model.standing_base_height_m = kHeight;
  const double down = type == FootType::kSphere ? 0.02 - kHeight : -kHeight;
  model.standing_joints = VectorX::Zero(model.num_dofs());
  for (int i = 2; i < model.num_dofs(); i += 3) model.standing_joints[i] = down;
  model.stiffness = model.damping = VectorX::Zero(model.num_dofs());
  return model;
}

void FillFootholds(const Motion& motion, int num_feet, MotionPlan& plan) {
  for (int foot = 0; foot < num_feet; ++foot) {
    for (const ContactInterval& stance : IntervalsOf(plan.schedule, foot)) {
      Foothold foothold;
      foothold.foot = foot;
      foothold.touchdown_s = stance.start_s;
      foothold.liftoff_s = stance.end_s;
      const std::size_t middle = static_cast<std::size_t>(std::lround(0.5 * (stance.start_s + stance.end_s) / kStep));
      foothold.X_WF.translation() =
          motion.foot[std::min(middle, motion.foot.size() - 1)][static_cast<std::size_t>(foot)];
      plan.footsteps.footholds.push_back(foothold);
    }
  }
  std::sort(plan.footsteps.footholds.begin(), plan.footsteps.footholds.end(), [](const Foothold& a, const Foothold& b) {
    return a.touchdown_s < b.touchdown_s || (a.touchdown_s == b.touchdown_s && a.foot < b.foot);
  });
}

MotionPlan PlanOf(const RobotModel& model, const Motion& motion) {
  MotionPlan plan;
  plan.robot = model.name;
  plan.terrain = FlatTerrain();
  plan.parts.emplace_back();
  plan.parts.front().gait.cycle_s = 1.0;
  plan.schedule = motion.schedule;
  FillWholeBody(model, motion, plan);
  FillFootholds(motion, static_cast<int>(model.feet.size()), plan);
  const VectorX& end = plan.whole_body.q.back();
  plan.goal = {end[0], end[1], 0.0};
  return plan;
}

MotionPlan StandingPlan(const RobotModel& model, double duration_s, const Vector2& zmp) {
  Motion motion;
  motion.schedule.phases = {{0.0, duration_s, AllFeet(static_cast<int>(model.feet.size()))}};
  std::vector<Vector3> feet;
  for (std::size_t i = 0; i < model.feet.size(); ++i) feet.push_back(model.joints[3 * i].X_PJ.translation());
  const std::size_t rows = static_cast<std::size_t>(std::lround(duration_s / kStep)) + 1;
  motion.foot.assign(rows, feet);
  motion.zmp.assign(rows, zmp);
  return PlanOf(model, motion);
}

MotionPlan SteppingPlan(const RobotModel& model, const Steps& steps) {
  const bool biped = model.feet.size() == 2;
  const FootSet groups[2] = {biped ? FootSet{1} : FootSet{0b1001}, biped ? FootSet{2} : FootSet{0b0110}};
  const FootSet all = AllFeet(static_cast<int>(model.feet.size()));
  std::vector<Vector3> feet;
  for (std::size_t i = 0; i < model.feet.size(); ++i) feet.push_back(model.joints[3 * i].X_PJ.translation());
  const auto middle_of = [&](FootSet set) {
    Vector2 sum = Vector2::Zero();
    double count = 0.0;
    for (std::size_t i = 0; i < feet.size(); ++i) {
      if (!Contains(set, static_cast<int>(i))) continue;
      sum += feet[i].head<2>();
      count += 1.0;
    }
    return Vector2(sum / count);
  };
  Motion motion;
  Vector2 zmp = middle_of(all);
  double time = 0.0;
  const auto hold = [&](double duration, const Vector2& zmp_end, FootSet swinging, double advance) {
    const int rows = static_cast<int>(std::lround(duration / kStep));
    const std::vector<Vector3> start = feet;
    for (int k = 0; k < rows; ++k) {
      const double s = static_cast<double>(k) / rows;
      std::vector<Vector3> now = start;
      for (std::size_t i = 0; i < feet.size(); ++i) {
        if (!Contains(swinging, static_cast<int>(i))) continue;
        now[i].x() += advance * Smooth(s);
        now[i].z() = 64.0 * steps.lift_m * std::pow(s * (1.0 - s), 3);
      }
      motion.foot.push_back(now);
      motion.zmp.push_back(zmp + Smooth(s) * (zmp_end - zmp));
    }
    for (std::size_t i = 0; i < feet.size(); ++i) {
      if (Contains(swinging, static_cast<int>(i))) feet[i].x() += advance;
    }
    zmp = zmp_end;
    const FootSet stance = all & ~swinging;
    auto& phases = motion.schedule.phases;
    const double end = kStep * static_cast<double>(motion.zmp.size());
    if (!phases.empty() && phases.back().stance == stance) {
      phases.back().end_s = end;
    } else {
      phases.push_back({time, end, stance});
    }
    time = end;
  };
  hold(steps.rest_s, zmp, 0, 0.0);
  for (int i = 0; i < steps.count; ++i) {
    const FootSet swinging = groups[i % 2];
    hold(steps.double_s, middle_of(all & ~swinging), 0, 0.0);
    const bool half = i == 0 || i + 1 == steps.count;
    hold(steps.swing_s, zmp, swinging, half ? 0.5 * steps.length_m : steps.length_m);
  }
  hold(steps.double_s, middle_of(all), 0, 0.0);
  hold(steps.rest_s, zmp, 0, 0.0);
  motion.foot.push_back(feet);
  motion.zmp.push_back(zmp);
  motion.schedule.phases.back().end_s = kStep * static_cast<double>(motion.zmp.size() - 1);
  return PlanOf(model, motion);
}

PlaybackLog PerfectLog(const RobotModel& model, const MotionPlan& plan) {
  PlaybackLog log;
  log.robot = model.name;
  log.controller = "perfect";
  log.total_mass_kg = model.total_mass_kg;
  log.friction = 0.8;
  log.log_rate_hz = 1.0 / kStep;
  const WholeBodyTrajectory& body = plan.whole_body;
  for (int k = 0; k < body.size(); ++k) {
    const std::size_t now = static_cast<std::size_t>(k), before = now > 0 ? now - 1 : 0;
    LogSample sample;
    sample.time_s = kStep * k;
    sample.q = body.q[now];
    sample.v = body.v[now];
    sample.tau = body.tau[now];
    sample.tau_peak = sample.tau.cwiseAbs();
    sample.effort_use = VectorX::Zero(model.num_dofs());
    for (int i = 0; i < model.num_dofs(); ++i) sample.effort_use[i] = sample.tau_peak[i] / model.dof_effort_limit(i);
    sample.wrenches = body.wrenches[now];
    for (std::size_t i = 0; i < sample.wrenches.size(); ++i) {
      sample.wrenches[i].force_W = 0.5 * (sample.wrenches[i].force_W + body.wrenches[before][i].force_W);
      sample.wrenches[i].moment_W = 0.5 * (sample.wrenches[i].moment_W + body.wrenches[before][i].moment_W);
    }
    const int phase = PhaseAt(plan.schedule, sample.time_s);
    sample.contact = plan.schedule.phases[static_cast<std::size_t>(phase)].stance;
    log.samples.push_back(sample);
  }
  for (const Foothold& foothold : plan.footsteps.footholds) {
    StanceRecord stance;
    stance.foot = foothold.foot;
    stance.touchdown_s = foothold.touchdown_s;
    stance.liftoff_s = foothold.liftoff_s;
    stance.p_touchdown_W = foothold.X_WF.translation();
    stance.touchdown_speed_m_s = 0.02;
    stance.slip_m = 0.0005;
    stance.peak_normal_n = 1.1 * model.weight_n();
    stance.penetration_m = 1e-5;
    stance.friction_use_max = 0.3;
    log.stances.push_back(stance);
  }
  log.saturated_s = VectorX::Zero(model.num_dofs());
  return log;
}

void Sink(PlaybackLog& log, std::size_t first, double base_height_m) {
  for (std::size_t k = first; k < log.samples.size(); ++k) {
    VectorX& q = log.samples[k].q;
    for (Eigen::Index i = 9; i < q.size(); i += 3) q[i] += q[2] - base_height_m;
    q[2] = base_height_m;
  }
}

}  // namespace gaitwright::synthetic
