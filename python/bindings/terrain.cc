// SPDX-License-Identifier: BSD-3-Clause
#include "python/bindings/terrain.h"

#include <fmt/format.h>
#include <pybind11/eigen.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <cmath>

#include "kinematics/base/text.h"
#include "planning/plan/built_in_terrain.h"
#include "planning/plan/terrain_scale.h"
#include "planning/terrain/load_terrain.h"
#include "planning/terrain/sense.h"
#include "python/bindings/arrays.h"
#include "python/bindings/bindings.h"
#include "python/bindings/errors.h"
#include "python/bindings/robot.h"

namespace gaitwright::python {
namespace {

namespace py = pybind11;

Terrain Load(const std::filesystem::path& name_or_file, const SharedRobot& robot) {
  return Value(LoadTerrain(name_or_file.string(), ScaleOf(*robot)));
}

constexpr double kFinest = 1e-4;  // smallest distance between points of a height field [m]

void CheckFriction(double friction) {
  if (!(friction >= kLeastFriction && friction <= kMostFriction))
    throw InvalidArgument(fmt::format("friction is {}; accepted: {} to {}", friction, kLeastFriction, kMostFriction));
}

void CheckPlace(double x_m, double y_m) {
  if (!(std::max(std::abs(x_m), std::abs(y_m)) <= kFarthest))
    throw InvalidArgument(fmt::format("({}, {}) is not within {} m of the origin", x_m, y_m, kFarthest));
}

Terrain Flat(double friction) {
  CheckFriction(friction);
  return FlatTerrain(friction);
}

/// Adds ground by heights: the first index of the array is along y, the second along x.
Terrain WithHeights(Terrain terrain, const Eigen::Ref<const RowMatrix>& height_m, double resolution_m, double x_m,
                    double y_m, double friction, const std::string& name) {
  const auto nodes = height_m.size();
  if (height_m.rows() < 2 || height_m.cols() < 2 || nodes > kMostNodes)
    throw InvalidArgument(fmt::format("height_m is {} x {}; 2 x 2 to {} nodes are accepted", height_m.rows(),
                                      height_m.cols(), kMostNodes));
  if (!height_m.allFinite() || height_m.cwiseAbs().maxCoeff() > kHighest)
    throw InvalidArgument(fmt::format("height_m contains a height that is not within {} m", kHighest));
  CheckPlace(x_m, y_m);
  CheckFriction(friction);
  if (!(resolution_m >= kFinest && resolution_m <= kFarthest))
    throw InvalidArgument(fmt::format("resolution_m is {}; accepted: {} to {} m", resolution_m, kFinest, kFarthest));
  HeightField field;
  field.name = name;
  field.origin_W = Vector2(x_m, y_m);
  field.resolution_m = resolution_m;
  field.columns = static_cast<int>(height_m.cols());
  field.rows = static_cast<int>(height_m.rows());
  for (Eigen::Index row = 0; row < height_m.rows(); ++row)
    for (Eigen::Index column = 0; column < height_m.cols(); ++column) field.height_m.push_back(height_m(row, column));
  field.friction = friction;
  terrain.height_fields.push_back(std::move(field));
  return terrain;
}

Terrain WithPatch(Terrain terrain, const std::vector<Vector3>& corners, double friction, const std::string& name) {
  CheckFriction(friction);
  for (const Vector3& corner : corners) {
    CheckPlace(corner.x(), corner.y());
    if (!(std::abs(corner.z()) <= kHighest))
      throw InvalidArgument(
          fmt::format("a corner is {} m high; accepted: -{} to {} m", corner.z(), kHighest, kHighest));
  }
  terrain.patches.push_back(PatchThrough(name, corners, friction));
  return terrain;
}

Terrain WithMarker(Terrain terrain, const std::string& name, double x_m, double y_m) {
  CheckPlace(x_m, y_m);
  if (Trimmed(name).empty()) throw InvalidArgument("a marker needs a name");
  terrain.markers.push_back({name, Vector2(x_m, y_m)});
  return terrain;
}

py::dict Ground(const Terrain& terrain, double x_m, double y_m) {
  CheckPlace(x_m, y_m);
  const GroundPoint ground = GroundAt(terrain, Vector2(x_m, y_m));
  py::dict point;
  point["surface"] = ground.patch < 0 ? py::object(py::none()) : py::object(py::int_(ground.patch));
  point["height_m"] = ground.height_m;
  point["normal"] = py::cast(ground.normal_W);
  point["friction"] = ground.friction;
  return point;
}

RowMatrix Heights(const Terrain& terrain, const std::vector<double>& x_m, const std::vector<double>& y_m) {
  RowMatrix heights(static_cast<Eigen::Index>(y_m.size()), static_cast<Eigen::Index>(x_m.size()));
  for (Eigen::Index row = 0; row < heights.rows(); ++row) {
    for (Eigen::Index column = 0; column < heights.cols(); ++column) {
      CheckPlace(x_m[static_cast<std::size_t>(column)], y_m[static_cast<std::size_t>(row)]);
      const Vector2 p(x_m[static_cast<std::size_t>(column)], y_m[static_cast<std::size_t>(row)]);
      const GroundPoint ground = GroundAt(terrain, p);
      heights(row, column) = ground.patch < 0 ? std::nan("") : ground.height_m;
    }
  }
  return heights;
}

py::dict Kinds() {
  py::dict kinds;
  for (const BuiltInTerrain& kind : BuiltInTerrains()) kinds[kind.name.c_str()] = kind.description;
  return kinds;
}

std::vector<std::string> NamesOf(const std::vector<TerrainPatch>& patches) {
  std::vector<std::string> names;
  for (const TerrainPatch& patch : patches) names.push_back(patch.name);
  return names;
}

}  // namespace

Terrain TerrainOf(const py::object& terrain, const RobotModel& model) {
  if (py::isinstance<Terrain>(terrain)) return terrain.cast<const Terrain&>();
  if (!py::isinstance<py::str>(terrain) && !py::hasattr(terrain, "__fspath__"))
    throw py::type_error(
        fmt::format("terrain is {}; a Terrain, or the name of one, is needed", py::repr(terrain).cast<std::string>()));
  return Value(LoadTerrain(terrain.cast<std::filesystem::path>().string(), ScaleOf(model)));
}

void BindTerrain(py::module_& module) {
  py::class_<Terrain>(module, "Terrain",
                      R"(The ground and everything on it: planar patches, height fields, obstacles, markers.

A terrain never changes: the methods ``with_...`` return a new one. Where surfaces overlap, the highest one counts.)")
      .def(py::init([](const std::string& name) {
             Terrain terrain;
             terrain.name = name;
             return terrain;
           }),
           py::arg("name") = "own", "An empty terrain without any ground.")
      .def_readonly("name", &Terrain::name)
      .def_property_readonly(
          "patches", [](const Terrain& t) { return NamesOf(t.patches); }, "Names of the patches.")
      .def("ground_at", Ground, py::arg("x_m"), py::arg("y_m"),
           "Highest ground at a point: surface (None if there is no ground), height_m, normal, friction.")
      .def("heights", Heights, py::arg("x_m"), py::arg("y_m"),
           "Heights on a grid of points, len(y) x len(x); NaN without ground.")
      .def("with_patch", WithPatch, py::arg("corners_m"), py::arg("friction") = 0.8, py::arg("name") = "patch",
           "Adds a convex patch; its corners lie in one plane and are counter-clockwise from above.")
      .def("with_heights", WithHeights, py::arg("height_m"), py::arg("resolution_m"), py::arg("x_m") = 0.0,
           py::arg("y_m") = 0.0, py::arg("friction") = 0.8, py::arg("name") = "heights",
           "Adds ground by heights [m]: the first index is along y, the second along x; x_m and y_m are the position "
           "of height_m[0, 0].")
      .def("with_marker", WithMarker, py::arg("name"), py::arg("x_m"), py::arg("y_m"), "Adds a named place.")
      .def("__repr__", [](const Terrain& t) {
        return fmt::format("<gaitwright.Terrain {}: {} surfaces, {} obstacles>", t.name, t.num_surfaces(),
                           t.obstacles.size());
      });
  module.def("load_terrain", Load, py::arg("name_or_file"), py::arg("robot").none(false),
             R"(Loads a ground by name as for ``--terrain``, such as ``"stairs:rise_m=0.05,count=2"``, or from a file.

Parameters that are not given have default sizes for the robot.)");
  module.def("flat_terrain", Flat, py::arg("friction") = 0.8, "Infinite level ground at height 0.");
  module.def("terrain_kinds", Kinds, "Names and descriptions of the built-in grounds.");
}

}  // namespace gaitwright::python
