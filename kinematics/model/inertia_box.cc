// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/inertia_box.h"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace gaitwright {
namespace {

constexpr double kCore = 0.5;  // factor on the edges of the box

int BodyOfLink(const RobotModel& model, const std::string& link) {
  const auto frame =
      std::find_if(model.frames.begin(), model.frames.end(), [&](const Frame& f) { return f.name == link; });
  return frame == model.frames.end() ? -1 : frame->body;
}

bool HasShapeOrFoot(const RobotModel& model, int body) {
  return std::any_of(model.collision_shapes.begin(), model.collision_shapes.end(),
                     [&](const Shape& shape) { return shape.body == body; }) ||
         std::any_of(model.feet.begin(), model.feet.end(), [&](const Foot& foot) { return foot.body == body; });
}

/// Whether a finding already reports the replacement of a link's missing mesh, as for feet.
bool IsReported(const RobotModel& model, const std::string& link) {
  const RobotPart part{PartKind::kLink, link};
  return std::any_of(model.findings.begin(), model.findings.end(),
                     [&](const Finding& f) { return f.code == FailureCode::kMissingMesh && f.part == part; });
}

}  // namespace

std::optional<Shape> InertiaBox(const RobotModel& model, int body) {
  const Body& b = model.bodies[static_cast<std::size_t>(body)];
  if (b.mass <= 0.0) return std::nullopt;
  const Eigen::SelfAdjointEigenSolver<Matrix3> principal(b.I_C);
  const Vector3& I = principal.eigenvalues();
  Shape box;
  box.body = body;
  box.link = b.name;
  for (int i = 0; i < 3; ++i)
    box.size[i] = std::sqrt(std::max(0.0, 6.0 * (I[(i + 1) % 3] + I[(i + 2) % 3] - I[i]) / b.mass));
  if (!(box.size.minCoeff() > 0.0)) return std::nullopt;
  box.X_BS.translation() = b.p_BC;
  box.X_BS.linear() = principal.eigenvectors();
  if (box.X_BS.linear().determinant() < 0.0) box.X_BS.linear().col(2) *= -1.0;
  return box;
}

void TakeInertiaBoxes(const std::vector<MissingMesh>& missing, RobotModel& model) {
  for (const MissingMesh& mesh : missing) {
    const int body = BodyOfLink(model, mesh.link);
    const auto add = [&](FindingLevel level, const std::string& message) {
      model.findings.push_back({level, FailureCode::kMissingMesh, RobotPart{PartKind::kLink, mesh.link}, 0, message});
    };
    if (IsReported(model, mesh.link)) continue;
    if (body >= 0 && HasShapeOrFoot(model, body)) {
      add(FindingLevel::kInfo, fmt::format("{}: only the other shapes of its body are used", mesh.why));
      continue;
    }
    std::optional<Shape> box;
    if (body >= 0) box = InertiaBox(model, body);
    if (box) box->size *= kCore;
    if (!box || box->size.maxCoeff() > model.leg_length_m()) {
      add(FindingLevel::kWarning, fmt::format("{}: no contact of this link is checked", mesh.why));
      continue;
    }
    add(FindingLevel::kWarning,
        fmt::format("{}: a box of {:.3f} x {:.3f} x {:.3f} m, half the size of the link's inertia box, is used instead",
                    mesh.why, box->size.x(), box->size.y(), box->size.z()));
    model.collision_shapes.push_back(std::move(*box));
  }
}

}  // namespace gaitwright
