// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "kinematics/base/text.h"
#include "playback/mjcf/elements_internal.h"
#include "playback/mjcf/ground_text_internal.h"

namespace gaitwright::mujoco {
namespace {

constexpr double kObstacleFriction = 0.8;
constexpr double kFieldBase = 1.0;  // depth of the solid under a height field [m]

/// MuJoCo's rows and columns go along y and x as ours do, and it splits cells along the same diagonal.
FieldHeights HeightsOf(const HeightField& field, double low, double rise) {
  FieldHeights heights{field.rows, field.columns, {}};
  for (const double height : field.height_m) heights.heights.push_back(static_cast<float>((height - low) / rise));
  return heights;
}

class GroundWriter {
 public:
  explicit GroundWriter(const GroundStyle& style) : style_(style) {}

  GroundText Write(const Terrain& terrain) {
    for (const Obstacle& obstacle : terrain.obstacles)
      AddGeom(ShapeText(ShapeOf(obstacle), Name(), text_.assets), obstacle.X_WO, kObstacleFriction);
    for (const TerrainPatch& patch : terrain.patches) AddPatch(patch);
    for (const HeightField& field : terrain.height_fields) AddField(field);
    return std::move(text_);
  }

 private:
  /// Name of the current part.
  std::string Name() const { return EscapedXml(style_.names.at(part_)); }

  void AddGeom(const std::string& shape, const Pose& X_WS, double friction) {
    text_.geoms +=
        fmt::format("<geom name=\"{}\" {} {} friction=\"{} 0 0\" {}/>\n", Name(), shape, PlaceOf(style_.X_tilt * X_WS),
                    Number(style_.friction > 0.0 ? style_.friction : friction), style_.attributes);
    ++part_;
  }

  void AddPatch(const TerrainPatch& patch) {
    if (patch.outline_T.empty()) return AddGeom("type=\"plane\" size=\"0 0 1\"", patch.X_WT, patch.friction);
    text_.has_edges = true;
    std::vector<Vector3> corners;
    for (const Vector3& corner_W : SolidUnder(patch)) corners.push_back(patch.X_WT.inverse() * corner_W);
    AddGeom(MeshText(corners, Name(), text_.assets), patch.X_WT, patch.friction);
  }

  void AddField(const HeightField& field) {
    text_.finest_m = text_.finest_m > 0.0 ? std::min(text_.finest_m, field.resolution_m) : field.resolution_m;
    const auto [low, high] = std::minmax_element(field.height_m.begin(), field.height_m.end());
    const double rise = std::max(*high - *low, 1e-6);
    FieldHeights heights = HeightsOf(field, *low, rise);
    const Vector2 extent = field.resolution_m * Vector2(field.columns - 1, field.rows - 1);
    Pose X_WS = Pose::Identity();
    X_WS.translation() << field.origin_W + 0.5 * extent, *low;
    const std::string size = style_.height_files.empty()
                                 ? fmt::format("nrow=\"{}\" ncol=\"{}\"", heights.rows, heights.columns)
                                 : fmt::format("file=\"{}\"", EscapedXml(style_.height_files.at(text_.fields.size())));
    text_.assets += fmt::format("<hfield name=\"{}\" {} size=\"{} {} {} {}\"/>\n", Name(), size,
                                Number(0.5 * extent.x()), Number(0.5 * extent.y()), Number(rise), Number(kFieldBase));
    text_.fields.push_back(std::move(heights));
    AddGeom(fmt::format("type=\"hfield\" hfield=\"{}\"", Name()), X_WS, field.friction);
  }

  const GroundStyle& style_;
  std::size_t part_ = 0;
  GroundText text_;
};

}  // namespace

GroundText WriteGround(const Terrain& terrain, const GroundStyle& style) { return GroundWriter(style).Write(terrain); }

}  // namespace gaitwright::mujoco
