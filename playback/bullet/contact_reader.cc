// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "kinematics/dynamics/foot_contact.h"
#include "playback/bullet/contact_reader_internal.h"

namespace gaitwright::bullet {

void ContactReader::Read(btDispatcher& dispatcher, double step_s, const DynamicsScratch& before,
                         const DynamicsScratch& after) {
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
  for (int i = 0; i < dispatcher.getNumManifolds(); ++i) {
    ReadManifold(*dispatcher.getManifoldByIndexInternal(i), step_s, before, after);
  }
  for (FootContact& foot : feet_) {
    if (foot.normal_n > 0.0) {
      foot.slide_m /= foot.normal_n;
      foot.friction /= foot.normal_n;
    }
  }
}

void ContactReader::ReadManifold(const btPersistentManifold& manifold, double step_s, const DynamicsScratch& before,
                                 const DynamicsScratch& after) {
  const auto* first = btMultiBodyLinkCollider::upcast(manifold.getBody0());
  const auto* robot = first != nullptr ? first : btMultiBodyLinkCollider::upcast(manifold.getBody1());
  if (robot == nullptr) return;
  const bool is_first = first != nullptr;
  const double sign = is_first ? 1.0 : -1.0;  // Bullet gives impulses and normals for the first body
  const int body = robot->m_link + 1;
  const auto b = static_cast<std::size_t>(body);
  for (int i = 0; i < manifold.getNumContacts(); ++i) {
    const btManifoldPoint& contact = manifold.getContactPoint(i);
    if (contact.m_appliedImpulse <= 0.0) continue;
    const ColliderPart& part = robot_.part(body, is_first ? contact.m_index0 : contact.m_index1);
    if (part.foot < 0) {
      if (std::find(body_contacts_.begin(), body_contacts_.end(), part.link) == body_contacts_.end()) {
        body_contacts_.push_back(part.link);
      }
      continue;
    }
    const Vector3 normal = sign * FromBullet(contact.m_normalWorldOnB);
    const Vector3 impulse = sign * FromBullet(contact.m_normalWorldOnB * contact.m_appliedImpulse +
                                              contact.m_lateralFrictionDir1 * contact.m_appliedImpulseLateral1 +
                                              contact.m_lateralFrictionDir2 * contact.m_appliedImpulseLateral2);
    const Vector3 p_BQ = robot_.X_BM(body) * FromBullet(is_first ? contact.m_localPointA : contact.m_localPointB);
    const Vector3 moved = (after.p_WB[b] - before.p_WB[b]) + (after.R_WB[b] - before.R_WB[b]) * p_BQ;
    const Point point{before.p_WB[b] + before.R_WB[b] * p_BQ,     impulse / step_s,      normal,
                      contact.m_appliedImpulse / step_s,          contact.getDistance(), contact.m_combinedFriction,
                      (moved - normal.dot(moved) * normal).norm()};
    AddToFoot(part.foot, point);
  }
}

void ContactReader::AddToFoot(int index, const Point& point) {
  FootContact& foot = feet_[static_cast<std::size_t>(index)];
  foot.touching = true;
  foot.wrench.force_W += point.force_W;
  foot.wrench.moment_W += (point.p_W - foot.p_W).cross(point.force_W);
  foot.normal_n += point.normal_n;
  foot.tangential_n += (point.force_W - point.normal_n * point.normal_W).norm();
  foot.friction += point.normal_n * point.friction;
  foot.slide_m += point.normal_n * point.slide_m;
  foot.penetration_m = std::max(foot.penetration_m, -point.distance_m);
}

}  // namespace gaitwright::bullet
