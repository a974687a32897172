// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "playback/mjcf/elements_internal.h"

namespace gaitwright::mujoco {

std::string PlaceOf(const Pose& X) {
  const Quaternion q(X.linear());
  return fmt::format("pos=\"{}\" quat=\"{} {} {} {}\"", Numbers(Vector3(X.translation())), Number(q.w()), Number(q.x()),
                     Number(q.y()), Number(q.z()));
}

std::string ShapeText(const Shape& shape, const std::string& mesh, std::string& assets) {
  switch (shape.type) {
    case ShapeType::kBox:
      return fmt::format("type=\"box\" size=\"{}\"", Numbers(Vector3(0.5 * shape.size)));
    case ShapeType::kSphere:
      return fmt::format("type=\"sphere\" size=\"{}\"", Number(std::max(shape.size.x(), 1e-6)));
    case ShapeType::kCylinder:
      return fmt::format("type=\"cylinder\" size=\"{} {}\"", Number(shape.size.x()), Number(0.5 * shape.size.y()));
    case ShapeType::kCapsule:
      return fmt::format("type=\"capsule\" size=\"{} {}\"", Number(shape.size.x()), Number(0.5 * shape.size.y()));
    case ShapeType::kMesh:
      break;
  }
  return MeshText(shape.vertices, mesh, assets);
}

std::string MeshText(const std::vector<Vector3>& vertices, const std::string& mesh, std::string& assets) {
  // The scale is explicit, because the defaults of a file that includes this one may differ.
  assets += fmt::format("<mesh name=\"{}\" scale=\"1 1 1\" vertex=\"", mesh);
  for (const Vector3& p : vertices) assets += Numbers(p) + " ";
  assets += "\"/>\n";
  return fmt::format("type=\"mesh\" mesh=\"{}\"", mesh);
}

std::string ContactAttributes(const WorldOptions& options) {
  constexpr double kContactTime = 0.004;  // [s]
  constexpr const char* kContactImpedance = "0.95 0.99 0.0005";
  const double time_s = std::max(2.0 * options.step_s, kContactTime * std::sqrt(options.contact_softness));
  return fmt::format("condim=\"3\" solref=\"{} 1\" solimp=\"{}\"", Number(time_s), kContactImpedance);
}

}  // namespace gaitwright::mujoco
