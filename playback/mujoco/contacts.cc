// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "kinematics/dynamics/foot_contact.h"
#include "playback/mujoco/contacts_internal.h"

namespace gaitwright::mujoco {

Contacts::Contacts(const RobotModel& model, const Terrain& terrain, const ModelText& text, const mjModel& m,
                   const mjData& d)
    : model_(model),
      terrain_(terrain),
      text_(text),
      m_(m),
      d_(d),
      part_(static_cast<std::size_t>(m.ngeom), -1),
      solid_(part_) {
  for (std::size_t g = 0; g < text.parts.size(); ++g)
    part_[static_cast<std::size_t>(IdOf(m, mjOBJ_GEOM, "g" + std::to_string(g)))] = static_cast<int>(g);
  for (std::size_t t = 0; t < text.solids.size(); ++t)
    solid_[static_cast<std::size_t>(IdOf(m, mjOBJ_GEOM, "t" + std::to_string(t)))] = static_cast<int>(t);
  feet_.assign(model.feet.size(), FootContact{});
}

Penetration Contacts::PenetrationOf(const mjContact& contact) const {
  const auto first = static_cast<std::size_t>(contact.geom1), second = static_cast<std::size_t>(contact.geom2);
  const int part = std::max(part_[first], part_[second]), solid = std::max(solid_[first], solid_[second]);
  return {-contact.dist, part < 0 ? "" : text_.parts[static_cast<std::size_t>(part)].link,
          solid < 0 ? "" : text_.solids[static_cast<std::size_t>(solid)]};
}

void Contacts::Read(double step_s, const DynamicsScratch& before, const DynamicsScratch& after) {
  feet_.assign(model_.feet.size(), FootContact{});
  body_contacts_.clear();
  for (int i = 0; i < static_cast<int>(feet_.size()); ++i) {
    FootContact& foot = feet_[static_cast<std::size_t>(i)];
    const Foot& shape = model_.feet[static_cast<std::size_t>(i)];
    const Vector3 middle_W = FramePose(before, shape.body, shape.X_BF).translation();
    const Vector3 normal_W = GroundAt(terrain_, middle_W.head<2>()).normal_W;
    foot.p_W = ContactFrame(model_, before, i, normal_W).translation();
    foot.speed_m_s = (ContactFrame(model_, after, i, normal_W).translation() - foot.p_W).norm() / step_s;
  }
  for (int c = 0; c < d_.ncon; ++c) Add(c, before, after);
  for (FootContact& foot : feet_) {
    if (foot.normal_n <= 0.0) continue;
    foot.slide_m /= foot.normal_n;
    foot.friction /= foot.normal_n;
  }
}

void Contacts::Add(int index, const DynamicsScratch& before, const DynamicsScratch& after) {
  const mjContact& contact = d_.contact[index];
  if (contact.efc_address < 0) return;
  const int first = part_[static_cast<std::size_t>(contact.geom1)],
            second = part_[static_cast<std::size_t>(contact.geom2)];
  const int part = first >= 0 ? first : second;
  if (part < 0) return;
  mjtNum force[6];
  mj_contactForce(&m_, &d_, index, force);
  if (force[0] <= 0.0) return;
  const mujoco::GeomPart& of = text_.parts[static_cast<std::size_t>(part)];
  if (of.foot < 0) {
    if (std::find(body_contacts_.begin(), body_contacts_.end(), of.link) == body_contacts_.end())
      body_contacts_.push_back(of.link);
    return;
  }
  // Force and normal point from the first geom to the second.
  const double sign = first >= 0 ? -1.0 : 1.0;
  const Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> frame(contact.frame);
  const Vector3 normal = sign * frame.row(0).transpose();
  const Vector3 force_W = sign * (frame.transpose() * AsVector(force));
  const auto body = static_cast<std::size_t>(model_.feet[static_cast<std::size_t>(of.foot)].body);
  const Vector3 p_W = AsVector(contact.pos), p_B = before.R_WB[body].transpose() * (p_W - before.p_WB[body]);
  const Vector3 moved = after.p_WB[body] + after.R_WB[body] * p_B - p_W;
  FootContact& foot = feet_[static_cast<std::size_t>(of.foot)];
  foot.touching = true;
  foot.wrench.force_W += force_W;
  foot.wrench.moment_W += (p_W - foot.p_W).cross(force_W);
  foot.normal_n += force[0];
  foot.tangential_n += std::hypot(force[1], force[2]);
  foot.friction += force[0] * contact.friction[0];
  foot.slide_m += force[0] * (moved - normal.dot(moved) * normal).norm();
  foot.penetration_m = std::max(foot.penetration_m, -contact.dist);
}

}  // namespace gaitwright::mujoco
