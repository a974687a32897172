// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "kinematics/spatial/rotation.h"
#include "tests/playback/played.h"

/// Laws that the score of every playback satisfies.
namespace gaitwright {
namespace {

using LawCase = synthetic::Played;

/// A walk whose log deviates a little from its plan everywhere, deterministically.
LawCase Imperfect(int legs) {
  LawCase c = synthetic::Walked(legs);
  for (LogSample& sample : c.log.samples) {
    const double t = sample.time_s;
    sample.q.head<3>() += 0.004 * Vector3(std::sin(3.0 * t), std::sin(5.0 * t), std::sin(7.0 * t));
    sample.v.head<3>() += 0.02 * Vector3(std::cos(3.0 * t), std::cos(5.0 * t), std::cos(7.0 * t));
    for (Eigen::Index i = 7; i < sample.q.size(); ++i) sample.q[i] += 0.002 * std::sin(t + static_cast<double>(i));
    for (ContactWrench& wrench : sample.wrenches)
      wrench.moment_W += 0.3 * Vector3(std::sin(11.0 * t), std::cos(13.0 * t), 0.0);
  }
  return c;
}

void MoveState(const Pose& X, VectorX& q, VectorX& v) {
  q.head<3>() = X * Vector3(q.head<3>());
  q.segment<4>(3) = (Quaternion(X.linear()) * Quaternion(Eigen::Vector4d(q.segment<4>(3)))).coeffs();
  v.head<3>() = X.linear() * Vector3(v.head<3>());
  v.segment<3>(3) = X.linear() * Vector3(v.segment<3>(3));
}

void MoveWrenches(const Pose& X, std::vector<ContactWrench>& wrenches) {
  for (ContactWrench& wrench : wrenches) {
    wrench.force_W = X.linear() * wrench.force_W;
    wrench.moment_W = X.linear() * wrench.moment_W;
  }
}

/// The same playback at another place on the plane, with another heading.
LawCase Moved(LawCase c, const Pose& X) {
  WholeBodyTrajectory& body = c.plan.whole_body;
  for (std::size_t k = 0; k < body.q.size(); ++k) {
    VectorX unused = body.q[k];
    MoveState(X, body.q[k], body.v[k]);
    MoveState(X, unused, body.a[k]);
    MoveWrenches(X, body.wrenches[k]);
  }
  for (Foothold& foothold : c.plan.footsteps.footholds) foothold.X_WF = X * foothold.X_WF;
  const Vector3 goal = X * Vector3(c.plan.goal.x_m, c.plan.goal.y_m, 0.0);
  c.plan.goal = {goal.x(), goal.y(), YawOf(X.linear())};
  for (LogSample& sample : c.log.samples) {
    MoveState(X, sample.q, sample.v);
    MoveWrenches(X, sample.wrenches);
  }
  for (StanceRecord& stance : c.log.stances) stance.p_touchdown_W = X * stance.p_touchdown_W;
  return c;
}

void ExpectSameFigures(const StabilityReport& a, const StabilityReport& b) {
  ASSERT_EQ(a.metrics.size(), b.metrics.size());
  for (std::size_t i = 0; i < a.metrics.size(); ++i) {
    const Metric &m = a.metrics[i], &n = b.metrics[i];
    ASSERT_EQ(m.value.has_value(), n.value.has_value()) << m.key;
    EXPECT_EQ(m.pass, n.pass) << m.key;
    if (m.value) {
      EXPECT_NEAR(*m.value, *n.value, 1e-6 * std::max(1.0, std::abs(*m.value))) << m.key;
    }
    if (m.planned && n.planned) {
      EXPECT_NEAR(*m.planned, *n.planned, 1e-6 * std::max(1.0, std::abs(*m.planned))) << m.key << ", planned";
    }
  }
  EXPECT_NEAR(a.score, b.score, 1e-4);
}

TEST(ScoreLaws, PlaceAndHeadingOfTheWalkDoNotMatter) {
  for (const int legs : {2, 4}) {
    const LawCase c = Imperfect(legs);
    const StabilityReport here = Score(c.model, c.plan, c.log);
    EXPECT_GT(*here.At("zmp_error_mean_m").value, 1e-4) << "the case must be off its plan to show anything";
    for (const double yaw : {0.0, 0.5, 3.0, -2.2}) {
      Pose X = Pose::Identity();
      X.linear() = Eigen::AngleAxisd(yaw, Vector3::UnitZ()).toRotationMatrix();
      X.translation() = Vector3(3.0, -7.0, 0.0);
      const LawCase moved = Moved(c, X);
      ExpectSameFigures(here, Score(moved.model, moved.plan, moved.log));
    }
  }
}

/// Left and right exchanged: y changes sign, neighbouring legs are exchanged.
LawCase Mirrored(LawCase c) {
  const auto swap_legs = [&](VectorX& x, Eigen::Index first) {
    for (Eigen::Index leg = 0; leg < static_cast<Eigen::Index>(c.model.feet.size()); leg += 2) {
      const Vector3 left = x.segment<3>(first + 3 * leg);
      x.segment<3>(first + 3 * leg) = x.segment<3>(first + 3 * leg + 3);
      x.segment<3>(first + 3 * leg + 3) = left;
    }
    for (Eigen::Index i = first + 1; i < x.size(); i += 3) x[i] = -x[i];
  };
  const auto swap_wrenches = [](std::vector<ContactWrench>& wrenches) {
    for (std::size_t i = 0; i + 1 < wrenches.size(); i += 2) std::swap(wrenches[i], wrenches[i + 1]);
    for (ContactWrench& wrench : wrenches) {
      wrench.force_W.y() *= -1.0;
      wrench.moment_W.x() *= -1.0;
      wrench.moment_W.z() *= -1.0;
    }
  };
  const auto swap_set = [](FootSet set) { return (set & 0b0101U) << 1U | (set & 0b1010U) >> 1U; };
  for (std::size_t k = 0; k < c.plan.whole_body.q.size(); ++k) {
    WholeBodyTrajectory& body = c.plan.whole_body;
    for (VectorX* x : {&body.q[k], &body.v[k], &body.a[k]}) (*x)[1] *= -1.0;
    swap_legs(body.q[k], 7);
    swap_legs(body.v[k], 6);
    swap_legs(body.a[k], 6);
    swap_legs(body.tau[k], 0);
    swap_wrenches(body.wrenches[k]);
  }
  for (ContactPhase& phase : c.plan.schedule.phases) phase.stance = swap_set(phase.stance);
  for (Foothold& foothold : c.plan.footsteps.footholds) {
    foothold.foot ^= 1;
    foothold.X_WF.translation().y() *= -1.0;
  }
  c.plan.goal.y_m *= -1.0;
  for (LogSample& sample : c.log.samples) {
    sample.q[1] *= -1.0;
    sample.v[1] *= -1.0;
    swap_legs(sample.q, 7);
    swap_legs(sample.v, 6);
    swap_legs(sample.tau, 0);
    swap_legs(sample.tau_peak, 0);
    sample.tau_peak = sample.tau_peak.cwiseAbs();
    swap_legs(sample.effort_use, 0);
    sample.effort_use = sample.effort_use.cwiseAbs();
    swap_wrenches(sample.wrenches);
    sample.contact = swap_set(sample.contact);
  }
  for (StanceRecord& stance : c.log.stances) {
    stance.foot ^= 1;
    stance.p_touchdown_W.y() *= -1.0;
  }
  return c;
}

TEST(ScoreLaws, LeftAndRightAreEqual) {
  for (const int legs : {2, 4}) {
    const LawCase c = Imperfect(legs), mirrored = Mirrored(c);
    ASSERT_NE(c.plan.schedule, mirrored.plan.schedule);
    ExpectSameFigures(Score(c.model, c.plan, c.log), Score(mirrored.model, mirrored.plan, mirrored.log));
  }
}

TEST(ScoreLaws, APlanPlayedPerfectlyHasTheFiguresItPlanned) {
  for (const int legs : {2, 4}) {
    LawCase c = Imperfect(legs);
    c.log = synthetic::PerfectLog(c.model, c.plan);
    const StabilityReport report = Score(c.model, c.plan, c.log);
    for (const char* key :
         {"zmp_margin_min_m", "zmp_margin_p05_m", "static_margin_min_m", "energy_margin_min_m",
          "dcm_capture_margin_min_m", "clearance_min_m", "joint_limit_margin_min_rad", "distance_m"}) {
      EXPECT_NEAR(*report.At(key).value, *report.At(key).planned, 1e-3) << key;
    }
  }
}

}  // namespace
}  // namespace gaitwright
