// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <numbers>

#include "playback/policy/observations_internal.h"

namespace gaitwright {
namespace {

using FillTerm = void (*)(const PolicyState& state, const ObservationTerm& term, Eigen::VectorXf& out);

/// Length of an observation: fixed, one for each joint, or one for each action.
enum class TermSize { kFixed, kJoints, kActions };

struct TermKind {
  std::string name, meaning;
  TermSize size = TermSize::kFixed;
  int count = 0;
  FillTerm fill = nullptr;
};

void Put(const Vector3& v, Eigen::VectorXf& out) { out = v.cast<float>(); }

/// Elements of the term's joints.
template <class Value>
void PutJoints(const ObservationTerm& term, Eigen::VectorXf& out, Value value) {
  for (Eigen::Index i = 0; i < out.size(); ++i) {
    const Eigen::Index joint = term.joints.empty() ? i : term.joints[static_cast<std::size_t>(i)];
    out[i] = static_cast<float>(value(joint));
  }
}

void Positions(const PolicyState& s, const ObservationTerm& term, Eigen::VectorXf& out) {
  PutJoints(term, out, [&](Eigen::Index joint) { return s.joint_position[joint]; });
}

void RelativePositions(const PolicyState& s, const ObservationTerm& term, Eigen::VectorXf& out) {
  PutJoints(term, out, [&](Eigen::Index joint) { return s.joint_position[joint] - s.default_position[joint]; });
}

void Velocities(const PolicyState& s, const ObservationTerm& term, Eigen::VectorXf& out) {
  PutJoints(term, out, [&](Eigen::Index joint) { return s.joint_velocity[joint]; });
}

void GaitPhase(const PolicyState& s, const ObservationTerm& term, Eigen::VectorXf& out) {
  const double angle = 2.0 * std::numbers::pi * s.time_s / term.period_s.value();
  out << static_cast<float>(std::sin(angle)), static_cast<float>(std::cos(angle));
}

const std::vector<TermKind>& Kinds() {
  static const std::vector<TermKind> kinds = {
      {"base_lin_vel", "Velocity of the base, in base axes [m/s].", TermSize::kFixed, 3,
       [](const PolicyState& s, const ObservationTerm&, Eigen::VectorXf& out) {
         Put(s.R_WB.transpose() * s.v_WB, out);
       }},
      {"base_ang_vel", "Angular velocity of the base, in base axes [rad/s].", TermSize::kFixed, 3,
       [](const PolicyState& s, const ObservationTerm&, Eigen::VectorXf& out) {
         Put(s.R_WB.transpose() * s.w_WB, out);
       }},
      {"projected_gravity", "Direction of gravity, in base axes.", TermSize::kFixed, 3,
       [](const PolicyState& s, const ObservationTerm&, Eigen::VectorXf& out) {
         Put(-s.R_WB.transpose().col(2), out);
       }},
      {"base_pos_z", "Height of the base [m].", TermSize::kFixed, 1,
       [](const PolicyState& s, const ObservationTerm&, Eigen::VectorXf& out) {
         out[0] = static_cast<float>(s.height_m);
       }},
      {"velocity_commands", "Commanded forward and lateral speed [m/s] and yaw rate [rad/s].", TermSize::kFixed, 3,
       [](const PolicyState& s, const ObservationTerm&, Eigen::VectorXf& out) { Put(s.command, out); }},
      {"joint_pos", "Joint positions [rad].", TermSize::kJoints, 0, Positions},
      {"joint_pos_rel", "Joint positions minus default_joint_pos [rad].", TermSize::kJoints, 0, RelativePositions},
      {"joint_vel", "Joint velocities [rad/s].", TermSize::kJoints, 0, Velocities},
      {"joint_vel_rel", "Joint velocities [rad/s].", TermSize::kJoints, 0, Velocities},
      {"last_action", "The network's last output; zero at the start.", TermSize::kActions, 0,
       [](const PolicyState& s, const ObservationTerm&, Eigen::VectorXf& out) { out = s.last_action; }},
      {kGaitPhase, "Sine and cosine of 2 pi t / period, from the start of the policy.", TermSize::kFixed, 2,
       GaitPhase}};
  return kinds;
}

const TermKind& KindOf(const std::string& name) {
  return *std::find_if(Kinds().begin(), Kinds().end(), [&](const TermKind& kind) { return kind.name == name; });
}

void ClipAndScale(const ObservationTerm& term, Eigen::VectorXf& values) {
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    const auto scale = static_cast<float>(term.scale[term.scale.size() == 1 ? 0 : static_cast<std::size_t>(i)]);
    if (term.scale_first) values[i] *= scale;
    if (term.clip)
      values[i] = std::clamp(values[i], static_cast<float>(term.clip->lowest), static_cast<float>(term.clip->highest));
    if (!term.scale_first) values[i] *= scale;
  }
}

}  // namespace

const std::vector<std::string>& ObservationNames() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const TermKind& kind : Kinds()) all.push_back(kind.name);
    return all;
  }();
  return names;
}

const std::string& ObservationMeaning(const std::string& name) { return KindOf(name).meaning; }

int SizeOf(const ObservationTerm& term, int joints, int actions) {
  const TermKind& kind = KindOf(term.name);
  if (kind.size == TermSize::kActions) return actions;
  if (kind.size == TermSize::kFixed) return kind.count;
  return term.joints.empty() ? joints : static_cast<int>(term.joints.size());
}

int SizeOf(const PolicyContract& contract, int actions) {
  int size = 0;
  for (const ObservationTerm& term : contract.observations)
    size += term.history * SizeOf(term, contract.num_joints(), actions);
  return size;
}

Observer::Observer(const PolicyContract& contract, int actions)
    : contract_(contract), input_(SizeOf(contract, actions)) {
  for (const ObservationTerm& term : contract.observations) {
    sizes_.push_back(SizeOf(term, contract.num_joints(), actions));
    histories_.emplace_back(Eigen::VectorXf::Zero(term.history * sizes_.back()));
  }
}

const Eigen::VectorXf& Observer::Observe(const PolicyState& state) {
  for (std::size_t i = 0; i < histories_.size(); ++i) {
    const ObservationTerm& term = contract_.observations[i];
    Eigen::VectorXf& history = histories_[i];
    const Eigen::Index size = sizes_[i];
    now_.resize(size);
    KindOf(term.name).fill(state, term, now_);
    ClipAndScale(term, now_);
    if (begun_) {
      std::copy(history.data() + size, history.data() + history.size(), history.data());
      history.tail(size) = now_;
    } else {
      for (Eigen::Index k = 0; k < history.size(); k += size) history.segment(k, size) = now_;
    }
  }
  begun_ = true;
  Eigen::Index at = 0;
  const int frames = contract_.history_by_frame ? contract_.observations.front().history : 1;
  for (int frame = 0; frame < frames; ++frame) {
    for (const auto& history : histories_) {
      const Eigen::Index count = history.size() / frames;
      input_.segment(at, count) = history.segment(frame * count, count);
      at += count;
    }
  }
  return input_;
}

}  // namespace gaitwright
