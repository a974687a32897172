// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/mesh_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <numbers>
#include <string_view>

#include "kinematics/base/file.h"
#include "kinematics/base/options.h"
#include "kinematics/model/mesh_parts.h"

namespace gaitwright {
namespace {

namespace fs = std::filesystem;

const std::vector<std::string> kKinds = {".stl", ".obj", ".dae"};

Failure Refused(FailureCode code, const std::string& message) {
  return {FailureKind::kBadInput, code, "ReadMesh", message, {}};
}

std::string Kind(const std::string& path) {
  std::string kind = fs::path(path).extension().string();
  std::transform(kind.begin(), kind.end(), kind.begin(),
                 [](char c) { return static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c); });
  return kind;
}

constexpr std::size_t kLargestMeshFile = std::size_t{256} << 20;  // [byte]
constexpr double kLargestCoordinate = 1e12;

/// The mesh without the points that no triangle uses.
Mesh OnlyUsed(const Mesh& mesh) {
  std::vector<int> number(mesh.vertices.size(), -1);
  Mesh used;
  for (const Eigen::Vector3i& triangle : mesh.triangles) {
    Eigen::Vector3i kept;
    for (int i = 0; i < 3; ++i) {
      int& place = number[static_cast<std::size_t>(triangle[i])];
      if (place < 0) {
        place = static_cast<int>(used.vertices.size());
        used.vertices.push_back(mesh.vertices[static_cast<std::size_t>(triangle[i])]);
      }
      kept[i] = place;
    }
    used.triangles.push_back(kept);
  }
  return used;
}

/// Direction i of n directions that are spread evenly over the sphere, on a spiral with the golden angle.
Vector3 Spread(int i, int n) {
  const double z = 1.0 - (2.0 * i + 1.0) / n;
  const double turn = i * std::numbers::pi * (3.0 - std::sqrt(5.0)), r = std::sqrt(1.0 - z * z);
  return {r * std::cos(turn), r * std::sin(turn), z};
}

std::size_t FarthestOf(const std::vector<Vector3>& points, const Vector3& direction) {
  std::size_t farthest = 0;
  double most = points.front().dot(direction);
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double along = points[i].dot(direction);
    if (along <= most) continue;
    most = along;
    farthest = i;
  }
  return farthest;
}

/// The farthest of the points in each of many directions. To save time, only candidates near a coarse direction D are
/// compared. All points are within R of a middle c. If a known point reaches r along d, the farthest point along d
/// reaches at least r - R |D - d| along D.
std::vector<Vector3> FarthestAlong(const std::vector<Vector3>& points, const std::vector<Vector3>& directions) {
  constexpr int kCoarse = 64;
  Vector3 low = points.front(), high = low;
  for (const Vector3& p : points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const Vector3 middle = 0.5 * (low + high);
  const double radius = 0.5 * (high - low).norm();
  std::vector<Vector3> coarse, extremes;
  for (int k = 0; k < kCoarse; ++k) {
    coarse.push_back(Spread(k, kCoarse));
    extremes.push_back(points[FarthestOf(points, coarse.back())]);
  }
  std::vector<std::vector<std::size_t>> near(kCoarse);
  for (std::size_t i = 0; i < directions.size(); ++i) near[FarthestOf(coarse, directions[i])].push_back(i);
  std::vector<Vector3> farthest(directions.size(), points.front()), candidates;
  for (std::size_t k = 0; k < near.size(); ++k) {
    double least = std::numeric_limits<double>::infinity();
    for (const std::size_t i : near[k]) {
      const Vector3& d = directions[i];
      const double reached = (extremes[FarthestOf(extremes, d)] - middle).dot(d);
      least = std::min(least, reached - radius * ((coarse[k] - d).norm() + 1e-9));
    }
    candidates.clear();
    for (const Vector3& p : points) {
      if ((p - middle).dot(coarse[k]) >= least) candidates.push_back(p);
    }
    for (const std::size_t i : near[k]) farthest[i] = candidates[FarthestOf(candidates, directions[i])];
  }
  return farthest;
}

}  // namespace

Result<std::string> ReadMeshBytes(const std::string& path) {
  std::error_code error;
  if (!fs::is_regular_file(path, error))
    return Refused(FailureCode::kNoFile, fmt::format("file '{}' does not exist", path));
  if (std::find(kKinds.begin(), kKinds.end(), Kind(path)) == kKinds.end()) {
    return Refused(FailureCode::kMeshKind,
                   fmt::format("'{}' is a mesh in an unsupported format; accepted: {}", path, QuotedList(kKinds)));
  }
  Result<std::string> bytes = ReadBytes(path, kLargestMeshFile);
  if (!bytes) return bytes.failure();
  if (bytes->starts_with("version https://git-lfs")) {
    return Refused(
        FailureCode::kNoFile,
        fmt::format("the mesh '{}' is a Git LFS pointer, not the file itself; fetch the file with 'git lfs pull'",
                    path));
  }
  return bytes;
}

Result<Mesh> MeshOfBytes(const std::string& path, const std::string& bytes) {
  Mesh mesh;
  try {
    mesh = Kind(path) == ".stl" ? ParseStl(bytes) : Kind(path) == ".obj" ? ParseObj(bytes) : ParseCollada(bytes);
  } catch (const InvalidArgument& bad) {
    return Refused(FailureCode::kMeshUnreadable, fmt::format("the mesh '{}' cannot be read: {}", path, bad.what()));
  }
  if (mesh.triangles.empty())
    return Refused(FailureCode::kMeshEmpty, fmt::format("the mesh '{}' has no triangles", path));
  for (const Vector3& v : mesh.vertices) {
    if (!(v.cwiseAbs().maxCoeff() <= kLargestCoordinate)) {
      return Refused(FailureCode::kMeshNumber,
                     fmt::format("the mesh '{}' has a vertex that is not finite, or farther away than {}", path,
                                 kLargestCoordinate));
    }
  }
  return OnlyUsed(mesh);
}

Result<Mesh> ReadMesh(const std::string& path) {
  const Result<std::string> bytes = ReadMeshBytes(path);
  if (!bytes) return bytes.failure();
  return MeshOfBytes(path, *bytes);
}

std::vector<Vector3> HullPoints(std::vector<Vector3> points) {
  constexpr std::size_t kMany = 512;
  constexpr int kDirections = 1024;
  const auto less = [](const Vector3& a, const Vector3& b) {
    return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
  };
  const auto once = [&](std::vector<Vector3>& all) {
    std::sort(all.begin(), all.end(), less);
    all.erase(std::unique(all.begin(), all.end()), all.end());
  };
  once(points);
  if (points.size() <= kMany) return points;
  std::vector<Vector3> directions;
  for (int i = 0; i < kDirections; ++i) directions.push_back(Spread(i, kDirections));
  std::vector<Vector3> farthest = FarthestAlong(points, directions);
  once(farthest);
  return farthest;
}

Result<std::string> FindMeshFile(const std::string& name, const std::string& folder, const PackageFolders& packages) {
  constexpr std::string_view kPackage = "package://", kFile = "file://";
  constexpr int kFoldersAbove = 2;
  std::error_code error;
  std::vector<std::string> tried;
  const auto is_there = [&](const fs::path& file) {
    tried.push_back(file.lexically_normal().string());
    return fs::is_regular_file(file, error);
  };
  const std::size_t slash = name.find('/', kPackage.size());
  std::string reason;
  if (name.starts_with(kPackage) && slash != std::string::npos) {
    const std::string path = name.substr(slash + 1);
    const Result<std::string> package =
        FindPackage(name.substr(kPackage.size(), slash - kPackage.size()), folder, packages,
                    [&](const auto& at) { return is_there(fs::path(at) / path); });
    if (package) return tried.back();
    reason = package.failure().message;
    // The folder of a package may have another name, for example a copy or an unpacked archive.
    fs::path above = fs::weakly_canonical(folder.empty() ? "." : folder, error);
    for (int level = 0; level <= kFoldersAbove; ++level, above = above.parent_path()) {
      if (is_there(above / path)) return tried.back();
    }
    tried.clear();
  } else if (name.starts_with(kFile) || name.find("://") == std::string::npos) {
    const std::string path = name.starts_with(kFile) ? name.substr(kFile.size()) : name;
    if (is_there(fs::path(folder) / path)) return tried.back();
  }
  if (!tried.empty())
    return Refused(FailureCode::kNoFile,
                   fmt::format("the mesh '{}' does not exist; searched for {}", name, QuotedList(tried)));
  return Refused(
      FailureCode::kNoFile,
      reason.empty()
          ? fmt::format("the mesh '{}' has an unsupported kind of address; use a path, 'file://' or 'package://NAME/'",
                        name)
          : fmt::format("the mesh '{}' is not found: {}", name, reason));
}

}  // namespace gaitwright
