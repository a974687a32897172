// SPDX-License-Identifier: BSD-3-Clause
#include <BulletCollision/CollisionShapes/btCompoundShape.h>
#include <BulletDynamics/Featherstone/btMultiBodyLinkCollider.h>

#include <algorithm>
#include <numeric>

#include "kinematics/stability/polygon.h"
#include "playback/bullet/contact_thinning_internal.h"
#include "playback/bullet/robot_body_internal.h"

namespace gaitwright::bullet {
namespace {

const btMultiBodyLinkCollider* LinkOf(const btPersistentManifold& manifold) {
  const auto* first = btMultiBodyLinkCollider::upcast(manifold.getBody0());
  return first != nullptr ? first : btMultiBodyLinkCollider::upcast(manifold.getBody1());
}

int RoleOf(const btCollisionObject& link, int child) {
  const auto& compound = static_cast<const btCompoundShape&>(*link.getCollisionShape());
  return compound.getChildShape(std::max(child, 0))->getUserIndex();
}

bool OnHeightField(const btPersistentManifold& manifold, const btCollisionObject& link) {
  const btCollisionObject* ground = manifold.getBody0() == &link ? manifold.getBody1() : manifold.getBody0();
  return ground->getCollisionShape()->getShapeType() == TERRAIN_SHAPE_PROXYTYPE;
}

/// Hull of the kept points, without point `but` and without points higher than `highest_m`.
Polygon HullOf(const std::vector<Gap>& points, const std::vector<bool>& kept, std::size_t but, double highest_m) {
  Polygon places;
  for (std::size_t k = 0; k < points.size(); ++k)
    if (kept[k] && k != but && points[k].gap_m <= highest_m) places.push_back(points[k].place);
  return ConvexHull(std::move(places));
}

}  // namespace

std::vector<bool> HoldingPoints(const std::vector<Gap>& points) {
  constexpr double kOn = 1e-6;      // tolerance for a point on an edge [m]
  constexpr double kNearly = 1e-5;  // [m]
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t k) { return points[k].gap_m; });
  std::vector<bool> kept(points.size(), false);
  Polygon hull;
  for (const std::size_t k : order) {
    if (!hull.empty() && SignedDistance(hull, points[k].place) >= -kOn) continue;
    kept[k] = true;
    hull.push_back(points[k].place);
    hull = ConvexHull(std::move(hull));
  }
  for (const std::size_t k : order) {  // removes corners that farther corners of similar height made redundant
    if (!kept[k]) continue;
    const Polygon others = HullOf(points, kept, k, points[k].gap_m + kNearly);
    kept[k] = others.empty() || SignedDistance(others, points[k].place) < -kOn;
  }
  return kept;
}

double ContactThinning::SpeedAt(const btCollisionObject& link, const btVector3& p_W) {
  const auto& collider = static_cast<const btMultiBodyLinkCollider&>(link);
  const btMultiBody& body = *collider.m_multiBody;
  if (body_ != &body) {
    body_ = &body;
    spin_.resize(static_cast<std::size_t>(body.getNumLinks()) + 1);
    velocity_.resize(spin_.size());
    body.compTreeLinkVelocities(spin_.data(), velocity_.data());
  }
  const auto i = static_cast<std::size_t>(collider.m_link + 1);
  return (velocity_[i] + spin_[i].cross(body.worldPosToLocal(collider.m_link, p_W))).length();
}

bool ContactThinning::IsNear(const btCollisionObject& link, const btManifoldPoint& point, const btVector3& p_W,
                             double step_s) {
  constexpr double kNear = 1e-4;  // [m]
  constexpr double kSteps = 2.0;  // speed is extrapolated over so many steps
  return point.getDistance() < kNear || point.getDistance() < kNear + kSteps * step_s * SpeedAt(link, p_W);
}

void ContactThinning::ThinLink() {
  const std::vector<bool> kept = HoldingPoints(gaps_);
  for (std::size_t k = 0; k < points_.size(); ++k)
    if (!kept[k]) points_[k].manifold->removeContactPoint(points_[k].index);
  points_.clear();
  gaps_.clear();
}

void ContactThinning::Thin(btPersistentManifold** manifolds, int num_manifolds, double step_s) {
  body_ = nullptr;
  link_ = nullptr;
  for (int m = 0; m < num_manifolds; ++m) {
    btPersistentManifold& manifold = *manifolds[m];
    const btMultiBodyLinkCollider* link = LinkOf(manifold);
    if (link == nullptr) continue;
    if (link != link_) ThinLink();
    link_ = link;
    const bool first = manifold.getBody0() == link, field = OnHeightField(manifold, *link);
    // Backwards, because Bullet moves the last point to the place of a removed one.
    for (int i = manifold.getNumContacts() - 1; i >= 0; --i) {
      const btManifoldPoint& point = manifold.getContactPoint(i);
      const int role = RoleOf(*link, first ? point.m_index0 : point.m_index1);
      if (role <= 0 || (role == kCorner && !field)) continue;
      const btVector3& p_W = first ? point.getPositionWorldOnA() : point.getPositionWorldOnB();
      if (!field || !IsNear(*link, point, p_W, step_s)) {
        manifold.removeContactPoint(i);
      } else {
        points_.push_back({&manifold, i});
        gaps_.push_back({FromBullet(p_W).head<2>(), point.getDistance()});
      }
    }
  }
  ThinLink();
}

}  // namespace gaitwright::bullet
