// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/transmission.h"

#include <fmt/format.h>

#include <Eigen/LU>
#include <Eigen/SVD>
#include <cmath>

#include "kinematics/base/result.h"
#include "kinematics/model/robot_model.h"

namespace gaitwright {
namespace {

void CheckTransmission(const Transmission& t, const RobotModel& model) {
  const Eigen::Index n = t.size();
  if (n == 0 || static_cast<Eigen::Index>(t.motors.size()) != n || t.ratios.rows() != n || t.ratios.cols() != n) {
    throw InvalidArgument(
        fmt::format("transmission '{}' has {} joints, {} motors and a matrix of {} x {} ratios; it needs one motor and "
                    "one row and column of ratios for each joint",
                    t.name, n, t.motors.size(), t.ratios.rows(), t.ratios.cols()));
  }
  for (const int dof : t.dofs) {
    if (dof < 0 || dof >= model.num_dofs())
      throw InvalidArgument(fmt::format("transmission '{}' names coordinate {}; robot '{}' has coordinates 0 to {}",
                                        t.name, dof, model.name, model.num_dofs() - 1));
    if (const Transmission* other = model.TransmissionOf(dof))
      throw InvalidArgument(fmt::format("joint '{}' of transmission '{}' is already driven by transmission '{}'",
                                        model.dof_names[static_cast<std::size_t>(dof)], t.name, other->name));
  }
  const double regularity = Regularity(t.ratios);
  if (!(regularity >= kLeastRegularity)) {
    throw InvalidArgument(fmt::format(
        "the ratios of transmission '{}' are singular: its motors cannot move its joints independently. With rows and "
        "columns scaled to length 1, the smallest singular value is {:.2g} of the largest; {:g} or more is needed",
        t.name, regularity, kLeastRegularity));
  }
}

/// Largest value of the sum of weight * x for |x| within limits; motors with weight 0 are ignored.
double MostOf(const Eigen::Ref<const VectorX>& weights, const VectorX& limits) {
  double most = 0.0;
  for (Eigen::Index m = 0; m < weights.size(); ++m) {
    if (weights[m] != 0.0) most += std::abs(weights[m]) * limits[m];
  }
  return most;
}

void SetBox(const Transmission& t, RobotModel& model) {
  VectorX efforts(t.size()), speeds(t.size());
  for (Eigen::Index m = 0; m < t.size(); ++m) {
    efforts[m] = t.motors[static_cast<std::size_t>(m)].effort_limit;
    speeds[m] = t.motors[static_cast<std::size_t>(m)].velocity_limit;
  }
  for (Eigen::Index i = 0; i < t.size(); ++i) {
    const double effort = MostOf(t.ratios.col(i), efforts), speed = MostOf(t.inverse.row(i).transpose(), speeds);
    for (Joint& joint : model.joints) {
      if (joint.dof != t.dofs[static_cast<std::size_t>(i)]) continue;
      joint.effort_limit = effort;
      joint.velocity_limit = speed * std::abs(joint.multiplier);
      joint.effort_limit_is_placeholder = !std::isfinite(effort);
      joint.velocity_limit_is_placeholder = !std::isfinite(speed);
    }
  }
}

}  // namespace

VectorX Transmission::Own(const Eigen::Ref<const VectorX>& joints) const {
  VectorX own(size());
  for (Eigen::Index i = 0; i < size(); ++i) own[i] = joints[dofs[static_cast<std::size_t>(i)]];
  return own;
}

void Transmission::Put(const VectorX& own, Eigen::Ref<VectorX> joints) const {
  for (Eigen::Index i = 0; i < size(); ++i) joints[dofs[static_cast<std::size_t>(i)]] = own[i];
}

MatrixX Transmission::RotorInertia() const {
  VectorX rotors(size());
  for (Eigen::Index m = 0; m < size(); ++m) rotors[m] = motors[static_cast<std::size_t>(m)].motor.rotor_inertia;
  return ratios.transpose() * rotors.asDiagonal() * ratios;
}

double Regularity(const MatrixX& ratios) {
  MatrixX scaled = ratios;
  for (Eigen::Index i = 0; i < scaled.rows(); ++i) {
    if (const double length = scaled.row(i).stableNorm(); length > 0.0) scaled.row(i) /= length;
  }
  for (Eigen::Index i = 0; i < scaled.cols(); ++i) {
    if (const double length = scaled.col(i).stableNorm(); length > 0.0) scaled.col(i) /= length;
  }
  if (scaled.size() == 0 || !scaled.allFinite()) return 0.0;
  const VectorX values = Eigen::JacobiSVD<MatrixX>(scaled).singularValues();
  return values[0] > 0.0 ? values[values.size() - 1] / values[0] : 0.0;
}

void AddTransmission(Transmission transmission, RobotModel& model) {
  CheckTransmission(transmission, model);
  transmission.inverse = transmission.ratios.inverse();
  SetBox(transmission, model);
  model.transmissions.push_back(std::move(transmission));
}

}  // namespace gaitwright
