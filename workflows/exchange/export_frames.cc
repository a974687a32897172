// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>
#include <vector>

#include "kinematics/base/result.h"
#include "kinematics/dynamics/dynamics.h"
#include "workflows/exchange/export_frames_internal.h"
#include "workflows/exchange/export_npz.h"
#include "workflows/exchange/frame_motion_internal.h"
#include "workflows/exchange/stored_zip.h"

namespace gaitwright {
namespace {

std::vector<Eigen::Index> DescribedDofs(const RobotModel& model) {
  std::vector<Eigen::Index> dofs;
  for (const std::string& name : DescribedJointOrder(model)) dofs.push_back(model.DofIndex(name));
  return dofs;
}

/// The numbers of a frame, separated by commas.
void AppendFrame(const std::vector<Eigen::Index>& dofs, const VectorX& q, std::string& text) {
  if (!q.allFinite()) throw InvalidArgument("a position is not finite; only finite numbers are exported");
  const auto add = [&](double value) { text += fmt::format("{:.6f}", value) + ','; };
  for (Eigen::Index i = 0; i < 7; ++i) add(q[i]);
  for (const Eigen::Index dof : dofs) add(q[7 + dof]);
  text.pop_back();
}

/// Values of all frames, one after the other.
struct FrameArray {
  std::string name;
  std::vector<std::size_t> shape;
  std::vector<double> values = {};

  template <class Vector>
  void Add(const Vector& numbers) {
    values.insert(values.end(), numbers.data(), numbers.data() + numbers.size());
  }
  ZipEntry Entry() const {
    for (const double value : values) {
      if (!std::isfinite(value)) throw InvalidArgument(fmt::format("array '{}' has a value that is not finite", name));
    }
    return {name + ".npy", NpyOfNumbers(values, shape)};
  }
};

}  // namespace

std::string FramesCsv(const RobotModel& model, const MotionRows& rows) {
  const std::vector<Eigen::Index> dofs = DescribedDofs(model);
  std::string text;
  for (const VectorX& q : rows.q) {
    AppendFrame(dofs, q, text);
    text += '\n';
  }
  return text;
}

std::string FramesJson(const RobotModel& model, const MotionRows& rows, double rate_hz, bool wraps) {
  const std::vector<Eigen::Index> dofs = DescribedDofs(model);
  std::string text = fmt::format("{{\n\"LoopMode\": \"{}\",\n\"FrameDuration\": {:.9g},\n\"Frames\":\n[\n",
                                 wraps ? "Wrap" : "Clamp", 1.0 / rate_hz);
  for (const VectorX& q : rows.q) {
    text += '[';
    AppendFrame(dofs, q, text);
    text += &q == &rows.q.back() ? "]\n" : "],\n";
  }
  return text + "]\n}\n";
}

std::string FramesNpz(const RobotModel& model, const MotionRows& rows, double rate_hz) {
  const std::vector<Eigen::Index> dofs = DescribedDofs(model);
  const std::size_t frames = rows.q.size(), bodies = model.bodies.size();
  FrameArray fps{"fps", {1}, {rate_hz}};
  FrameArray q{"joint_pos", {frames, dofs.size()}}, v{"joint_vel", {frames, dofs.size()}};
  FrameArray p_W{"body_pos_w", {frames, bodies, 3}}, turn{"body_quat_w", {frames, bodies, 4}};
  FrameArray v_W{"body_lin_vel_w", {frames, bodies, 3}}, w_W{"body_ang_vel_w", {frames, bodies, 3}};
  DynamicsScratch scratch(model);
  for (std::size_t k = 0; k < frames; ++k) {
    q.Add(VectorX(rows.q[k].tail(model.num_dofs())(dofs)));
    v.Add(VectorX(rows.v[k].tail(model.num_dofs())(dofs)));
    ForwardVelocities(model, rows.q[k], rows.v[k], scratch);
    for (std::size_t b = 0; b < bodies; ++b) {
      const Quaternion R_WB(scratch.R_WB[b]);
      p_W.Add(scratch.p_WB[b]);
      turn.Add(Eigen::Vector4d(R_WB.w(), R_WB.x(), R_WB.y(), R_WB.z()));
      v_W.Add(scratch.v_WB[b]);
      w_W.Add(scratch.w_WB[b]);
    }
  }
  std::vector<ZipEntry> entries;
  for (const FrameArray* array : {&fps, &q, &v, &p_W, &turn, &v_W, &w_W}) entries.push_back(array->Entry());
  std::vector<std::string> names;
  for (const Body& body : model.bodies) names.push_back(body.name);
  entries.push_back({"joint_names.npy", NpyOfTexts(DescribedJointOrder(model))});
  entries.push_back({"body_names.npy", NpyOfTexts(names)});
  return StoredZip(entries);
}

std::string FramesNote(const RobotModel& model, double rate_hz, bool without_rate) {
  std::string note = fmt::format("joints are in the order of the robot's description: {}",
                                 fmt::join(DescribedJointOrder(model), ", "));
  if (without_rate) note += fmt::format("; the file does not contain its rate of {:.6g} frames a second", rate_hz);
  return note;
}

}  // namespace gaitwright
