// SPDX-License-Identifier: BSD-3-Clause
#include <benchmark/benchmark.h>

#include "kinematics/dynamics/contact_split.h"
#include "kinematics/dynamics/dynamics.h"
#include "kinematics/dynamics/dynamics_derivatives.h"
#include "kinematics/dynamics/foot_contact.h"
#include "kinematics/dynamics/forward_dynamics.h"
#include "kinematics/ik/leg_ik.h"
#include "kinematics/ik/whole_body_ik.h"
#include "kinematics/model/load_robot.h"

namespace gaitwright {
namespace {

const char* const kRobots[] = {"a1", "nao"};

/// A standing robot, with its scratch.
struct Stand {
  explicit Stand(const benchmark::State& state)
      : model(LoadNamedRobot(kRobots[state.range(0)]).value()),
        scratch(model),
        q(StandingConfiguration(model)),
        v(VectorX::Constant(model.nv(), 0.1)),
        a(VectorX::Constant(model.nv(), 0.2)) {
    ForwardVelocities(model, q, v, scratch);
  }
  RobotModel model;
  DynamicsScratch scratch;
  VectorX q, v, a;
};

void ForwardKinematicsCall(benchmark::State& state) {
  Stand s(state);
  for (auto _ : state) ForwardKinematics(s.model, s.q, s.scratch);
}

void FootJacobians(benchmark::State& state) {
  Stand s(state);
  MatrixX J(6, s.model.nv());
  for (auto _ : state) {
    for (const Foot& foot : s.model.feet) PointJacobian(s.model, s.scratch, foot.body, foot.X_BF.translation(), J);
    benchmark::DoNotOptimize(J.data());
  }
}

/// The columns of all Jacobians, once per joint, from the configuration: the joint Jacobians of other libraries.
void JointScrewsFromConfiguration(benchmark::State& state) {
  Stand s(state);
  MatrixX S(6, static_cast<Eigen::Index>(s.model.joints.size()));
  for (auto _ : state) {
    ForwardKinematics(s.model, s.q, s.scratch);
    JointScrews(s.model, s.scratch, S);
    benchmark::DoNotOptimize(S.data());
  }
}

void FootJacobianRates(benchmark::State& state) {
  Stand s(state);
  MatrixX rate(6, s.model.nv());
  for (auto _ : state) {
    for (const Foot& foot : s.model.feet)
      PointJacobianRate(s.model, s.scratch, foot.body, foot.X_BF.translation(), rate);
    benchmark::DoNotOptimize(rate.data());
  }
}

/// The Jacobians of all bodies, from the configuration.
void AllJacobians(benchmark::State& state) {
  Stand s(state);
  MatrixX J(6, s.model.nv());
  for (auto _ : state) {
    ForwardKinematics(s.model, s.q, s.scratch);
    for (int b = 1; b < static_cast<int>(s.model.bodies.size()); ++b) {
      PointJacobian(s.model, s.scratch, b, Vector3::Zero(), J);
      benchmark::DoNotOptimize(J.data());
    }
  }
}

void CentreOfMassCall(benchmark::State& state) {
  Stand s(state);
  for (auto _ : state) benchmark::DoNotOptimize(CentreOfMass(s.model, s.scratch));
}

void CentroidalMomentumCall(benchmark::State& state) {
  Stand s(state);
  for (auto _ : state) benchmark::DoNotOptimize(CentroidalMomentum(s.model, s.scratch));
}

void CentreOfMassJacobianCall(benchmark::State& state) {
  Stand s(state);
  MatrixX J(3, s.model.nv());
  for (auto _ : state) {
    CentreOfMassJacobian(s.model, s.scratch, J);
    benchmark::DoNotOptimize(J.data());
  }
}

void InverseDynamicsCall(benchmark::State& state) {
  Stand s(state);
  VectorX tau(s.model.nv());
  for (auto _ : state) InverseDynamics(s.model, s.q, s.v, s.a, s.scratch, tau);
}

void MassMatrixCall(benchmark::State& state) {
  Stand s(state);
  MatrixX M(s.model.nv(), s.model.nv());
  for (auto _ : state) MassMatrix(s.model, s.q, s.scratch, M);
}

void ContactSplitCall(benchmark::State& state) {
  Stand s(state);
  std::vector<ContactPoint> contacts;
  for (int f = 0; f < static_cast<int>(s.model.feet.size()); ++f) {
    for (const Vector3& p : ContactPoints(s.model, s.scratch, f)) contacts.push_back({p, Vector3::UnitZ(), 0.8, 1.0});
  }
  const PointWrench wanted{CentreOfMass(s.model, s.scratch), Vector3(5.0, 2.0, s.model.weight_n()),
                           Vector3(0.3, 0.2, 0.1)};
  ContactSplitter splitter;
  ContactSplit split;
  for (auto _ : state) splitter.Solve(contacts, wanted, split);
}

/// One leg from a guess with an error of a few degrees, as in a sequence: A1's (three joints) or NAO's (six).
void SolveLeg(benchmark::State& state, const LegIk& ik, const RobotModel& model) {
  VectorX standing(static_cast<Eigen::Index>(ik.dofs().size()));
  for (std::size_t i = 0; i < ik.dofs().size(); ++i) {
    standing[static_cast<Eigen::Index>(i)] = model.standing_joints[ik.dofs()[i]];
  }
  const VectorX bent = standing + VectorX::Constant(standing.size(), 0.05);
  const Pose X_BF = ik.FootPose(bent);
  for (auto _ : state) benchmark::DoNotOptimize(ik.Solve(X_BF, standing));
}

void LegIkClosedForm(benchmark::State& state) {
  const RobotModel model = LoadNamedRobot(kRobots[state.range(0)]).value();
  SolveLeg(state, LegIk(model, 0), model);
}

void LegIkDamped(benchmark::State& state) {
  const RobotModel model = LoadNamedRobot(kRobots[state.range(0)]).value();
  SolveLeg(state, LegIk(model, 0, LegIk::Method::kDamped), model);
}

/// A target 0.5 m below the reach of the leg.
void LegIkOutOfReach(benchmark::State& state) {
  const RobotModel model = LoadNamedRobot(kRobots[state.range(0)]).value();
  const LegIk ik(model, 0, state.range(1) == 0 ? LegIk(model, 0).method() : LegIk::Method::kDamped);
  Pose X_BF = Pose::Identity();
  X_BF.translation() = Vector3(0.0, 0.1, -1.0);
  for (auto _ : state) benchmark::DoNotOptimize(ik.Solve(X_BF));
}

/// Positions and rates of all joints for a standing body whose centre of mass is shifted laterally by 1 cm, from
/// standing.
void WholeBodyIkCall(benchmark::State& state) {
  Stand s(state);
  WholeBodyIk ik(s.model);
  BodyTarget target;
  target.p_WC = CentreOfMass(s.model, s.scratch) + Vector3(0.01, 0.01, -0.01);
  for (const Foot& foot : s.model.feet) {
    FootTarget on_ground;
    const Pose X_WF = FramePose(s.scratch, foot.body, foot.X_BF);
    on_ground.p_WF = X_WF.translation();
    on_ground.R_WF = on_ground.R_anchor = X_WF.linear();
    target.feet.push_back(on_ground);
  }
  VectorX q = s.q;
  for (auto _ : state) {
    q = s.q;
    if (!ik.SolvePosition(target, q)) state.SkipWithError("out of reach");
    ik.SolveRates(target, q, s.v, s.a);
  }
}

void InverseDynamicsDerivativesCall(benchmark::State& state) {
  Stand s(state);
  DynamicsDerivatives derivatives(s.model);
  InverseDynamicsDerivatives result;
  for (auto _ : state) derivatives.Compute(s.q, s.v, s.a, result);
}

void ForwardDynamicsCall(benchmark::State& state) {
  Stand s(state);
  ForwardDynamics forward(s.model);
  const VectorX tau = VectorX::Constant(s.model.nv(), 0.3);
  VectorX a(s.model.nv());
  for (auto _ : state) forward.Compute(s.q, s.v, tau, a);
}

BENCHMARK(ForwardKinematicsCall)->Arg(0)->Arg(1);
BENCHMARK(FootJacobians)->Arg(0)->Arg(1);
BENCHMARK(JointScrewsFromConfiguration)->Arg(0)->Arg(1);
BENCHMARK(FootJacobianRates)->Arg(0)->Arg(1);
BENCHMARK(AllJacobians)->Arg(0)->Arg(1);
BENCHMARK(CentreOfMassCall)->Arg(0)->Arg(1);
BENCHMARK(CentroidalMomentumCall)->Arg(0)->Arg(1);
BENCHMARK(CentreOfMassJacobianCall)->Arg(0)->Arg(1);
BENCHMARK(InverseDynamicsCall)->Arg(0)->Arg(1);
BENCHMARK(MassMatrixCall)->Arg(0)->Arg(1);
BENCHMARK(InverseDynamicsDerivativesCall)->Arg(0)->Arg(1);
BENCHMARK(ForwardDynamicsCall)->Arg(0)->Arg(1);
BENCHMARK(ContactSplitCall)->Arg(0)->Arg(1);
BENCHMARK(LegIkClosedForm)->Arg(0)->Arg(1);
BENCHMARK(LegIkDamped)->Arg(0)->Arg(1);
BENCHMARK(LegIkOutOfReach)->ArgsProduct({{0, 1}, {0, 1}});
BENCHMARK(WholeBodyIkCall)->Arg(0)->Arg(1)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace gaitwright
