// SPDX-License-Identifier: BSD-3-Clause
#include "planning/footsteps/foothold_check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "kinematics/spatial/dense_solvers.h"
#include "kinematics/spatial/rotation.h"
#include "kinematics/stability/polygon.h"
#include "planning/footsteps/plan_view.h"
#include "planning/plan/resting_plane.h"
#include "planning/plan/sole_support.h"

namespace gaitwright {
namespace {

constexpr double kRolls = 0.5;          // [rad] by which a sphere may roll towards a riser during a stance
constexpr double kFlush = 3e-4;         // [m] allowed height of ground above a sole's plane; swings allow 0.5 mm
constexpr double kMissed = 0.5;         // share of the margin by which a sole may miss its place
constexpr double kSteady = 0.05;        // share of half a sole's width: depth of its middle inside its steady part
constexpr double kSafe = 0.06;          // distance from edges without risk, as a share of the leg length
constexpr double kUnderFoot = 0.5;      // height over a foothold up to which obstacles matter, in leg lengths
constexpr double kFrictionShare = 0.8;  // share of the friction coefficient that a slope may use
constexpr int kAround = 8;

Vector2 Around(int i) {
  const double angle = 2.0 * std::numbers::pi * i / kAround;
  return {std::cos(angle), std::sin(angle)};
}

Vector2 PlaceOf(const PlanarPose& at) { return {at.x_m, at.y_m}; }

Vector3 PlaneOf(const GroundPoint& ground, const Vector2& p_W) {
  const Vector3 n = ground.normal_W / ground.normal_W.z();
  return {-n.x(), -n.y(), ground.height_m + n.x() * p_W.x() + n.y() * p_W.y()};
}

double On(const Vector3& plane, const Vector2& p_W) { return plane.dot(Vector3(p_W.x(), p_W.y(), 1.0)); }

Vector3 NormalOf(const Vector3& plane) { return Vector3(-plane.x(), -plane.y(), 1.0).normalized(); }

Pose Standing(const PlanarPose& at, double height_m, const Vector3& normal_W) {
  const Vector2 forward(std::cos(at.yaw_rad), std::sin(at.yaw_rad));
  Pose X_WF = Pose::Identity();
  X_WF.linear().col(0) =
      Vector3(forward.x(), forward.y(), -normal_W.head<2>().dot(forward) / normal_W.z()).normalized();
  X_WF.linear().col(1) = normal_W.cross(X_WF.linear().col(0));
  X_WF.linear().col(2) = normal_W;
  X_WF.translation() = Vector3(at.x_m, at.y_m, height_m);
  return X_WF;
}

/// The plane fitted to points of the ground, raised to the highest point.
Vector3 PlaneOver(const std::vector<Vector3>& points_W, const PlanarPose& at) {
  MatrixX places(static_cast<Eigen::Index>(points_W.size()), 3);
  VectorX heights(static_cast<Eigen::Index>(points_W.size()));
  for (std::size_t i = 0; i < points_W.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    places.row(row) << (points_W[i].head<2>() - PlaceOf(at)).transpose(), 1.0;
    heights[row] = points_W[i].z();
  }
  Vector3 plane = SolveLeastNorm(places, heights);
  plane.z() += (heights - places * plane).maxCoeff();
  plane.z() -= plane.head<2>().dot(PlaceOf(at));
  return plane;
}

/// Corners, edge midpoints and centre of a sole in plan view.
std::vector<Vector2> SamplesOf(const Polygon& outline_W) {
  std::vector<Vector2> samples = {Centroid(outline_W)};
  for (std::size_t i = 0; i < outline_W.size(); ++i) {
    samples.push_back(outline_W[i]);
    samples.emplace_back(0.5 * (outline_W[i] + outline_W[(i + 1) % outline_W.size()]));
  }
  return samples;
}

}  // namespace

std::string Describe(FootholdFault fault) {
  static const std::array<std::string, 7> kWords = {"none",      "no ground",        "too near an edge", "too steep",
                                                    "too rough", "too near a riser", "an obstacle there"};
  return kWords[static_cast<std::size_t>(fault)];
}

FootholdChecker::FootholdChecker(const RobotModel& model, const GroundIndex& ground, const FootholdOptions& options)
    : model_(&model), ground_(&ground), options_(options), leg_m_(model.leg_length_m()) {
  CheckOptions(options_.Fields());
  tan_slope_ = std::tan(options.slope_deg * std::numbers::pi / 180.0);
}

bool FootholdChecker::TooSteep(const Vector3& normal_W, double friction) const {
  const double slope = normal_W.head<2>().norm() / std::max(normal_W.z(), 1e-9);
  return slope > std::min(tan_slope_, kFrictionShare * friction) + 1e-9;
}

double FootholdChecker::SlopeRisk(const Vector3& normal_W) const {
  const double slope = normal_W.head<2>().norm() / std::max(normal_W.z(), 1e-9);
  return tan_slope_ > 0.0 ? slope * slope / (tan_slope_ * tan_slope_) : 0.0;
}

Placing FootholdChecker::Place(int foot, const PlanarPose& at) const {
  return model_->feet[static_cast<std::size_t>(foot)].has_sole() ? PlaceSole(foot, at) : PlacePoint(foot, at);
}

bool FootholdChecker::MayRock(int foot) const {
  return !ground_->terrain().height_fields.empty() && model_->feet[static_cast<std::size_t>(foot)].sole_F.size() > 2;
}

Polygon FootholdChecker::OutlineAt(int foot, const PlanarPose& at) const {
  const Foot& described = model_->feet[static_cast<std::size_t>(foot)];
  Polygon outline;
  if (described.has_sole()) {
    const double c = std::cos(at.yaw_rad), s = std::sin(at.yaw_rad);
    for (const Vector2& p : described.sole_F)
      outline.emplace_back(at.x_m + c * p.x() - s * p.y(), at.y_m + s * p.x() + c * p.y());
    return outline;
  }
  if (described.radius == 0.0) return {PlaceOf(at)};
  const double around = described.radius / std::cos(std::numbers::pi / kAround);
  for (int i = 0; i < kAround; ++i) outline.emplace_back(PlaceOf(at) + around * Around(i));
  return outline;
}

bool FootholdChecker::HitsObstacle(int foot, const PlanarPose& at, double height_m) const {
  if (ground_->obstacles().empty()) return false;
  const Polygon outline = OutlineAt(foot, at);
  const PlanBox box = BoxOf(outline, options_.margin_m);
  std::vector<int> near;
  ground_->ObstaclesIn(box.lowest, box.highest, near);
  return std::any_of(near.begin(), near.end(), [&](int i) {
    const ObstacleOutline& obstacle = ground_->obstacles()[static_cast<std::size_t>(i)];
    if (obstacle.top_m <= height_m || obstacle.bottom_m >= height_m + kUnderFoot * leg_m_) return false;
    return !ApartBy(outline, obstacle.outline_W, options_.margin_m);
  });
}

FootholdFault FootholdChecker::PointSurroundings(const Vector2& p_W, double clear_m, const GroundPoint& ground) const {
  const Vector3 plane = PlaneOf(ground, p_W);
  const double unrolled_m = clear_m + kRolls * (clear_m - options_.margin_m);
  const Vector2 box = Vector2::Constant(unrolled_m);
  std::vector<int> near;
  ground_->PatchesIn(p_W - box, p_W + box, near);
  for (const int i : near) {
    const GroundSurface& other = ground_->surfaces()[static_cast<std::size_t>(i)];
    if (i == ground.patch || other.outline_W.empty()) continue;
    const Vector2 q = NearestPoint(other.outline_W, p_W);
    const double distance = (q - p_W).norm();
    if (distance < unrolled_m && other.HeightAt(q) - On(plane, q) > kFlush + kGoesOn * distance)
      return FootholdFault::kRiser;
  }
  const bool patch = ground.patch < static_cast<int>(ground_->surfaces().size());
  if (patch && ground_->surfaces()[static_cast<std::size_t>(ground.patch)].Inside(p_W) >= clear_m &&
      ground_->terrain().height_fields.empty())
    return FootholdFault::kNone;
  for (const double distance : {0.5 * clear_m, clear_m}) {
    for (int i = 0; i < kAround; ++i) {
      const Vector2 q = p_W + distance * Around(i);
      const GroundPoint there = ground_->At(q);
      if (there.patch < 0) return FootholdFault::kEdge;
      const double rise = there.height_m - On(plane, q), most = kFlush + kGoesOn * distance;
      if (rise < -most) return FootholdFault::kEdge;
      if (rise > most) return patch ? FootholdFault::kRiser : FootholdFault::kRough;
    }
  }
  return FootholdFault::kNone;
}

double FootholdChecker::PointRisk(const Vector2& p_W, double clear_m, const GroundPoint& ground) const {
  const Vector3 plane = PlaneOf(ground, p_W);
  const double distance = clear_m + kSafe * leg_m_;
  int bad = 0;
  for (int i = 0; i < kAround; ++i) {
    const Vector2 q = p_W + distance * Around(i);
    const GroundPoint there = ground_->At(q);
    if (there.patch < 0 || std::abs(there.height_m - On(plane, q)) > kGoesOn * distance) ++bad;
  }
  return std::min(1.0, static_cast<double>(bad) / kAround + SlopeRisk(ground.normal_W));
}

Placing FootholdChecker::PlacePoint(int foot, const PlanarPose& at) const {
  const Vector2 p = PlaceOf(at);
  const GroundPoint ground = ground_->At(p);
  if (ground.patch < 0) return {FootholdFault::kNoGround, {}};
  if (TooSteep(ground.normal_W, ground.friction)) return {FootholdFault::kSlope, {}};
  const double clear = options_.margin_m + model_->feet[static_cast<std::size_t>(foot)].radius;
  if (const FootholdFault fault = PointSurroundings(p, clear, ground); fault != FootholdFault::kNone)
    return {fault, {}};
  if (HitsObstacle(foot, at, ground.height_m)) return {FootholdFault::kObstacle, {}};
  const PlacedFoot placed{foot, Standing(at, ground.height_m, ground.normal_W), ground.patch,
                          PointRisk(p, clear, ground)};
  return {FootholdFault::kNone, placed};
}

Placing FootholdChecker::PlaceSole(int foot, const PlanarPose& at) const {
  std::vector<int> tried;
  Placing best;
  double on = -1.0;
  for (const Vector2& q : SamplesOf(OutlineAt(foot, at))) {
    const int surface = ground_->At(q).patch;
    if (surface < 0 || std::find(tried.begin(), tried.end(), surface) != tried.end()) continue;
    tried.push_back(surface);
    const bool patch = surface < static_cast<int>(ground_->surfaces().size());
    const Placing placing = patch ? PlaceOnPatch(foot, at, surface) : PlaceOnField(foot, at, surface);
    // Report the fault that came nearest to standing: an edge is preferred to a riser of the lower surface.
    const double rank = placing.ok() ? 2.0 - placing.placed.risk : placing.fault == FootholdFault::kEdge ? 0.5 : 0.0;
    if (rank <= on) continue;
    on = rank;
    best = placing;
  }
  if (!best.ok() && tried.size() > 1) {
    const Placing across = PlaceAcross(foot, at);
    if (across.ok()) best = across;
  }
  if (best.ok() && HitsObstacle(foot, at, best.placed.X_WF.translation().z())) return {FootholdFault::kObstacle, {}};
  return best;
}

bool FootholdChecker::AnythingAbove(const Polygon& outline_W, int patch, const Vector3& plane) const {
  return SticksOut(Widened(outline_W, kMissed * options_.margin_m), patch, plane, kFlush) ||
         SticksOut(Widened(outline_W, options_.margin_m), patch, plane, kFlush + kGoesOn * options_.margin_m);
}

bool FootholdChecker::SticksOut(const Polygon& outline_W, int patch, const Vector3& plane, double most_m) const {
  const PlanBox box = BoxOf(outline_W, 0.0);
  std::vector<int> near;
  ground_->PatchesIn(box.lowest, box.highest, near);
  for (const int i : near) {
    const GroundSurface& other = ground_->surfaces()[static_cast<std::size_t>(i)];
    const auto above = [&](const Vector2& q) { return other.HeightAt(q) - On(plane, q) > most_m; };
    if (i == patch || std::none_of(outline_W.begin(), outline_W.end(), above)) continue;  // nor between them
    Polygon part = outline_W;
    for (std::size_t k = 0; k < other.inward.size() && !part.empty(); ++k)
      part = Clipped(part, other.inward[k], other.inward[k].dot(other.outline_W[k]));
    if (std::any_of(part.begin(), part.end(), above)) return true;
  }
  if (ground_->terrain().height_fields.empty()) return false;
  const std::vector<Vector2> samples = SamplesOf(outline_W);
  return std::any_of(samples.begin(), samples.end(), [&](const Vector2& q) {
    const GroundPoint there = ground_->At(q);
    return there.patch >= 0 && there.height_m - On(plane, q) > most_m;
  });
}

Placing FootholdChecker::PlaceOnPatch(int foot, const PlanarPose& at, int patch) const {
  const GroundSurface& surface = ground_->surfaces()[static_cast<std::size_t>(patch)];
  if (TooSteep(surface.normal_W, surface.friction)) return {FootholdFault::kSlope, {}};
  if (AnythingAbove(OutlineAt(foot, at), patch, surface.plane)) return {FootholdFault::kRiser, {}};
  const Foot& described = model_->feet[static_cast<std::size_t>(foot)];
  PlacedFoot placed{foot, Standing(at, surface.HeightAt(PlaceOf(at)), surface.normal_W), patch, 0.0};
  double overhang = 0.0;
  if (!surface.outline_W.empty()) {
    const TerrainPatch& whole = ground_->terrain().patches[static_cast<std::size_t>(patch)];
    const double on = ShareOf(PartOnPatch(described.sole_F, placed.X_WF, whole, options_.margin_m), described.sole_F);
    if (on < options_.least_on) return {FootholdFault::kEdge, {}};
    overhang = (1.0 - on) / std::max(1.0 - options_.least_on, 1e-6);
  }
  placed.risk = std::min(1.0, overhang + SlopeRisk(surface.normal_W));
  return {FootholdFault::kNone, placed};
}

bool FootholdChecker::GoesOn(const Vector2& from_W, const Vector2& to_W) const {
  constexpr double kNear = 1e-5;  // [m]
  const GroundPoint from = ground_->At(from_W), to = ground_->At(to_W);
  if (from.patch < 0 || to.patch < 0) return false;
  const double length = (to_W - from_W).norm();
  if (std::abs(to.height_m - from.height_m) > kFlush + kGoesOn * length) return false;
  if (from.patch == to.patch || length < kNear) return true;
  const Vector2 middle_W = 0.5 * (from_W + to_W);  // next to a point where one surface ends and another begins
  return GoesOn(from_W, middle_W) && GoesOn(middle_W, to_W);
}

bool FootholdChecker::GoesOn(const Polygon& outline_W) const {
  constexpr int kParts = 24;  // samples along an edge
  for (std::size_t i = 0; i < outline_W.size(); ++i) {
    const Vector2 &a = outline_W[i], edge = outline_W[(i + 1) % outline_W.size()] - a;
    for (int part = 0; part < kParts; ++part) {
      if (!GoesOn(a + edge * part / kParts, a + edge * (part + 1) / kParts)) return false;
    }
  }
  return true;
}

Placing FootholdChecker::PlaceAcross(int foot, const PlanarPose& at) const {
  constexpr double kRisk = 0.5;
  const Polygon outline = OutlineAt(foot, at);
  const GroundPoint middle = ground_->At(PlaceOf(at));
  std::vector<Vector3> corners;
  for (const Vector2& corner : outline) {
    const GroundPoint ground = ground_->At(corner);
    if (ground.patch < 0) return {FootholdFault::kEdge, {}};
    corners.emplace_back(corner.x(), corner.y(), ground.height_m);
  }
  const Vector3 plane = PlaneOver(corners, at);
  const bool patch = middle.patch >= 0 && middle.patch < static_cast<int>(ground_->surfaces().size());
  const bool touching = std::all_of(corners.begin(), corners.end(), [&](const Vector3& corner) {
    return std::abs(corner.z() - On(plane, corner.head<2>())) <= kFlush;
  });
  if (!patch || !touching) return {FootholdFault::kEdge, {}};
  if (AnythingAbove(outline, -1, plane) || !GoesOn(outline)) return {FootholdFault::kRiser, {}};
  const Vector3 normal = NormalOf(plane);
  if (TooSteep(normal, middle.friction)) return {FootholdFault::kSlope, {}};
  PlacedFoot placed{foot, Standing(at, On(plane, PlaceOf(at)), normal), middle.patch, 0.0};
  placed.risk = std::min(1.0, kRisk + SlopeRisk(normal));
  return {FootholdFault::kNone, placed};
}

bool FootholdChecker::HoldsSteady(const Polygon& sole_F, const Pose& X_WF, const HeightField& field) const {
  if (sole_F.size() < 3) return true;
  const Polygon steady = SteadyPart(sole_F, X_WF, ground_->terrain(), field.resolution_m);
  const Vector2 middle = Centroid(sole_F);
  return !steady.empty() && SignedDistance(steady, middle) >= kSteady * SignedDistance(sole_F, middle);
}

Placing FootholdChecker::PlaceOnField(int foot, const PlanarPose& at, int surface) const {
  const Foot& described = model_->feet[static_cast<std::size_t>(foot)];
  const Terrain& terrain = ground_->terrain();
  const HeightField& field = terrain.height_fields[static_cast<std::size_t>(surface) - terrain.patches.size()];
  const double c = std::cos(at.yaw_rad), s = std::sin(at.yaw_rad);
  std::vector<Vector3> under;
  for (const Vector2& p : SoleSamples(described.sole_F, kSoleSampling * field.resolution_m)) {
    const Vector2 p_W(at.x_m + c * p.x() - s * p.y(), at.y_m + s * p.x() + c * p.y());
    const GroundPoint ground = ground_->At(p_W);
    if (ground.patch < 0) return {FootholdFault::kEdge, {}};
    under.emplace_back(p_W.x(), p_W.y(), ground.height_m);
  }
  const Vector3 plane =
      described.sole_F.size() < 3 ? PlaneOver(under, at) : RestingPlane(under, Centroid(OutlineAt(foot, at)));
  double deepest = 0.0;
  for (const Vector3& p_W : under) deepest = std::max(deepest, On(plane, p_W.head<2>()) - p_W.z());
  if (deepest > options_.roughness * leg_m_) return {FootholdFault::kRough, {}};
  const Vector3 normal = NormalOf(plane);
  if (TooSteep(normal, ground_->At(PlaceOf(at)).friction)) return {FootholdFault::kSlope, {}};
  PlacedFoot placed{foot, Standing(at, On(plane, PlaceOf(at)), normal), surface, 0.0};
  const double on = ShareOf(TouchingPart(described.sole_F, placed.X_WF, terrain, field.resolution_m), described.sole_F);
  if (on < options_.least_on || !HoldsSteady(described.sole_F, placed.X_WF, field)) return {FootholdFault::kRough, {}};
  placed.risk = std::min(1.0, (1.0 - on) / std::max(1.0 - options_.least_on, 1e-6) + SlopeRisk(normal));
  return {FootholdFault::kNone, placed};
}

double FootholdChecker::LeastInside(const Polygon& outline_F, const Vector2& inward, Depths& known) const {
  const auto same = [&](const auto& depth) { return depth.first == inward; };
  const auto found = std::find_if(known.begin(), known.end(), same);
  if (found != known.end()) return found->second;
  return known.emplace_back(inward, DepthOfShare(outline_F, inward, options_.least_on) + options_.margin_m).second;
}

Polygon FootholdChecker::Eroded(const GroundSurface& surface, const Polygon& outline_F, double inside,
                                Depths& known) const {
  Polygon left = surface.outline_W;
  for (std::size_t i = 0; i < surface.inward.size() && !left.empty(); ++i) {
    const Vector2& n = surface.inward[i];
    const double reach = ReachOf(outline_F, -n) + options_.margin_m;
    const double share = surface.beyond[i] == GroundSurface::Beyond::kHigher  ? std::max(1.0, inside)
                         : surface.beyond[i] == GroundSurface::Beyond::kLower ? inside
                                                                              : 0.0;
    const bool least = inside == 0.0 && surface.beyond[i] == GroundSurface::Beyond::kLower;
    const double keep = least ? LeastInside(outline_F, n, known) : share * reach;
    left = Clipped(left, n, n.dot(surface.outline_W[i]) + keep + 1e-9);
  }
  return left;
}

void FootholdChecker::Near(int foot, const PlanarPose& at, double radius_m, std::vector<PlanarPose>& places) const {
  const Vector2 p = PlaceOf(at), box = Vector2::Constant(radius_m);
  const bool sole = model_->feet[static_cast<std::size_t>(foot)].has_sole();
  const Polygon outline_F = OutlineAt(foot, {0.0, 0.0, at.yaw_rad});
  constexpr double kBeside = 1e-4;  // [m] added to the margin
  std::vector<int> near;
  Depths known;
  ground_->PatchesIn(p - box, p + box, near);
  const auto offer = [&](const Vector2& q) {
    if ((q - p).norm() <= radius_m) places.push_back({q.x(), q.y(), at.yaw_rad});
  };
  for (const int i : near) {
    const GroundSurface& surface = ground_->surfaces()[static_cast<std::size_t>(i)];
    if (surface.outline_W.empty()) continue;
    // Shares of the foot's size that stay inside of an edge; a sole may overhang as far as allowed.
    for (const double inside : sole ? std::array<double, 3>{1.0, 0.6, 0.0} : std::array<double, 3>{2.0, 1.4, 1.0}) {
      const Polygon left = Eroded(surface, outline_F, inside, known);
      if (!left.empty()) offer(NearestPoint(ConvexHull(left), p));
    }
    offer(Centroid(surface.outline_W));
    // Beside the edge: in front of a riser, as near as allowed. Spheres roll towards it during the stance.
    for (std::size_t k = 0; sole && k < surface.inward.size(); ++k) {
      const Vector2& n = surface.inward[k];
      const double inside = n.dot(p - surface.outline_W[k]) + ReachOf(outline_F, n) + options_.margin_m;
      offer(p - (inside + kBeside) * n);
    }
  }
}

}  // namespace gaitwright
