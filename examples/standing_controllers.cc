// SPDX-License-Identifier: BSD-3-Clause
#include "examples/standing_controllers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "kinematics/base/options.h"
#include "kinematics/dynamics/foot_contact.h"
#include "kinematics/stability/polygon.h"
#include "playback/control/joint_pd.h"
#include "playback/control/stabilised.h"

namespace gaitwright::examples {
namespace {

/// How a strategy feeds back.
struct Gains {
  double of_position = 0.0, of_speed = 0.0;  ///< of the ZMP by the centre of mass [1], and by its speed over omega [1]
  double of_hips = 0.0;                      ///< of the hips' bend by the DCM's error over the height [1]
};

/// Joint PD, with the ZMP moved by the ankles and the hips bent.
class ByAnklesAndHips final : public Controller {
 public:
  ByAnklesAndHips(const std::string& name, const RobotModel& model, const MotionPlan& plan, const Gains& gains)
      : name_(name), model_(model), replay_(model, plan), scratch_(model), gains_(gains) {
    ForwardKinematics(model, plan.whole_body.q.front(), scratch_);
    home_ = CentreOfMass(model, scratch_);
    omega_rad_s_ = std::sqrt(kGravity / home_.z());
    for (const Leg& leg : model.legs) {
      for (std::size_t k = leg.joints.size() - std::min<std::size_t>(2, leg.joints.size()); k < leg.joints.size(); ++k)
        ankles_.push_back(leg.joints[k]);
    }
  }

  std::string Name() const override { return name_; }

  JointCommand Update(const ControlInput& input) override {
    JointCommand command = replay_.Update(input);
    ForwardVelocities(model_, input.q, input.v, scratch_);
    const Vector3 centre = CentreOfMass(model_, scratch_);
    const Vector2 speed = (CentroidalMomentum(model_, scratch_).head<2>()) / model_.total_mass_kg;
    const Vector2 off = (centre - home_).head<2>(), dcm = off + speed / omega_rad_s_;
    const Vector2 wished = home_.head<2>() + gains_.of_position * off + gains_.of_speed * speed / omega_rad_s_;
    MoveZmp(WithinSoles(wished) - home_.head<2>(), command);
    BendHips(dcm.x() / home_.z(), command);
    return command;
  }

 private:
  /// The nearest place where the soles can press, a little inside of their edges.
  Vector2 WithinSoles(const Vector2& zmp) const {
    constexpr double kInside = 0.01;  // [m]
    std::vector<Vector2> corners;
    for (std::size_t f = 0; f < model_.feet.size(); ++f) {
      const Pose X_WF = ContactFrame(model_, scratch_, static_cast<int>(f));
      for (const Vector2& p : model_.feet[f].sole_F) corners.push_back((X_WF * Vector3(p.x(), p.y(), 0.0)).head<2>());
    }
    const Polygon inside = Shrunk(ConvexHull(corners), kInside);
    return inside.empty() ? home_.head<2>() : NearestPoint(inside, zmp);
  }

  /// A ZMP that is moved by d presses with the moment (m g d_y, -m g d_x) more: ankles give it, tau = -a . M.
  void MoveZmp(const Vector2& by, JointCommand& command) const {
    const double share = model_.weight_n() / static_cast<double>(model_.legs.size());
    const Vector3 moment(share * by.y(), -share * by.x(), 0.0);
    for (const int joint : ankles_) {
      const auto j = static_cast<std::size_t>(joint);
      command.tau_ff[model_.joints[j].dof] -= scratch_.axis_W[j].dot(moment);
    }
  }

  /// Thighs go ahead, and with the feet on the ground that is the trunk that does.
  void BendHips(double fall_rad, JointCommand& command) const {
    constexpr double kMost = 0.8;  // [rad]
    const double bend = std::clamp(gains_.of_hips * fall_rad, -kMost, kMost);
    for (const Leg& leg : model_.legs) {
      const auto j = static_cast<std::size_t>(leg.hip_joint);
      command.q[model_.joints[j].dof] -= scratch_.axis_W[j].y() * bend;
    }
  }

  const std::string name_;
  const RobotModel& model_;
  JointPd replay_;
  DynamicsScratch scratch_;
  const Gains gains_;
  Vector3 home_;
  double omega_rad_s_ = 1.0;
  std::vector<int> ankles_;
};

}  // namespace

const std::vector<std::string>& StandingStrategies() {
  static const std::vector<std::string> names = {"joint-pd", "ankle", "ankle-dcm", "hip", "whole-body"};
  return names;
}

std::unique_ptr<Controller> MakeStandingController(const std::string& strategy, const RobotModel& model,
                                                   const MotionPlan& plan) {
  if (strategy == "joint-pd") return std::make_unique<JointPd>(model, plan);
  if (strategy == "whole-body") return MakeStabilised(model, plan, {}, {});
  if (strategy == "ankle") return std::make_unique<ByAnklesAndHips>(strategy, model, plan, Gains{1.5, 0.5, 0.0});
  if (strategy == "ankle-dcm") return std::make_unique<ByAnklesAndHips>(strategy, model, plan, Gains{2.0, 2.0, 0.0});
  if (strategy == "hip") return std::make_unique<ByAnklesAndHips>(strategy, model, plan, Gains{2.0, 2.0, 3.0});
  throw InvalidArgument(
      fmt::format("there is no strategy '{}'; there are {}", strategy, QuotedList(StandingStrategies())));
}

}  // namespace gaitwright::examples
