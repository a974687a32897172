// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/collision/collision_checker.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <numbers>
#include <random>

#include "kinematics/collision/fcl_shape_internal.h"
#include "kinematics/collision/shape_extent.h"

namespace gaitwright {
namespace {

/// The joint through which `ancestor` carries `body` directly: by one joint, by joints whose axes meet at one point (an
/// ankle, a hip), or through bodies without shapes. The first joint of several; null if it does not carry it directly.
const Joint* CarryingJoint(const RobotModel& model, const std::vector<bool>& has_shapes, int ancestor, int body) {
  constexpr double kMeet = 5e-3;  // [m]
  while (body > 0) {
    const Joint& joint = model.joints[static_cast<std::size_t>(body - 1)];
    body = joint.parent_body;
    if (body == ancestor) return &joint;
    if (has_shapes[static_cast<std::size_t>(body)] && joint.X_PJ.translation().norm() > kMeet) return nullptr;
  }
  return nullptr;
}

/// Random positions of all joints within their limits (within a full turn without limits), the same in each call.
std::vector<VectorX> PosturesOverRanges(const RobotModel& model, int count) {
  std::mt19937 engine(1);
  std::vector<VectorX> postures(static_cast<std::size_t>(count), StandingConfiguration(model));
  for (VectorX& q : postures) {
    for (int d = 0; d < model.num_dofs(); ++d) {
      const double low = std::max(model.dof_lower(d), -std::numbers::pi);
      const double high = std::min(model.dof_upper(d), std::numbers::pi);
      q[7 + d] = low + (high - low) * (static_cast<double>(engine()) / 4294967296.0);
    }
  }
  return postures;
}

}  // namespace

struct CollisionChecker::Scene {
  struct Part {
    const Shape* shape;
    double radius;
    fcl::CollisionObjectd object;
    Pose X_BS = Pose::Identity();  ///< in the robot's base, so that a motion of the whole robot does not count
    double path_m = 0.0;           ///< bound on the path length of any of its points since the start
  };
  struct Pair {
    std::size_t a, b;
    /// Sum of the two paths before which the parts cannot touch; reduced by their depth if they overlap.
    double free_m = -std::numeric_limits<double>::infinity();
  };
  std::vector<Shape> shapes;
  std::vector<Part> parts;
  std::vector<Pair> pairs;
  std::vector<std::pair<int, int>> shape_pairs;  // of `pairs`
  std::vector<std::string> notes;
  std::vector<LeftOutPair> left_out;
  std::vector<Overlap> overlaps;

  void Place(const DynamicsScratch& scratch) {
    for (Part& part : parts) {
      part.object.setTransform(FramePose(scratch, part.shape->body, part.shape->X_BS));
      part.object.computeAABB();
    }
  }

  /// Updates the poses in the base, and the path bound of each part by the motion of its centre plus the radius times
  /// the chord of its rotation.
  void Move(const DynamicsScratch& scratch) {
    Pose X_WB = Pose::Identity();
    X_WB.linear() = scratch.R_WB[0];
    X_WB.translation() = scratch.p_WB[0];
    const Pose X_BW = X_WB.inverse();
    for (Part& part : parts) {
      const Pose X_BS = X_BW * FramePose(scratch, part.shape->body, part.shape->X_BS);
      const double chord = (X_BS.linear() - part.X_BS.linear()).norm() / std::numbers::sqrt2;
      part.path_m += (X_BS.translation() - part.X_BS.translation()).norm() + part.radius * chord;
      part.X_BS = X_BS;
    }
  }

  /// A lower bound of the distance of a pair; the negative depth if they touch.
  double Apart(const Pair& pair) {
    const Part &a = parts[pair.a], &b = parts[pair.b];
    const double spheres = (a.X_BS.translation() - b.X_BS.translation()).norm() - a.radius - b.radius;
    return spheres > 0.0 ? spheres : Gap(pair);
  }

  /// The exact distance of a pair; the negative depth if they touch.
  double Gap(const Pair& pair) {
    Part &a = parts[pair.a], &b = parts[pair.b];
    for (Part* part : {&a, &b}) {
      part->object.setTransform(part->X_BS);
      part->object.computeAABB();
    }
    return SignedGap(a.object, b.object);
  }

  bool Touch(const Pair& pair) const {
    const Part &a = parts[pair.a], &b = parts[pair.b];
    if ((a.object.getTranslation() - b.object.getTranslation()).norm() > a.radius + b.radius) return false;
    const fcl::CollisionRequestd request;
    fcl::CollisionResultd result;
    return fcl::collide(&a.object, &b.object, request, result) > 0;
  }

  /// Adds a pair of links that is not checked, once for all shapes of the links.
  void LeaveOut(const Pair& pair, bool adjacent, const std::string& reason) {
    const LeftOutPair entry{parts[pair.a].shape->link, parts[pair.b].shape->link, adjacent, reason};
    const bool known = std::any_of(left_out.begin(), left_out.end(), [&](const LeftOutPair& other) {
      return other.link_a == entry.link_a && other.link_b == entry.link_b;
    });
    if (!known) left_out.push_back(entry);
  }

  /// Leaves out pairs that touch in the standing posture. Postures over all joint ranges show whether they always
  /// touch.
  void LeaveOutTouching(const RobotModel& model, const std::vector<Pair>& touching, DynamicsScratch& scratch) {
    constexpr int kPostures = 200;
    if (touching.empty()) return;
    std::vector<int> touched(touching.size(), 0);
    for (const VectorX& q : PosturesOverRanges(model, kPostures)) {
      ForwardKinematics(model, q, scratch);
      Place(scratch);
      for (std::size_t k = 0; k < touching.size(); ++k) touched[k] += Touch(touching[k]) ? 1 : 0;
    }
    for (std::size_t k = 0; k < touching.size(); ++k) {
      LeaveOut(
          touching[k], false,
          touched[k] == kPostures
              ? fmt::format("always touching, in all of {} postures over the joints' ranges", kPostures)
              : fmt::format("touching in the standing posture, and in {} of {} other postures over the joints' ranges",
                            touched[k], kPostures));
    }
  }
};

CollisionChecker::CollisionChecker(const RobotModel& model) : scene_(std::make_unique<Scene>()) {
  std::vector<bool> has_shapes(model.bodies.size(), false);
  scene_->shapes = model.collision_shapes;
  for (const Shape& shape : scene_->shapes) {
    has_shapes[static_cast<std::size_t>(shape.body)] = true;
    const auto geometry = FclGeometry(shape);
    if (geometry == nullptr) {
      scene_->notes.push_back(fmt::format("link '{}': its mesh is not used for self-collision", shape.link));
      continue;
    }
    scene_->parts.push_back({&shape, BoundingRadius(shape), fcl::CollisionObjectd(geometry)});
  }
  DynamicsScratch scratch(model);
  ForwardKinematics(model, StandingConfiguration(model), scratch);
  scene_->Place(scratch);
  std::vector<Scene::Pair> touching;
  for (std::size_t i = 0; i < scene_->parts.size(); ++i) {
    for (std::size_t j = i + 1; j < scene_->parts.size(); ++j) {
      const int a = scene_->parts[i].shape->body, b = scene_->parts[j].shape->body;
      if (a == b) continue;
      const Joint* joint = CarryingJoint(model, has_shapes, a, b);
      if (joint == nullptr) joint = CarryingJoint(model, has_shapes, b, a);
      if (joint != nullptr) {
        scene_->LeaveOut({i, j}, true, fmt::format("adjacent: joint '{}' connects them", joint->name));
      } else if (scene_->Touch({i, j})) {
        touching.push_back({i, j});
      } else {
        scene_->pairs.push_back({i, j});
      }
    }
  }
  scene_->LeaveOutTouching(model, touching, scratch);
  const auto shape_of = [&](std::size_t part) {
    return static_cast<int>(scene_->parts[part].shape - scene_->shapes.data());
  };
  for (const Scene::Pair& pair : scene_->pairs) scene_->shape_pairs.emplace_back(shape_of(pair.a), shape_of(pair.b));
}

CollisionChecker::~CollisionChecker() = default;
CollisionChecker::CollisionChecker(CollisionChecker&&) noexcept = default;
CollisionChecker& CollisionChecker::operator=(CollisionChecker&&) noexcept = default;

const std::vector<Overlap>& CollisionChecker::Overlaps(const DynamicsScratch& scratch) {
  scene_->Move(scratch);
  scene_->overlaps.clear();
  for (Scene::Pair& pair : scene_->pairs) {
    const Scene::Part &a = scene_->parts[pair.a], &b = scene_->parts[pair.b];
    const double path = a.path_m + b.path_m;
    if (path < pair.free_m) continue;
    const double apart = scene_->Apart(pair);
    pair.free_m = path + apart;
    if (apart < 0.0) scene_->overlaps.push_back({a.shape->link, b.shape->link, -apart});
  }
  return scene_->overlaps;
}

Overlap CollisionChecker::Nearest(const DynamicsScratch& scratch, double within_m) {
  constexpr double kNearer = 1e-4;  // [m]
  scene_->Move(scratch);
  Overlap nearest;
  for (Scene::Pair& pair : scene_->pairs) {
    const Scene::Part &a = scene_->parts[pair.a], &b = scene_->parts[pair.b];
    const double path = a.path_m + b.path_m, wanted = within_m - kNearer;
    if (pair.free_m - path >= wanted) continue;
    double apart = scene_->Apart(pair);
    if (apart >= 0.0 && apart < wanted) apart = scene_->Gap(pair);
    pair.free_m = path + apart;
    if (apart >= wanted) continue;
    nearest = {a.shape->link, b.shape->link, -apart};
    within_m = apart;
  }
  return nearest;
}

const std::vector<std::string>& CollisionChecker::notes() const { return scene_->notes; }
const std::vector<LeftOutPair>& CollisionChecker::left_out() const { return scene_->left_out; }
int CollisionChecker::num_pairs() const { return static_cast<int>(scene_->pairs.size()); }
const std::vector<std::pair<int, int>>& CollisionChecker::pairs() const { return scene_->shape_pairs; }

}  // namespace gaitwright
